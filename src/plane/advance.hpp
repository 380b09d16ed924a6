// Conservative advancement of two convex pieces that move and turn (Mirtich 1996, section 2.3).
//
// Guarantee: no time at which the pieces come as close as is asked is passed over.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "graze/plane/cast.hpp"
#include "plane/nearest.hpp"

namespace graze::plane {

/// The most steps of conservative advancement of bodies that turn.
inline constexpr int most_advances = 2000;

inline Pose2d moved(const Pose2d& pose, const Velocity<double>& velocity, double t) {
  Pose2d out{pose.translation + velocity.linear * t, pose.rotation};
  if (velocity.angular != 0) out.rotation = normalized(Rot2d::from_angle(velocity.angular * t) * pose.rotation);
  return out;
}

/// An upper bound of what turning adds to a height h below the reach R. By an angle w it becomes at most
/// h cos w + sqrt(R² - h²) sin w, and sin w <= w, 1 - cos w <= w² / 2: with no sine computed, and exact to first order.
struct Gain {
  double rate = 0, bend = 0;  ///< rate t + bend t²
  double most = 0;            ///< and no more than this
};

/// A convex piece and how it moves: of a compound's child, that turns with its body, the pose at any time.
template <class T>
struct Mover {
  const Core<T>& core;
  Pose2d in_body;  ///< the piece seen from its body
  Pose2d body;
  Velocity<double> velocity;
  double reach;  ///< of the piece from the body's origin

  Pose2d at(double t) const { return compose(moved(body, velocity, t), in_body); }
  /// Bounds how much further than `height` the piece reaches along a fixed direction while its body turns: its points
  /// lie below that height and no further than `reach` from the body's origin.
  Gain gain(double height) const {
    const double speed = std::abs(velocity.angular);
    if (speed == 0 || !(height < reach)) return {};
    const double beside = std::sqrt((reach - height) * (reach + height));
    return {speed * beside, speed * speed * greatest(-height, 0.0) / 2, reach - height};
  }
};

struct WorldContact {
  double t = 0;
  Vec2d point{}, normal{};
  double depth = 0;
  Status status = Status::converged;
};

/// A time in which a gap is not closed by an approach and by what two bodies gain by turning; infinite where it never is.
inline double time_to_close(double gap, double approach, const Gain& a, const Gain& b) {
  const double rate = approach + a.rate + b.rate, bend = a.bend + b.bend, turning = a.most + b.most;
  const double root = rate + std::sqrt(rate * rate + 4 * bend * gap);
  const double bounded = root > 0 ? 2 * gap / root : std::numeric_limits<double>::infinity();
  if (!(gap > turning)) return bounded;
  return approach > 0 ? greatest(bounded, (gap - turning) / approach) : std::numeric_limits<double>::infinity();
}

/// What is nearest of two pieces at a time.
struct Nearby {
  WorldContact contact;
  double gap;
  Vec2d on_a;  ///< in the world
};

template <class T>
Nearby nearby(const Mover<T>& a, const Mover<T>& b, double t, double size) {
  const Pose2d pose_a = a.at(t), pose_b = b.at(t);
  const Nearest found = nearest(a.core, b.core, relative(pose_a, pose_b), size);
  Nearby out;
  out.gap = found.distance - found.error - a.core.radius - b.core.radius;
  out.contact.t = t;
  out.contact.normal = rotate(pose_a.rotation, found.normal);
  out.on_a = transform(pose_a, found.a.point + found.normal * a.core.radius);
  out.contact.point = out.on_a + out.contact.normal * (out.gap / 2);
  return out;
}

/// Conservative advancement from a time on: along the normal of the nearest points no body gets further than its origin
/// moves and the turn of the piece's outermost points adds. The first time at which the gap is at most `near`, which
/// may be less than zero; steps end `tolerance / 2` below it, so that the last one does not fall short by rounding.
/// Calls `seen(nearby)` at each time that is looked at.
template <class T, class Seen>
std::optional<WorldContact> advance(const Mover<T>& a, const Mover<T>& b, double from, double duration, double size,
                                    double near, double tolerance, const Seen& seen) {
  const Vec2d linear = b.velocity.linear - a.velocity.linear;
  double t = from;
  for (int step = 0; step < most_advances; ++step) {
    const Nearby now = nearby(a, b, t, size);
    const Vec2d& normal = now.contact.normal;
    seen(now);
    if (now.gap <= near) return now.contact;
    const double approach = greatest(-dot(linear, normal), 0.0);
    const double height_a = dot(now.on_a - a.body.translation - a.velocity.linear * t, normal);
    const double height_b = -dot(now.on_a + normal * now.gap - b.body.translation - b.velocity.linear * t, normal);
    const double way = now.gap - (near - tolerance / 2);
    const double later = t + time_to_close(way, approach, a.gain(height_a), b.gain(height_b));
    if (!(later <= duration)) return {};
    if (later == t) return now.contact;
    t = later;
  }
  WorldContact out = nearby(a, b, t, size).contact;
  out.status = Status::bounded;
  return out;
}
template <class T>
std::optional<WorldContact> advance(const Mover<T>& a, const Mover<T>& b, double from, double duration, double size,
                                    double near) {
  return advance(a, b, from, duration, size, near, near, [](const Nearby&) {});
}

}  // namespace graze::plane
