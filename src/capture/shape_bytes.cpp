// Shapes of space as bytes of a capture.
#include "capture/shape_reading.hpp"

namespace graze::capture {

namespace {

/// The numbers that a shape is made from.
template <class T>
class WrittenShape {
 public:
  explicit WrittenShape(Writing& io) : io_(io) {}

  void operator()(const Sphere<T>& s) { io_(s.radius(), s.center()); }
  void operator()(const Capsule<T>& c) { io_(T(2) * c.half_height(), c.radius_bottom(), c.radius_top()); }
  void operator()(const Box<T>& b) { io_(b.half_extents() * T(2)); }
  void operator()(const Rectangle<T>& r) {
    const Vec3<T> size = r.as_box().half_extents() * T(2);
    io_(size.x, size.z);
  }
  void operator()(const Cylinder<T>& c) { io_(T(2) * c.half_height(), c.radius_bottom(), c.radius_top()); }
  void operator()(const Ellipsoid<T>& e) { io_(e.radii()); }
  void operator()(const LineSegment<T>& s) { io_(s.point(0), s.point(1)); }
  void operator()(const Triangle<T>& t) { io_(t.point(0), t.point(1), t.point(2)); }
  void operator()(const HalfSpace<T>&) {}
  void operator()(const ConvexHull<T>& h) { list(copied(std::span<const Vec3<T>>(h.data().vertices)), sizeof(T)); }
  void operator()(const Mesh<T>& m) {
    list(copied(m.points()), sizeof(T));
    io_(std::uint64_t{m.triangles().size()});
    for (const auto& [i, j, k] : m.triangles()) io_(i, j, k);
    io_(m.sides(), m.solid());
  }
  void operator()(const HeightField<T>& f) {
    io_(std::uint64_t{f.columns()}, std::uint64_t{f.rows()}, f.spacing_x(), f.spacing_z(), f.sides());
    list(copied(f.heights()), sizeof(T));
  }
  void operator()(const Compound<T>& c) {
    io_(std::uint64_t{c.children().size()});
    for (const Placed<T>& child : c.children()) {
      write_shape(io_, child.shape);
      io_(child.pose);
    }
  }
  [[noreturn]] void operator()(const UserConvex<T>&) {
    throw InvalidValue("shape", "a shape that a file can hold", "one of the user's own");
  }

 private:
  template <class V>
  void list(std::vector<V> values, std::size_t least_bytes) {
    fields(io_, values, least_bytes);
  }

  Writing& io_;
};

/// The reader of a shape of each kind.
template <class T>
class ReadShape : ShapeReading<T> {
 public:
  using ShapeReading<T>::ShapeReading;

  Sphere<T> concrete(std::type_identity<Sphere<T>>) {
    const T radius = number();
    return Sphere<T>(radius, vector());
  }
  template <class C>
  requires std::is_same_v<C, Capsule<T>> || std::is_same_v<C, Cylinder<T>> C concrete(std::type_identity<C>) {
    const T height = number(), bottom = number(), top = number();
    return C(height, bottom, top);
  }
  Box<T> concrete(std::type_identity<Box<T>>) { return Box<T>(vector()); }
  Rectangle<T> concrete(std::type_identity<Rectangle<T>>) {
    const T x = number(), z = number();
    return Rectangle<T>(x, z);
  }
  Ellipsoid<T> concrete(std::type_identity<Ellipsoid<T>>) { return Ellipsoid<T>(vector()); }
  LineSegment<T> concrete(std::type_identity<LineSegment<T>>) {
    const Vec3<T> a = vector(), b = vector();
    return LineSegment<T>(a, b);
  }
  Triangle<T> concrete(std::type_identity<Triangle<T>>) {
    const Vec3<T> a = vector(), b = vector(), c = vector();
    return Triangle<T>(a, b, c);
  }
  HalfSpace<T> concrete(std::type_identity<HalfSpace<T>>) { return {}; }
  ConvexHull<T> concrete(std::type_identity<ConvexHull<T>>) { return ConvexHull<T>(list<Vec3<T>>(3 * sizeof(T))); }
  Mesh<T> concrete(std::type_identity<Mesh<T>>) {
    std::vector<Vec3<T>> points = list<Vec3<T>>(3 * sizeof(T));
    const auto count = this->template number<std::uint64_t>();
    if (count > io_.left() / sizeof(typename Mesh<T>::Index)) throw Damaged{"more triangles than it has bytes for"};
    std::vector<typename Mesh<T>::Index> triangles(static_cast<std::size_t>(count));
    for (auto& [i, j, k] : triangles) io_(i, j, k);
    const Sides sides = this->template number<Sides>();
    return Mesh<T>(std::move(points), std::move(triangles), sides, this->template number<bool>());
  }
  HeightField<T> concrete(std::type_identity<HeightField<T>>) {
    const auto columns = this->template number<std::uint64_t>(), rows = this->template number<std::uint64_t>();
    const T x = number(), z = number();
    const Sides sides = this->template number<Sides>();
    return HeightField<T>(static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), list<T>(sizeof(T)), x, z,
                          sides);
  }
  Compound<T> concrete(std::type_identity<Compound<T>>) {
    return Compound<T>(this->template children<Placed<T>, Shape<T>, Pose<T>>());
  }
  [[noreturn]] UserConvex<T> concrete(std::type_identity<UserConvex<T>>) { throw Damaged{"a shape of no kind"}; }

 private:
  using ShapeReading<T>::io_;
  using ShapeReading<T>::number;
  Vec3<T> vector() { return this->template number<Vec3<T>>(); }
  template <class V>
  std::vector<V> list(std::size_t least_bytes) {
    return ShapeReading<T>::template list<V>(least_bytes);
  }
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
  return shape_of_kind<Shape<T>, ShapeList<T>>(kind, rounding, one);
}

}  // namespace

#define GRAZE_SHAPE_BYTES(T)                                                                                           \
  template <>                                                                                                          \
  void write_shape(Writing& io, const Shape<T>& shape) {                                                               \
    write(io, shape);                                                                                                  \
  }                                                                                                                    \
  template <>                                                                                                          \
  Shape<T> read_shape(Reading& io, int depth) {                                                                        \
    return read<T>(io, depth);                                                                                         \
  }
GRAZE_SHAPE_BYTES(float)
GRAZE_SHAPE_BYTES(double)
#undef GRAZE_SHAPE_BYTES

}  // namespace graze::capture
