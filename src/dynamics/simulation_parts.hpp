// The data of a simulation, and the stages of its step, a file each.
//
//     forces -> World::update -> islands -> contact rows -> restitution -> sub-steps -> continuous -> sleep -> poses
//
// Guarantee: plain arrays by index of body. A stage reads what those before it left; the order of everything follows
// from the world's pairs, which are sorted.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "dynamics/body_mass.hpp"
#include "dynamics/island_solver.hpp"
#include "dynamics/islands.hpp"
#include "dynamics/joints.hpp"
#include "dynamics/rolling_impulses.hpp"
#include "dynamics/surfaces.hpp"
#include "graze/simulation.hpp"

namespace graze {

/// A body and its motion.
template <class T, class Space>
struct SimulatedBody {
  FreeBodyIn<Space> free{};
  typename Space::Turning spin{};  ///< angular velocity of what nothing pushes, which has no angular momentum
  BodyMass<T, Space> mass{};
  MaterialIn<T, Space> material{};
  std::shared_ptr<const PieceMaterials<T, Space>> pieces;  ///< null where all pieces have `material`
  T gravity_factor = T(1), linear_damping{}, angular_damping{};
  T size{};    ///< the least extent of the shape: what tolerances refer to
  T depth{};   ///< of the centre of mass in the shape: sunk by more, it would be pushed out on the other side
  T radius{};  ///< no point of the shape is further from the centre of mass
  typename Space::Vec force{};
  typename Space::Turning torque{};
  T rested{};            ///< for how long it has been slow
  int sub_steps = 0;     ///< of its island in the last step; 0 before its first
  bool movable = false;  ///< by pushing
  bool moves = false;    ///< by itself: movable or kinematic
  bool may_sleep = true;
  bool asleep = false;
  bool placed = true;  ///< by hand, into others that it still overlaps

  /// Whether `has` is true of any of its materials.
  template <class F>
  bool any_material(const F& has) const {
    return pieces ? std::any_of(pieces->materials.begin(), pieces->materials.end(), has) : has(material);
  }
};

/// A joint's place: whether there is one, and how often its index was given away.
template <class T, class Space>
struct JointPlace {
  JointInPlace<T, Space> in_place;
  std::uint32_t generation = 0;
  bool alive = false;
};

/// The lengths, speeds and times that a scene's own gravity and steps give: no number here has a unit.
template <class T>
struct Scales {
  T gravity{};  ///< its length
  T step{};

  /// The speed at which something of `size` matters: that of a fall through half its size; without gravity the one at
  /// which it moves by a twentieth of its size in a step.
  T speed(T size) const { return gravity > T(0) ? std::sqrt(gravity * size) : size / (T(20) * step); }
  /// The time of such a fall; without gravity the one in which something of `size` moves by its size at that speed.
  T time(T size) const { return gravity > T(0) ? std::sqrt(size / gravity) : T(20) * step; }
};

/// Throws `InvalidValue` for invalid settings.
template <class T, class Space>
void check(const SimulationSettings<T, Space>& settings);

template <class T, class Space>
struct SimulationParts {
  SimulationParts(const SimulationSettings<T, Space>& s, Executor* e)
      : settings(s), executor(e ? e : &serial), world({}, e) {}

  SimulationSettings<T, Space> settings;
  SerialExecutor serial;
  Executor* executor;
  World<T, Space> world;
  std::vector<SimulatedBody<T, Space>> bodies;
  std::vector<JointPlace<T, Space>> joints;
  std::vector<std::uint32_t> free_joints;
  std::vector<IdPair> muted;  ///< by joints, sorted; as often as there are joints that mute them
  std::size_t drifting = 0;   ///< the number of bodies that move and are not pushed, without triggers
  RollingImpulses<T, Space> rolling;

  // Members that a step fills anew.
  Islands islands;
  std::vector<IslandSolver<T, Space>> solvers;  ///< one for each task, kept for their storage
  CutManifolds<T, Space> cut;
  std::vector<std::uint8_t> movable, awake;    ///< of each body; of each island
  std::vector<typename Space::Pose> found_at;  ///< where the last update found contacts
  std::vector<IslandLink> links;
  std::vector<std::uint32_t> link_pairs;  ///< of each link: its place among the contact pairs, or the joint behind them
  std::vector<FreeBodyIn<Space>> before;  ///< state of the bodies at the beginning of the step
  std::vector<T> shares;                  ///< of the step that each body has: less where it flew ahead to a blow
  struct Moves {
    std::vector<BodyId> ids;
    std::vector<typename Space::Pose> poses;
    std::vector<typename Space::Vec> linear;
    std::vector<typename Space::Turning> angular;
  } moves;  ///< of all that is awake, where the step ends
  T last_step{};
  T usual_step{};  ///< the last step, or a longer one before it (`usual_step_kept`)
  StepReport<T, Space> last{};

