// Contacts by the general path, whatever routine of their own a pair has: what such routines are held against.
#pragma once

#include "narrow/general_contacts.hpp"
#include "narrow/pair_table.hpp"
#include "narrow/sat/polyhedral_pair.hpp"

namespace graze::testing {

/// As `contacts` of two convex shapes.
template <class T>
bool contacts_in_general(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                         Manifolds<T>& manifolds) {
  if (against_order(a, b)) {
    const bool touch = contacts_in_general(b, pose_b, a, pose_a, margin, manifolds);
    if (!manifolds.empty()) mirror(manifolds.back());
    return touch;
  }
  Manifold<T> manifold;
  std::optional<T> distance;
  if (has_separating_axes(a, b)) distance = polyhedral_contacts(a, pose_a, b, pose_b, margin, manifold);
  if (!distance) distance = general_contacts(a, pose_a, b, pose_b, margin, manifold);
  if (!manifold.points.empty()) manifolds.push_back(manifold);
  return *distance <= T(0);
}

}  // namespace graze::testing
