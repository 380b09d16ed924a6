// Conservative advancement of two convex pieces that move and turn (Mirtich 1996, section 2.3).
//
// Guarantee: no time at which the pieces come as close as is asked is passed over.
#pragma once

#include <cmath>
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

/// A convex piece and how it moves: of a compound's child, that turns with its body, the pose at any time.
template <class T>
struct Mover {
  const Core<T>& core;
  Pose2d in_body;  ///< the piece seen from its body
  Pose2d body;
  Velocity<double> velocity;
  double reach;  ///< of the piece from the body's origin

  Pose2d at(double t) const { return compose(moved(body, velocity, t), in_body); }
  /// How much further than `height` the piece may reach along a fixed direction once its body has turned by `angle`:
  /// its points lie below that height and no further than `reach` from the body's origin.
  double gain(double height, double angle) const {
    if (angle == 0 || !(height < reach)) return 0;
    const double away = std::acos(greatest(height / reach, -1.0));
    return reach * std::cos(greatest(away - angle, 0.0)) - height;
  }
};

struct WorldContact {
  double t = 0;
  Vec2d point{}, normal{};
  double depth = 0;
  Status status = Status::converged;
};

/// The longest time, up to `longest`, in which `closing` (which grows) stays below `gap`: by bisection to a double's
/// digits.
template <class F>
double time_to_close(double gap, double longest, const F& closing) {
  double low = 0, high = longest;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (closing(middle) < gap ? low : high) = middle;
  }
  return low;
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
    const auto closing = [&](double time) {
      return approach * time + a.gain(height_a, std::abs(a.velocity.angular) * time) +
             b.gain(height_b, std::abs(b.velocity.angular) * time);
    };
    const double way = now.gap - (near - tolerance / 2), left_over = duration - t;
    if (closing(left_over) < way) return {};
    const double later = t + time_to_close(way, left_over, closing);
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
