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
};

/// The springs of a sub-step of h: their period is some sub-steps, damped beyond the critical, so that nothing
/// swings (Catto 2024). Stiffer springs against bodies that cannot be pushed, as Catto has them, shake heavy
/// bodies that lie on light ones.
template <class T>
ContactStep<T> contact_step(const SubStep<T>& time, T gravity);

/// The greatest speed at which contacts push bodies apart, the smaller of which has this size: that of a fall through
/// half of it; without gravity a twentieth of it in a step.
template <class S, class T>
S fastest_push(const ContactStep<T>& step, const S& size) {
  using std::sqrt;
  return step.gravity > T(0) ? sqrt(S(step.gravity) * size) : size / S(T(20) * step.time.step);
}

/// The depth of a contact of two free masses under a steady force, in sub-steps of h. `strain`: the force times the sum
/// of both inverse masses.
template <class T>
T predicted_sink(T strain, T h);

}  // namespace graze
