// The bits of what moves in space as one number: masses, rotations by angles, casts of bodies that turn, and a
// simulation.
//
// Guarantee: needs nothing but the library, and random numbers that every standard library makes the same.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "common/hash.hpp"
#include "graze/cast.hpp"
#include "graze/simulation.hpp"

namespace graze::testing {

/// The hash of the run below, from every compiler, at every level of optimisation and of the instruction set, on every
/// processor. It changes only with the arithmetic of the library, and whoever changes that writes it anew.
template <class T>
inline constexpr std::uint64_t golden_moving_bits = 0;
template <>
inline constexpr std::uint64_t golden_moving_bits<float> = 17953683369088362827u;
template <>
inline constexpr std::uint64_t golden_moving_bits<double> = 738942080703002073u;

template <class T>
class MovingRun {
 public:
  explicit MovingRun(unsigned seed) : random_(seed) {}

  void add(Hash& hash) {
    constexpr int kinds = 9;
    for (int i = 0; i < 3 * kinds; ++i) add_mass(hash, shape(i % kinds));
    for (int i = 0; i < 40 * kinds; ++i) {
      const Shape<T> b = shape(i / 4 % kinds), a = shape(i % kinds);  // in this order, whatever the compiler's
      add_cast(hash, a, b);
    }
    add_simulation(hash);
  }

 private:
  T within(float reach) { return T(reach * (static_cast<float>(random_() >> 40) * 0x1p-23f - 1)); }
  T size(float least, float reach) { return T(least) + std::abs(within(reach)); }
  Vec3<T> vector(float reach) {
    const T x = within(reach), y = within(reach), z = within(reach);
    return {x, y, z};
  }
  Pose<T> pose(float reach) {
    const Vec3<T> at = vector(reach), axis = vector(1);
    return {at, Quat<T>::from_axis_angle(normalized(axis), within(4))};
  }
  /// One of each kind whose mass takes more than its corners, or is the sum of some.
  Shape<T> shape(int kind) {
    const T a = size(0.2f, 0.8f), b = size(0.2f, 0.8f), c = size(0.2f, 0.8f), rounding = size(0.05f, 0.2f);
    switch (kind) {
    case 0: return Sphere<T>(a, {b, c, T(0)});
    case 1: return {Box<T>({a, b, c}), rounding};
    case 2: return Capsule<T>(a, b, c);
    case 3: return Cylinder<T>(a, b, c);
    case 4: return {Cylinder<T>(a, b, T(0)), rounding};
    case 5: return Ellipsoid<T>({a, b, c});
    case 6: {
      std::vector<Vec3<T>> points(8);
      for (Vec3<T>& p : points) p = vector(1);
      return {ConvexHull<T>(points), rounding};
    }
    case 7: {
      const Vec3<T> p = vector(1), q = vector(1), r = vector(1);
      return {Triangle<T>(p, q, r), rounding};
    }
    default: {
      const Pose<T> at = pose(1);
      return Compound<T>({{Box<T>({a, b, c}), {}}, {Capsule<T>(b, a, a), at}});
    }
    }
  }
  static void add_mass(Hash& hash, const Shape<T>& shape) {
    const MassProperties<T> m = mass_properties(shape);
    hash.add(m.volume), hash.add(m.center);
    for (const Vec3<T>& row : m.inertia.row) hash.add(row);
  }
  void add_cast(Hash& hash, const Shape<T>& a, const Shape<T>& b) {
    const Pose<T> at_a = pose(1);
    Pose<T> at_b = pose(1);
    const Vec3<T> way = vector(3);
    at_b.translation = at_b.translation - way * T(2);
    const Vec3<T> turning_a = vector(2), turning_b = vector(2);
    const auto hit = cast<T>(a, at_a, {{}, turning_a}, b, at_b, {way * T(2), turning_b}, T(2));
    hash.add(hit.has_value());
    if (hit) hash.add(hit->t), hash.add(hit->point), hash.add(hit->normal), hash.add(hit->depth);
  }
  /// Bodies of all kinds that fall on the ground, turn there and come upon each other, for two thirds of a second.
  void add_simulation(Hash& hash) {
    Simulation<T> simulation;
    Body<T> ground{Shape<T>(HalfSpace<T>())};
    ground.fixed = true;
    simulation.add(ground);
    std::vector<BodyId> ids;
    for (int i = 0; i < 45; ++i) {
      Pose<T> at = pose(2);
      at.translation.y += T(3);
      const Shape<T> of = shape(i % 9);
      const Vec3<T> linear = vector(2), angular = vector(3);
      ids.push_back(simulation.add({of, at, linear, angular}));
    }
    for (int i = 0; i < 42; ++i) simulation.step(T(1) / T(64));
    for (const BodyId id : ids) {
      const Pose<T>& at = simulation.poses()[id.index];
      const Quat<T>& q = at.rotation;
      hash.add(at.translation), hash.add(q.x), hash.add(q.y), hash.add(q.z), hash.add(q.w);
    }
  }

  std::mt19937_64 random_;
};

template <class T>
std::uint64_t hash_of_a_moving_run() {
  Hash hash;
  for (unsigned seed = 50; seed < 52; ++seed) MovingRun<T>(seed).add(hash);
  return hash.value();
}

}  // namespace graze::testing
