// Boxes, balls and even capsules on a half-space: the support face, each of its corners with its own height, in T.
//
// Guarantee: the distance is that of `distance`, bit for bit, and the lowest corner's of what is not rounded; the names
// of the points are those that the general path gives. Nothing is answered for other shapes.
#pragma once

#include <optional>

#include "graze/query.hpp"
#include "graze/shape/face.hpp"
#include "narrow/add_point.hpp"
#include "narrow/features.hpp"
#include "narrow/pairs/half_space.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace resting {

/// How far straight below a corner of the core's support face the surface lies; `down` is in the body's frame.
template <class C, class T>
T rise(const C&, const Vec3<T>&, T radius, const Face<T>&, std::size_t) {
  return radius;
}
/// Below an end of a capsule's side, which leans, the side may lie, or the other end's ball.
template <class T>
T rise(const Capsule<T>& capsule, const Vec3<T>& down, T radius, const Face<T>& face, std::size_t corner) {
  if (face.vertices.size() == 1) return radius;
  const T length = T(2) * capsule.half_height(), toward_other = corner == 0 ? down.y : -down.y;
  const T steep = down.x * down.x + down.z * down.z;
  T most = radius;
  const T side = radius / std::sqrt(steep), place = side * toward_other;
  if (place >= T(0) && place <= length) most = greatest(most, side);
  const T beside = radius * radius - length * length * steep;
  if (beside >= T(0)) most = greatest(most, std::sqrt(beside) + length * toward_other);
  return most;
}

/// `plane` is the height of the half-space's surface in its own frame.
template <class C, class T>
T contacts(const C& body, T radius, const Pose<T>& pose, T plane, const Pose<T>& plane_pose, T margin,
           Manifold<T>& manifold) {
  const Pose<T> seen = relative(plane_pose, pose);
  const CoreDistance<T> core = half_space_distance(body, seen);
  const T distance = core.distance - (plane + radius);
  const Vec3<T> up = rotate(plane_pose.rotation, core.normal);
  manifold.normal = -up;
  if (!(distance <= margin)) return distance;
  const Vec3<T> down = rotate(conjugate(seen.rotation), -core.normal);
  Face<T> face;
  body.core_face(down, face);
  const T together = tolerance<T> * (body.core_extent() + radius);
  for (std::size_t i = 0; i < face.vertices.size(); ++i) {
    const T lift = rise(body, down, radius, face, i);
    const T apart = transform(seen, face.vertices[i]).y - (plane + lift);
    if (apart > margin) continue;
    const Vec3<T> low = transform(pose, face.vertices[i]) - up * lift;
    add_point<T>({low, low - up * apart, apart, feature_id(vertex_feature(face.ids[i]), face_feature(0))}, together,
                 manifold);
  }
  return distance;
}

}  // namespace resting

/// `b` is the half-space. Fills the manifold as `convex_contacts`, and returns the distance.
template <class T>
std::optional<T> half_space_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                     T margin, Manifold<T>& manifold) {
  if (!b.template as<HalfSpace<T>>()) return std::nullopt;
  const auto contacts = [&](const auto& body) {
    return resting::contacts(body, rounding_radius(body, a.margin()), pose_a, b.margin(), pose_b, margin, manifold);
  };
  if (const auto* ball = a.template as<Sphere<T>>()) return contacts(*ball);
  if (const auto* capsule = a.template as<Capsule<T>>())
    return has_core(*capsule) && capsule->half_height() > T(0) ? std::optional(contacts(*capsule)) : std::nullopt;
  // The corners of a rounded box do not lie straight above its lowest points.
  const auto* box = a.template as<Box<T>>();
  return box && a.margin() == T(0) ? std::optional(contacts(*box)) : std::nullopt;
}

}  // namespace graze
