// Time to sink: the time for which two bodies that touch may go on as they move before one of them is deep in the
// other.
//
// Contacts hold bodies apart at the points that were found when the step began. A body that turns may come down beside
// them, and one that lies on another may be struck from above; sunk to its centre of mass, it would be pushed out on
// the other side.
#pragma once

#include <optional>

#include "dynamics/rigid_space.hpp"

namespace graze {

/// Two bodies that move by constant velocities from where a step found them.
template <class T, class Space>
struct MovingPair {
  using Shape = typename Space::Shape;
  using Pose = typename Space::Pose;
  using Velocity = typename Space::Velocity;

  const Shape &shape_a, &shape_b;
  const Pose &from_a, &from_b;
  const Velocity &velocity_a, &velocity_b;

  /// The depth of their overlap after `time`; negative where they are apart.
  T depth(T time) const {
    return -distance(shape_a, pose_at(from_a, velocity_a, time), shape_b, pose_at(from_b, velocity_b, time)).distance;
  }
  /// The speed at which they get deeper, at most.
  T speed() const {
    return length(velocity_a.linear - velocity_b.linear) + Space::speed_of_turning(shape_a, velocity_a.angular) +
           Space::speed_of_turning(shape_b, velocity_b.angular);
  }
};

/// The time within `duration` up to which two bodies that touch get no deeper than by half of what is left to `most`:
/// so that no row of steps takes them further. An eighth of `most` is allowed in any case, or they would hang where
/// they are. Where 32 steps of conservative advancement do not tell, the time that they reached for what is deeper at
/// the end, as a long rod that turns down; else nothing, as of wheels that move by several times their width: these
/// sink by no turning. Costs a distance for each step; of two that get no deeper, one for each half of `most` that they
/// move.
template <class T, class Space>
std::optional<T> time_to_sink(const MovingPair<T, Space>& pair, T most, T duration) {
  constexpr int steps = 32;
  const T speed = pair.speed(), at_first = greatest(T(0), pair.depth(T(0)));
  const T more = greatest(most / T(8), (most - at_first) / T(2));
  T time{}, left = more;
  for (int i = 0; i < steps; ++i) {
    time += left / speed;
    if (!(time < duration)) return duration;
    left = at_first + more - pair.depth(time);
    if (left < more / T(4)) return time;
  }
  if (pair.depth(duration) > at_first + more) return time;
  return {};
}

}  // namespace graze
