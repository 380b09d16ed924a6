// The bounds of what a hierarchy holds, under a pose, without a look at every piece.
#pragma once

#include "graze/pose.hpp"
#include "shape/hierarchy.hpp"

namespace graze {

/// The bounds of all pieces, each of which has `bounds_of(piece)` in the frame that the pose leads to; but for a few
/// roundings of the largest number involved. Six descents, one a side.
template <class Hierarchy, class T, class BoundsOf>
Aabb<T> placed_bounds(const Hierarchy& hierarchy, const Pose<T>& pose, const BoundsOf& bounds_of) {
  const Vec3<T>& t = pose.translation;
  if (pose.rotation == Quat<T>{}) return {hierarchy.bounds().lower + t, hierarchy.bounds().upper + t};
  const Mat3<T> rotation = rotation_matrix(pose.rotation);
  Aabb<T> all = Aabb<T>::empty();
  // What would move a side by rounding alone is not looked at: of a face that lies in the side, one piece is enough.
  const T size = greatest(max_abs(hierarchy.bounds().lower), max_abs(hierarchy.bounds().upper)) + max_abs(t);
  const T least_gain = T(4) * std::numeric_limits<T>::epsilon() * size;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto merge = [&](std::uint32_t piece) { all = merged(all, bounds_of(piece)); };
    visit(
        hierarchy, PlaneQuestion<T>{rotation.row[i], -t[i]}, [&] { return all.lower[i] - least_gain; }, merge);
    visit(
        hierarchy, PlaneQuestion<T>{-rotation.row[i], t[i]}, [&] { return -all.upper[i] - least_gain; }, merge);
  }
  return all;
}

}  // namespace graze
