// Rows of joints: prepared once a step, then solved with the contacts of their island in every sub-step.
//
// Guarantee: rows read and write `SolverBody` alone. A joint is solved by itself: the island calls, in this order,
// `prepare` once a step, and in each sub-step `refresh`, `warm_start`, `solve` with bias, and, once the bodies have
// moved, `solve` without. Impulses on the two bodies are opposite. A joint alone needs one pass: what it locks is
// solved at once, by elimination, and limits and drives push in directions that what is locked leaves free.
//
// Where a pendulum swings, a constraint force at the beginning of the sub-step alone adds or takes energy. Once the
// bodies have moved, half of what the rows pushed is taken back and pushed along the rows at the new place: the
// trapezoid of RATTLE (Andersen 1983), which keeps energy over any time.
#pragma once

#include <array>
#include <vector>

#include "dynamics/joint_measures.hpp"
#include "dynamics/solver_body.hpp"
#include "graze/joint.hpp"

namespace graze {

/// A joint among the bodies of a simulation.
template <class T, class Space = graze::Space<T>>
struct JointInPlace {
  Joint<T, Space> joint;
  std::uint32_t a{}, b{};                     ///< indices of the bodies, as all arrays have them
  typename Space::Pose frame_a{}, frame_b{};  ///< in the frames of the principal axes about the centres of mass
  std::vector<T> impulses;  ///< λ of each row, of the last sub-step solved; carried from step to step
  T impulse_step{};         ///< the duration of that sub-step
};

/// Throws `InvalidValue` for frames, limits and drives that are none. The bodies are the caller's to check.
template <class T, class Space>
void check(const Joint<T, Space>& joint);

/// The rows of a joint while a step is solved.
template <class T, class Space = graze::Space<T>>
class JointRows {
 public:
  /// Takes the joint's impulses over, scaled to the sub-steps of this step. `joint` outlives the rows.
  void prepare(JointInPlace<T, Space>& joint, const SubStep<T>& step);
  /// Axes, arms, errors and effective masses where the bodies are now, at the beginning of a sub-step.
  void refresh(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b);
  /// Applies the impulses of the last sub-step.
  void warm_start(SolverBody<T, Space>& a, SolverBody<T, Space>& b) const;
  /// One pass over the rows: with `bias` errors of position are corrected (see `SubStep`), otherwise velocities alone.
  void solve(SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias);
  /// Writes the impulses back to the joint.
  void store() const;

  std::uint32_t a() const { return joint_->a; }
  std::uint32_t b() const { return joint_->b; }

 private:
  static constexpr std::size_t most_locked = 6;

  /// Which way a row pushes: any, or only towards larger or smaller values.
  enum class Side : std::uint8_t { both, lower, upper };

  struct Row {
    Measured what{};
    Side side = Side::both;
    bool soft = false, acceleration = false, angle = false;
    bool active = true;
    T target{}, target_speed{}, stiffness{}, damping{}, max_force{};
    T impulse{};
    // Where the bodies are now.
    MeasuredRow<T, Space> at{};
    T error{};     ///< past the target
    T yielding{};  ///< the change of the rate by an impulse of 1, with what is locked pushing back
    std::array<T, most_locked> reaction{};  ///< of what is locked, to an impulse of 1
    MeasuredRow<T, Space> free{};           ///< the row less that reaction
  };

  void add_limits(const Joint<T, Space>& joint);
  void add_bounds(const JointLimit<T>& limit, const Row& row);
  void measure(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b);
  void factor(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b);
  void free_of_locked(Row& row, const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) const;
  std::array<T, most_locked> eliminated(std::array<T, most_locked> v) const;
  void solve_locked(SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias);
  void solve_hard(Row& row, SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias);
  void solve_soft(Row& row, SolverBody<T, Space>& a, SolverBody<T, Space>& b);
  void push_free(Row& row, T impulse, SolverBody<T, Space>& a, SolverBody<T, Space>& b);
  T corrected(const Row& row) const;
  T rate_towards(const Row& row, T error, const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) const;

  JointInPlace<T, Space>* joint_ = nullptr;
  SubStep<T> step_{};
  std::vector<Row> rows_;  ///< those that are locked first
  std::size_t locked_ = 0;
  std::array<std::array<T, most_locked>, most_locked> lower_{};  ///< L of the locked rows' L D Lᵀ
  std::array<T, most_locked> inverse_pivots_{};                  ///< of D; zero where a row follows from those before
  T reach_{};                                                    ///< of both arms
  bool moved_ = false;                                           ///< the rows are those of the end of the sub-step
};

}  // namespace graze
