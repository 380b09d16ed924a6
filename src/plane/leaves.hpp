// Compounds taken apart into convex shapes in place.
//
// Guarantee: visits every convex shape of a shape once, in order; `piece` is the number of the outermost compound's
// child.
#pragma once

#include "plane/core.hpp"

namespace graze::plane {

/// Calls `f(core, pose, extent, piece)`. The pose is in double and of unit length there, so that a float's rounding of
/// it does not lengthen what it turns.
template <class T, class F>
void for_each_leaf(const Shape<T>& shape, const Pose2d& pose, std::uint32_t piece, bool outermost, F&& f) {
  if (const auto* compound = shape.template as<Compound<T>>()) {
    std::uint32_t number = 0;
    for (const Placed<T>& child : compound->children()) {
      const Pose2d own{converted<double>(child.pose.translation), normalized(converted<double>(child.pose.rotation))};
      for_each_leaf(child.shape, compose(pose, own), outermost ? number : piece, false, f);
      ++number;
    }
    return;
  }
  f(convex_core(shape), pose, double(extent(shape)), piece);
}
template <class T, class F>
void for_each_leaf(const Shape<T>& shape, const Pose2<T>& pose, F&& f) {
  const Pose2d wide{converted<double>(pose.translation), normalized(converted<double>(pose.rotation))};
  for_each_leaf(shape, wide, 0, true, f);
}

/// Two convex shapes in place, one of each body.
template <class T>
struct LeafPair {
  const Core<T>&a, &b;
  const Pose2d &pose_a, &pose_b;
  double extent_a, extent_b;
  std::uint32_t piece_a, piece_b;

  /// Whether both are bounded.
  bool bounded() const { return a.kind != CoreKind::half_plane && b.kind != CoreKind::half_plane; }
  /// A lower bound of their distance, by the discs around them. None where one is unbounded.
  double apart() const {
    if (!bounded()) return -std::numeric_limits<double>::infinity();
    return length(pose_b.translation - pose_a.translation) * (1 - 1e-15) - (extent_a + extent_b) * (1 + 1e-15);
  }
  double size() const { return greatest(extent_a, extent_b); }
};

/// Calls `f` with every pair of convex shapes of two bodies.
template <class T, class F>
void for_each_pair(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, F&& f) {
  for_each_leaf(a, pose_a, [&](const Core<T>& core_a, const Pose2d& at_a, double extent_a, std::uint32_t piece_a) {
    for_each_leaf(b, pose_b, [&](const Core<T>& core_b, const Pose2d& at_b, double extent_b, std::uint32_t piece_b) {
      f(LeafPair<T>{core_a, core_b, at_a, at_b, extent_a, extent_b, piece_a, piece_b});
    });
  });
}

}  // namespace graze::plane
