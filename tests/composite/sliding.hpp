// Things that slide over a floor: what they are, and how they lie on it.
#pragma once

#include <vector>

#include "common/specimen.hpp"
#include "graze/shape.hpp"

namespace graze::testing {

/// Some of each kind that a game moves, about one across: round, flat, long, rounded, and one like a pebble.
template <class T>
std::vector<Shape<T>> sliders(Random& random) {
  std::vector<Shape<T>> all{Shape<T>(Sphere<T>(T(0.5))), Shape<T>(Box<T>({1, T(0.5), T(1.5)})),
                            Shape<T>(Capsule<T>(1, T(0.3), T(0.3))), Shape<T>(Cylinder<T>(T(0.8), T(0.5), T(0.5))),
                            Shape<T>(Box<T>({1, 1, 1}), T(0.1))};
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 20; ++i) points.push_back(converted<T>(random_vector(random, 0.6f)));
  all.push_back(ConvexHull<T>(points));
  return all;
}

/// The point of a turned shape that lies furthest along a direction.
template <class T>
Vec3<T> furthest(const Shape<T>& shape, const Quat<T>& turn, const Vec3<T>& direction) {
  return rotate(turn, support(shape, rotate(conjugate(turn), direction)));
}

/// The height of the lowest point of a shape as it is turned.
template <class T>
T lowest(const Shape<T>& shape, const Quat<T>& turn) {
  return furthest(shape, turn, Vec3<T>{0, -1, 0}).y;
}

}  // namespace graze::testing
