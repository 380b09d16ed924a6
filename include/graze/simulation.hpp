// A simulation: bodies that fall, collide, slide, stack, are joined and come to rest. A floor above `World`, which
// finds the contacts.
//
// Guarantee: a step is a function of the calls made so far alone: the same bits for any executor, and after `restore`.
// No length, speed or time is built in: sizes times four and steps times two give the same bits but for exponents. Free
// bodies fall exactly up to rounding and keep their angular momentum bit for bit. What throws has changed nothing.
//
// The method is that of soft contacts in sub-steps, each with a pass that takes the push out again ("soft step", Catto
// 2024, "Solver2D"), warm started by the feature of each contact. The number of sub-steps grows, island by island,
// where a contact would sink visibly under the load that it bore in the last step. Restitution is passed on through
// touching bodies by Newton's law (`blows.hpp`).
#pragma once

#include <memory>
#include <span>

#include "graze/joint.hpp"
#include "graze/material.hpp"
#include "graze/motion.hpp"
#include "graze/rigid.hpp"
#include "graze/world.hpp"

namespace graze {

/// What a simulation may be told at its beginning.
template <class T, class Space = graze::Space<T>>
struct SimulationSettings {
  typename Space::Vec gravity{T(0), T(-9.81)};  ///< an acceleration
  int sub_steps = 4;                            ///< of a step, at least; a power of two
  int most_sub_steps = 16;                      ///< of an island that bears much; a power of two
  bool sleep = true;                            ///< islands at rest cost nothing and do not move
  bool continuous = true;                       ///< what moves fast passes through nothing
  T longest_step = T(1);                        ///< a longer step is refused
};

/// What a step did. Lengths, masses and times in the caller's units; times by the clock in milliseconds.
template <class T, class Space = graze::Space<T>>
struct StepReport {
  std::size_t awake = 0;     ///< bodies that move by mass and are not asleep
  std::size_t islands = 0;   ///< of awake bodies
  std::size_t contacts = 0;  ///< points that were solved
  std::size_t colors = 0;    ///< of the largest island
  int most_sub_steps = 0;    ///< that any island took
  std::size_t stopped = 0;   ///< bodies that continuous collision held back
  T deepest{};               ///< penetration of any contact at the beginning of the step; 0 without
  T mean_depth{};            ///< of the points that penetrate
  T residual{};              ///< fastest approach of touching points that the solver left
  // Of the bodies with mass as they are now, asleep or not.
  T kinetic_energy{}, potential_energy{};      ///< the latter from the origin up
  typename Space::Vec momentum{};              ///< of all of them together
  typename Space::Turning angular_momentum{};  ///< about the origin
  /// By the clock: finding contacts, preparing, solving, what moves fast, and all of it.
  double collide_ms{}, prepare_ms{}, solve_ms{}, continuous_ms{}, whole_ms{};
};

template <class T, class Space>
struct SimulationParts;

/// Everything that `restore` brings back: a value that may be kept, copied and thrown away.
template <class T, class Space = graze::Space<T>>
class GRAZE_API State {
 public:
  State();
  ~State();
  State(const State&);                 ///< states are copied and moved as values
  State(State&&) noexcept;             ///< states are copied and moved as values
  State& operator=(const State&);      ///< states are copied and moved as values
  State& operator=(State&&) noexcept;  ///< states are copied and moved as values

 private:
  template <class, class>
  friend class Simulation;
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

/// Bodies that move by forces, contacts and joints.
template <class T, class Space = graze::Space<T>>
class GRAZE_API Simulation {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Pose = typename Space::Pose;
  using Velocity = typename Space::Velocity;
  using Motion = typename Rigid<Space>::Motion;
  using Dynamics = typename Rigid<Space>::Dynamics;
  using Material = graze::Material<T, Vec>;

