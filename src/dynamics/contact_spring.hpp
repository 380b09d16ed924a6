// The springs by which contacts recover depth.
#pragma once

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

/// The depth of a contact of two free masses under a steady force, in sub-steps of h. `strain`: the force times the sum
/// of both inverse masses.
template <class T>
T predicted_sink(T strain, T h);

}  // namespace graze
