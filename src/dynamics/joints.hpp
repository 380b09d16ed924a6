// Rows of joints: prepared once a step, then solved with the contacts of their island in every sub-step.
//
// Guarantee: rows read and write `SolverBody` alone. A joint is solved by itself: the island calls, in this order,
// `prepare` once a step, and in each sub-step `refresh`, `warm_start`, `solve` with bias, and, once the bodies have
// moved, `solve` without. Impulses on the two bodies are opposite. A joint alone needs one pass: what it locks is
// solved at once, by elimination, and limits and drives push in directions that what is locked leaves free.
//
// A constraint force at the beginning of the sub-step alone adds or takes energy where a pendulum swings. Once the
// bodies have moved, half of what the rows pushed is taken back and pushed along the rows at the new place: the
// trapezoid of RATTLE (Andersen 1983), which keeps energy over any time.
#pragma once

#include <array>
#include <type_traits>
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
  std::vector<T> impulses;  ///< λ of each row in the last step solved, as its last sub-step had it; carried on
  T impulse_step{};         ///< the duration of that step
};

/// Throws `InvalidValue` for frames, limits and drives that are none. The bodies are the caller's to check.
template <class T, class Space>
void check(const Joint<T, Space>& joint);

/// L D Lᵀ of a symmetric matrix that has no negative eigenvalues. A row that follows from those before is left out.
template <class T, std::size_t N>
class FactoredRows {
 public:
  using Rows = std::array<T, N>;

  /// Factors the first `count` rows, by their lower half. `scale(i)`: the size of the terms whose difference a diagonal
  /// element is.
  template <class Element, class Scale>
  void factor(std::size_t count, const Element& element, const Scale& scale);
  /// The vector whose product with the matrix is `v`; zero in the rows that were left out.
  Rows solved(Rows v) const;

 private:
  std::size_t count_ = 0;
  std::array<Rows, N> lower_{};
  Rows inverse_pivots_{};  ///< of D; zero where a row follows from those before
};

/// A row follows from those before where elimination leaves no more than this part of its scale. In single precision
/// some roundings, since long arms leave little too: what holds a body by an arm of two hundred of its sizes leaves one
/// in 200,000. Double precision can be surer that what is left is more than roundings.
template <class T>
inline constexpr T redundant = std::is_same_v<T, float> ? T(64) * std::numeric_limits<T>::epsilon() : T(1e-10);

template <class T, std::size_t N>
template <class Element, class Scale>
void FactoredRows<T, N>::factor(std::size_t count, const Element& element, const Scale& scale) {
  count_ = count;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      T k = element(i, j);
      for (std::size_t m = 0; m < j; ++m)
        if (inverse_pivots_[m] > T(0)) k -= lower_[i][m] * lower_[j][m] / inverse_pivots_[m];
      if (j < i)
        lower_[i][j] = k * inverse_pivots_[j];
      else
        inverse_pivots_[i] = k > scale(i) * redundant<T> ? T(1) / k : T(0);
    }
}

template <class T, std::size_t N>
auto FactoredRows<T, N>::solved(Rows v) const -> Rows {
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = 0; j < i; ++j) v[i] -= lower_[i][j] * v[j];
  for (std::size_t i = 0; i < count_; ++i) v[i] *= inverse_pivots_[i];
  for (std::size_t i = count_; i-- > 0;)
    for (std::size_t j = i + 1; j < count_; ++j) v[i] -= lower_[j][i] * v[j];
  return v;
}

/// The number of axes of a limit.
inline int count(const std::array<bool, 3>& axes) { return int{axes[0]} + int{axes[1]} + int{axes[2]}; }

/// The rows of a joint while a step is solved. Those of locked axes are solved by `JointSystem`, or, where the joint
/// closes one loop too many for that, by themselves.
template <class T, class Space = graze::Space<T>>
class JointRows {
 public:
  static constexpr std::size_t most_locked = std::is_same_v<typename Space::Vec, Vec3<T>> ? 6 : 3;

  /// Takes the joint's impulses over, scaled to the sub-steps of this step. `joint` outlives the rows.
  void prepare(JointInPlace<T, Space>& joint, const SubStep<T>& step);
  /// Sets the sub-step where bodies move otherwise than `prepare` assumed.
  void set_step(const SubStep<T>& step) { step_ = step; }
  /// Computes axes, arms, errors and effective masses where the bodies are now, at the beginning of a sub-step.
  void refresh(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b);
  /// Applies the impulses of the last sub-step.
  void warm_start(SolverBody<T, Space>& a, SolverBody<T, Space>& b) const;
  /// Drops the impulses of the last sub-step.
  void start_cold();
  /// Computes the axes where the bodies are at the end of the sub-step, for the pass without bias after they have moved
  /// by the mean of their velocities.
  void arrive(SolverBody<T, Space>& a, SolverBody<T, Space>& b);
  /// The locked rows, and by how much their rates are to change: with `bias` errors of position are corrected (see
  /// `SubStep`), otherwise velocities alone.
  std::size_t locked() const { return locked_; }
  /// Whether the joint has neither bounds nor drives.
  bool all_locked() const { return locked_ == rows_.size(); }
  const MeasuredRow<T, Space>& locked_row(std::size_t i) const { return rows_[i].at; }
  T locked_impulse(std::size_t i) const { return rows_[i].impulse; }
  std::array<T, most_locked> wanted(const SolverBody<T, Space>& a, const SolverBody<T, Space>& b, bool bias) const;
  void push_locked(const std::array<T, most_locked>& impulses, SolverBody<T, Space>& a, SolverBody<T, Space>& b);
  /// One pass over the locked rows of a joint that closes a loop and is not held by `JointSystem`: as a spring, since
  /// the other joints of the loop are not taken into account.
  void solve_loop(SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias);
  /// One pass over the rows of bounds and drives.
  void solve_free(SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias);
  /// Writes the impulses back to the joint.
  void store() const;

  std::uint32_t a() const { return joint_->a; }
  std::uint32_t b() const { return joint_->b; }

 private:
  /// The values towards which a row pushes: any, or only larger or smaller ones.
  enum class Side : std::uint8_t { both, lower, upper };

  struct Row {
    Measured what{};
    Side side = Side::both;
    bool soft = false, acceleration = false, angle = false;
    bool active = true;
    T target{}, target_speed{}, stiffness{}, damping{}, max_force{};
    T about{};  ///< the angle to which those that differ by whole turns are taken: the target, or the middle of bounds
    T impulse{};
    // Values where the bodies are now.
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
  void solve_hard(Row& row, SolverBody<T, Space>& a, SolverBody<T, Space>& b, bool bias);
  void solve_soft(Row& row, SolverBody<T, Space>& a, SolverBody<T, Space>& b);
  void push_free(Row& row, T impulse, SolverBody<T, Space>& a, SolverBody<T, Space>& b);
  T corrected(const Row& row) const;
  T rate_towards(const Row& row, T error, const SolverBody<T, Space>& a, const SolverBody<T, Space>& b) const;

  JointInPlace<T, Space>* joint_ = nullptr;
  SubStep<T> step_{};
  std::vector<Row> rows_;  ///< those that are locked first
  std::size_t locked_ = 0;
  FactoredRows<T, most_locked> factors_{};  ///< of the locked rows' J M⁻¹ Jᵀ
  T reach_{};                               ///< of both arms
};

}  // namespace graze
