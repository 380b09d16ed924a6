// Contacts of shapes that rest on half-spaces: of one pair, and of many by the kernel for them.
//
// Guarantee: for each pair the answer of `convex_contacts`, bit for bit.
#pragma once

#include <algorithm>
#include <bit>

#include "narrow/batch/box_batch.hpp"
#include "narrow/manifold/add_point.hpp"
#include "narrow/pairs/box_half_space.hpp"
#include "narrow/pairs/sphere_capsule_half_space.hpp"
#include "narrow/pairs/triangle_half_space.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// Distance within which two contact points of a body are one; zero for bodies without points so close.
template <class T>
T merge_distance(const Sphere<T>&, T) {
  return T(0);
}
template <class T>
T merge_distance(const Capsule<T>& capsule, T margin) {
  const T most_merged = tolerance<T> * (capsule.core_extent() + rounding_radius(capsule, margin));
  return T(2) * capsule.half_height() > most_merged ? T(0) : most_merged;
}
template <class T>
T merge_distance(const Box<T>& box, T) {
  const Vec3<T>& half = box.half_extents();
  const T most_merged = tolerance<T> * length(half);
  return least(half.x, least(half.y, half.z)) > most_merged ? T(0) : most_merged;
}

template <class T>
T merge_distance(const Triangle<T>& triangle, T) {
  const T most_merged = tolerance<T> * triangle.core_extent();
  const auto side = [&](std::size_t i, std::size_t j) { return length(triangle.point(i) - triangle.point(j)); };
  return least(side(0, 1), least(side(1, 2), side(2, 0))) > T(2) * most_merged ? T(0) : most_merged;
}

/// Calls `f(point)` for the points in the slots of one pair, with the body as A and the half-space as B, leaving out
/// the later of two at one place. `slot(i)` returns the i-th slot; `most_merged` is that of `merge_distance`.
template <class T, class Slot, class F>
void each_half_space_point(unsigned filled, T most_merged, const Slot& slot, const F& f) {
  const auto point = [&](std::size_t i) {
    const typename Rest<T>::Slot from = slot(i);
    return ContactPoint<T>{from.of_body, from.of_plane, from.distance,
                           feature_id(vertex_feature(static_cast<std::uint32_t>(from.corner)), face_feature(0))};
  };
  if (most_merged == T(0)) [[likely]] {
    for (; filled != 0; filled &= filled - 1) f(point(static_cast<std::size_t>(std::countr_zero(filled))));
    return;
  }
  Manifold<T> manifold;
  for (; filled != 0; filled &= filled - 1)
    add_point(point(static_cast<std::size_t>(std::countr_zero(filled))), most_merged, manifold);
  for (const ContactPoint<T>& p : manifold.points) f(p);
}

/// The points of one of the pairs of a block, in the caller's order of the two shapes: half-space first where `turned`.
template <class T>
struct HalfSpacePoints {
  const HalfSpaceBlock<T>& block;
  std::size_t pair;
  T most_merged;
  bool turned;

  /// Unit, from the first shape to the second.
  Vec3<T> normal() const {
    const Vec3<T> up{block.up[0][pair], block.up[1][pair], block.up[2][pair]};
    return turned ? up : -up;
  }
  /// Appends the points to `points` (of contact points or of types that begin with one) and returns their number.
  template <class Points>
  std::size_t append(Points& points) const {
    const std::size_t first = points.size();
    const auto at = [&](const auto& columns) { return Vec3<T>{columns[0][pair], columns[1][pair], columns[2][pair]}; };
    each_half_space_point<T>(
        static_cast<unsigned>(block.filled[pair]), most_merged,
        [&](std::size_t i) {
          const auto& slot = block.slots[i];
          return typename Rest<T>::Slot{at(slot.of_body), at(slot.of_plane), slot.distance[pair], slot.corner[pair]};
        },
        [&](const ContactPoint<T>& p) { points.push_back({turned ? mirrored(p) : p}); });
    return points.size() - first;
  }
};

/// Finds the contacts of pairs of a body A, as the kernels take it, and a plain half-space. Calls, in order, `apart(i)`
/// for those further apart than their margins, and `touching(i, distance, points)` with `HalfSpacePoints` for the
/// others. `turned`: the half-space is the caller's first shape.
template <class A, class T, class Apart, class Touching>
void visit_half_space_contacts(const PairRef<T>* pairs, std::size_t count, bool turned, const Apart& apart,
                               const Touching& touching) {
  const auto kernel = GRAZE_KERNEL(chosen_isa(), half_space_slots<A, T>);
  HalfSpaceBlock<T> block;
  for (std::size_t first = 0; first < count; first += block_pairs) {
    const std::size_t size = std::min(block_pairs, count - first);
    kernel(pairs + first, size, block);
    for (std::size_t k = 0; k < size; ++k) {
      const PairRef<T>& pair = pairs[first + k];
      if (!(block.distance[k] <= pair.margin))
        apart(first + k);
      else
        touching(first + k, block.distance[k],
                 HalfSpacePoints<T>{block, k, merge_distance(*static_cast<const A*>(pair.a), T(0)), turned});
    }
  }
}

}  // namespace graze
