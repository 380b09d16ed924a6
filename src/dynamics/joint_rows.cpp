// The rows of a joint: those of its locked axes, of bounds and of drives; and the impulses kept from step to step.
#include <cmath>
#include <numbers>

#include "dynamics/joints.hpp"

namespace graze {

namespace {

/// Whether the bounds of an angle leave it a whole turn.
template <class T>
bool turns_freely(const JointLimit<T>& limit) {
  return limit.max - limit.min >= T(2) * std::numbers::pi_v<T>;
}

/// The middle of two bounds, or the one that there is.
template <class T>
T middle_of_bounds(T min, T max) {
  return !std::isfinite(min) ? max : !std::isfinite(max) ? min : (min + max) / T(2);
}

/// The angle of a driven axis to which those that differ by whole turns are taken: the middle of the axis' own bounds,
/// if there are two, or the drive would push against one of them, the shorter way to a target within.
template <class T, class Space>
T turn_of_drive(const Joint<T, Space>& joint, const JointDrive<T>& drive) {
  for (const JointLimit<T>& l : joint.limits)
    if (l.space == JointSpace::angular && l.axes[drive.axis] && count(l.axes) == 1 && !turns_freely(l))
      return middle_of_bounds(l.min, l.max);
  return drive.position_target;
}

}  // namespace

template <class T, class Space>
void JointRows<T, Space>::prepare(JointInPlace<T, Space>& joint, const SubStep<T>& step) {
  joint_ = &joint;
  step_ = step;
  rows_.clear();
  add_limits(joint.joint);
  for (const JointDrive<T>& drive : joint.joint.drives) {
    Row row{};
    row.what = {drive.space == JointSpace::linear ? Measure::along : Measure::twist, drive.axis};
    row.soft = true;
    row.angle = drive.space == JointSpace::angular;
    row.acceleration = drive.mode == DriveMode::acceleration;
    row.target = drive.position_target;
    row.about = turn_of_drive(joint.joint, drive);
    row.target_speed = drive.velocity_target;
    row.stiffness = drive.stiffness;
    row.damping = drive.damping;
    row.max_force = drive.max_force;
    rows_.push_back(row);
  }
  const T scale = joint.impulse_step > T(0) ? step.h / joint.impulse_step : T(0);
  if (joint.impulses.size() == rows_.size())
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].impulse = joint.impulses[i] * scale;
}

/// Axes that are held by any hard limit are locked together; what is left of the limits has bounds.
template <class T, class Space>
void JointRows<T, Space>::add_limits(const Joint<T, Space>& joint) {
  std::array<bool, 3> linear{}, angular{};
  const auto is_lock = [](const JointLimit<T>& l) {
    return !l.stiffness && l.max == T(0) && (l.min == T(0) || (count(l.axes) > 1 && l.min <= T(0)));
  };
  for (const JointLimit<T>& l : joint.limits)
    for (std::size_t i = 0; i < 3; ++i)
      if (is_lock(l) && l.axes[i]) (l.space == JointSpace::linear ? linear : angular)[i] = true;
  for (std::uint8_t i = 0; i < 3; ++i)
    if (linear[i]) rows_.push_back({{Measure::along, i}});
  const std::uint8_t held = !angular[0] ? 0 : !angular[1] ? 1 : 2;  // of two locked angles, the axis that stays
  for (std::uint8_t i = 0; i < 3; ++i)
    if (angular[i])
      rows_.push_back({{count(angular) == 3   ? Measure::locked_turn
                        : count(angular) == 2 ? Measure::locked_swing
                                              : Measure::twist,
                        i, held}});
  locked_ = rows_.size();
  for (const JointLimit<T>& l : joint.limits) {
    if (is_lock(l)) continue;
    Row row{};
    row.what.axes = l.axes;
    row.angle = l.space == JointSpace::angular;
    const int axes = count(l.axes);
    const std::uint8_t first = l.axes[0] ? 0 : l.axes[1] ? 1 : 2, left = !l.axes[0] ? 0 : !l.axes[1] ? 1 : 2;
    row.what.axis = axes == 2 && row.angle ? left : first;
    if (row.angle)
      row.what.measure = axes == 1 ? Measure::twist : axes == 2 ? Measure::swing : Measure::whole_turn;
    else
      row.what.measure = axes == 1 ? Measure::along : Measure::distance;
    row.soft = l.stiffness.has_value();
    row.stiffness = l.stiffness.value_or(T(0));
    row.damping = l.damping;
    row.max_force = std::numeric_limits<T>::infinity();
    add_bounds(l, row);
  }
}

template <class T, class Space>
void JointRows<T, Space>::add_bounds(const JointLimit<T>& limit, const Row& row) {
  const bool several = count(limit.axes) > 1;
  if (limit.min == limit.max) {
    rows_.push_back(row);
    rows_.back().target = rows_.back().about = limit.min;
    return;
  }
  if (row.what.measure == Measure::twist && turns_freely(limit)) return;
  const Side sides[] = {Side::lower, Side::upper};
  const T bounds[] = {limit.min, limit.max};
  for (int i = 0; i < 2; ++i) {
    if (!std::isfinite(bounds[i]) || (i == 0 && several && bounds[i] <= T(0))) continue;
    rows_.push_back(row);
    rows_.back().side = sides[i];
    rows_.back().target = bounds[i];
    rows_.back().about = middle_of_bounds(limit.min, limit.max);
  }
}

template <class T, class Space>
void JointRows<T, Space>::store() const {
  joint_->impulses.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i)
    joint_->impulses[i] = rows_[i].impulse * (step_.step * step_.inverse_h);
  joint_->impulse_step = step_.step;
}

#define GRAZE_JOINT_ROWS(T, Space)                                                                                     \
  template void JointRows<T, Space>::prepare(JointInPlace<T, Space>&, const SubStep<T>&);                              \
  template void JointRows<T, Space>::store() const;
GRAZE_JOINT_ROWS(float, Space<float>)
GRAZE_JOINT_ROWS(double, Space<double>)
GRAZE_JOINT_ROWS(float, plane::Space<float>)
GRAZE_JOINT_ROWS(double, plane::Space<double>)
#undef GRAZE_JOINT_ROWS

}  // namespace graze
