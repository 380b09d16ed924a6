#include "dynamics/contact_spring.hpp"

#include <numbers>

namespace graze {

namespace {

/// Sub-steps in the period of a contact's spring, and its damping ratio. Measured: with ratios of 5 and more the rows
/// forget so little from pass to pass that a pyramid of base 20 sways for good (14 J of energy after 20 s; with 2 it is
/// 6e-4 J), with 1 a box of a thousand times the mass falls off a light one; with periods of 5 and less walls sway too,
/// and with 8 a tower of forty leans.
template <class T>
constexpr T period = T(5.5);

template <class T>
constexpr T damping_ratio = T(2);

}  // namespace

template <class T>
ContactStep<T> contact_step(const SubStep<T>& time, T gravity, T usual_step, int sub_steps) {
  const T w = T(2) * std::numbers::pi_v<T> / (period<T> * (usual_step / T(sub_steps)));
  return {time, softness(w, damping_ratio<T>, time.h), gravity, usual_step};
}

template <class T>
T predicted_sink(T strain, T h) {
  const T w = T(2) * std::numbers::pi_v<T> / (period<T> * h);
  return strain / (w * w);
}

template ContactStep<float> contact_step(const SubStep<float>&, float, float, int);
template ContactStep<double> contact_step(const SubStep<double>&, double, double, int);
template float predicted_sink(float, float);
template double predicted_sink(double, double);

}  // namespace graze
