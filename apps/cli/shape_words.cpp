#include "shape_words.hpp"

#include <fmt/format.h>

#include "output.hpp"

namespace graze::cli {

namespace {

std::string words(const Sphere<double>& s) { return fmt::format("radius {:.6g}", s.radius()); }
std::string words(const Capsule<double>& c) {
  return fmt::format("height {:.6g}, radii {:.6g} and {:.6g}", 2 * c.half_height(), c.radius_bottom(), c.radius_top());
}
std::string words(const Cylinder<double>& c) {
  return fmt::format("height {:.6g}, radii {:.6g} and {:.6g}", 2 * c.half_height(), c.radius_bottom(), c.radius_top());
}
std::string words(const Box<double>& b) {
  const Vec3d s = b.half_extents() * 2.0;
  return fmt::format("{:.6g} x {:.6g} x {:.6g}", s.x, s.y, s.z);
}
std::string words(const Rectangle<double>& r) {
  const Vec3d s = r.as_box().half_extents() * 2.0;
  return fmt::format("{:.6g} x {:.6g}", s.x, s.z);
}
std::string words(const Ellipsoid<double>& e) {
  return fmt::format("radii {:.6g}, {:.6g}, {:.6g}", e.radii().x, e.radii().y, e.radii().z);
}
std::string words(const ConvexHull<double>& h) {
  return fmt::format("{} vertices, {} faces", h.data().vertices.size(), h.data().planes.size());
}
std::string words(const Mesh<double>& m) { return counted(m.triangles().size(), "triangle"); }
std::string words(const HeightField<double>& f) { return fmt::format("{} x {} heights", f.columns(), f.rows()); }
template <class AnyCompound>
std::string words_of_compound(const AnyCompound& c) {
  return c.children().size() == 1 ? "of one " + told(c.children()[0].shape)
                                  : fmt::format("{} children", c.children().size());
}
std::string words(const Compound<double>& c) { return words_of_compound(c); }
std::string words(const plane::Compound<double>& c) { return words_of_compound(c); }

std::string words(const plane::Circle<double>& c) { return fmt::format("radius {:.6g}", c.radius()); }
std::string words(const plane::Capsule<double>& c) {
  return fmt::format("height {:.6g}, radii {:.6g} and {:.6g}", 2 * c.half_height(), c.radius_bottom(), c.radius_top());
}
std::string words(const plane::Box<double>& b) {
  return fmt::format("{:.6g} x {:.6g}", 2 * b.half_extents().x, 2 * b.half_extents().y);
}
std::string words(const plane::Ellipse<double>& e) {
  return fmt::format("radii {:.6g}, {:.6g}", e.radii().x, e.radii().y);
}
std::string words(const plane::Segment<double>& s) { return fmt::format("length {:.6g}", length(s.b() - s.a())); }
std::string words(const plane::ConvexPolygon<double>& p) { return fmt::format("{} vertices", p.vertices().size()); }

std::string words(const plane::Polygon<double>& p) {
  return fmt::format("{} vertices", p.pieces().outline_vertices().size());
}
std::string words(const plane::Chain<double>& c) { return counted(c.pieces().size(), "segment"); }

template <class C>
std::string words(const C&) {
  return "";
}

template <class AnyShape>
std::string told_of(const AnyShape& shape) {
  const std::string detail = shape.visit([](const auto& c) { return words(c); });
  return detail.empty() ? shape.name() : fmt::format("{} ({})", shape.name(), detail);
}

}  // namespace

std::string told(const Shaped& shape) { return told_of(shape); }
std::string told(const plane::Shaped& shape) { return told_of(shape); }

}  // namespace graze::cli
