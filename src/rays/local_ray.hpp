// A ray in the frame of a shape, and a hit there; or one of each in every lane.
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

/// Largest coordinate and length: sums of a few do not overflow in `T`, nor products of two in double.
template <class T>
constexpr double longest = std::is_same_v<T, float> ? 1e37 : 1e150;

/// Whether a ray can hit, by its origin and its direction's square, in any unit in which that is finite and not zero.
/// NaN fails.
template <class T, class S>
auto usable(const Vec3<S>& origin, const S& squared) {
  const Vec3<S> reach = abs(origin);
  const S most(longest<T>), most_squared(std::numeric_limits<double>::max());
  return (reach.x <= most) & (reach.y <= most) & (reach.z <= most) & (squared > S(0)) & (squared <= most_squared);
}

/// The length up to which a ray is followed, so far that a hit counts whose distance is `length` once it is rounded to
/// `T`; less than zero when it cannot hit.
template <class T>
double end_of(T length) {
  constexpr double rounding = 2 * static_cast<double>(std::numeric_limits<T>::epsilon());
  return length >= T(0) ? least(static_cast<double>(length) * (1 + rounding), longest<T>) : -1;
}
/// The length up to which a ray is followed. `direction` is the ray's, of any length that has a square.
template <class T>
double end_of(const Ray<T>& ray, const Vec3d& direction, T length) {
  return usable<T>(converted<double>(ray.origin), length_squared(direction)) ? end_of(length) : -1;
}

/// The result of comparing two numbers: `bool`, or a truth value a lane.
template <class S>
using MaskOf = decltype(S() < S());

/// Whether a condition holds for a single ray, so that excluded parts need not be computed. Never for lanes: some of
/// them nearly always need these.
template <class M>
[[gnu::always_inline]] inline bool alone(const M& condition) {
  if constexpr (std::is_integral_v<M>)
    return condition != 0;
  else
    return false;
}

/// The points origin + t direction with begin <= t <= end, of one ray or of one in each lane.
template <class S>
struct LocalRayOf {
  Vec3<S> origin, direction;
  S begin, end;
  /// Displacement of the ray by rounding of the caller's numbers: the thickness given to things without thickness.
  S blur;

  [[gnu::always_inline]] Vec3<S> at(const S& t) const { return origin + direction * t; }
};
using LocalRay = LocalRayOf<double>;

/// A hit. The point is carried along, since `t` cannot have its digits when the ray comes from afar.
struct LocalHit {
  double t;
  Vec3d point, normal;
};

using MaybeHit = std::optional<LocalHit>;

/// The result of a closed form, for one ray or for one in each lane. The numbers are meaningless where `hit` is not
/// set. Where `undecided` is set the closed form has no answer, and code for one ray has to give it.
template <class S>
struct FoundHit {
  MaskOf<S> hit{};
  S t{};
  Vec3<S> point{}, normal{};
  MaskOf<S> undecided{};

  explicit(false) operator MaybeHit() const requires(std::is_same_v<S, double>) {
    if (!hit) return {};
    return LocalHit{t, point, normal};
  }
};

/// A ray whose origin is its point nearest to `center`, and the shift of the origin. Squares of coordinates then are of
/// the order of the shape and not of the distance that the ray comes from. The ray's end has no part in it: rounding of
/// a hit does not depend on the length up to which the ray is followed, and the end is so much further that the hit is
/// found again by a ray that ends there.
template <class S>
struct RecenteredOf {
  LocalRayOf<S> ray;
  S shift;

  [[gnu::always_inline]] FoundHit<S> restored(FoundHit<S> found) const {
    found.t = found.t + shift;
    return found;
  }
  MaybeHit restored(MaybeHit hit) const {
    if (hit) hit->t += shift;
    return hit;
  }
};
using Recentered = RecenteredOf<double>;
/// The end of a ray as seen from an origin `shift` further on, with room for the rounding of both.
template <class S>
[[gnu::always_inline]] inline S end_from(const S& shift, const S& end) {
  using std::abs;
  return end - shift + S(2 * epsilon) * (abs(end) + abs(shift));
}

template <class S>
[[gnu::always_inline]] inline RecenteredOf<S> recentered(const LocalRayOf<S>& ray,
                                                         const std::type_identity_t<Vec3<S>>& center) {
  const S shift = greatest(dot(center - ray.origin, ray.direction), ray.begin);
  return {{ray.at(shift), ray.direction, ray.begin - shift, end_from(shift, ray.end), ray.blur}, shift};
}

/// A frame in another. A matrix, since a ray and its hit are rotated four times.
struct Frame {
  Vec3d translation;
  Mat3d rotation;

