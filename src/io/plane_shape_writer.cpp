// Shapes of the plane as the query protocol reads them.
#include <cmath>

#include "graze/error.hpp"
#include "io/shape_writer.hpp"

namespace graze::io {

namespace {

using plane::Vec2;

template <class T>
JsonWriter& put(JsonWriter& out, const Vec2<T>& v) {
  return out.open('[').number(double(v.x)).number(double(v.y)).close(']');
}

/// The object that has the name of the shape's type: its measures.
template <class T>
class PlaneMeasures {
 public:
  explicit PlaneMeasures(JsonWriter& out) : out_(out) {}

  void operator()(const plane::Circle<T>& c) { number("radius", c.radius()); }
  void operator()(const plane::Capsule<T>& c) {
    number("height", T(2) * c.half_height());
    number("radiusBottom", c.radius_bottom());
    number("radiusTop", c.radius_top());
  }
  void operator()(const plane::Box<T>& b) { put(key("size"), b.half_extents() * T(2)); }
  void operator()(const plane::Segment<T>& s) { points({s.a(), s.b()}); }
  void operator()(const plane::ConvexPolygon<T>& p) { points({p.vertices().begin(), p.vertices().end()}); }
  void operator()(const plane::Ellipse<T>& e) { put(key("radii"), e.radii()); }
  void operator()(const plane::HalfPlane<T>&) {}
  void operator()(const plane::Polygon<T>& p) { points(p.pieces().outline_vertices()); }
  void operator()(const plane::Chain<T>& c) {
    points(c.pieces().outline_vertices());
    if (c.closed()) key("closed").value(true);
    if (c.sides() == plane::ChainSides::one) key("sides").raw("\"one\"");
  }
  void operator()(const plane::Compound<T>& c) {
    key("children").open('[');
    for (const auto& child : c.children()) {
      write_shape(out_.open('{').key("shape"), child.shape);
      write_pose(out_, child.pose);
      out_.close('}');
    }
    out_.close(']');
  }
  void operator()(const plane::UserConvex<T>&) {
    throw InvalidValue("shape", "a shape that a question can hold", "one of the user's own");
  }

 private:
  JsonWriter& key(const char* name) { return out_.key(name); }
  void number(const char* name, T value) { key(name).number(double(value)); }
  void points(const std::vector<Vec2<T>>& all) {
    key("points").open('[');
    for (const Vec2<T>& p : all) put(out_, p);
    out_.close(']');
  }

  JsonWriter& out_;
};

}  // namespace

template <class T>
void write_pose(JsonWriter& out, const plane::Pose2<T>& pose) {
  put(out.key("translation"), pose.translation);
  const auto& turn = pose.rotation;
  if (turn.sine != T(0) || turn.cosine != T(1))
    out.key("rotation").number(std::atan2(double(turn.sine), double(turn.cosine)));
}

template <class T>
void write_shape(JsonWriter& out, const plane::Shape<T>& shape) {
  const char* type = shape.name();  // kinds have the names of the protocol
  out.open('{').key("type").raw('"' + std::string(type) + '"').key(type).open('{');
  shape.visit(PlaneMeasures<T>(out));
  out.close('}');
  if (shape.rounding() > T(0)) out.key("margin").number(double(shape.rounding()));
  out.close('}');
}

template void write_pose(JsonWriter&, const plane::Pose2<float>&);
template void write_pose(JsonWriter&, const plane::Pose2<double>&);
template void write_shape(JsonWriter&, const plane::Shape<float>&);
template void write_shape(JsonWriter&, const plane::Shape<double>&);

}  // namespace graze::io
