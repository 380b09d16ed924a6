// Saving the state of a simulation, and going back to it.
//
// A step depends on the poses and velocities of the bodies, and on the impulses of the last step's contacts. The latter
// belong to points that the world finds anew where the last update found them: so bodies are put there first. Nothing
// in a state belongs to the simulation that saved it, so that one with the same bodies and joints may go on from it.
#include <algorithm>
#include <iterator>
#include <string>

#include "dynamics/bit_hash.hpp"
#include "dynamics/kept_state.hpp"

namespace graze {

template <class T, class Space>
State<T, Space>::State() = default;
template <class T, class Space>
State<T, Space>::~State() = default;
template <class T, class Space>
State<T, Space>::State(const State& other) : kept_(other.kept_ ? std::make_unique<Kept>(*other.kept_) : nullptr) {}
template <class T, class Space>
State<T, Space>::State(State&&) noexcept = default;
template <class T, class Space>
State<T, Space>& State<T, Space>::operator=(const State& other) {
  if (this != &other) kept_ = other.kept_ ? std::make_unique<Kept>(*other.kept_) : nullptr;
  return *this;
}
template <class T, class Space>
State<T, Space>& State<T, Space>::operator=(State&&) noexcept = default;

namespace {

template <class T, class Space>
std::vector<BodyId> ids_of(const World<T, Space>& world) {
  std::vector<BodyId> ids;
  for (std::uint32_t i = 0; i < world.bodies().size(); ++i)
    if (world.bodies().alive()[i] != 0) ids.push_back(world.bodies().id(i));
  return ids;
}

/// Calls `f` with every point, pair by pair: an order that the pairs alone decide.
template <class T, class Space, class F>
void each_point(ContactArrays<T, Space>& contacts, F&& f) {
  for (const ContactPair<T>& pair : contacts.pairs)
    for (const ContactManifold<T, Space>& m : contacts.manifolds_of(pair))
      for (std::uint32_t i = 0; i < m.point_count; ++i) f(contacts.points[m.first_point + i]);
}

template <class T, class Space>
std::vector<std::uint32_t> kinds_of(const World<T, Space>& world) {
  std::vector<std::uint32_t> kinds;
  for (const auto& shape : world.bodies().shapes()) kinds.push_back(static_cast<std::uint32_t>(shape.index()));
  return kinds;
}

/// Whether two bodies are alike in what never changes: what they weigh, how large they are, and how they may move.
template <class T, class Space>
bool alike(const SimulatedBody<T, Space>& a, const SimulatedBody<T, Space>& b) {
  return a.mass.mass == b.mass.mass && a.mass.inverse_mass == b.mass.inverse_mass && a.mass.inertia == b.mass.inertia &&
         a.mass.inverse_inertia == b.mass.inverse_inertia && a.mass.principal == b.mass.principal &&
         a.free.inverse_inertia == b.free.inverse_inertia && a.size == b.size && a.depth == b.depth &&
         a.radius == b.radius && a.gravity_factor == b.gravity_factor && a.linear_damping == b.linear_damping &&
         a.angular_damping == b.angular_damping && a.movable == b.movable && a.moves == b.moves &&
         a.may_sleep == b.may_sleep;
}

/// Whether there are the same joints of the same bodies, whatever their frames, limits and drives.
template <class T, class Space>
bool same_joints(const std::vector<JointPlace<T, Space>>& a, const std::vector<JointPlace<T, Space>>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const JointInPlace<T, Space>&in_a = a[i].in_place, &in_b = b[i].in_place;
    if (a[i].alive != b[i].alive || a[i].generation != b[i].generation || in_a.a != in_b.a || in_a.b != in_b.b)
      return false;
  }
  return true;
}

/// The events of the last step, and those that were lost since, in the order of their bodies.
template <class T, class Space>
std::vector<ContactEvent> events_of(const World<T, Space>& world) {
  const auto events = world.events(), lost = world.lost_events();
  std::vector<ContactEvent> all;
  std::merge(events.begin(), events.end(), lost.begin(), lost.end(), std::back_inserter(all),
             [](const ContactEvent& e, const ContactEvent& o) {
               return IdPair{e.a.index, e.b.index} < IdPair{o.a.index, o.b.index};
             });
  return all;
}

/// Takes the events of a saved step in place of those that finding its contacts gave: a pair that touches within its
/// margin alone has begun before, and what a body touched that was removed since has still to end.
template <class T, class Space>
void go_back_to(World<T, Space>& world, std::span<const ContactEvent> events) {
  const auto& pairs = world.contacts().pairs;
  // Sets the event's pair. Returns whether it goes on from there: it has ended, or its pair was found again.
  const auto find_pair = [&](ContactEvent& event) {
    event.pair = ContactEvent::no_pair;
    if (event.kind == EventKind::end) return true;
    const IdPair ids{event.a.index, event.b.index};
    const auto at = std::lower_bound(pairs.begin(), pairs.end(), ids, [](const ContactPair<T>& p, const IdPair& other) {
      return IdPair{p.a, p.b} < other;
    });
    if (at == pairs.end() || at->a != ids.a || at->b != ids.b) return false;
    if (world.bodies().id(ids.a) != event.a || world.bodies().id(ids.b) != event.b) return false;
    event.pair = static_cast<std::uint32_t>(at - pairs.begin());
    return true;
  };
  std::vector<ContactEvent> found, lost;
  for (ContactEvent event : events) {
    const bool goes_on = find_pair(event);
    (goes_on ? found : lost).push_back(event);
  }
  world.go_back_to(found, lost);
}

template <class T, class Space>
void add_bits(BitHash& hash, const SimulationSettings<T, Space>& settings) {
  hash.add(settings.gravity);
  hash.add(settings.sub_steps);
  hash.add(settings.most_sub_steps);
  hash.add(settings.sleep);
  hash.add(settings.continuous);
  hash.add(settings.warm_start);
  hash.add(settings.longest_step);
}

template <class T, class Vec>
void add_bits(BitHash& hash, const Material<T, Vec>& material) {
  for (const T value :
       {material.static_friction, material.dynamic_friction, material.restitution, material.rolling_friction})
    hash.add(value);
  hash.add(material.friction_combine);
  hash.add(material.restitution_combine);
  hash.add(material.surface_velocity);
}

template <class T, class Space>
void add_bits(BitHash& hash, const Joint<T, Space>& joint) {
  hash.add(joint.frame_a);
  hash.add(joint.frame_b);
  hash.add(joint.enable_collision);
  for (const JointLimit<T>& limit : joint.limits) {
    hash.add(limit.space);
    hash.add(limit.axes);
    for (const T value : {limit.min, limit.max, limit.stiffness.value_or(T(-1)), limit.damping}) hash.add(value);
  }
  for (const JointDrive<T>& drive : joint.drives) {
    hash.add(drive.space);
    hash.add(drive.mode);
    hash.add(drive.axis);
    for (const T value :
         {drive.position_target, drive.velocity_target, drive.stiffness, drive.damping, drive.max_force})
      hash.add(value);
  }
}

}  // namespace