 public:
  /// Throws `InvalidValue` for a gravity that is not finite or too large, sub-steps that are no powers of two from 1 to
  /// 1024, the most fewer than the least, and a longest step that is not > 0.
  explicit Simulation(const SimulationSettings<T, Space>& settings = {}, Executor* executor = nullptr);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// The velocity of the body is that of its pose's origin. Throws `InvalidValue` for what `World::add` refuses, and
  /// for masses and materials that are none. The shape of a body with mass has to be bounded.
  BodyId add(Body<T, Space> body, const Dynamics& dynamics = {}, const Material& material = {});
  /// Throws `InvalidValue` for bodies that are gone or the same, frames that are not finite, limits and drives that are
  /// none.
  JointId add(const Joint<T, Space>& joint);
  /// What stood on the body or was joined to it wakes; joints of the body go with it.
  void remove(BodyId id);
  void remove(JointId id);  ///< the bodies that it joined wake

  /// Moves everything by `dt` > 0. Throws `InvalidValue` for a step that is not finite, not > 0, or longer than
  /// `settings.longest_step`.
  void step(T dt);

  /// An impulse at a point of the world, at once. None of these moves what is fixed or kinematic; all wake.
  void apply_impulse(BodyId id, const Vec& impulse, const Vec& point);
  void apply_angular_impulse(BodyId id, const Turning& impulse);  ///< A turning blow, at once.
  /// A force on the centre of mass, and a torque, throughout the next step.
  void apply_force(BodyId id, const Vec& force);
  void apply_torque(BodyId id, const Turning& torque);  ///< A torque throughout the next step.
  /// Of the pose's origin, and the turning about it.
  void set_velocity(BodyId id, const Velocity& velocity);
  /// Puts a body elsewhere at once; its velocity stays.
  void set_pose(BodyId id, const Pose& pose);
  /// Gives a kinematic body the velocity that takes it to `pose` in a step of `dt`.
  void move_to(BodyId id, const Pose& pose, T dt);
  void set_material(BodyId id, const Material& material);  ///< its material from now on
  void wake(BodyId id);                                    ///< wakes the body and what touches it

  /// Of all bodies, by index; what is said in `World::bodies` of indices that are not alive.
  std::span<const Pose> poses() const;
  /// Of the centre of mass.
  Motion motion(BodyId id) const;
  Turning angular_momentum(BodyId id) const;       ///< about the centre of mass
  T mass(BodyId id) const;                         ///< infinite for what is fixed or kinematic
  bool asleep(BodyId id) const;                    ///< whether it is at rest and not moved until something wakes it
  int sub_steps(BodyId id) const;                  ///< of its island in the last step; 0 before its first
  std::vector<JointId> joints() const;             ///< all of them, by index
  const Joint<T, Space>& joint(JointId id) const;  ///< as it was added
  std::span<const T> joint_impulses(JointId id) const;  ///< of the last step, a number for each row of the joint

  /// Contacts with the impulses of the last step, events, and all queries. Contacts are those that the last step began
  /// with.
  const World<T, Space>& world() const;
  const SimulationSettings<T, Space>& settings() const;  ///< as they are now
  void set_gravity(const Vec& gravity);                  ///< from the next step on

  StepReport<T, Space> report() const;  ///< what the last step did
  /// A number for the bits of all that the next step follows from: poses, motions, rest, and the impulses of contacts
  /// and joints. The same in runs that are the same, and after `restore`. Costs a pass over bodies and contacts.
  std::uint64_t state_hash() const;

  State<T, Space> save() const;  ///< all that `restore` needs
  /// Goes back to a state of this simulation. Throws `InvalidValue` where bodies or joints came or went in between.
  /// Costs an update of the world. What touched is found anew, so that the events of the next step may begin what had
  /// begun before where bodies are apart by less than their margin.
  void restore(const State<T, Space>& state);

 private:
  std::unique_ptr<SimulationParts<T, Space>> parts_;
};

using Simulationf = Simulation<float>;
using Simulationd = Simulation<double>;

}  // namespace graze
