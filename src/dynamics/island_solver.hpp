// One island: its bodies and rows side by side, and the sub-steps that solve them.
//
// Guarantee: an island touches nothing outside itself until `store`: bodies that nothing pushes are copied into every
// island that they touch. So islands run on any threads, in any order, with the same bits. So do the contacts of one
// island, colour by colour, if it is given an executor.
#pragma once

#include <vector>

#include "dynamics/colors.hpp"
#include "dynamics/contact_rows.hpp"
#include "dynamics/joint_system.hpp"
#include "dynamics/joints.hpp"

namespace graze {

/// What an island has to know of a body.
template <class T, class Space>
struct IslandBody {
  FreeBodyIn<Space> free{};   ///< as it is now
  FreeBodyIn<Space> first{};  ///< as contacts found it
  typename Rigid<Space>::PrincipalInertia inertia{};
  T inverse_mass{};
  typename Space::Turning spin{};  ///< of a body that nothing pushes
  typename Space::Vec acceleration{};
  typename Space::Turning torque{};
  T linear_damping{}, angular_damping{};
  T share = T(1);     ///< of a sub-step's duration that the body has
  int sub_steps = 0;  ///< of its island in the last step; 0 of a body that is new
  bool movable = false;
};

template <class T, class Space>
class IslandSolver {
 public:
  /// An empty island, for whose contacts and bodies `executor` has threads; null where the island has one thread.
  void clear(Executor* executor = nullptr);
  /// The body's place in the island.
  std::uint32_t add(const IslandBody<T, Space>& body);
  /// The place of a body that nothing pushes, which may be asked for again by its `index`.
  std::uint32_t add_once(std::uint32_t index, const IslandBody<T, Space>& body);
  /// The manifolds of a pair, which outlive the step.
  void add(const TouchingBodies<T, Space>& touching, std::span<const ContactManifold<T, Space>> manifolds);
  void add(JointInPlace<T, Space>& joint, std::uint32_t a, std::uint32_t b);

  /// Colours and rows of what was added. `share` is what the step has of the last one's impulses.
  void prepare_contacts(std::span<const SolverPoint<T, Space>> points, T share);
  /// As many sub-steps as it takes, by the impulses of the last step, that no contact sinks visibly, and no fewer than
  /// half of the last step's: a power of two from `least` to `most`.
  void choose_sub_steps(T step, T gravity, int least, int most);
  void solve(T step, T gravity);
  /// Impulses to the world's points and to the joints.
  void store(std::span<SolverPoint<T, Space>> points);

  const FreeBodyIn<Space>& body(std::uint32_t place) const { return states_[place].free; }
  int sub_steps() const { return sub_steps_; }
  std::size_t point_count() const { return points_.size(); }
  std::size_t color_count() const { return coloring_.colors().size(); }
  /// The fastest approach of a point that touches.
  T residual() const { return residual_; }

 private:
  /// A pair that touches.
  struct Contact {
    TouchingBodies<T, Space> touching;
    std::span<const ContactManifold<T, Space>> found;
    std::uint32_t first_manifold = 0, manifold_count = 0;  ///< those with points
    std::uint32_t first_row = 0;
  };

  void begin_sub_step(const SubStep<T>& time);
  void move(const SubStep<T>& time);
  void end_sub_step();
  void begin_body(std::size_t i, const SubStep<T>& time);
  void move_body(std::size_t i, const SubStep<T>& time);
  void end_body(std::size_t i);
  void solve_rows(const ContactStep<T>& step, bool bias);
  void solve_joints(bool bias);
  void arrive();
  void warm_start_contacts();
  void find_residual();
  std::span<PointRow<T, Space>> rows_of(const ManifoldRows<T, Space>& m) {
    return std::span(points_).subspan(m.first_row, m.row_count);
  }
  std::span<ManifoldRows<T, Space>> manifolds_of(const Contact& c) {
    return std::span(manifolds_).subspan(c.first_manifold, c.manifold_count);
  }
  template <class F>
  void each(std::size_t count, const F& f);
  template <class F>
  void each_by_color(const F& f);

  std::vector<IslandBody<T, Space>> states_;
  std::vector<SolverBody<T, Space>> bodies_;
  std::vector<InertiaIn<Space>> inertias_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> immovable_;  ///< by index, sorted: their places
  std::vector<std::uint8_t> movable_;
  std::vector<Contact> contacts_, added_;  ///< colour by colour; as they were added
  std::vector<IslandLink> touching_;       ///< of those that were added
  Coloring coloring_;
  std::vector<ManifoldRows<T, Space>> manifolds_;  ///< in the order of the contacts, as are the points
  std::vector<PointRow<T, Space>> points_;
  std::vector<JointRows<T, Space>> joints_;
  std::vector<JointInPlace<T, Space>*> joined_;
  JointSystem<T, Space> joint_system_;
  bool by_mean_ = true;  ///< what joints hold moves by the mean of its velocities
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joint_bodies_;
  Executor* executor_ = nullptr;
  int sub_steps_ = 1;
  T residual_{};
};

}  // namespace graze