template <class T, class Space>
State<T, Space> Simulation<T, Space>::save() const {
  SimulationParts<T, Space>& p = *parts_;
  const BodyArrays<T, Space>& all = p.world.bodies();
  State<T, Space> state;
  state.kept_ = std::make_unique<typename State<T, Space>::Kept>();
  auto& kept = *state.kept_;
  kept.bodies = p.bodies;
  kept.joints = p.joints;
  kept.ids = ids_of(p.world);
  kept.kinds = kinds_of(p.world);
  kept.poses.assign(all.poses().begin(), all.poses().end());
  kept.linear.assign(all.linear().begin(), all.linear().end());
  kept.angular.assign(all.angular().begin(), all.angular().end());
  // Bodies that were added since the last update have not been found anywhere yet.
  kept.found_at = p.found_at;
  for (std::size_t i = kept.found_at.size(); i < kept.poses.size(); ++i) kept.found_at.push_back(kept.poses[i]);
  each_point<T, Space>(p.world.contacts(),
                       [&](const SolverPoint<T, Space>& point) { kept.impulses.push_back(point.impulse); });
  kept.rolling = p.rolling.kept();
  kept.events = events_of(p.world);
  kept.settings = p.settings;
  kept.last = p.last;
  kept.last_step = p.last_step;
  kept.usual_step = p.usual_step;
  return state;
}

