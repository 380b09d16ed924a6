// Contacts of balls and capsules by their closed forms: one point, without laying faces over each other.
//
// Guarantee: the point of `distance`, bit for bit, under the names that the faces give it. Nothing is answered where the
// faces may give two points (capsules that are about parallel) or where a side has no length: the faces answer then.
#pragma once

#include <optional>

#include "narrow/closed_form.hpp"
#include "narrow/features.hpp"
#include "narrow/outline.hpp"
#include "narrow/pairs/capsule_capsule.hpp"
#include "narrow/pairs/sphere_box.hpp"
#include "narrow/pairs/sphere_capsule.hpp"
#include "narrow/pairs/sphere_sphere.hpp"
#include "shape/rounding.hpp"

namespace graze {

namespace round {

/// B's core in A's frame. The centre of a ball about its own origin does not turn.
template <class T>
PointCore<T> seen_from(const Pose<T>& pose_a, const Sphere<T>& b, const Pose<T>& pose_b) {
  if (b.center() == Vec3<T>{}) return {inverse_transform(pose_a, pose_b.translation)};
  return moved(core_of(b), relative(pose_a, pose_b));
}
template <class T>
SegmentCore<T> seen_from(const Pose<T>& pose_a, const Capsule<T>& b, const Pose<T>& pose_b) {
  return moved(core_of(b), relative(pose_a, pose_b));
}

/// Fills the manifold with the one point there is when that is near enough; `feature` names it. Returns the distance.
template <class T, class Feature>
T filled(const CoreDistance<T>& core, T radius_a, T radius_b, const Pose<T>& pose_a, T margin, Manifold<T>& manifold,
         bool swapped, const Feature& feature) {
  const T distance = core.distance - (radius_a + radius_b);
  const Vec3<T> normal = rotate(pose_a.rotation, core.normal);
  manifold.normal = swapped ? -normal : normal;
  if (!(distance <= margin)) return distance;
  const Distance<T> d = finished(core, radius_a, radius_b, pose_a);
  manifold.points.push_back({swapped ? d.b : d.a, swapped ? d.a : d.b, distance, feature(), T(0.5)});
  return distance;
}

/// A capsule's segment as a face seen along a unit vector: its side where that leans little from the normal plane of the
/// axis, else an end.
template <class T>
struct SegmentFace {
  bool side;
  bool top;          ///< the end, where it is no side
  T length_squared;  ///< of the side as seen
  T beside_squared;  ///< the distance of the point in question from the nearer end, as seen
  bool nearer_top;

  SegmentFace(const Segment<T>& segment, const Vec3<T>& outward, const Vec3<T>& point) {
    const Vec3<T> axis = segment.b - segment.a;
    const T whole = graze::length_squared(axis), up = dot(axis, outward), limit = face_lean<T> * face_lean<T> * whole;
    side = up * up <= limit;
    top = up > T(0);
    const T seen = T(1) - up * up / whole, from_a = dot(point - segment.a, axis), from_b = whole - from_a;
    nearer_top = from_b < from_a;
    const T beside = nearer_top ? from_b : from_a;
    length_squared = whole * seen;
    beside_squared = beside * beside / whole * seen;
  }