  Scales<T> scales(T dt) const { return {length(settings.gravity), dt}; }
  using Sides = typename CutManifolds<T, Space>::Sides;
  using CutPair = typename CutManifolds<T, Space>::Cut;

  std::uint32_t checked(BodyId id) const;
  std::uint32_t checked(JointId id) const;
  typename Space::Pose pose_of(std::uint32_t index) const;
  /// Sets the state of the body from the pose and velocity that the world has of it.
  void place(std::uint32_t index, const typename Space::Pose& pose, const typename Space::Velocity& velocity);
  MotionIn<Space> motion(std::uint32_t index) const;
  void wake(std::uint32_t index);
  /// Wakes all that touches the body or is joined to it.
  void wake_around(std::uint32_t index);
  /// The contact of a link, or null where the link is a joint: links of contacts come first.
  const ContactPair<T>* contact_of(std::uint32_t link) const {
    const auto& pairs = world.contacts().pairs;
    return link_pairs[link] < pairs.size() ? &pairs[link_pairs[link]] : nullptr;
  }
  JointInPlace<T, Space>& joint_of(std::uint32_t link) {
    return joints[link_pairs[link] - world.contacts().pairs.size()].in_place;
  }
  const JointInPlace<T, Space>& joint_of(std::uint32_t link) const {
    return joints[link_pairs[link] - world.contacts().pairs.size()].in_place;
  }
  /// Whether the body moves and nothing pushes it: it is kinematic, of infinite mass, or a trigger without a mass.
  bool drifts(std::uint32_t index) const { return bodies[index].moves && !bodies[index].movable; }
  /// Leaves out of the world's pairs those that joints mute, and those of two bodies that nothing pushes.
  void mute();

  /// Calls `f(manifolds, sides, first)` with the manifolds of a pair that have the same materials, `sides`, side by
  /// side in the world's or in the cut ones. `first` is a number for the first of them, which no other has.
  template <class F>
  void each_surface(const ContactPair<T>& pair, const F& f) const {
    const ContactArrays<T, Space>& contacts = world.contacts();
    const CutPair* known = nullptr;
    if (!cut.pairs.empty()) {
      const auto index = static_cast<std::uint32_t>(&pair - contacts.pairs.data());
      const auto at = std::lower_bound(cut.pairs.begin(), cut.pairs.end(), index,
                                       [](const CutPair& c, std::uint32_t i) { return c.pair < i; });
      if (at != cut.pairs.end() && at->pair == index) known = &*at;
    }
    if (!known)
      return f(contacts.manifolds_of(pair), Sides{&bodies[pair.a].material, &bodies[pair.b].material},
               std::size_t{pair.first_manifold});
    for (std::uint32_t i = known->first; i < known->first + known->count; ++i)
      f(std::span(cut.manifolds).subspan(i, 1), cut.sides[i], contacts.manifolds.size() + i);
  }
  /// One more than the largest number of a manifold.
  std::size_t surface_count() const { return world.contacts().manifolds.size() + cut.manifolds.size(); }
  void cut_manifolds();  // surfaces.cpp
  void find_islands();
  typename Space::Vec rolled_by(std::uint32_t index, const typename Space::Vec& outward,
                                const typename Space::Vec& point, T time) const;
  T round_at(std::uint32_t index, const typename Space::Vec& outward, const typename Space::Vec& point) const;
  void solve_island(IslandSolver<T, Space>& solver, const Islands::Range& island, T dt, Executor* threads);
  IslandBody<T, Space> island_body(std::uint32_t index) const;
  void pass_blows_on(T dt);  // restitution.cpp
  bool may_bounce(const ContactPair<T>& pair) const;
  bool strike_next(const Islands::Range& range, T slow, T dt);
  void solve_islands(T dt);
  void hold_back(T dt);                      // continuous.cpp
  bool is_driven(std::uint32_t link) const;  // sleep.cpp
  void put_to_sleep(T dt);                   // sleep.cpp
  void move_world();
};

}  // namespace graze
