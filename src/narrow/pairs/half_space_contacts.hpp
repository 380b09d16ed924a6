// Boxes, balls and even capsules on a half-space: the support face, each of its corners with its own height, in T.
//
// Guarantee: the distance is that of `distance`, bit for bit; the points are those that the general path gives, up to
// rounding, under the same names. Nothing is answered for other shapes.
#pragma once

#include <optional>

#include "graze/query.hpp"
#include "graze/shape/face.hpp"
#include "narrow/add_point.hpp"
#include "narrow/features.hpp"
#include "narrow/pairs/half_space.hpp"
#include "narrow/rest_batch.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace resting {

/// A body on a half-space whose surface has the height `plane` in its own frame.
template <class C, class T>
struct Resting {
  const C& body;
  T radius;
  const Pose<T>& pose;
  Pose<T> seen;  ///< from the half-space
  Vec3<T> up;    ///< of the world
  Vec3<T> down;  ///< in the body's frame
  T plane, distance;

  Resting(const C& c, T rounding, const Pose<T>& pose_c, T height, const Pose<T>& plane_pose)
      : body(c), radius(rounding), pose(pose_c), seen(relative(plane_pose, pose_c)), plane(height) {
    const CoreDistance<T> core = half_space_distance(body, seen);
    distance = core.distance - (plane + radius);
    up = rotate(plane_pose.rotation, core.normal);
    down = rotate(conjugate(seen.rotation), -core.normal);
  }
  /// Below a corner of the core, on which the surface lies `rise` straight below.
  ContactPoint<T> below(const Vec3<T>& corner, std::uint32_t id, T rise) const {
    const T apart = seen.translation.y - dot(down, corner) - (plane + rise);
    const Vec3<T> low = transform(pose, corner) - up * rise;
    return {low, low - up * apart, apart, feature_id(vertex_feature(id), face_feature(0))};
  }
  /// Points nearer to each other than this are one.
  T together() const { return tolerance<T> * (body.core_extent() + radius); }
};

template <class T>
void add_points(const Resting<Sphere<T>, T>& ball, T margin, Manifold<T>& manifold) {
  const ContactPoint<T> point = ball.below(ball.body.center(), 0, ball.radius);
  if (point.distance <= margin) manifold.points.push_back(point);
}

/// Both ends of a side that lies, or the lower end.
template <class T>
void add_points(const Resting<Capsule<T>, T>& capsule, T margin, Manifold<T>& manifold) {
  Face<T> face;
  capsule.body.core_face(capsule.down, face);
  const T radius = capsule.radius, length = T(2) * capsule.body.half_height(), along = capsule.down.y;
  const T steep = capsule.down.x * capsule.down.x + capsule.down.z * capsule.down.z;
  for (std::size_t i = 0; i < face.vertices.size(); ++i) {
    T rise = radius;
    if (face.vertices.size() == 2) {
      // Straight below an end of a side that leans may lie the side, or the other end's ball.
      const T side = radius / std::sqrt(steep), toward_other = i == 0 ? along : -along, place = side * toward_other;
      if (place >= T(0) && place <= length) rise = greatest(rise, side);
      const T beside = radius * radius - length * length * steep;
      if (beside >= T(0)) rise = greatest(rise, std::sqrt(beside) + length * toward_other);
    }
    const ContactPoint<T> point = capsule.below(face.vertices[i], face.ids[i], rise);
    if (point.distance <= margin) add_point(point, capsule.together(), manifold);
  }
}

}  // namespace resting

/// Of a body on a half-space: fills the manifold as `convex_contacts`, and returns the distance.
template <class C, class T>
T resting_contacts(const C& body, T margin_body, const Pose<T>& pose_body, T margin_plane, const Pose<T>& pose_plane,
                   T margin, Manifold<T>& manifold) {
  const resting::Resting rests(body, rounding_radius(body, margin_body), pose_body, margin_plane, pose_plane);
  manifold.normal = -rests.up;
  if (rests.distance <= margin) resting::add_points(rests, margin, manifold);
  return rests.distance;
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
  if (!has_core(capsule) || !(capsule.half_height() > T(0))) return std::nullopt;
  return resting_contacts(capsule, margin_capsule, pose_capsule, margin_plane, pose_plane, margin, manifold);
}

/// Not of a rounded box, whose corners do not lie straight above its lowest points.
template <class T>
std::optional<T> own_contacts(const Box<T>& box, T margin_box, const Pose<T>& pose_box, const HalfSpace<T>&,
                              T margin_plane, const Pose<T>& pose_plane, T margin, Manifold<T>& manifold) {
  if (margin_box != T(0)) return std::nullopt;
  const BoxRest<T> found = box_rest(box.half_extents(), pose_box, margin_plane, pose_plane, margin);
  manifold.normal = -found.up;
  each_rest_point<T>(
      static_cast<unsigned>(found.filled), box, [&](std::size_t i) { return found.slots[i]; },
      [&](const ContactPoint<T>& p) { manifold.points.push_back(p); });
  return found.distance;
}

}  // namespace graze
