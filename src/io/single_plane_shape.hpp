// A shape of the plane in another precision.
#pragma once

#include <memory>

#include "graze/plane/shape.hpp"

namespace graze::io {

inline plane::Shapef to_single(const plane::Shaped& shape);

namespace detail {

inline float single(double x) { return static_cast<float>(x); }

inline plane::Circle<float> single(const plane::Circle<double>& c) { return plane::Circle<float>(single(c.radius())); }
inline plane::Capsule<float> single(const plane::Capsule<double>& c) {
  return {single(2 * c.half_height()), single(c.radius_bottom()), single(c.radius_top())};
}
inline plane::Box<float> single(const plane::Box<double>& b) {
  return plane::Box<float>(plane::converted<float>(b.half_extents() * 2.0));
}
inline plane::Segment<float> single(const plane::Segment<double>& s) {
  return {plane::converted<float>(s.a()), plane::converted<float>(s.b())};
}
inline plane::ConvexPolygon<float> single(const plane::ConvexPolygon<double>& p) {
  std::vector<plane::Vec2f> points;
  for (const plane::Vec2d& v : p.vertices()) points.push_back(plane::converted<float>(v));
  return plane::ConvexPolygon<float>(points);
}
inline plane::Ellipse<float> single(const plane::Ellipse<double>& e) {
  return plane::Ellipse<float>(plane::converted<float>(e.radii()));
}
inline plane::HalfPlane<float> single(const plane::HalfPlane<double>&) { return {}; }

/// A user's shape whose support points are computed in double and rounded.
class SinglePlaneSupport final : public plane::SupportFunction<float> {
 public:
  explicit SinglePlaneSupport(plane::UserConvex<double> shape) : shape_(std::move(shape)) {}
  plane::Vec2f support(const plane::Vec2f& direction) const override {
    return plane::converted<float>(shape_.function().support(plane::converted<double>(direction)));
  }

 private:
  plane::UserConvex<double> shape_;
};
inline plane::UserConvex<float> single(const plane::UserConvex<double>& u) {
  return plane::UserConvex<float>(std::make_shared<SinglePlaneSupport>(u));
}

inline std::vector<plane::Vec2f> outline_of(const plane::Pieces<double>& pieces) {
  std::vector<plane::Vec2f> out;
  for (const plane::Vec2d& v : pieces.outline_vertices()) out.push_back(plane::converted<float>(v));
  return out;
}
inline plane::Polygon<float> single(const plane::Polygon<double>& p) {
  return plane::Polygon<float>(outline_of(p.pieces()));
}
inline plane::Chain<float> single(const plane::Chain<double>& c) {
  return plane::Chain<float>(outline_of(c.pieces()), c.closed(), c.sides());
}
inline plane::Compound<float> single(const plane::Compound<double>& c) {
  std::vector<plane::Placed<float>> children;
  for (const plane::Placed<double>& child : c.children())
    children.push_back({to_single(child.shape), plane::converted<float>(child.pose)});
  return plane::Compound<float>(std::move(children));
}

}  // namespace detail

/// A shape with its numbers rounded to float. Throws `InvalidValue` for one that floats cannot hold.
inline plane::Shapef to_single(const plane::Shaped& shape) {
  return shape.visit([&](const auto& c) -> plane::Shapef {
    return {detail::single(c), static_cast<float>(shape.rounding())};
  });
}

/// The shape in the precision that a question is answered in.
template <class T>
plane::Shape<T> in_precision(const plane::Shaped& shape) {
  if constexpr (std::is_same_v<T, double>)
    return shape;
  else
    return to_single(shape);
}

}  // namespace graze::io
