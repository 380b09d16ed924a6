// Conservative advancement of two convex pieces that move and turn (Mirtich 1996, section 2.3).
//
// Guarantee: no time at which the pieces come as close as `near` is passed over.
#pragma once

#include <optional>

#include "plane/nearest.hpp"
#include "plane/turning_axis.hpp"

namespace graze::plane {

/// The most steps of conservative advancement of bodies that turn.
inline constexpr int most_advances = 2000;

struct WorldContact {
  double t = 0;
  Vec2d point{}, normal{};
  double depth = 0;
  Status status = Status::converged;
};

/// The time in which a gap is not closed by an approach and by what two bodies gain by turning; infinite where it never
/// closes.
inline double time_to_close(double gap, double approach, const Gain& a, const Gain& b) {
  const double rate = approach + a.rate + b.rate, bend = a.bend + b.bend, turning = a.most + b.most;
  const double root = rate + std::sqrt(rate * rate + 4 * bend * gap);
  const double bounded = root > 0 ? 2 * gap / root : std::numeric_limits<double>::infinity();
  if (!(gap > turning)) return bounded;
  return approach > 0 ? greatest(bounded, (gap - turning) / approach) : std::numeric_limits<double>::infinity();
}

/// The nearest points of two pieces at a time.
struct Nearby {
  WorldContact contact;
  double gap;
  Vec2d on_a;  ///< in the world
  Pose2d pose_a, pose_b;
  bool axis_of_b;                    ///< whether the normal is that of an edge of B
  std::uint32_t vertex_a, vertex_b;  ///< of polygons: where the nearest features begin
};

template <class T>
Nearby nearby(const Mover<T>& a, const Mover<T>& b, double t, double size) {
  Nearby out;
  const Pose2d pose_a = out.pose_a = a.at(t), pose_b = out.pose_b = b.at(t);
  const Nearest found = nearest(a.core, b.core, relative(pose_a, pose_b), size);
  out.axis_of_b = found.b.feature >= side_feature(0) || (found.a.feature < side_feature(0) && b.velocity.angular == 0);
  out.vertex_a = vertex_of(a.core, found.a.feature), out.vertex_b = vertex_of(b.core, found.b.feature);
  out.gap = found.distance - found.error - a.core.radius - b.core.radius;
  out.contact.t = t;
  out.contact.normal = rotate(pose_a.rotation, found.normal);
  out.on_a = transform(pose_a, found.a.point + found.normal * a.core.radius);
  out.contact.point = out.on_a + out.contact.normal * (out.gap / 2);
  return out;
}

/// The time up to which a half-plane X and a bounded piece Y surely stay apart: at `now` their gap along the
/// half-plane's unit normal `n`, which turns with it, is larger than it has to be by `way`.
template <class T>
ApartUntil apart_from_half_plane(const Mover<T>& x, const Mover<T>& y, const Pose2d& pose_y, const Vec2d& n,
                                 std::uint32_t nearest, double way, double t, double duration) {
  ApartUntil apart = y.core.kind == CoreKind::polygon ? apart_along(x, y, pose_y, n, nearest, way, t, duration)
                                                      : apart_along_by_reach(x, y, pose_y, n, way, t, duration);
  // The bounds may end before the duration does.
  apart.closes = apart.closes || apart.t < duration;
  return apart;
}

/// The time up to which two pieces come nearer than they are at `now` by less than `way`: along the normal there no
/// body gets further than its origin moves and the turn of the piece's outermost points adds, or of polygons its
/// vertices. Of a half-plane that turns no points are outermost: its normal turns with it.
template <class T>
ApartUntil apart_from(const Mover<T>& a, const Mover<T>& b, const Nearby& now, double way, double duration) {
  const double t = now.contact.t;
  const Vec2d& normal = now.contact.normal;
  const bool half_a = a.core.kind == CoreKind::half_plane, half_b = b.core.kind == CoreKind::half_plane;
  if (half_a && half_b && a.velocity.angular != b.velocity.angular) return {t, true};  // not opposite any more
  if (half_a && !half_b && a.velocity.angular != 0)
    return apart_from_half_plane(a, b, now.pose_b, normal, now.vertex_b, way, t, duration);
  if (half_b && !half_a && b.velocity.angular != 0)
    return apart_from_half_plane(b, a, now.pose_a, -normal, now.vertex_a, way, t, duration);
  ApartUntil by_axis{t, true};
  if (a.core.kind == CoreKind::polygon && b.core.kind == CoreKind::polygon) {
    by_axis = now.axis_of_b ? apart_along(b, a, now.pose_a, -normal, now.vertex_a, way, t, duration)
                            : apart_along(a, b, now.pose_b, normal, now.vertex_b, way, t, duration);
    if (by_axis.closes || by_axis.t >= duration) return by_axis;
  }
  const double approach = greatest(-dot(b.velocity.linear - a.velocity.linear, normal), 0.0);
  const double height_a = dot(now.on_a - a.origin(t), normal);
  const double height_b = -dot(now.on_a + normal * now.gap - b.origin(t), normal);
  const double later = t + time_to_close(way, approach, a.gain(height_a), b.gain(height_b));
  return {greatest(by_axis.t, later), later <= duration};
}

/// The time at which the discs around two pieces that begin further apart are `near / 2` apart; nothing where they
/// never are.
template <class T>
std::optional<double> discs_meet(const Mover<T>& a, const Mover<T>& b, double near) {
  const Vec2d between = b.body.translation - a.body.translation, velocity = b.velocity.linear - a.velocity.linear;
  const double radius = a.reach + b.reach + near / 2, speed = length(velocity), closing = -dot(between, velocity);
  // A product of sums: the difference of squares would lose digits far away.
  const double reached = speed * radius, missed = std::abs(cross(between, velocity));
  if (!(closing > 0) || missed > reached) return {};
  const double way = length_squared(between) - radius * radius;
  return way > 0 ? way / (closing + std::sqrt((reached - missed) * (reached + missed))) : 0;
}

/// Conservative advancement from a time on. The first time at which the gap is at most `near`, which may be less than
/// zero; steps end `tolerance / 2` below it, so that the last one does not fall short by rounding. Calls `seen(nearby)`
/// at each time that is looked at, and goes by what that leaves of it.
template <class T, class Seen>
std::optional<WorldContact> advance(const Mover<T>& a, const Mover<T>& b, double from, double duration, double size,
                                    double near, double tolerance, const Seen& seen) {
  double t = from;
  for (int step = 0; step < most_advances; ++step) {
    Nearby now = nearby(a, b, t, size);
    seen(now);
    if (now.gap <= near) return now.contact;
    const ApartUntil next = apart_from(a, b, now, now.gap - (near - tolerance / 2), duration);
    if (!next.closes) return {};
    const double later = next.t;
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
