// The first contact of two cores that move along a line.
//
// Guarantee: exact for polygons, rounded or not, by a ray against their Minkowski difference. All other kinds by steps
// of the separating line, each of which ends no later than the true contact.
#pragma once

#include <optional>

#include "plane/nearest.hpp"
#include "plane/outline_hit.hpp"

namespace graze::plane {

/// A first contact of cores in A's frame.
struct FirstContact {
  double t = 0;
  Vec2d normal{};  ///< unit, from A to B
  Vec2d point{};   ///< on A's surface
  Status status = Status::converged;
};

/// Whether two polygons are surely further apart than `near`, by an edge of their difference above whose line the
/// origin lies. False where a closer look is needed.
template <class T>
bool surely_apart(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a, double near);

/// The first contact at a time in [0, duration] of polygons that are apart at the start, while B moves by `velocity` in
/// A's frame.
template <class T>
std::optional<FirstContact> contact_of_polygons(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                                const Vec2d& velocity, double duration, double size);

/// The most steps along separating lines. Each closes what the line leaves of the gap: flat sides take a few, round
/// ones converge quadratically unless they pass each other.
inline constexpr int most_straight_steps = 100;

/// The first contact of any cores, by steps along separating lines. `near`: the gap that counts as contact. Calls
/// `seen(t, gap, normal)` at each time that is looked at.
template <class T, class Seen>
std::optional<FirstContact> advance_straight(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                             const Vec2d& velocity, double duration, double size, double near,
                                             const Seen& seen) {
  if (!(length(velocity) > 0)) return {};
  FirstContact out;
  const auto moved = [&](double t) { return Pose2d{b_in_a.translation + velocity * t, b_in_a.rotation}; };
  for (int step = 0; step < most_straight_steps; ++step) {
    const Nearest found = nearest(a, b, moved(out.t), size);
    const double gap = found.distance - found.error - a.radius - b.radius, closing = -dot(velocity, found.normal);
    out.normal = found.normal;
    out.point = found.a.point + found.normal * a.radius;
    seen(out.t, gap, found.normal);
    if (gap <= near && (closing > 0 || gap <= 0)) return out;
    if (!(closing > 0)) return {};
    // Up to half of the gap that counts as contact, so that the last step does not fall short by rounding.
    const double later = out.t + (gap - near / 2) / closing;
    if (later == never) return {};
    if (!(later <= duration)) {
      // The way ends before this step does: at its end the cores may touch all the same.
      const Nearest last = nearest(a, b, moved(duration), size);
      if (!(last.distance - a.radius - b.radius <= 0)) return {};
      out.t = duration;
      return out;
    }
    if (later == out.t) return out;
    out.t = later;
  }
  out.status = Status::bounded;
  return out;
}

}  // namespace graze::plane
