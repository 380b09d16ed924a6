// Contacts of two convex shapes of any kind: the normal from their distance or their separating axes, the points from
// their support faces.
#pragma once

#include <optional>

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/manifold/clip_faces.hpp"
#include "narrow/manifold/features.hpp"

namespace graze {

/// `convex_contacts` of two shapes in order, for pairs without a form of their own and where that has no answer.
template <class T>
T general_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                   Manifold<T>& manifold);

/// The points of two polyhedra by their separating axes (`has_separating_axes`). Returns their signed distance (or,
/// when nothing is within the margin, a lower bound that exceeds it); nothing when the axes do not determine the
/// distance, since the nearest corners or edges have no axis, or when the nearest points are not on the faces.
template <class T>
std::optional<T> polyhedral_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                     T margin, Manifold<T>& manifold);

/// The faces of two flat-sided shapes that meet along an axis, in the frame of A.
struct MeetingFaces {
  Vec3d normal;  ///< unit, from A to B, along the axis
  PlacedFace a, b;
  bool best;        ///< no other axis shows a larger separation
  double distance;  ///< signed, of the rounded shapes along the best axis
  bool apart;       ///< the cores are apart along that axis
  double noise;     ///< rounding of a separation
};

/// The points of two flat-sided shapes whose closest points are known too: these decide whether the faces contain the
/// nearest points.
template <class T>
void contacts_of_faces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                       const MeetingFaces& faces, const Distance<T>& d, Manifold<T>& manifold);

/// Exchanges A and B in a manifold.
template <class T>
void mirror(Manifold<T>& manifold) {
  manifold.normal = -manifold.normal;
  for (ContactPoint<T>& p : manifold.points) p = mirrored(p);
}

}  // namespace graze
