// Shapes of the plane as bytes of a capture.
#include "capture/shape_reading.hpp"

namespace graze::plane {

namespace {

using capture::copied;
using capture::Reading;
using capture::Writing;

/// The numbers that a shape is made from.
template <class T>
class WrittenShape {
 public:
  explicit WrittenShape(Writing& io) : io_(io) {}

  void operator()(const Circle<T>& c) { io_(c.radius()); }
  void operator()(const Capsule<T>& c) { io_(T(2) * c.half_height(), c.radius_bottom(), c.radius_top()); }
  void operator()(const Box<T>& b) { io_(b.half_extents() * T(2)); }
  void operator()(const Segment<T>& s) { io_(s.a(), s.b()); }
  void operator()(const ConvexPolygon<T>& p) { list(copied(p.vertices())); }
  void operator()(const Ellipse<T>& e) { io_(e.radii()); }
  void operator()(const HalfPlane<T>&) {}
  void operator()(const Polygon<T>& p) { list(p.pieces().outline_vertices()); }
  void operator()(const Chain<T>& c) {
    list(c.pieces().outline_vertices());
    io_(c.closed(), c.sides());
  }
  void operator()(const Compound<T>& c) {
    io_(std::uint64_t{c.children().size()});
    for (const Placed<T>& child : c.children()) {
      capture::write_shape(io_, child.shape);
      io_(child.pose);
    }
  }
  [[noreturn]] void operator()(const UserConvex<T>&) {
    throw InvalidValue("shape", "a shape that a file can hold", "one of the user's own");
  }

 private:
  void list(std::vector<Vec2<T>> points) { fields(io_, points, 2 * sizeof(T)); }

  Writing& io_;
};

/// The reader of a shape of each kind.
template <class T>
class ReadShape : capture::ShapeReading<T> {
 public:
  using capture::ShapeReading<T>::ShapeReading;

  Circle<T> concrete(std::type_identity<Circle<T>>) { return Circle<T>(number()); }
  Capsule<T> concrete(std::type_identity<Capsule<T>>) {
    const T height = number(), bottom = number(), top = number();
    return Capsule<T>(height, bottom, top);
  }
  Box<T> concrete(std::type_identity<Box<T>>) { return Box<T>(vector()); }
  Segment<T> concrete(std::type_identity<Segment<T>>) {
    const Vec2<T> a = vector(), b = vector();
    return Segment<T>(a, b);
  }
  ConvexPolygon<T> concrete(std::type_identity<ConvexPolygon<T>>) { return ConvexPolygon<T>(points()); }
  Ellipse<T> concrete(std::type_identity<Ellipse<T>>) { return Ellipse<T>(vector()); }
  HalfPlane<T> concrete(std::type_identity<HalfPlane<T>>) { return {}; }
  Polygon<T> concrete(std::type_identity<Polygon<T>>) { return Polygon<T>(points()); }
  Chain<T> concrete(std::type_identity<Chain<T>>) {
    const std::vector<Vec2<T>> corners = points();
    const bool closed = this->template number<bool>();
    return Chain<T>(corners, closed, this->template number<ChainSides>());
  }
  Compound<T> concrete(std::type_identity<Compound<T>>) {
    return Compound<T>(this->template children<Placed<T>, Shape<T>, Pose2<T>>());
  }
  [[noreturn]] UserConvex<T> concrete(std::type_identity<UserConvex<T>>) {
    throw capture::Damaged{"a shape of no kind"};
  }

 private:
  using capture::ShapeReading<T>::number;
  Vec2<T> vector() { return this->template number<Vec2<T>>(); }
  std::vector<Vec2<T>> points() { return this->template list<Vec2<T>>(2 * sizeof(T)); }
};

template <class T>
void write(Writing& io, const Shape<T>& shape) {
  io(static_cast<std::uint8_t>(shape.index()), shape.rounding());
  WrittenShape<T> written(io);
  shape.visit([&](const auto& concrete) { written(concrete); });
}
template <class T>
Shape<T> read(Reading& io, int depth) {
  std::uint8_t kind = 0;
  T rounding{};
  io(kind, rounding);
  ReadShape<T> one(io, depth);
  return capture::shape_of_kind<Shape<T>, ShapeList<T>>(kind, rounding, one);
}

}  // namespace

}  // namespace graze::plane

namespace graze::capture {

#define GRAZE_SHAPE_BYTES(T)                                                                                           \
  template <>                                                                                                          \
  void write_shape(Writing& io, const plane::Shape<T>& shape) {                                                        \
    plane::write(io, shape);                                                                                           \
  }                                                                                                                    \
  template <>                                                                                                          \
  plane::Shape<T> read_shape(Reading& io, int depth) {                                                                 \
    return plane::read<T>(io, depth);                                                                                  \
  }
GRAZE_SHAPE_BYTES(float)
GRAZE_SHAPE_BYTES(double)
#undef GRAZE_SHAPE_BYTES

}  // namespace graze::capture
