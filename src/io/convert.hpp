// A shape in another precision.
#pragma once

#include "graze/shape.hpp"

namespace graze::io {

inline Shapef to_single(const Shaped& shape);

namespace detail {

inline Sphere<float> single(const Sphere<double>& s) {
  return Sphere<float>(static_cast<float>(s.radius()), converted<float>(s.center()));
}
inline Capsule<float> single(const Capsule<double>& c) {
  return {static_cast<float>(2 * c.half_height()), static_cast<float>(c.radius_bottom()),
          static_cast<float>(c.radius_top())};
}
inline Box<float> single(const Box<double>& b) { return Box<float>(converted<float>(b.half_extents() * 2.0)); }
inline Rectangle<float> single(const Rectangle<double>& r) {
  const Vec3f size = converted<float>(r.as_box().half_extents() * 2.0);
  return {size.x, size.z};
}
inline Cylinder<float> single(const Cylinder<double>& c) {
  return {static_cast<float>(2 * c.half_height()), static_cast<float>(c.radius_bottom()),
          static_cast<float>(c.radius_top())};
}
inline Ellipsoid<float> single(const Ellipsoid<double>& e) { return Ellipsoid<float>(converted<float>(e.radii())); }
inline LineSegment<float> single(const LineSegment<double>& s) {
  return {converted<float>(s.point(0)), converted<float>(s.point(1))};
}
inline Triangle<float> single(const Triangle<double>& t) {
  return {converted<float>(t.point(0)), converted<float>(t.point(1)), converted<float>(t.point(2))};
}
inline HalfSpace<float> single(const HalfSpace<double>&) { return {}; }

template <class From>
std::vector<Vec3f> points(const From& from) {
  std::vector<Vec3f> out;
  out.reserve(from.size());
  for (const Vec3d& p : from) out.push_back(converted<float>(p));
  return out;
}
inline ConvexHull<float> single(const ConvexHull<double>& h) { return ConvexHull<float>(points(h.data().vertices)); }
inline Mesh<float> single(const Mesh<double>& m) {
  return {points(m.points()), {m.triangles().begin(), m.triangles().end()}, m.sides(), m.solid()};
}
inline HeightField<float> single(const HeightField<double>& f) {
  std::vector<float> heights;
  heights.reserve(f.heights().size());
  for (const double h : f.heights()) heights.push_back(static_cast<float>(h));
  return {
      f.columns(), f.rows(), std::move(heights), static_cast<float>(f.spacing_x()), static_cast<float>(f.spacing_z()),
      f.sides()};
}
inline Compound<float> single(const Compound<double>& c) {
  std::vector<Placed<float>> children;
  for (const Placed<double>& child : c.children())
    children.push_back({to_single(child.shape), converted<float>(child.pose)});
  return Compound<float>(std::move(children));
}

/// A user's shape whose support points are computed in double and rounded.
class SingleSupport final : public SupportFunction<float> {
 public:
  explicit SingleSupport(UserConvex<double> shape) : shape_(std::move(shape)) {}
  Vec3f support(const Vec3f& direction) const override {
    return converted<float>(shape_.core_support(converted<double>(direction)));
  }

 private:
  UserConvex<double> shape_;
};
inline UserConvex<float> single(const UserConvex<double>& u) {
  return UserConvex<float>(std::make_shared<SingleSupport>(u));
}

}  // namespace detail

/// A shape with its numbers rounded to float. Throws `InvalidValue` for one that floats cannot hold.
inline Shapef to_single(const Shaped& shape) {
  return shape.visit([&](const auto& c) -> Shapef {
    return {detail::single(c), static_cast<float>(shape.rounding())};
  });
}

/// The shape in the precision that a question is answered in.
template <class T>
Shape<T> in_precision(const Shaped& shape) {
  if constexpr (std::is_same_v<T, double>)
    return shape;
  else
    return to_single(shape);
}

}  // namespace graze::io