  Vec3d out(const Vec3d& direction) const { return rotation * direction; }
  Vec3d in(const Vec3d& direction) const { return transposed_times(rotation, direction); }
};

/// The frame of a pose, its rotation to double's precision: a quaternion of floats is of unit length only in float, and
/// lengths would change.
template <class T>
Frame frame_of(const Pose<T>& pose) {
  return {converted<double>(pose.translation), rotation_of(converted<double>(pose.rotation))};
}

/// The frame `b` in the one that `a` is in.
inline Frame compose(const Frame& a, const Frame& b) {
  return {a.translation + a.out(b.translation), a.rotation * b.rotation};
}

/// A ray in a frame that is given in the ray's present one.
inline LocalRay seen_from(const Frame& frame, const LocalRay& ray) {
  return {frame.in(ray.origin - frame.translation), frame.in(ray.direction), ray.begin, ray.end, ray.blur};
}

inline LocalHit hit_at(const LocalRay& ray, double t, const Vec3d& normal) { return {t, ray.at(t), normal}; }
/// The hit of a ray that begins inside.
inline LocalHit hit_inside(const LocalRay& ray) { return hit_at(ray, ray.begin, -ray.direction); }

/// The hit of a solid that the ray is in from `enter` to `leave` (empty when `enter` is not the lesser).
template <class S>
[[gnu::always_inline]] inline FoundHit<S> entered(const LocalRayOf<S>& ray, const std::type_identity_t<S>& enter,
                                                  const std::type_identity_t<S>& leave, const Vec3<S>& normal) {
  const MaskOf<S> hit = (enter <= leave) & (leave >= ray.begin) & (enter <= ray.end), inside = enter <= ray.begin;
  if (alone(!hit)) return {};
  const S t = select(inside, ray.begin, enter);
  return {hit, t, ray.at(t), select(inside, -ray.direction, normal)};
}

/// Whether a ray meets a ball about a shape's origin that contains the shape, widened by `blur`.
template <class S>
[[gnu::always_inline]] inline MaskOf<S> near_ball(const LocalRayOf<S>& ray, const std::type_identity_t<S>& radius) {
  const S reach = radius + ray.blur;
  return length_squared(ray.at(clamp(-dot(ray.origin, ray.direction), ray.begin, ray.end))) <= reach * reach;
}

/// `normal` or its opposite, whichever faces the ray.
template <class S>
[[gnu::always_inline]] inline Vec3<S> against(const LocalRayOf<S>& ray, const Vec3<S>& normal) {
  return select(dot(normal, ray.direction) > S(0), -normal, normal);
}

/// The normal without the component along the ray that rounding may give it where the ray grazes; `ray` of any length.
inline Vec3d opposing(const Vec3d& normal, const Vec3d& ray) {
  if (!(dot(normal, ray) > 0)) return normal;
  const Vec3d direction = normalized(ray);
  return normalized(normal - direction * dot(normal, direction), -direction);
}

/// `size`, which is not negative, with the sign of `sign`, also of a zero.
template <class S>
[[gnu::always_inline]] inline S with_sign(const S& size, const S& sign) {
  if constexpr (std::is_floating_point_v<S>) {
    return std::copysign(size, sign);
  } else {
    using Bits = typename S::BitVector;
    const Bits sign_bit = Bits{} + static_cast<typename S::Bits>(0x8000000000000000u);
    return S::of(reinterpret_cast<typename S::Vector>(reinterpret_cast<Bits>(size.v) |
                                                      (reinterpret_cast<Bits>(sign.v) & sign_bit)));
  }
}

/// The real roots of a t^2 + 2 b t + c, lesser first; for a linear one, both the same. Each by the formula that does
/// not cancel (Higham 2002, "Accuracy and stability of numerical algorithms", section 1.8).
template <class S>
struct RootsOf {
  MaskOf<S> real{};
  S first{}, second{};
};
using Roots = RootsOf<double>;
template <class S>
[[gnu::always_inline]] inline RootsOf<S> roots(const S& a, const S& b, const S& c) {
  using std::sqrt;
  const S zero(0), under = b * b - a * c;
  if (alone(!(under >= zero))) return {};
  const S q = -(b + with_sign(sqrt(under), b));
  const MaskOf<S> none = q == zero, linear = a == zero;  // none: b = c = 0, or a constant
  const S one = c / q, other = select(linear, one, q / a);
  const MaskOf<S> real = (under >= zero) & !(none & linear);
  return {real, select(none, zero, least(one, other)), select(none, zero, greatest(one, other))};
}

}  // namespace graze::rays
