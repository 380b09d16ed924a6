// Contacts of balls and capsules with a mesh or height field that its edges refuse at once.
//
// A round body among small triangles meets most of them at an edge that the neighbour rises above: its own contact
// there is a ghost. What such a body stands on lies below its centre or axis, so that a refused contact has nothing to
// be laid along the triangle's face, and `settle_normal` (ghost_contacts.hpp) would leave it without points after a
// search.
//
// Guarantee: what is refused here has no points there. Constant time, nothing is searched.
#pragma once

#include <optional>

#include "composite/internal_edges/face_contact.hpp"
#include "composite/internal_edges/voronoi_neighbours.hpp"
#include "composite/leaves.hpp"
#include "composite/triangle_pair.hpp"
#include "graze/contact.hpp"
#include "graze/geometry.hpp"

namespace graze {

/// A mesh or height field and a ball or untapered capsule that meets it.
template <class T>
class SphereCapsuleOnSurface {
 public:
  /// Empty for another body.
  static std::optional<SphereCapsuleOnSurface> of(const Shape<T>& surface, const Pose<T>& surface_pose,
                                                  const Shape<T>& body, const Pose<T>& body_pose) {
    const auto in_frame = [&](const Vec3<T>& p) { return inverse_transform(surface_pose, transform(body_pose, p)); };
    if (const auto* ball = body.template as<Sphere<T>>())
      return SphereCapsuleOnSurface(surface, surface_pose, {in_frame(ball->center()), in_frame(ball->center())});
    const auto* capsule = body.template as<Capsule<T>>();
    if (!capsule || capsule->tapered()) return std::nullopt;
    const T h = capsule->half_height();
    return SphereCapsuleOnSurface(surface, surface_pose, {in_frame({T(0), -h, T(0)}), in_frame({T(0), h, T(0)})});
  }

  /// Whether the contact of the body with a triangle is known to be a ghost: it stands on an edge above which the
  /// triangle beyond that edge rises, and no place of the core lies over the face.
  bool is_ghost(std::uint32_t triangle, const Manifold<T>& manifold, bool surface_is_a) const {
    const Vec3<T> touched =
        standing_point<T>(manifold.points, surface_is_a ? &ContactPoint<T>::a : &ContactPoint<T>::b);
    const Vec3<T> point = inverse_transform(pose_, touched);
    const Vec3<T> outward = rotate(conjugate(pose_.rotation), surface_is_a ? manifold.normal : -manifold.normal);
    const T noise = place_noise(touched, point);
    return is_beside_face(triangle, outward, noise) && rises_across_edge(surface_, triangle, point, outward, noise);
  }

 private:
  SphereCapsuleOnSurface(const Shape<T>& surface, const Pose<T>& pose, const Segment<T>& core)
      : surface_(surface), pose_(pose), core_(core) {}

  /// Whether a contact is none of a triangle's face, and the whole core beyond one of its edges.
  bool is_beside_face(std::uint32_t triangle, const Vec3<T>& outward, T at_place) const {
    Corners<T> corners;
    with_surface(surface_, [&](const auto& data) { corners = data.triangle(triangle); });
    const Vec3<T> face = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (length_squared(cross(face, outward)) <= same_direction<T> * same_direction<T> * length_squared(face))
      return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<T> edge = corners[(i + 1) % 3] - corners[i], away = cross(edge, face);
      const T noise = (coordinate_noise(max_abs(edge)) + at_place) * max_abs(away);
      if (dot(core_.a - corners[i], away) > noise && dot(core_.b - corners[i], away) > noise) return true;
    }
    return false;
  }

  const Shape<T>& surface_;
  const Pose<T>& pose_;
  Segment<T> core_;  ///< its axis, or its centre twice; in the surface's frame
};

}  // namespace graze
