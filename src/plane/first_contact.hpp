// The first contact of two cores that move along a line.
//
// Guarantee: exact for polygons, rounded or not, by a ray against their Minkowski difference. All other kinds by steps
// of the separating line, each of which ends no later than the true contact.
#pragma once

#include <optional>

#include "plane/nearest.hpp"

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

/// The first contact at a time in [0, duration] of cores that are apart at the start, while B moves by `velocity` in
/// A's frame. `near`: the gap that counts as contact where no closed form answers. With `steps`, those along separating
/// lines are recorded there, in A's frame.
template <class T>
std::optional<FirstContact> first_contact(const Core<T>& a, const Core<T>& b, const Pose2d& b_in_a,
                                          const Vec2d& velocity, double duration, double size, double near,
                                          std::vector<TraceStep>* steps = nullptr);

}  // namespace graze::plane
