// Contacts of two convex shapes of any kind: their distance or their separating axes give the normal, their support
// faces the points.
#pragma once

#include "graze/query.hpp"
#include "narrow/features.hpp"

namespace graze {

/// `convex_contacts` of two shapes that stand in order, for pairs without a form of their own and where that does not
/// answer; without the axes of an explanation.
template <class T>
T general_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                   Manifold<T>& manifold, Trace* trace);

/// The same contacts with the shapes in each other's place.
template <class T>
void mirror(Manifold<T>& manifold) {
  manifold.normal = -manifold.normal;
  for (ContactPoint<T>& p : manifold.points) p = mirrored(p);
}

}  // namespace graze
