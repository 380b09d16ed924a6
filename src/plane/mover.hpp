// A convex piece of a body that moves and turns.
#pragma once

#include <cmath>
#include <limits>

#include "graze/plane/cast.hpp"
#include "plane/core.hpp"
#include "plane/unit_rotation.hpp"

namespace graze::plane {

inline Pose2d moved(const Pose2d& pose, const Velocity<double>& velocity, double t) {
  Pose2d out{pose.translation + velocity.linear * t, pose.rotation};
  if (velocity.angular != 0) out.rotation = at_unit(Rot2d::from_angle(velocity.angular * t) * pose.rotation);
  return out;
}

/// An upper bound of what turning adds to a height h below the reach R. By an angle w it becomes at most
/// h cos w + sqrt(R² - h²) sin w, and sin w <= w, 1 - cos w <= w² / 2: with no sine computed, and exact to first order.
struct Gain {
  double rate = 0, bend = 0;  ///< rate t + bend t²
  double most = 0;            ///< bound at any time
};

/// A convex piece and its motion: its place in a body, and that body's pose and velocity.
template <class T>
struct Mover {
  const Core<T>& core;
  Pose2d in_body;  ///< the piece seen from its body
  Pose2d body;
  Velocity<double> velocity;
  double reach;  ///< of the piece from the body's origin

  Pose2d at(double t) const { return compose(moved(body, velocity, t), in_body); }
  /// The body's origin.
  Vec2d origin(double t) const { return body.translation + velocity.linear * t; }
  /// Bounds how much further than `height` the piece reaches along a fixed direction while its body turns: its points
  /// lie below that height and no further than `reach` from the body's origin.
  Gain gain(double height) const {
    const double speed = std::abs(velocity.angular);
    if (speed == 0 || !(height < reach)) return {};
    // Rounding may take the height of a point on the origin below its reach.
    const double beside = std::sqrt(greatest((reach - height) * (reach + height), 0.0));
    return {speed * beside, speed * speed * greatest(-height, 0.0) / 2, reach - height};
  }
};

}  // namespace graze::plane
