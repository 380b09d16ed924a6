// The rows of a joint where its bodies are, and their solution.
#include "dynamics/joints.hpp"

#include <cmath>
#include <numbers>

namespace graze {

namespace {

/// Errors of the size that a sub-step's drift makes are taken back in one sub-step; larger ones, of frames that were
/// put together wrongly, by an eighth in each: at once they would throw their bodies through others.
template <class T>
inline constexpr T drift_part = T(1) / T(64);  // of the arms, or in radians
template <class T>
inline constexpr T recovered_part = T(1) / T(8);

/// The period in sub-steps, and the damping ratio, of the spring that stands for a joint of a loop that is not solved
/// with the trees. Shorter periods build up oscillations with the rest of the loop, and so does more damping, which a
/// pass over the loop cannot follow: of a net of 25 x 25 discs that hangs on seven of them hinges part by 3 mm with a
/// ratio of 0.5 to 1, by 40 with 2 and by 300 with 5; by 3 mm with a period of 4, 7 with 6 and 100 with 3.
template <class T>
inline constexpr T loop_period = T(4);
template <class T>
inline constexpr T loop_damping_ratio = T(1);

template <class T>
T part_of(T error, T drift) {
  using std::abs;
  if (abs(error) <= drift) return error;
  const T size = greatest(drift, abs(error) * recovered_part<T>);
  return error < T(0) ? -size : size;
}

/// An angle by whole turns as near to `about` as can be.
template <class T>
T nearest_turn(T angle, T about) {
  constexpr T turn = T(2) * std::numbers::pi_v<T>;
  return angle + turn * std::floor((about - angle) / turn + T(0.5));
}

template <class Mass, class Turning>
Turning turned_by(const Mass& mass, const Turning& angular) {
  return mass.inertia * angular;
}

}  // namespace

template <class T, class Space>
void JointRows<T, Space>::measure(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) {
  const JointFrames<T, Space> frames(a, joint_->frame_a, b, joint_->frame_b);
  reach_ = length(frames.arm_a) + length(frames.arm_b);
  for (Row& row : rows_) {
    row.at = frames.measured(row.what);
    const T value = row.what.measure == Measure::twist ? nearest_turn(row.at.value, row.about) : row.at.value;
    row.error = value - row.target;
  }
  factor(a, b);
  for (std::size_t i = locked_; i < rows_.size(); ++i) free_of_locked(rows_[i], a, b);
}

template <class T, class Space>
void JointRows<T, Space>::factor(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) {
  std::array<typename Space::Vec, most_locked> linear{};
  std::array<typename Space::Turning, most_locked> turn_a{}, turn_b{};
  for (std::size_t i = 0; i < locked_; ++i) {
    linear[i] = rows_[i].at.linear * (a.mass.mass + b.mass.mass);
    turn_a[i] = turned_by(a.mass, rows_[i].at.angular_a);
    turn_b[i] = turned_by(b.mass, rows_[i].at.angular_b);
  }
  const auto element = [&](std::size_t i, std::size_t j) {
    const MeasuredRow<T, Space>& o = rows_[j].at;
    return dot(linear[i], o.linear) + dot(turn_a[i], o.angular_a) + dot(turn_b[i], o.angular_b);
  };
  factors_.factor(locked_, element, [&](std::size_t i) { return element(i, i); });
}

/// Adds the reaction of the locked axes to a row, so that pushing it does not move them.
template <class T, class Space>
void JointRows<T, Space>::free_of_locked(Row& row, const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) const {
  const auto linear = row.at.linear * (a.mass.mass + b.mass.mass);
  const auto turn_a = turned_by(a.mass, row.at.angular_a), turn_b = turned_by(b.mass, row.at.angular_b);
  std::array<T, most_locked> coupling{};
  for (std::size_t i = 0; i < locked_; ++i) {
    const MeasuredRow<T, Space>& r = rows_[i].at;
    coupling[i] = dot(linear, r.linear) + dot(turn_a, r.angular_a) + dot(turn_b, r.angular_b);
  }
  row.reaction = factors_.solved(coupling);
  row.free = row.at;
  row.free.value = T(0);
  for (std::size_t i = 0; i < locked_; ++i) {
    const MeasuredRow<T, Space>& r = rows_[i].at;
    row.free.linear -= r.linear * row.reaction[i];
    row.free.angular_a -= r.angular_a * row.reaction[i];
    row.free.angular_b -= r.angular_b * row.reaction[i];
  }
  const T own = dot(linear, row.at.linear) + dot(turn_a, row.at.angular_a) + dot(turn_b, row.at.angular_b);
  row.yielding = dot(row.free.linear, linear) + dot(row.free.angular_a, turn_a) + dot(row.free.angular_b, turn_b);
  if (!(row.yielding > own * redundant<T>)) row.yielding = T(0);
}

template <class T, class Space>
void JointRows<T, Space>::refresh(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) {
  measure(a, b);
  for (std::size_t i = locked_; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    const bool inside =
        (row.side == Side::lower && row.error >= T(0)) || (row.side == Side::upper && row.error <= T(0));
    row.active = row.yielding > T(0) && !(row.soft && inside);
    if (!row.active) row.impulse = T(0);
  }
}

template <class T, class Space>
void push_row(const MeasuredRow<T, Space>& row, T impulse, SolverBody<T, Space>& a, SolverBody<T, Space>& b) {
  a.linear -= row.linear * (impulse * a.mass.mass);
  b.linear += row.linear * (impulse * b.mass.mass);
  a.angular -= a.mass.inertia * (row.angular_a * impulse);
  b.angular += b.mass.inertia * (row.angular_b * impulse);
}

template <class T, class Space>
T rate_of(const MeasuredRow<T, Space>& row, const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) {
  return row.rate(a.linear, a.angular, b.linear, b.angular);
}
template <class T, class Space>
T rate_before(const MeasuredRow<T, Space>& row, const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) {
  return row.rate(a.linear_before, a.angular_before, b.linear_before, b.angular_before);
}

template <class T, class Space>
void JointRows<T, Space>::warm_start(SolverBody<T, Space>& a, SolverBody<T, Space>& b) const {
  for (const Row& row : rows_) push_row(row.at, row.impulse, a, b);
}

template <class T, class Space>
void JointRows<T, Space>::start_cold() {
  for (Row& row : rows_) row.impulse = T(0);
}

template <class T, class Space>
void JointRows<T, Space>::arrive(SolverBody<T, Space>& a, SolverBody<T, Space>& b) {
  for (const Row& row : rows_) push_row(row.at, row.impulse / T(-2), a, b);
  measure(a, b);
  for (const Row& row : rows_) push_row(row.at, row.impulse / T(2), a, b);
}

template <class T, class Space>
void JointRows<T, Space>::solve_free(SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias) {
  for (std::size_t i = locked_; i < rows_.size(); ++i) {
    Row& row = rows_[i];
    if (!row.active || !(row.yielding > T(0))) continue;
    if (!row.soft)
      solve_hard(row, a, b, bias);
    else if (bias)
      solve_soft(row, a, b);
  }
}

/// The part of a row's error that one sub-step takes back.
template <class T, class Space>
T JointRows<T, Space>::corrected(const Row& row) const {
  const bool angle = row.what.measure != Measure::along && row.what.measure != Measure::distance;
  return part_of(row.error, angle ? drift_part<T> : drift_part<T> * reach_);
}

/// The rate at which an error is gone at the end of the sub-step: where bodies move by h (v₀ + v₁) / 2, it is
/// -2 e / h - v₀, and where they move by h v₁, -e / h.
template <class T, class Space>
T JointRows<T, Space>::rate_towards(const Row& row, T error, const SolverBody<T, Space>& a,
                                    const SolverBody<T, Space>& b) const {
  if (!step_.joined_by_mean) return -error * step_.inverse_h;
  return T(-2) * error * step_.inverse_h - rate_before(row.at, a, b);
}

template <class T, class Space>
auto JointRows<T, Space>::wanted(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b, bool bias) const
    -> std::array<T, most_locked> {
  std::array<T, most_locked> rates{};
  for (std::size_t i = 0; i < locked_; ++i) {
    const Row& row = rows_[i];
    rates[i] = -rate_of(row.at, a, b);
    if (bias) rates[i] += rate_towards(row, corrected(row), a, b);
  }
  return rates;
}

template <class T, class Space>
void JointRows<T, Space>::push_locked(const std::array<T, most_locked>& impulses, SolverBody<T, Space>& a,
                                      SolverBody<T, Space>& b) {
  for (std::size_t i = 0; i < locked_; ++i) {
    rows_[i].impulse += impulses[i];
    push_row(rows_[i].at, impulses[i], a, b);
  }
}

template <class T, class Space>
void JointRows<T, Space>::solve_loop(SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias) {
  const Softness<T> spring =
      softness(T(2) * std::numbers::pi_v<T> * step_.inverse_h / loop_period<T>, loop_damping_ratio<T>, step_.h);
  std::array<T, most_locked> rates{};
  for (std::size_t i = 0; i < locked_; ++i) {
    rates[i] = -rate_of(rows_[i].at, a, b);
    if (bias) rates[i] -= corrected(rows_[i]) * spring.bias_rate;
  }
  std::array<T, most_locked> impulses = factors_.solved(rates);
  if (bias)
    for (std::size_t i = 0; i < locked_; ++i)
      impulses[i] = impulses[i] * spring.mass_scale - rows_[i].impulse * spring.impulse_scale;
  push_locked(impulses, a, b);
}

template <class T, class Space>
void JointRows<T, Space>::push_free(Row& row, T impulse, SolverBody<T, Space>& a, SolverBody<T, Space>& b) {
  push_row(row.free, impulse, a, b);
  row.impulse += impulse;
  for (std::size_t i = 0; i < locked_; ++i) rows_[i].impulse -= row.reaction[i] * impulse;
}

/// Solves a bound, which is kept at the end of the sub-step, however far it is now; once there,
/// nothing goes on past it.
template <class T, class Space>
void JointRows<T, Space>::solve_hard(Row& row, SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias) {
  T wanted = -rate_of(row.at, a, b);
  if (bias) {
    const bool past = row.side == Side::both || (row.side == Side::lower) == (row.error < T(0));
    wanted += rate_towards(row, past ? corrected(row) : row.error, a, b);
  } else if (row.side != Side::both && row.impulse == T(0)) {
    return;
  }
  T impulse = row.impulse + wanted / row.yielding;
  if (row.side == Side::lower) impulse = greatest(impulse, T(0));
  if (row.side == Side::upper) impulse = least(impulse, T(0));
  push_free(row, impulse - row.impulse, a, b);
}

/// A spring and damper by the implicit midpoint rule, which neither adds nor takes energy and is right to the second
/// order; one that is too stiff for the sub-step by backward Euler (weight 1), which does not ring, as is any whose
/// bodies do not move by the mean of their velocities.
template <class T, class Space>
void JointRows<T, Space>::solve_soft(Row& row, SolverBody<T, Space>& a, SolverBody<T, Space>& b) {
  const T h = step_.h, mass = row.acceleration ? T(1) / row.yielding : T(1);
  const T k = row.stiffness * mass, c = row.damping * mass;
  const T stiff = h * (h * k + c) * row.yielding;
  const T weight = !step_.joined_by_mean ? T(1) : stiff > T(1) ? T(1) - T(1) / stiff : T(0);
  const T middle = T(1) - weight;
  const T before = h * (h * k * middle / T(4) + c * middle / T(2));
  const T after = h * (h * k * (middle / T(4) + weight) + c * (middle / T(2) + weight));
  const T wanted = h * (c * row.target_speed - k * row.error) - before * rate_before(row.at, a, b);
  T impulse = row.impulse + (wanted - after * rate_of(row.at, a, b) - row.impulse) / (T(1) + after * row.yielding);
  const T most = row.max_force * h;
  impulse = least(greatest(impulse, -most), most);
  if (row.side == Side::lower) impulse = greatest(impulse, T(0));
  if (row.side == Side::upper) impulse = least(impulse, T(0));
  push_free(row, impulse - row.impulse, a, b);
}

#define GRAZE_JOINTS(T, Space)                                                                                         \
  template void JointRows<T, Space>::refresh(const SolverBody<T, Space>&, const SolverBody<T, Space>&);                \
  template void JointRows<T, Space>::warm_start(SolverBody<T, Space>&, SolverBody<T, Space>&) const;                   \
  template void JointRows<T, Space>::start_cold();                                                                     \
  template void JointRows<T, Space>::arrive(SolverBody<T, Space>&, SolverBody<T, Space>&);                             \
  template auto JointRows<T, Space>::wanted(const SolverBody<T, Space>&, const SolverBody<T, Space>&, bool)            \
      const->std::array<T, most_locked>;                                                                               \
  template void JointRows<T, Space>::push_locked(const std::array<T, most_locked>&, SolverBody<T, Space>&,             \
                                                 SolverBody<T, Space>&);                                               \
  template void JointRows<T, Space>::solve_loop(SolverBody<T, Space>&, SolverBody<T, Space>&, bool);                   \
  template void JointRows<T, Space>::solve_free(SolverBody<T, Space>&, SolverBody<T, Space>&, bool);
GRAZE_JOINTS(float, Space<float>)
GRAZE_JOINTS(double, Space<double>)
GRAZE_JOINTS(float, plane::Space<float>)
GRAZE_JOINTS(double, plane::Space<double>)
#undef GRAZE_JOINTS

}  // namespace graze
