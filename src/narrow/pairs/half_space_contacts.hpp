// Boxes, triangles, balls and untapered capsules on a half-space: the points that `rest` finds, as a manifold.
//
// Guarantee: the distance is that of `distance`, bit for bit; the points are those that the general path gives, up to
// rounding, under the same names. Nothing is answered for other shapes.
#pragma once

#include <optional>

#include "narrow/batch/half_space_batch.hpp"
#include "narrow/pairs/closed_form.hpp"

namespace graze {

/// Of a body on a half-space: fills the manifold as `convex_contacts`, and returns the distance.
template <class C, class T>
T resting_contacts(const C& body, T margin_body, const Pose<T>& pose_body, T margin_plane, const Pose<T>& pose_plane,
                   T margin, Manifold<T>& manifold) {
  const Rest<T> found = rest(rounded_core(body, margin_body), pose_body, margin_plane, pose_plane, margin);
  manifold.normal = -found.up;
  each_half_space_point<T>(
      static_cast<unsigned>(found.filled), points_together(body, margin_body),
      [&](std::size_t i) { return found.slots[i]; }, [&](const ContactPoint<T>& p) { manifold.points.push_back(p); });
  return found.distance;
}

template <class T>
std::optional<T> own_contacts(const Sphere<T>& ball, T margin_ball, const Pose<T>& pose_ball, const HalfSpace<T>&,
                              T margin_plane, const Pose<T>& pose_plane, T margin, Manifold<T>& manifold) {
  return resting_contacts(ball, margin_ball, pose_ball, margin_plane, pose_plane, margin, manifold);
}

template <class T>
std::optional<T> own_contacts(const Capsule<T>& capsule, T margin_capsule, const Pose<T>& pose_capsule,
                              const HalfSpace<T>&, T margin_plane, const Pose<T>& pose_plane, T margin,
                              Manifold<T>& manifold) {
  if (!has_untapered_side(capsule)) return std::nullopt;
  return resting_contacts(capsule, margin_capsule, pose_capsule, margin_plane, pose_plane, margin, manifold);
}

/// Not of a rounded box, whose corners do not lie straight above its lowest points.
template <class T>
std::optional<T> own_contacts(const Box<T>& box, T margin_box, const Pose<T>& pose_box, const HalfSpace<T>&,
                              T margin_plane, const Pose<T>& pose_plane, T margin, Manifold<T>& manifold) {
  if (margin_box != T(0)) return std::nullopt;
  return resting_contacts(box, margin_box, pose_box, margin_plane, pose_plane, margin, manifold);
}

/// The same of a triangle.
template <class T>
std::optional<T> own_contacts(const Triangle<T>& triangle, T margin_triangle, const Pose<T>& pose_triangle,
                              const HalfSpace<T>&, T margin_plane, const Pose<T>& pose_plane, T margin,
                              Manifold<T>& manifold) {
  if (margin_triangle != T(0)) return std::nullopt;
  return resting_contacts(triangle, margin_triangle, pose_triangle, margin_plane, pose_plane, margin, manifold);
}

}  // namespace graze
