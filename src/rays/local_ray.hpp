// A ray in the frame of what it is cast at, and a hit there.
//
// Guarantee: double, whichever scalar the shapes have; the direction is of unit length, so that t is a length.
#pragma once

#include <optional>

#include "graze/lines.hpp"
#include "graze/pose.hpp"
#include "narrow/core/relative_frame.hpp"

namespace graze::rays {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// How large coordinates and lengths may be: sums of a few do not overflow in `T`, nor products of two in double.
template <class T>
constexpr double longest = std::is_same_v<T, float> ? 1e37 : 1e150;

/// Whether a ray can hit: its origin, and its direction's square, in whichever unit that has one. No NaN can.
template <class T, class S>
auto usable(const Vec3<S>& origin, const S& squared) {
  const Vec3<S> reach = abs(origin);
  const S most(longest<T>), most_squared(std::numeric_limits<double>::max());
  return (reach.x <= most) & (reach.y <= most) & (reach.z <= most) & (squared > S(0)) & (squared <= most_squared);
}

/// How far a ray is followed; less than zero when it cannot hit.
template <class T>
double end_of(T length) {
  return length >= T(0) ? least(static_cast<double>(length), longest<T>) : -1;
}
/// `direction` is the ray's, of any length that has a square.
template <class T>
double end_of(const Ray<T>& ray, const Vec3d& direction, T length) {
  return usable<T>(converted<double>(ray.origin), length_squared(direction)) ? end_of(length) : -1;
}

/// The points origin + t direction with begin <= t <= end.
struct LocalRay {
  Vec3d origin, direction;
  double begin, end;
  /// What rounding of the caller's numbers moves the ray by: how thick things without thickness are taken to be.
  double blur;

  Vec3d at(double t) const { return origin + direction * t; }
};

/// The point is carried along, since `t` cannot have its digits when the ray comes from afar.
struct LocalHit {
  double t;
  Vec3d point, normal;
};

using MaybeHit = std::optional<LocalHit>;

/// A ray whose origin is its point nearest to `center`, and how far that was moved. Squares of coordinates then are of
/// the order of the shape and not of the distance that the ray comes from. The ray's end has no part in it: where a ray
/// hits does not depend, by rounding, on how far it was to be followed.
struct Recentered {
  LocalRay ray;
  double shift;

  MaybeHit restored(MaybeHit hit) const {
    if (hit) hit->t += shift;
    return hit;
  }
};
inline Recentered recentered(const LocalRay& ray, const Vec3d& center) {
  const double shift = greatest(dot(center - ray.origin, ray.direction), ray.begin);
  return {{ray.at(shift), ray.direction, ray.begin - shift, ray.end - shift, ray.blur}, shift};
}

/// A frame that stands in another. A matrix, since a ray and its hit are turned four times.
struct Frame {
  Vec3d translation;
  Mat3d rotation;

  Vec3d out(const Vec3d& direction) const { return rotation * direction; }
  Vec3d in(const Vec3d& direction) const { return transposed_times(rotation, direction); }
};

/// A rotation to double's precision: a quaternion of floats is of unit length only in float, and lengths would change.
template <class T>
Frame frame_of(const Pose<T>& pose) {
  return {converted<double>(pose.translation), rotation_of(converted<double>(pose.rotation))};
}

/// The frame `b` in the one that `a` stands in.
inline Frame compose(const Frame& a, const Frame& b) {
  return {a.translation + a.out(b.translation), a.rotation * b.rotation};
}

/// The same ray seen from a frame that stands in the present one.
inline LocalRay seen_from(const Frame& frame, const LocalRay& ray) {
  return {frame.in(ray.origin - frame.translation), frame.in(ray.direction), ray.begin, ray.end, ray.blur};
}

inline LocalHit hit_at(const LocalRay& ray, double t, const Vec3d& normal) { return {t, ray.at(t), normal}; }
/// Of a ray that begins inside.
inline LocalHit hit_inside(const LocalRay& ray) { return hit_at(ray, ray.begin, -ray.direction); }

/// The hit of a solid that the ray is in from `enter` to `leave` (empty when `enter` is not the lesser).
inline MaybeHit entered(const LocalRay& ray, double enter, double leave, const Vec3d& normal) {
  if (!((enter <= leave) & (leave >= ray.begin) & (enter <= ray.end))) return {};
  if (enter <= ray.begin) return hit_inside(ray);
  return hit_at(ray, enter, normal);
}

/// `normal` or its opposite, whichever faces the ray.
inline Vec3d against(const LocalRay& ray, const Vec3d& normal) {
  return dot(normal, ray.direction) > 0 ? -normal : normal;
}

/// The normal without the little by which rounding may turn it along the ray where that grazes; `ray` of any length.
inline Vec3d opposing(const Vec3d& normal, const Vec3d& ray) {
  if (!(dot(normal, ray) > 0)) return normal;
  const Vec3d direction = normalized(ray);
  return normalized(normal - direction * dot(normal, direction), -direction);
}

/// The real roots of a t^2 + 2 b t + c, lesser first; of a linear one, both the same. Each by the formula that does not
/// cancel (Higham 2002, "Accuracy and stability of numerical algorithms", section 1.8).
struct Roots {
  bool real;
  double first, second;
};
inline Roots roots(double a, double b, double c) {
  const double under = b * b - a * c;
  if (!(under >= 0)) return {false, 0, 0};
  const double q = -(b + std::copysign(std::sqrt(under), b));
  if (q == 0) return {a != 0, 0, 0};  // b = c = 0, or a constant
  const double one = c / q;
  if (a == 0) return {true, one, one};
  const double other = q / a;
  return {true, least(one, other), greatest(one, other)};
}

}  // namespace graze::rays
