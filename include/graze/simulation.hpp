// A simulation: bodies that fall, collide, slide, stack, are joined and come to rest. A floor above `World`, which
// finds the contacts.
//
// Guarantee: a step is a function of the calls made so far alone: the same bits for any executor, and after `restore`.
// No length, speed or time is built in: sizes times four and steps times two give the same bits but for exponents. Free
// bodies fall exactly up to rounding and keep their angular momentum bit for bit. A call that throws has changed
// nothing.
//
// Method: soft contacts in sub-steps, each with a relaxing pass that takes the push out again ("soft step", Catto 2024,
// "Solver2D"), warm started by the feature of each contact. The number of sub-steps grows, island by island, where a
// contact would sink visibly under the load that it bore in the last step, up to sixteen, and further where bodies
// stand so high on each other that they would lean. Restitution is propagated through touching bodies by Newton's law
// (`blows.hpp`).
#pragma once

#include <memory>
#include <span>

#include "graze/joint.hpp"
#include "graze/material.hpp"
#include "graze/motion.hpp"
#include "graze/rigid.hpp"
#include "graze/world.hpp"

namespace graze {

/// Settings of a simulation.
template <class T, class Space = graze::Space<T>>
struct SimulationSettings {
  typename Space::Vec gravity{T(0), T(-9.81)};  ///< an acceleration
  int sub_steps = 4;                            ///< least number of sub-steps of a step; a power of two
  int most_sub_steps = 64;                      ///< largest number of sub-steps, for an island under load; a power of
                                                ///< two; more than 16 only where bodies stand high on each other or
                                                ///< fall by much of their size in a sub-step
  bool sleep = true;                            ///< islands at rest cost nothing and do not move
  bool continuous = true;                       ///< fast bodies do not pass through others
  bool warm_start = true;                       ///< a sub-step begins with the impulses of contacts and joints that the
                                                ///< last one ended with; without it with none: stacks sink and lean
  T longest_step = T(1);                        ///< longer steps are refused
};

/// Statistics of a step. Lengths, masses and times in the caller's units; durations by the clock in milliseconds.
template <class T, class Space = graze::Space<T>>
struct StepReport {
  std::size_t awake = 0;     ///< bodies moved by their mass that are not asleep
  std::size_t islands = 0;   ///< islands of awake bodies
  std::size_t contacts = 0;  ///< points that were solved
  std::size_t colors = 0;    ///< colours of the largest island's graph of contacts
  int most_sub_steps = 0;    ///< largest number of sub-steps of any island
  std::size_t stopped = 0;   ///< bodies that continuous collision held back
  T deepest{};               ///< penetration of any contact at the beginning of the step; 0 without
  T mean_depth{};            ///< mean depth of the penetrating points
  T residual{};              ///< fastest approach of touching points that the solver left
  // Sums over the bodies with mass as they are now, asleep or not.
  T kinetic_energy{}, potential_energy{};      ///< potential energy counts from the origin up
  typename Space::Vec momentum{};              ///< linear momentum
  typename Space::Turning angular_momentum{};  ///< angular momentum about the origin
  /// Durations by the clock: finding contacts, preparing, solving, continuous collision, and the whole step.
  double collide_ms{}, prepare_ms{}, solve_ms{}, continuous_ms{}, whole_ms{};
};

template <class T, class Space>
struct SimulationParts;

template <class T, class Space>
class GRAZE_API State;
template <class T, class Space>
GRAZE_API std::string state_bytes(const State<T, Space>& state);
template <class T, class Space>
GRAZE_API State<T, Space> read_state(std::string_view bytes);

/// A saved state, for `restore`: a value that may be kept, copied and thrown away, and outlives its simulation. With
/// `graze/state_bytes.hpp` it goes into a file and back.
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
  friend std::string graze::state_bytes<T, Space>(const State&);
  friend State graze::read_state<T, Space>(std::string_view);
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
  /// 1024, fewer `most_sub_steps` than `sub_steps`, and a longest step that is not > 0.
  explicit Simulation(const SimulationSettings<T, Space>& settings = {}, Executor* executor = nullptr);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Adds a body, whose velocity is that of its pose's origin. Throws `InvalidValue` for what `World::add` refuses, and
  /// for invalid masses and materials. The shape of a body with mass has to be bounded. Two bodies that nothing pushes,
  /// fixed, kinematic or of infinite mass, are no pair of the world. A trigger is pushed by nothing that it touches: it
  /// keeps its velocity, or, given a mass in `dynamics`, moves by gravity, forces and joints.
  BodyId add(Body<T, Space> body, const Dynamics& dynamics = {}, const Material& material = {});
  /// Adds a joint. Throws `InvalidValue` for bodies that are gone or the same, frames that are not finite, and invalid
  /// limits and drives.
  JointId add(const Joint<T, Space>& joint);
  /// Replaces the frames, limits and drives of a joint from the next step on, as of a motor that gets another target.
  /// Its bodies wake. Throws `InvalidValue` as `add` does, and for a joint of other bodies.
  void set_joint(JointId id, const Joint<T, Space>& joint);
  /// Removes a body and its joints. Bodies that stood on it or were joined to it wake.
  void remove(BodyId id);
  void remove(JointId id);  ///< removes a joint; its bodies wake