template <class T, class Space>
void Simulation<T, Space>::restore(const State<T, Space>& state) {
  SimulationParts<T, Space>& p = *parts_;
  if (!state.kept_) throw InvalidValue("state", "a state that a simulation saved", "an empty one");
  const auto& kept = *state.kept_;
  if (kept.ids != ids_of(p.world) || kept.bodies.size() != p.bodies.size())
    throw InvalidValue("state", "one of the bodies that there are now", "others");
  const std::vector<std::uint32_t> kinds = kinds_of(p.world);
  for (const BodyId id : kept.ids)
    if (kept.kinds[id.index] != kinds[id.index] || !alike(kept.bodies[id.index], p.bodies[id.index]))
      throw InvalidValue("state", "one of bodies like those that there are now",
                         "another body " + std::to_string(id.index));
  if (!same_joints(kept.joints, p.joints))
    throw InvalidValue("state", "one of the joints that there are now", "others");
  const auto put = [&](std::span<const typename Space::Pose> poses) {
    for (const BodyId id : kept.ids) p.world.move(id, poses[id.index], kept.linear[id.index], kept.angular[id.index]);
  };
  put(kept.found_at);
  p.world.update();
  std::size_t known = 0;
  each_point<T, Space>(p.world.contacts(), [&](SolverPoint<T, Space>& point) {
    point.impulse = known < kept.impulses.size() ? kept.impulses[known] : typename Space::Vec{};
    ++known;
  });
  go_back_to<T, Space>(p.world, kept.events);
  put(kept.poses);
  p.bodies = kept.bodies;
  p.joints = kept.joints;
  p.mute();
  p.found_at = kept.found_at;
  p.rolling.set_kept(kept.rolling);
  p.settings = kept.settings;
  p.last = kept.last;
  p.last_step = kept.last_step;
  p.usual_step = kept.usual_step;
}

template <class T, class Space>
std::uint64_t Simulation<T, Space>::state_hash() const {
  SimulationParts<T, Space>& p = *parts_;
  const BodyArrays<T, Space>& all = p.world.bodies();
  BitHash hash;
  add_bits(hash, p.settings);
  hash.add(p.last_step);
  hash.add(p.usual_step);
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (all.alive()[i] == 0) continue;
    hash.add(i);
    hash.add(all.poses()[i]);
    hash.add(all.linear()[i]);
    hash.add(all.angular()[i]);
    const SimulatedBody<T, Space>& body = p.bodies[i];
    hash.add(i < p.found_at.size() ? p.found_at[i] : all.poses()[i]);
    hash.add(body.free.center);
    hash.add(body.free.rotation);
    hash.add(body.free.linear);
    hash.add(body.free.angular_momentum);
    hash.add(body.spin);
    add_bits(hash, body.material);
    if (body.pieces) {
      for (const auto& material : body.pieces->materials) add_bits(hash, material);
      for (const std::uint32_t place : body.pieces->of_piece) hash.add(place);
    }
    hash.add(body.force);
    hash.add(body.torque);
    hash.add(body.rested);
    hash.add(body.sub_steps);
    hash.add(body.asleep);
    hash.add(body.placed);
  }
  each_point<T, Space>(p.world.contacts(), [&](const SolverPoint<T, Space>& point) { hash.add(point.impulse); });
  for (const auto& rolling : p.rolling.kept()) {
    hash.add(rolling.pair.a);
    hash.add(rolling.pair.b);
    hash.add(rolling.feature);
    hash.add(rolling.impulse);
  }
  for (const JointId id : joints()) {
    add_bits(hash, joint(id));
    for (const T impulse : joint_impulses(id)) hash.add(impulse);
    hash.add(p.joints[id.index].in_place.impulse_step);
  }
  return hash.value();
}

#define GRAZE_STATE(T, Space)                                                                                          \
  template class State<T, Space>;                                                                                      \
  template std::uint64_t Simulation<T, Space>::state_hash() const;                                                     \
  template State<T, Space> Simulation<T, Space>::save() const;                                                         \
  template void Simulation<T, Space>::restore(const State<T, Space>&);
GRAZE_STATE(float, Space<float>)
GRAZE_STATE(double, Space<double>)
GRAZE_STATE(float, plane::Space<float>)
GRAZE_STATE(double, plane::Space<double>)
#undef GRAZE_STATE

}  // namespace graze
