// One island: its bodies and rows side by side, and the sub-steps that solve them.
//
// Guarantee: an island touches nothing outside itself until `store`: bodies that nothing pushes are copied into every
// island that they touch. So islands run on any threads, in any order, with the same bits. So do the contacts of one
// island, colour by colour, if it is given an executor.
#pragma once

#include <vector>

#include "dynamics/body_kernels.hpp"
#include "dynamics/contact_bundles.hpp"
#include "dynamics/joint_system.hpp"
#include "dynamics/joints.hpp"
#include "dynamics/sub_step_count.hpp"

namespace graze {

/// A step, the one that springs are made for, and the part of the last step's impulses that this one has.
template <class T>
struct StepTime {
  T step, usual_step, share;
  bool warm_start;  ///< sub-steps begin with the impulses of the last one
};

template <class T, class Space>
class IslandSolver {
 public:
  /// Empties the island. `executor` has threads for its contacts and bodies; null where the island has one thread.
  void clear(Executor* executor = nullptr);
  /// Adds a body and returns its place in the island. Those that can be pushed are added first.
  std::uint32_t add(const IslandBody<T, Space>& body);
  /// Adds a body that nothing pushes, once for each `index`, and returns its place.
  std::uint32_t add_once(std::uint32_t index, const IslandBody<T, Space>& body);
  /// Adds the manifolds of a pair, which outlive the step.
  void add(const TouchingBodies<T, Space>& touching, std::span<const ContactManifold<T, Space>> manifolds);
  void add(JointInPlace<T, Space>& joint, std::uint32_t a, std::uint32_t b);

  /// Chooses the number of sub-steps by the impulses of the last step (sub_step_count.hpp), from `least` to `most`.
  void choose_sub_steps(std::span<const SolverPoint<T, Space>> points, const StepTime<T>& time, T gravity, int least,
                        int most);
  void solve(std::span<const SolverPoint<T, Space>> points, const StepTime<T>& time, T gravity);
  /// Writes the impulses to the world's points and to the joints.
  void store(std::span<SolverPoint<T, Space>> points);

  const FreeBodyIn<Space>& body(std::uint32_t place) const { return states_[place].free; }
  int sub_steps() const { return sub_steps_; }
  /// Whether the body still overlaps what it, or the other, was put into by hand.
  bool placed(std::uint32_t body) const { return placed_[body] != 0; }
  std::size_t point_count() const { return contacts_.point_count(); }
  std::size_t color_count() const { return contacts_.color_count(); }
  /// The fastest approach of a point that touches.
  T residual() const { return residual_; }

 private:
  void find_overlap(std::span<const SolverPoint<T, Space>> points, T step);
  void prepare_contacts(std::span<const SolverPoint<T, Space>> points, const StepTime<T>& whole);
  void begin_sub_step(const SubStep<T>& time);
  void begin_joints(bool warm_start);
  void move(const SubStep<T>& time);
  void end_sub_step();
  void turn_inertia(std::size_t i);
  void move_unpushed(const SubStep<T>& time);
  void solve_rows(const ContactStep<T>& step, bool bias);
  void solve_joints(bool bias);
  void arrive();
  IslandLoad<T> load(std::span<const SolverPoint<T, Space>> points, T step, T gravity, T share) const;
  void relax(const ContactStep<T>& step);
  void find_residual();
  T weight() const;
  T parting();
  template <class F>
  T greatest_speed(const F& of);
  template <class F>
  void each(std::size_t count, std::size_t per_task, const F& f);
  template <class F>
  void each_pushed(const F& f);
  template <class F>
  void each_bundle(const F& f);

  const BodyKernels<T, Space>& body_kernels_ = GRAZE_KERNEL(chosen_isa(), body_kernels)().template of<T, Space>();
  std::size_t pushed_ = 0;  ///< bodies that can be pushed: they come first
  std::vector<IslandBody<T, Space>> states_;
  std::vector<SolverBody<T, Space>> bodies_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> immovable_;  ///< by index, sorted: their places
  std::vector<std::uint8_t> movable_;
  ContactBundles<T, Space> contacts_;
  std::vector<JointRows<T, Space>> joints_;
  std::vector<JointInPlace<T, Space>*> joined_;
  JointSystem<T, Space> joint_system_;
  bool by_mean_ = true;  ///< bodies on joints move by the mean of their velocities
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joint_bodies_;
  Executor* executor_ = nullptr;
  std::vector<std::uint8_t> placed_;
  int sub_steps_ = 1;
  bool overlap_ = false;  ///< whether bodies were put into each other
  T smallest_{};          ///< the size of the smallest body that touches another
  T residual_{};
};

}  // namespace graze