  /// Advances the simulation by `dt` > 0. Throws `InvalidValue` for a step that is not finite, not > 0, or longer than
  /// `settings.longest_step`.
  void step(T dt);

  /// Applies an impulse at a point of the world, at once. Impulses, forces and torques do not move fixed or kinematic
  /// bodies; all of them wake the body. Throws `InvalidValue` for what is not finite, or makes the body so fast that
  /// its velocity is not.
  void apply_impulse(BodyId id, const Vec& impulse, const Vec& point);
  void apply_angular_impulse(BodyId id, const Turning& impulse);  ///< Applies an angular impulse, at once.
  /// Applies a force to the centre of mass throughout the next step.
  void apply_force(BodyId id, const Vec& force);
  void apply_torque(BodyId id, const Turning& torque);  ///< Applies a torque throughout the next step.
  /// Sets the velocity of the pose's origin, and the rotation about it.
  void set_velocity(BodyId id, const Velocity& velocity);
  /// Puts a body elsewhere at once; its velocity stays.
  void set_pose(BodyId id, const Pose& pose);
  /// Gives a kinematic body the velocity that takes it to `pose` in a step of `dt`. Throws `InvalidValue` for any other
  /// body, and for a velocity that is not finite.
  void move_to(BodyId id, const Pose& pose, T dt);
  void set_material(BodyId id, const Material& material);  ///< replaces the material, of all pieces, from now on
  /// Gives the pieces of a body's shape materials of their own from now on: `of_piece[i]` is the place among
  /// `materials` of that of piece i, counted as `ContactManifold::piece_a` does: children of a compound, triangles of a
  /// mesh or a height field (two for each cell, holes included), in the plane children of a compound and segments of a
  /// chain. A point of contact has the material of the piece whose surface is nearest to it. Throws `InvalidValue` for
  /// another shape, for lists of other lengths, and for invalid materials. Costs a search of the shape's pieces in each
  /// step for each of its points of contact.
  void set_materials(BodyId id, std::span<const Material> materials, std::span<const std::uint32_t> of_piece);
  /// Replaces the filter of a body from the next step on. What it touches wakes.
  void set_filter(BodyId id, const Filter& filter);
  void wake(BodyId id);  ///< wakes the body and what touches it

  /// The poses of all bodies, by index. Indices that are not alive are as in `World::bodies`.
  std::span<const Pose> poses() const;
  /// The velocity of the centre of mass, and the rotation about it.
  Motion motion(BodyId id) const;
  Turning angular_momentum(BodyId id) const;       ///< about the centre of mass
  T mass(BodyId id) const;                         ///< infinite for fixed and kinematic bodies
  bool asleep(BodyId id) const;                    ///< whether it is at rest and not moved until something wakes it
  int sub_steps(BodyId id) const;                  ///< sub-steps of its island in the last step; 0 before its first
  std::vector<JointId> joints() const;             ///< all joints, by index
  const Joint<T, Space>& joint(JointId id) const;  ///< a joint as it was added or set last
  std::span<const T> joint_impulses(JointId id) const;  ///< impulses of the last step, a number for each row of the
                                                        ///< joint

  /// The world: contacts with the impulses of the last step, events, and all queries. Contacts are those at the
  /// beginning of the last step.
  const World<T, Space>& world() const;
  const SimulationSettings<T, Space>& settings() const;  ///< the settings as they are now
  void set_gravity(const Vec& gravity);                  ///< sets the gravity from the next step on

  StepReport<T, Space> report() const;  ///< statistics of the last step
  /// A hash of all bits that the next step depends on, of the same bodies and joints: poses, motions, sleep, materials,
  /// settings, the lengths of past steps, and the impulses of contacts and joints. Equal runs have equal hashes, also
  /// after `restore`. Costs a pass over bodies and contacts.
  std::uint64_t state_hash() const;

  State<T, Space> save() const;  ///< all that `restore` needs
  /// Goes back to a state of this simulation, or on from one of another with the same bodies and joints, added and
  /// removed in the same order: the steps after it have the same bits. Throws `InvalidValue` where there are other
  /// bodies or joints now: of another handle, kind of shape, size or mass, or joints of other bodies. Costs an update
  /// of the world. Joints get the frames, limits and drives that they had, bodies keep their filters. The events of the
  /// steps after it are those of the saved run.
  void restore(const State<T, Space>& state);

 private:
  std::unique_ptr<SimulationParts<T, Space>> parts_;
};

using Simulationf = Simulation<float>;
using Simulationd = Simulation<double>;

}  // namespace graze
