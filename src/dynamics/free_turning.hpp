// The turning of a body on which no torque acts: the steps of rotation of `free_motion.hpp`, over S, a scalar or lanes.
//
// Guarantee: the result of a lane does not depend on the others, of which some may take more steps.
#pragma once

#include "graze/free_motion.hpp"
#include "graze/plane/free_motion.hpp"
#include "graze/wide.hpp"
#include "simd/lane_of.hpp"

namespace graze {

/// `yes` where the condition holds, else `no`.
template <class M, class S>
Quat<S> select(const M& condition, const Quat<S>& yes, const Quat<S>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z),
          select(condition, yes.w, no.w)};
}

/// The largest angle of one step of rotation. Its error grows with the fifth power. A book that is spun about its
/// middle axis, a thousandth beside it, turns over 9 times in 20 s at 10 rad/s; with steps 2.5 times as large 10 times.
template <class T>
inline constexpr T step_angle = T(0.1);

template <class S>
Vec3<S> angular_velocity_at(const FreeBody<S>& body, const Quat<S>& rotation) {
  const Vec3<S> in_body = rotate(conjugate(rotation), body.angular_momentum);
  return rotate(rotation, scaled(in_body, body.inverse_inertia));
}
/// The angular velocity in world space.
template <class S>
Vec3<S> spin_of(const FreeBody<S>& body) {
  return angular_velocity_at(body, body.rotation);
}

/// The rotation of a Rodrigues vector, which is the axis times the tangent of half the angle.
template <class S>
Quat<S> rotation_of(const Vec3<S>& g) {
  return normalized(Quat<S>{g.x, g.y, g.z, S(1)});
}

/// The rate of the Rodrigues vector g of the rotation since the beginning of a step. From q' = ω q / 2 follows
/// g' = (ω + ω × g + g (g·ω)) / 2, an equation in a vector space, on which the classical method of Runge and Kutta
/// keeps its fourth order.
template <class S>
Vec3<S> rate(const FreeBody<S>& body, const Vec3<S>& g) {
  const Vec3<S> w = angular_velocity_at(body, rotation_of(g) * body.rotation);
  return (w + cross(w, g) + g * dot(g, w)) / S(2);
}

/// The rotation after a step of duration h.
template <class S>
Quat<S> turned(const FreeBody<S>& body, const S& h) {
  const Vec3<S> k1 = spin_of(body) / S(2);
  const Vec3<S> k2 = rate(body, k1 * (h / S(2)));
  const Vec3<S> k3 = rate(body, k2 * (h / S(2)));
  const Vec3<S> k4 = rate(body, k3 * h);
  const Vec3<S> g = (k1 + (k2 + k3) * S(2) + k4) * (h / S(6));
  return normalized(rotation_of(g) * body.rotation);
}

/// The number of steps of rotation in a duration, by the greatest rate that the angular momentum can cause.
template <class S>
S rotation_steps(const FreeBody<S>& body, const S& duration) {
  using std::abs;
  const S angle = length(body.angular_momentum) * max_abs(body.inverse_inertia) * abs(duration);
  const S wanted = angle / S(step_angle<typename LaneOf<S>::type>);
  S steps(0);
  for (int i = 0; i < most_rotation_steps; ++i) {
    const auto more = steps < wanted;
    if (!any(more)) break;
    steps = select(more, steps + S(1), steps);
  }
  return steps;
}

/// Turns the body for a duration.
template <class S>
void turn(FreeBody<S>& body, const S& duration) {
  const S steps = rotation_steps(body, duration), h = duration / greatest(steps, S(1));
  for (S taken(0); any(taken < steps); taken += S(1)) {
    const auto more = taken < steps;
    body.rotation = select(more, turned(body, h), body.rotation);
  }
}

namespace plane {

template <class M, class S>
Rot2<S> select(const M& condition, const Rot2<S>& yes, const Rot2<S>& no) {
  return {select(condition, yes.cosine, no.cosine), select(condition, yes.sine, no.sine)};
}

/// The largest angle whose series is summed; larger ones are halved first.
template <class T>
inline constexpr T series_angle = T(0.25);

template <class S>
S spin_of(const FreeBody<S>& body) {
  return body.angular_momentum * body.inverse_inertia;
}

/// `normalized` of what is not zero, without a branch.
template <class S>
Rot2<S> of_unit_length(const Rot2<S>& q) {
  const Vec2<S> v{q.cosine, q.sine}, w = v / max_abs(v);
  const S l = length(w);
  return {w.x / l, w.y / l};
}

/// cos x - 1 and sin x by their series, whose first terms left out are below 0.25^14 / 14! = 5e-20; then doubled as
/// often as the angle was halved.
template <class S>
Rot2<S> rotation_of_angle(S angle) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  const S zero(0), one(1), limit(series_angle<T>);
  angle = select(abs(angle) <= S((std::numeric_limits<T>::max)()), angle, zero);
  S halvings(0);
  for (auto large = abs(angle) > limit; any(large); large = abs(angle) > limit) {
    angle = select(large, angle / S(2), angle);
    halvings = select(large, halvings + one, halvings);
  }
  const S square = angle * angle;
  S cosine(0), sine(0);
  for (int n = 12; n > 0; n -= 2) {
    cosine = -square / S(static_cast<T>(n * (n - 1))) * (one + cosine);
    sine = -square / S(static_cast<T>(n * (n + 1))) * (one + sine);
  }
  Rot2<S> turn = of_unit_length(Rot2<S>{one + cosine, angle * (one + sine)});
  for (; any(halvings > zero); halvings = halvings - one) {
    const auto more = halvings > zero;
    turn = select(more, of_unit_length(turn * turn), turn);
  }
  return turn;
}

template <class S>
void turn(FreeBody<S>& body, const S& duration) {
  const S angle = spin_of(body) * duration;
  body.rotation = select(angle != S(0), of_unit_length(rotation_of_angle(angle) * body.rotation), body.rotation);
}

}  // namespace plane

}  // namespace graze
