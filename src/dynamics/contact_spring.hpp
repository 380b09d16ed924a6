// The springs by which contacts recover depth.
#pragma once

#include "dynamics/solver_body.hpp"

namespace graze {

/// How rows of contacts recover depth in a sub-step.
template <class T>
struct ContactStep {
  SubStep<T> time{};
  Softness<T> soft{};
  T gravity{};
};

/// The springs of a sub-step of h: their period is some sub-steps, damped beyond the critical, so that nothing
/// swings (Catto 2024). Stiffer ones against what does not give, as Catto has them, shake heavy bodies that lie on
/// light ones.
template <class T>
ContactStep<T> contact_step(const SubStep<T>& time, T gravity);

/// How deep a contact of two free masses stands under a steady force, both inverse masses together, in sub-steps of h:
/// `strain` is the force times the inverse masses.
template <class T>
T predicted_sink(T strain, T h);

}  // namespace graze
