// A scene's colliders, of space or of the plane, as the bodies of a world.
#pragma once

#include <algorithm>

#include "graze/io/plane_scene.hpp"
#include "graze/io/scene.hpp"
#include "graze/plane/world.hpp"
#include "io/convert.hpp"
#include "io/single_plane_shape.hpp"

namespace graze::io {

/// Whether anything in the scene can move; if not, all bodies count as fixed, and are compared all the same.
template <class AnyScene>
bool moves_by_itself(const AnyScene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const auto& b) { return b.type != MotionType::fixed; });
}

/// Throws `InvalidValue` for a pose that T cannot hold, or only as a number too large to compute with.
template <class T>
void check_pose(const Pose<T>& pose) {
  for (std::size_t i = 0; i < 3; ++i)
    if (const char* expectation = validate::fault_of_coordinate(pose.translation[i]))
      validate::fail("translation[" + std::to_string(i) + "]", expectation, static_cast<double>(pose.translation[i]));
}

/// A collider as a body. Throws `InvalidValue` for numbers that double holds and float cannot.
template <class T>
graze::Body<T> in_world(const Scene& scene, const Collider& c, bool fixed) {
  try {
    graze::Body<T> body{in_precision<T>(c.shape), converted<T>(c.pose)};
    body.filter = c.filter;
    body.filter.group = -1 - static_cast<std::int32_t>(c.body);
    body.fixed = fixed;
    check_pose(body.pose);
    return body;
  } catch (const InvalidValue& e) {
    throw e.below(scene.source + ": " + c.name);
  }
}

/// A collider of the plane as a body, whose world checks its pose.
template <class T>
plane::Body<T> in_world(const PlaneScene& scene, const PlaneCollider& c, bool fixed) {
  try {
    plane::Body<T> body{in_precision<T>(c.shape), plane::converted<T>(c.pose)};
    plane::detail::checked_point(body.pose.translation, "translation");
    body.filter = c.filter;
    body.filter.group = -1 - static_cast<std::int32_t>(c.body);
    body.fixed = fixed;
    return body;
  } catch (const InvalidValue& e) {
    throw e.below(scene.source + ": " + c.name);
  }
}

/// The margin in T. Errors name the number that was given, not the one in T.
template <class T>
T checked_margin(double margin) {
  const auto value = static_cast<T>(margin);
  if (const char* expectation = validate::fault_of_length(value)) validate::fail("margin", expectation, margin);
  return value;
}

}  // namespace graze::io