  /// `near_squared`: how near an end counts as that.
  std::uint32_t feature(T near_squared) const {
    if (!side) return vertex_feature(top ? 1 : 0);
    return beside_squared <= near_squared ? vertex_feature(nearer_top ? 1 : 0) : edge_feature(0, 1);
  }
};

template <class T>
inline constexpr T near_end = static_cast<T>(same_place* same_place);

template <class T>
bool has_length(const Capsule<T>& capsule) {
  return !capsule.tapered() && capsule.half_height() > T(0);
}

/// What of a box's face that leans least from `outward` the point on it lies on, as both are seen along `outward`.
template <class T>
std::uint32_t box_feature(const Vec3<T>& half, const Vec3<T>& outward, const Vec3<T>& point) {
  const Vec3<T> n = abs(outward);
  const std::size_t major = n.x >= n.y && n.x >= n.z ? 0 : n.y >= n.z ? 1 : 2;
  const std::size_t u = major == 2 ? 0 : major + 1, v = major == 0 ? 2 : major - 1;
  const T seen_u = T(1) - n[u] * n[u], seen_v = T(1) - n[v] * n[v], facing = n[major] * n[major];
  const T near =
      T(4) * near_end<T> * least(half[u] * half[u] * seen_u, half[v] * half[v] * seen_v);  // squared, as all of these
  const T beside_u = half[u] - std::abs(point[u]), beside_v = half[v] - std::abs(point[v]);
  // The rim across u runs along v.
  const bool on_u = !(beside_u > T(0)) || beside_u * beside_u * facing <= near * seen_v;
  const bool on_v = !(beside_v > T(0)) || beside_v * beside_v * facing <= near * seen_u;
  const auto bit = [](bool positive, std::size_t axis) { return std::uint32_t{positive} << axis; };
  const std::uint32_t front = bit(outward[major] >= T(0), major);
  const std::uint32_t at_u = bit(point[u] > T(0), u), at_v = bit(point[v] > T(0), v);
  if (on_u && on_v) return vertex_feature(front | at_u | at_v);
  if (on_u) return edge_feature(front | at_u, front | at_u | bit(true, v));
  if (on_v) return edge_feature(front | at_v, front | at_v | bit(true, u));
  return face_feature(static_cast<std::uint32_t>(2 * major) + (outward[major] >= T(0) ? 1 : 0));
}

}  // namespace round

/// What touches of two balls, and where between their points the radius-weighted one lies.
inline constexpr std::uint32_t ball_feature = feature_id(vertex_feature(0), vertex_feature(0));
template <class T>
T ball_weight(T radius_a, T radius_b) {
  return radius_a + radius_b > T(0) ? radius_a / (radius_a + radius_b) : T(0.5);
}

/// Of two shapes in the order of the list; see above.
template <class T>
std::optional<T> round_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                                T margin, Manifold<T>& manifold) {
  const auto* capsule_b = b.template as<Capsule<T>>();
  if (capsule_b && !round::has_length(*capsule_b)) return std::nullopt;
  if (const auto* ball = a.template as<Sphere<T>>()) {
    const T ra = rounding_radius(*ball, a.margin());
    const std::uint32_t center = vertex_feature(0);
    if (const auto* other = b.template as<Sphere<T>>()) {
      const T rb = rounding_radius(*other, b.margin());
      const BallCores<T> balls(ball->center(), pose_a, other->center(), pose_b);
      const Distance<T> d = balls.distance(core_distance(balls.a, balls.b), ra, rb);
      manifold.normal = d.normal;
      if (d.distance <= margin) manifold.points.push_back({d.a, d.b, d.distance, ball_feature, ball_weight(ra, rb)});
      return d.distance;
    }
    if (capsule_b) {
      const SegmentCore<T> segment = round::seen_from(pose_a, *capsule_b, pose_b);
      const auto core = core_distance(core_of(*ball), segment);
      return round::filled(core, ra, rounding_radius(*capsule_b, b.margin()), pose_a, margin, manifold, false, [&] {
        const round::SegmentFace<T> face(segment.segment, -core.normal, core.b);
        return feature_id(center, face.feature(round::near_end<T> * face.length_squared));
      });
    }
    if (const auto* box = b.template as<Box<T>>()) {
      const Vec3<T>& half_extents = box->half_extents();
      if (!(least(half_extents.x, least(half_extents.y, half_extents.z)) > T(0))) return std::nullopt;
      const auto core = core_distance(core_of(*box), round::seen_from(pose_b, *ball, pose_a));
      return round::filled(core, b.margin(), ra, pose_b, margin, manifold, true,
                           [&] { return feature_id(center, round::box_feature(half_extents, core.normal, core.a)); });
    }
    return std::nullopt;
  }
  const auto* capsule_a = a.template as<Capsule<T>>();
  if (!capsule_a || !capsule_b || !round::has_length(*capsule_a)) return std::nullopt;
  const SegmentCore<T> segment_a = core_of(*capsule_a), segment_b = round::seen_from(pose_a, *capsule_b, pose_b);
  const auto core = core_distance(segment_a, segment_b);
  const T ra = rounding_radius(*capsule_a, a.margin()), rb = rounding_radius(*capsule_b, b.margin());
  const round::SegmentFace<T> face_a(segment_a.segment, core.normal, core.a),
      face_b(segment_b.segment, -core.normal, core.b);
  if (face_a.side && face_b.side) {
    const Vec3<T> along_a = segment_a.segment.b - segment_a.segment.a,
                  along_b = segment_b.segment.b - segment_b.segment.a;
    const T across = dot(cross(along_a, along_b), core.normal);
    // Twice what makes two sides a face.
    if (across * across <= T(4) * face_lean<T> * face_lean<T> * face_a.length_squared * face_b.length_squared)
      return std::nullopt;
  }
  const T infinite = std::numeric_limits<T>::infinity();
  const T shorter =
      least(face_a.side ? face_a.length_squared : infinite, face_b.side ? face_b.length_squared : infinite);
  const T near = round::near_end<T> * shorter;
  return round::filled(core, ra, rb, pose_a, margin, manifold, false,
                       [&] { return feature_id(face_a.feature(near), face_b.feature(near)); });
}

}  // namespace graze
