// The springs by which contacts recover depth.
#pragma once

#include <cmath>

#include "dynamics/solver_body.hpp"

namespace graze {

/// The spring by which rows of contacts recover depth in a sub-step.
template <class T>
struct ContactStep {
  SubStep<T> time{};
  Softness<T> soft{};
  T gravity{};
  T usual_step{};  ///< the step that the springs are made for
};

/// The part of the usual step that the next one is at least. A short step between long ones, as what a frame leaves
/// over, would stiffen all springs at once, by the square of both steps' ratio, and throw off what they let sink; and
/// the next long one would begin with those impulses. So they become stiffer by a fifth from step to step.
template <class T>
inline constexpr T usual_step_kept = T(0.9);

/// The springs of a sub-step: their period is some sub-steps of the usual step, damped beyond the critical, so that
/// nothing swings (Catto 2024). Stiffer springs against bodies that cannot be pushed, as Catto has them, shake heavy
/// bodies that lie on light ones. `sub_steps`: of the step.
template <class T>
ContactStep<T> contact_step(const SubStep<T>& time, T gravity, T usual_step, int sub_steps);

/// The greatest speed at which contacts push bodies apart, the smaller of which has this size: that of a fall through
/// half of it; without gravity a twentieth of it in a usual step.
template <class S, class T>
S fastest_push(const ContactStep<T>& step, const S& size) {
  using std::sqrt;
  return step.gravity > T(0) ? sqrt(S(step.gravity) * size) : size / S(T(20) * step.usual_step);
}

/// How a sub-step begins with the impulses of the last step: with `share` of them. Where the step is longer than the
/// last one, what bore a load bears more, and a blow does not come again: more than `plain` of an impulse, which an
/// equal step would have, is no more than `most`, the weight of all in a sub-step.
template <class T>
struct WarmStart {
  T share{}, plain{}, most{};

  template <class S>
  S of(const S& impulse) const {
    return least(impulse * share, greatest(impulse * plain, S(most)));
  }
};

/// The depth of a contact of two free masses under a steady force, in sub-steps of h. `strain`: the force times the sum
/// of both inverse masses.
template <class T>
T predicted_sink(T strain, T h);

}  // namespace graze
