// The bounds of the pieces of a hierarchy under a pose, without a look at every piece.
#pragma once

#include "graze/pose.hpp"
#include "shape/hierarchy.hpp"

namespace graze {

/// The share of the whole by which the bounds of many pieces may be too wide on each side: exact bounds would take a
/// look at thousands of triangles of a smooth surface, a millisecond for a million in place of some microseconds.
inline constexpr double loose_bounds = 1.0 / 128;

/// The bounds of all pieces, each of which has `bounds_of(piece)` in the frame that the pose leads to. They contain the
/// pieces, but for a few roundings of the largest number involved, and are as tight as can be for up to `few` pieces or
/// without a turn. Six descents, one a side.
template <class Hierarchy, class T, class BoundsOf>
Aabb<T> placed_bounds(const Hierarchy& hierarchy, const Pose<T>& pose, const BoundsOf& bounds_of) {
  constexpr std::size_t few = 256;
  const Vec3<T>& t = pose.translation;
  if (pose.rotation == Quat<T>{}) return {hierarchy.bounds().lower + t, hierarchy.bounds().upper + t};
  const Mat3<T> rotation = rotation_matrix(pose.rotation);
  Aabb<T> all = Aabb<T>::empty();
  // Pieces that would move a side by rounding alone are not looked at: of a face that lies in the side, one piece is
  // enough. Nor, among many, are those that would move it by little: the side is moved by as much instead.
  const T size = greatest(max_abs(hierarchy.bounds().lower), max_abs(hierarchy.bounds().upper)) + max_abs(t);
  const T rounding = T(4) * std::numeric_limits<T>::epsilon() * size;
  const Vec3<T> extent = hierarchy.bounds().extent();
  const T loose = hierarchy.size() > few ? static_cast<T>(loose_bounds) * max_abs(extent) : T(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto merge = [&](std::uint32_t piece) { all = merged(all, bounds_of(piece)); };
    visit(
        hierarchy, PlaneQuestion<T>{rotation.row[i], -t[i]}, [&] { return all.lower[i] - rounding - loose; }, merge);
    visit(
        hierarchy, PlaneQuestion<T>{-rotation.row[i], t[i]}, [&] { return -all.upper[i] - rounding - loose; }, merge);
  }
  return inflated(all, loose);
}

}  // namespace graze
