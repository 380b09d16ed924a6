// Contacts of two convex shapes of any kind: their distance or their separating axes give the normal, their support
// faces the points.
#pragma once

#include <optional>

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/manifold/clip_faces.hpp"
#include "narrow/manifold/features.hpp"

namespace graze {

/// `convex_contacts` of two shapes that stand in order, for pairs without a form of their own and where that does not
/// answer.
template <class T>
T general_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                   Manifold<T>& manifold);

/// The points of two polyhedra by their separating axes (`has_separating_axes`). Returns their signed distance (or,
/// when nothing is within the margin, a lower bound that exceeds it); nothing when the axes do not tell the distance,
/// since corners or edges are nearest that no axis belongs to, or when the faces miss what is nearest.
template <class T>
std::optional<T> polyhedral_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                     T margin, Manifold<T>& manifold);

/// The faces of two shapes with flat sides that meet along an axis, in the frame of A.
struct MeetingFaces {
  Vec3d normal;  ///< of the axis, unit, from A to B
  PlacedFace a, b;
  bool best;        ///< no other axis shows a larger separation
  double distance;  ///< signed, of the rounded shapes along the best axis
  bool apart;       ///< the cores are, by that axis
  double noise;     ///< what rounding may do to a separation
};

/// The points of two such shapes whose closest points are known too, which tell where the faces miss what is nearest.
template <class T>
void contacts_of_faces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                       const MeetingFaces& faces, const Distance<T>& d, Manifold<T>& manifold);

/// The same contacts with the shapes in each other's place.
template <class T>
void mirror(Manifold<T>& manifold) {
  manifold.normal = -manifold.normal;
  for (ContactPoint<T>& p : manifold.points) p = mirrored(p);
}

}  // namespace graze
