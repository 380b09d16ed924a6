// Simulations that tests begin with: a gravity of 10 downwards, a floor, a heap of shapes.
#pragma once

#include <random>
#include <vector>

#include "graze/simulation.hpp"

namespace graze::testing {

inline constexpr double dt = 1.0 / 64;  // exact, so that closed forms can be compared to the last digits

template <class T>
SimulationSettings<T> settings(T gravity = T(10), bool sleep = false) {
  SimulationSettings<T> s;
  s.gravity = {T(0), -gravity, T(0)};
  s.sleep = sleep;
  return s;
}

template <class T>
BodyId add_floor(Simulation<T>& s, const Material<T>& material = {}, const Quat<T>& rotation = {}) {
  Body<T> body{HalfSpace<T>()};
  body.pose.rotation = rotation;
  body.fixed = true;
  return s.add(body, {}, material);
}

/// Shapes of all kinds fall onto a floor between walls.
template <class T>
void add_heap(Simulation<T>& s, unsigned seed, int count, T size = T(1)) {
  add_floor(s);
  std::mt19937 random(seed);
  const auto number = [&] { return T(random() % 1024) / T(512) - T(1); };
  for (int i = 0; i < count; ++i) {
    const auto shape = [&]() -> Shape<T> {
      switch (random() % 6) {
      case 0: return Sphere<T>(size / T(2));
      case 1: return Capsule<T>(size / T(4), size);
      case 2: return Cylinder<T>(size / T(2), size);
      case 3: return Ellipsoid<T>({size / T(2), size / T(4), size / T(2)});
      case 4: return Box<T>({size, size / T(2), size});
      default: return Box<T>({size, size, size});
      }
    };
    const Pose<T> pose{{number() * size * T(2), (T(1) + T(i)) * size, number() * size * T(2)},
                       normalized(Quat<T>{number(), number(), number(), T(1.5)})};
    Material<T> m;
    m.rolling_friction = size / T(10);
    s.add({shape(), pose}, {}, m);
  }
}

template <class T>
std::vector<Pose<T>> poses_after(Simulation<T>& s, int steps, T step = T(dt)) {
  for (int i = 0; i < steps; ++i) s.step(step);
  return {s.poses().begin(), s.poses().end()};
}

}  // namespace graze::testing
