// One island: its bodies and rows side by side, and the sub-steps that solve them.
//
// Guarantee: an island touches nothing outside itself until `store`: bodies that nothing pushes are copied into every
// island that they touch. So islands run on any threads, in any order, with the same bits.
#pragma once

#include <vector>

#include "dynamics/contact_rows.hpp"
#include "dynamics/joints.hpp"

namespace graze {

/// What an island has to know of a body.
template <class T>
struct IslandBody {
  FreeBody<T> free{};   ///< as it is now
  FreeBody<T> first{};  ///< as contacts found it
  Vec3<T> inertia{};    ///< about the principal axes
  T inverse_mass{};
  Vec3<T> spin{};  ///< of a body that nothing pushes
  Vec3<T> acceleration{}, torque{};
  T linear_damping{}, angular_damping{};
  T share = T(1);  ///< of a sub-step's duration that the body has
  bool movable = false;
};

template <class T>
class IslandSolver {
 public:
  void clear();
  /// The body's place in the island.
  std::uint32_t add(const IslandBody<T>& body);
  /// The place of a body that nothing pushes, which may be asked for again by its `index`.
  std::uint32_t add_once(std::uint32_t index, const IslandBody<T>& body);
  /// Contacts whose points have impulses of a whole step of `last_step`.
  void add(const TouchingBodies<T>& touching, const ContactManifold<T>& manifold,
           std::span<const SolverPoint<T>> points, T share);
  void add(JointInPlace<T>& joint, std::uint32_t a, std::uint32_t b);

  /// As many sub-steps as it takes, by the impulses of the last step, that no contact sinks visibly: a power of two
  /// from `least` to `most`.
  void choose_sub_steps(T step, T gravity, int least, int most);
  void solve(T step, T gravity);
  /// Impulses to the world's points and to the joints.
  void store(std::span<SolverPoint<T>> points);

  const FreeBody<T>& body(std::uint32_t place) const { return states_[place].free; }
  int sub_steps() const { return sub_steps_; }
  std::size_t point_count() const { return points_.size(); }
  std::size_t color_count() const { return colors_; }
  /// The fastest approach of a point that touches.
  T residual() const { return residual_; }

 private:
  void begin_sub_step(const SubStep<T>& time);
  void move(const SubStep<T>& time);
  void end_sub_step();
  void solve_rows(const ContactStep<T>& step, bool bias);
  void note_pressed();
  void find_residual();

  std::vector<IslandBody<T>> states_;
  std::vector<SolverBody<T>> bodies_;
  std::vector<Mat3<T>> inertias_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> immovable_;  ///< by index, sorted: their places
  std::vector<ManifoldRows<T>> manifolds_;
  std::vector<PointRow<T>> points_;
  std::vector<JointRows<T>> joints_;
  std::vector<JointInPlace<T>*> joined_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> joint_bodies_;
  int sub_steps_ = 1;
  std::size_t colors_ = 0;
  T residual_{};
};

}  // namespace graze
