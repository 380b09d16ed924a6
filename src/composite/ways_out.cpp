#include "composite/ways_out.hpp"

#include "composite/solid.hpp"
#include "graze/geometry.hpp"
#include "narrow/general.hpp"
#include "narrow/pair_table.hpp"

namespace graze {

namespace {

/// A half-space in the place of a triangle.
template <class T>
Pose<T> plane_of(const Part<T>& triangle) {
  const auto& corners = *triangle.shape.template as<Triangle<T>>();
  const Vec3<T> u = corners.point(1) - corners.point(0), v = corners.point(2) - corners.point(0);
  const Vec3<T> along = normalized(u), up = normalized(cross(along, v), any_perpendicular(along));
  const Quat<T> rotation = rotation_quaternion(Mat3<T>::from_columns(cross(up, along), up, along));
  return {transform(triangle.pose, corners.point(0)), triangle.pose.rotation * rotation};
}

}  // namespace

template <class T>
auto WaysOut<T>::way_of(const Part<T>& body, const Part<T>& triangle) -> Way& {
  const Vec3<T> middle = bounds(body.shape, body.pose).center();
  for (Way& way : ways_)
    if (way.middle == middle && way.solid == triangle.solid) return way;
  const bool inside = encloses(*triangle.solid, inverse_transform(in_double(triangle.pose), converted<double>(middle)));
  Way& way = ways_.emplace_back();
  way.middle = middle;
  way.solid = triangle.solid;
  way.inside = inside;
  return way;
}

template <class T>
bool WaysOut<T>::leads_out(const Part<T>& body, const Part<T>& triangle, bool body_is_a, T margin) {
  if (body.shape.template as<HalfSpace<T>>() || body.shape.template as<Triangle<T>>()) return false;
  Way& way = way_of(body, triangle);
  if (!way.inside) return false;
  const Shape<T> half_space = HalfSpace<T>();
  const Pose<T> plane = plane_of(triangle);
  Manifold<T> manifold;
  const T distance = body_is_a ? convex_contacts(body.shape, body.pose, half_space, plane, margin, manifold)
                               : convex_contacts(half_space, plane, body.shape, body.pose, margin, manifold);
  if (!(distance > way.distance)) return true;
  way.distance = distance;
  manifold.piece_a = body_is_a ? body.number : triangle.number;
  manifold.piece_b = body_is_a ? triangle.number : body.number;
  way.manifold = manifold;
  way.leaves = body_is_a ? LeafPair{body.leaf, triangle.leaf} : LeafPair{triangle.leaf, body.leaf};
  return true;
}

template class WaysOut<float>;
template class WaysOut<double>;

}  // namespace graze
