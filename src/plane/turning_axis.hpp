// The time for which an axis that turns with one of two polygons keeps them apart.
//
// Guarantee: the time is no later than the first at which they may come too close. The axis goes with a body, so that
// this body's own reach along it does not change, and each vertex of the other one has a height that is known to second
// order: steps between the times that are looked at converge quadratically where bounds by the outermost point (Mirtich
// 1996) do linearly.
#pragma once

#include "plane/mover.hpp"

namespace graze::plane {

/// A time up to which nothing comes too close, and whether it may happen then.
struct ApartUntil {
  double t;
  bool closes;
};

/// The terms of a lower bound way + rate t - bend t² of what is left between two bodies up to some time.
struct AxisBound {
  double rate, bend;

  /// The time at which `way` is used up, where it ever is.
  double time_of(double way) const {
    const double root = std::sqrt(rate * rate + 4 * bend * way);
    return rate > 0 ? (rate + root) / (2 * bend) : 2 * way / (root - rate);
  }
  bool stays_above(double way, double t) const { return way + (rate - bend * t) * t > 0; }
};

/// The change of the separation along the axis `n` by a point that turns at `speed` about the origin, up to the time
/// `until`. By Taylor: cos x >= 1 - x²/2 and |sin x - x| <= |x|³/6.
inline AxisBound turned_point(const Vec2d& point, const Vec2d& n, double speed, double until) {
  const double height = dot(n, point), beside = cross(point, n), squared = speed * speed;
  return {speed * beside,
          squared * (greatest(height, 0.0) / 2 + std::abs(beside) * std::abs(speed) * until * (1.0 / 6))};
}

/// The change of the separation by the ways of the bodies' origins, where these are `between` and move by `velocity`
/// against each other while the axis turns at `speed`, by no more than a radian until then.
inline AxisBound moved_origins(const Vec2d& between, const Vec2d& velocity, const Vec2d& n, double speed,
                               double until) {
  const AxisBound turned = turned_point(between, n, -speed, until);
  const double rate = dot(n, velocity), aside = speed * dot(left(n), velocity);
  return {rate + turned.rate, turned.bend + speed * speed * greatest(rate, 0.0) * until / 2 + greatest(-aside, 0.0)};
}

/// The time up to which two polygons surely stay far enough apart, `until` at most: at the time `t` their separation
/// along the unit vector `n`, from X to Y, is larger than it has to be by `way`. `pose_y`: Y's at t. `nearest`: a
/// vertex of Y that is likely to come too close first, so that the others need but a glance.
template <class T>
ApartUntil apart_along(const Mover<T>& x, const Mover<T>& y, const Pose2d& pose_y, const Vec2d& n,
                       std::uint32_t nearest, double way, double t, double until) {
  const double axis_speed = x.velocity.angular, speed = y.velocity.angular - axis_speed;
  const double fastest = greatest(std::abs(axis_speed), std::abs(speed));
  double span = until - t;
  // The bounds hold for a radian, and are close for less.
  if (fastest * span > 1) span = 1 / fastest;
  const Vec2d origin_y = y.origin(t);
  const AxisBound origins =
      moved_origins(origin_y - x.origin(t), y.velocity.linear - x.velocity.linear, n, axis_speed, span);
  const Vec2d own = inverse_rotate(pose_y.rotation, n),
              offset = inverse_rotate(pose_y.rotation, pose_y.translation - origin_y);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < y.core.count; ++i) lowest = least(lowest, dot(own, y.core.vertex(i)));
  bool closes = false;
  const auto shorten = [&](std::uint32_t i) {
    const Vec2d vertex = y.core.vertex(i);
    const AxisBound turned = turned_point(offset + vertex, own, speed, span);
    const AxisBound both{origins.rate + turned.rate, origins.bend + turned.bend};
    const double left = way + (dot(own, vertex) - lowest);
    if (both.stays_above(left, span)) return;
    span = both.time_of(left);
    closes = true;
  };
  shorten(nearest);
  for (std::uint32_t i = 0; i < y.core.count; ++i)
    if (i != nearest) shorten(i);
  return {t + span, closes};
}

/// The time of `apart_along` for a piece Y that may be curved: by the most that its turning against the axis adds to
/// its reach.
template <class T>
ApartUntil apart_along_by_reach(const Mover<T>& x, const Mover<T>& y, const Pose2d& pose_y, const Vec2d& n, double way,
                                double t, double until) {
  const double axis_speed = x.velocity.angular;
  Mover<T> against_axis = y;
  against_axis.velocity.angular -= axis_speed;
  double span = until - t;
  if (std::abs(axis_speed) * span > 1) span = 1 / std::abs(axis_speed);
  const Vec2d origin_y = y.origin(t);
  const AxisBound origins =
      moved_origins(origin_y - x.origin(t), y.velocity.linear - x.velocity.linear, n, axis_speed, span);
  const Vec2d lowest = transform(pose_y, support(y.core, inverse_rotate(pose_y.rotation, -n)).point);
  const Gain turned = against_axis.gain(dot(origin_y - lowest, n) + y.core.radius);
  const AxisBound both{origins.rate - turned.rate, origins.bend + turned.bend};
  if (both.stays_above(way, span)) return {t + span, false};
  return {t + least(both.time_of(way), span), true};
}

}  // namespace graze::plane
