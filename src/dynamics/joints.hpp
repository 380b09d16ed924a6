// Rows of joints: prepared once a step, then solved with the contacts of their island in every sub-step.
//
// Guarantee: rows read and write `SolverBody` alone. A joint is solved by itself: the island calls, in this order,
// `prepare` once a step, and in each sub-step `refresh`, `warm_start`, `solve` with bias, and, once the bodies have
// moved, `solve` without.
#pragma once

#include <vector>

#include "dynamics/solver_body.hpp"
#include "graze/joint.hpp"

namespace graze {

/// A joint among the bodies of a simulation.
template <class T>
struct JointInPlace {
  Joint<T> joint;
  std::uint32_t a{}, b{};        ///< indices of the bodies, as all arrays have them
  Pose<T> frame_a{}, frame_b{};  ///< in the frames of the principal axes about the centres of mass
  std::vector<T> impulses;       ///< λ of each row, of the last sub-step solved; carried from step to step
  T impulse_step{};              ///< the duration of that sub-step
};

/// Throws `InvalidValue` for frames, limits and drives that are none. The bodies are the caller's to check.
template <class T>
void check(const Joint<T>& joint);

/// The rows of a joint while a step is solved.
template <class T>
class JointRows {
 public:
  /// Takes the joint's impulses over, scaled to the sub-steps of this step. `joint` outlives the rows.
  void prepare(JointInPlace<T>& joint, const SubStep<T>& step);
  /// Axes, arms, errors and effective masses where the bodies are now, at the beginning of a sub-step.
  void refresh(const SolverBody<T>& a, const SolverBody<T>& b);
  /// Applies the impulses of the last sub-step.
  void warm_start(SolverBody<T>& a, SolverBody<T>& b) const;
  /// One pass over the rows: with `bias` errors of position are corrected (see `SubStep`), otherwise velocities alone.
  void solve(SolverBody<T>& a, SolverBody<T>& b, bool bias);
  /// Writes the impulses back to the joint.
  void store() const;

  std::uint32_t a() const { return joint_->a; }
  std::uint32_t b() const { return joint_->b; }

 private:
  JointInPlace<T>* joint_ = nullptr;
  SubStep<T> step_{};
};

}  // namespace graze
