// Any shape against any shape: composites descend to convex pieces, and the table of pairs answers for those.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"

namespace graze {

/// The bound up to which pieces are visited so that none is left out whose distance rounds to `limit`.
template <class T>
T just_above(T limit) {
  return std::nextafter(limit, std::numeric_limits<T>::infinity());
}

/// With a limit, shapes that are further apart may be answered as infinitely far.
template <class T>
Distance<T> any_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                         T limit = std::numeric_limits<T>::infinity());

/// Whether the shapes are no further apart than `limit` >= 0.
template <class T>
bool any_within(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T limit);

/// Appends every pair of convex pieces that is no further apart than `margin` >= 0.
template <class T>
void any_near_pieces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                     std::vector<PieceDistance<T>>& out);

template <class T>
bool any_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// The shapes that stand still beside either one and may continue its surface: contacts that only the seams make are
/// settled as those between the pieces of one shape are.
template <class T, class PlacedRef = graze::PlacedRef<T>>
struct Surroundings {
  std::span<const PlacedRef> of_a = {}, of_b = {};

  bool empty() const { return of_a.empty() && of_b.empty(); }
};

/// Appends manifolds; returns the smallest signed distance found within the margin, or infinity. `singly`: each
/// triangle is answered by itself and not across lanes, which a test holds the lanes against.
template <class T>
T any_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
               Manifolds<T>& manifolds, const Surroundings<T>& beside = {}, bool singly = false);

}  // namespace graze
