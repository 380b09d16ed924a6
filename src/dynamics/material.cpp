#include "graze/material.hpp"

#include <cmath>
#include <string>

#include "dynamics/rigid_space.hpp"
#include "graze/detail/validate.hpp"

namespace graze {

namespace {

template <class T>
void check_friction(T value, const char* path) {
  if (!(value >= T(0)) || !std::isfinite(value))
    validate::fail(path, "a finite number >= 0", static_cast<double>(value));
}

void check_combine(Combine combine, const char* path) {
  const int number = static_cast<int>(combine);
  if (number < 0 || combine > Combine::multiply)
    throw InvalidValue(path, "unset, average, minimum, maximum or multiply", std::to_string(number));
}

}  // namespace

template <class T, class Vec>
void check(const Material<T, Vec>& m) {
  check_friction(m.static_friction, "static_friction");
  check_friction(m.dynamic_friction, "dynamic_friction");
  check_friction(m.rolling_friction, "rolling_friction");
  if (!(m.restitution >= T(0) && m.restitution <= T(1)))
    validate::fail("restitution", "a number from 0 to 1", static_cast<double>(m.restitution));
  checked_vector(m.surface_velocity, "surface_velocity");
  check_combine(m.friction_combine, "friction_combine");
  check_combine(m.restitution_combine, "restitution_combine");
}

template void check(const Material<float>&);
template void check(const Material<double>&);
template void check(const Material<float, plane::Vec2<float>>&);
template void check(const Material<double, plane::Vec2<double>>&);

}  // namespace graze
