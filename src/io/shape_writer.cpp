// Shapes of space as the query protocol reads them.
#include "io/shape_writer.hpp"

#include <span>

#include "graze/error.hpp"

namespace graze::io {

namespace {

void seen_from_both(Sides sides, const char* name) {
  if (sides == Sides::both) return;
  throw InvalidValue("shape", "a shape that a question can hold",
                     std::string(name) + " that is seen from its front alone");
}

/// The object that has the name of the shape's type, with its measures.
template <class T>
class Measures {
 public:
  explicit Measures(JsonWriter& out) : out_(out) {}

  void operator()(const Sphere<T>& s) {
    if (s.center() == Vec3<T>{}) {
      begin("sphere").number("radius", s.radius()).end();
    } else {
      begin("compound");
      out_.key("children").open('[');
      put_child(Sphere<T>(s.radius()), {s.center(), {}});
      out_.close(']');
      end();
    }
  }
  void operator()(const Capsule<T>& c) { put_ends("capsule", c); }
  void operator()(const Cylinder<T>& c) { put_ends("cylinder", c); }
  void operator()(const Box<T>& b) { begin("box").vector("size", b.half_extents() * T(2)).end(); }
  void operator()(const Rectangle<T>& r) {
    const Vec3<T> size = r.as_box().half_extents() * T(2);
    begin("plane").number("sizeX", size.x).number("sizeZ", size.z).end();
  }
  void operator()(const Ellipsoid<T>& e) { begin("ellipsoid").vector("radii", e.radii()).end(); }
  void operator()(const LineSegment<T>& s) {
    const Vec3<T> ends[] = {s.point(0), s.point(1)};
    begin("convex").points(ends).end();
  }
  void operator()(const Triangle<T>& t) {
    const Vec3<T> corners[] = {t.point(0), t.point(1), t.point(2)};
    begin("triangle").points(corners).end();
  }
  void operator()(const HalfSpace<T>&) { out_.key("type").raw("\"plane\""); }
  void operator()(const ConvexHull<T>& h) { begin("convex").points(h.data().vertices).end(); }
  void operator()(const Mesh<T>& m) {
    seen_from_both(m.sides(), "a mesh");
    begin("mesh").points(m.points());
    out_.key("triangles").open('[');
    for (const auto& [i, j, k] : m.triangles())
      out_.open('[').number(double(i)).number(double(j)).number(double(k)).close(']');
    out_.close(']');
    if (m.solid()) out_.key("solid").value(true);
    end();
  }
  void operator()(const HeightField<T>& f) {
    seen_from_both(f.sides(), "a height field");
    begin("heightfield");
    out_.key("columns").number(double(f.columns())).key("rows").number(double(f.rows())).key("spacing").open('[');
    out_.number(double(f.spacing_x())).number(double(f.spacing_z())).close(']').key("heights").open('[');
    for (const T height : f.heights()) out_.number(double(height));  // a hole, which is no number, as null
    out_.close(']');
    end();
  }
  void operator()(const Compound<T>& c) {
    begin("compound");
    out_.key("children").open('[');
    for (const Placed<T>& child : c.children()) put_child(child.shape, child.pose);
    out_.close(']');
    end();
  }
  void operator()(const UserConvex<T>&) {
    throw InvalidValue("shape", "a shape that a question can hold", "one of the user's own");
  }

 private:
  Measures& begin(const char* type) {
    out_.key("type").raw('"' + std::string(type) + '"').key(type).open('{');
    return *this;
  }
  void end() { out_.close('}'); }
  Measures& number(const char* name, T value) {
    out_.key(name).number(double(value));
    return *this;
  }
  Measures& vector(const char* name, const Vec3<T>& value) {
    out_.key(name).vector(converted<double>(value));
    return *this;
  }
  Measures& points(std::span<const Vec3<T>> all) {
    out_.key("points").open('[');
    for (const Vec3<T>& p : all) out_.vector(converted<double>(p));
    out_.close(']');
    return *this;
  }
  template <class C>
  void put_ends(const char* type, const C& c) {
    begin(type).number("height", T(2) * c.half_height());
    number("radiusBottom", c.radius_bottom()).number("radiusTop", c.radius_top()).end();
  }
  void put_child(const Shape<T>& shape, const Pose<T>& pose) {
    write_shape(out_.open('{').key("shape"), shape);
    out_.key("translation").vector(converted<double>(pose.translation)).key("rotation").open('[');
    const Quat<T>& q = pose.rotation;
    for (const T part : {q.x, q.y, q.z, q.w}) out_.number(double(part));
    out_.close(']').close('}');
  }

  JsonWriter& out_;
};

}  // namespace

template <class T>
void write_shape(JsonWriter& out, const Shape<T>& shape) {
  out.open('{');
  shape.visit(Measures<T>(out));
  if (shape.rounding() > T(0)) out.key("margin").number(double(shape.rounding()));
  out.close('}');
}

template void write_shape(JsonWriter&, const Shape<float>&);
template void write_shape(JsonWriter&, const Shape<double>&);

}  // namespace graze::io
