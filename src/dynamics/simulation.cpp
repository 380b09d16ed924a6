// Bodies and joints of a simulation, the changes to them from outside, and its step.
#include "graze/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "dynamics/simulation_parts.hpp"

namespace graze {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

template <class T>
void check_number(T value, const char* path, const char* expectation, bool good) {
  if (!good) validate::fail(path, expectation, static_cast<double>(value));
}

/// Adds to a body's velocity and angular momentum. Throws `InvalidValue` for what makes it too fast, and changes
/// nothing.
template <class T, class Space>
void push(SimulatedBody<T, Space>& body, const typename Space::Vec& linear, const typename Space::Turning& angular) {
  FreeBodyIn<Space> pushed = body.free;
  pushed.linear = checked_vector(body.free.linear + linear, "velocity after the impulse");
  pushed.angular_momentum += angular;
  checked_vector(angular_velocity(pushed), "angular velocity after the impulse");
  body.free = pushed;
}

bool power_of_two(int n) { return n > 0 && n <= 1024 && (n & (n - 1)) == 0; }

}  // namespace

template <class T, class Space>
void check(const SimulationSettings<T, Space>& s) {
  checked_vector(s.gravity, "gravity");
  if (!power_of_two(s.sub_steps)) validate::fail("sub_steps", "a power of two from 1 to 1024", s.sub_steps);
  if (!power_of_two(s.most_sub_steps) || s.most_sub_steps < s.sub_steps)
    validate::fail("most_sub_steps", "a power of two from sub_steps to 1024", s.most_sub_steps);
  check_number(s.longest_step, "longest_step", "a finite number > 0",
               s.longest_step > T(0) && std::isfinite(s.longest_step));
}

template <class T, class Space>
std::uint32_t SimulationParts<T, Space>::checked(BodyId id) const {
  if (!world.bodies().contains(id)) refuse_missing("body", "a body of the simulation", id);
  return id.index;
}

template <class T, class Space>
std::uint32_t SimulationParts<T, Space>::checked(JointId id) const {
  if (id.index >= joints.size() || !joints[id.index].alive || joints[id.index].generation != id.generation)
    refuse_missing("joint", "a joint of the simulation", id);
  return id.index;
}

template <class T, class Space>
typename Space::Pose SimulationParts<T, Space>::pose_of(std::uint32_t index) const {
  const SimulatedBody<T, Space>& body = bodies[index];
  const RotationIn<Space> rotation = normalized(body.free.rotation * conjugate(body.mass.principal.rotation));
  return {body.free.center - rotate(rotation, body.mass.principal.translation), rotation};
}

template <class T, class Space>
void SimulationParts<T, Space>::place(std::uint32_t index, const typename Space::Pose& pose,
                                      const typename Space::Velocity& velocity) {
  SimulatedBody<T, Space>& body = bodies[index];
  const typename Space::Vec arm = rotate(pose.rotation, body.mass.principal.translation);
  body.free.center = pose.translation + arm;
  body.free.rotation = normalized(pose.rotation * body.mass.principal.rotation);
  body.free.linear = velocity.linear + cross(velocity.angular, arm);
  body.spin = velocity.angular;
  if (body.movable) set_angular_velocity(body.free, velocity.angular);
}

template <class T, class Space>
MotionIn<Space> SimulationParts<T, Space>::motion(std::uint32_t index) const {
  const SimulatedBody<T, Space>& body = bodies[index];
  return {body.free.linear, body.movable ? angular_velocity(body.free) : body.spin, body.free.center};
}

template <class T, class Space>
void SimulationParts<T, Space>::move_world() {
  const auto alive = world.bodies().alive();
  moves.ids.clear(), moves.poses.clear(), moves.linear.clear(), moves.angular.clear();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    SimulatedBody<T, Space>& body = bodies[i];
    if (alive[i] == 0 || !body.moves || body.asleep) continue;
    typename Space::Pose pose = pose_of(i);
    const MotionIn<Space> m = motion(i);
    typename Space::Vec linear = m.linear + cross(m.angular, pose.translation - m.center);
    typename Space::Turning angular = m.angular;
    // A body that has left the range of accepted numbers stays where it was.
    if (!is_accepted(pose.translation) || !is_accepted(linear) || !is_accepted(angular) || !is_finite(pose.rotation)) {
      pose = world.bodies().poses()[i];
      linear = {};
      angular = {};
      body.free.angular_momentum = {};
      place(i, pose, {});
    }
    moves.ids.push_back(world.bodies().id(i));
    moves.poses.push_back(pose);
    moves.linear.push_back(linear);
    moves.angular.push_back(angular);
  }
  world.move(moves.ids, moves.poses, moves.linear, moves.angular);
}

template <class T, class Space>
void SimulationParts<T, Space>::mute() {
  muted.clear();
  for (const JointPlace<T, Space>& joint : joints) {
    if (!joint.alive || joint.in_place.joint.enable_collision) continue;
    muted.push_back({std::min(joint.in_place.a, joint.in_place.b), std::max(joint.in_place.a, joint.in_place.b)});
  }
  std::sort(muted.begin(), muted.end());
  if (muted.empty() && drifting == 0) return world.set_allow({});
  world.set_allow([this](BodyId a, BodyId b) {
    const auto triggers = world.bodies().triggers();
    const bool pushed = bodies[a.index].movable || bodies[b.index].movable;
    if (!pushed && (triggers[a.index] | triggers[b.index]) == 0) return false;
    const IdPair pair{std::min(a.index, b.index), std::max(a.index, b.index)};
    return !std::binary_search(muted.begin(), muted.end(), pair);
  });
}

template <class T, class Space>
Simulation<T, Space>::Simulation(const SimulationSettings<T, Space>& settings, Executor* executor) {
  check(settings);
  parts_ = std::make_unique<SimulationParts<T, Space>>(settings, executor);
}
template <class T, class Space>
Simulation<T, Space>::~Simulation() = default;

template <class T, class Space>
BodyId Simulation<T, Space>::add(Body<T, Space> body, const Dynamics& dynamics, const MaterialIn<T, Space>& material) {
  check(material);
  const bool trigger = body.trigger;
  const bool movable = !body.fixed && !dynamics.kinematic && (!trigger || dynamics.mass);
  SimulatedBody<T, Space> simulated;
  simulated.mass = body_mass(body.shape, dynamics, movable);
  simulated.movable = movable && simulated.mass.inverse_mass > T(0);
  simulated.moves = !body.fixed;
  if (simulated.movable && !std::isfinite(reach_of(body.shape)))
    validate::fail("shape", "a bounded shape, of a body that moves", body.shape.name());
  simulated.material = material;
  simulated.gravity_factor = dynamics.gravity_factor;
  simulated.linear_damping = dynamics.linear_damping;
  simulated.angular_damping = dynamics.angular_damping;
  simulated.may_sleep = dynamics.may_sleep;
  simulated.size = size_of(body.shape);
  simulated.depth =
      simulated.movable ? depth_of_center(body.shape, simulated.mass.principal.translation) : simulated.size / T(2);
  simulated.radius = reach_of(body.shape) + length(simulated.mass.principal.translation);
  simulated.free.inverse_inertia = simulated.mass.inverse_inertia;
  typename Space::Velocity velocity{};
  if (!body.fixed) velocity = {body.linear, body.angular};
  const BodyId id = parts_->world.add(std::move(body));
  if (parts_->bodies.size() <= id.index) parts_->bodies.resize(id.index + 1);
  parts_->bodies[id.index] = std::move(simulated);
  if (parts_->drifts(id.index) && !trigger && ++parts_->drifting == 1) parts_->mute();
  parts_->place(id.index, parts_->world.bodies().poses()[id.index], velocity);
  return id;
}

namespace {

/// The joint of two bodies where it acts: between the frames of their principal axes. Throws for an invalid one.
template <class T, class Space>
JointInPlace<T, Space> in_place(const SimulationParts<T, Space>& p, const Joint<T, Space>& joint) {
  const std::uint32_t a = p.checked(joint.a), b = p.checked(joint.b);
  if (a == b) validate::fail("b", "another body than a", std::to_string(b));
  check(joint);
  const auto in_principal = [&](std::uint32_t body, const typename Space::Pose& frame) {
    return compose(inverse(p.bodies[body].mass.principal), Space::checked(frame));
  };
  return {joint, a, b, in_principal(a, joint.frame_a), in_principal(b, joint.frame_b), {}, T(0)};
}

}  // namespace

template <class T, class Space>
JointId Simulation<T, Space>::add(const Joint<T, Space>& joint) {
  SimulationParts<T, Space>& p = *parts_;
  JointInPlace<T, Space> there = in_place(p, joint);
  std::uint32_t index{};
  if (p.free_joints.empty()) {
    index = static_cast<std::uint32_t>(p.joints.size());
    p.joints.emplace_back();
  } else {
    index = p.free_joints.back();
    p.free_joints.pop_back();
  }
  JointPlace<T, Space>& place = p.joints[index];
  place.alive = true;
  place.in_place = std::move(there);
  p.wake(place.in_place.a);
  p.wake(place.in_place.b);
  if (!joint.enable_collision) p.mute();
  return {index, place.generation};
}

template <class T, class Space>
void Simulation<T, Space>::set_joint(JointId id, const Joint<T, Space>& joint) {
  SimulationParts<T, Space>& p = *parts_;
  JointInPlace<T, Space>& place = p.joints[p.checked(id)].in_place;
  JointInPlace<T, Space> there = in_place(p, joint);
  for (const auto& [is, was, path] : {std::tuple(there.a, place.a, "a"), std::tuple(there.b, place.b, "b")})
    if (is != was) validate::fail(path, "body " + std::to_string(was) + ", which the joint has", std::to_string(is));
  p.wake(place.a);
  p.wake(place.b);
  // Rows of the same limits go on from the impulses of the last step.
  if (there.joint.limits.size() == place.joint.limits.size() &&
      there.joint.drives.size() == place.joint.drives.size()) {
    there.impulses = place.impulses;
    there.impulse_step = place.impulse_step;
  }
  const bool collided = place.joint.enable_collision;
  place = std::move(there);
  if (collided != joint.enable_collision) p.mute();
}

template <class T, class Space>
void Simulation<T, Space>::remove(JointId id) {
  SimulationParts<T, Space>& p = *parts_;
  JointPlace<T, Space>& place = p.joints[p.checked(id)];
  const std::uint32_t a = place.in_place.a, b = place.in_place.b;
  p.wake(a);
  p.wake(b);
  const bool collided = place.in_place.joint.enable_collision;
  place.alive = false;
  ++place.generation;
  place.in_place = {};
  p.free_joints.push_back(id.index);
  if (!collided) p.mute();
}

template <class T, class Space>
void Simulation<T, Space>::remove(BodyId id) {
  SimulationParts<T, Space>& p = *parts_;
  const std::uint32_t index = p.checked(id);
  p.wake_around(index);
  for (std::uint32_t j = 0; j < p.joints.size(); ++j)
    if (p.joints[j].alive && (p.joints[j].in_place.a == index || p.joints[j].in_place.b == index))
      remove(JointId{j, p.joints[j].generation});
  if (p.drifts(index) && p.world.bodies().triggers()[index] == 0 && --p.drifting == 0) p.mute();
  p.world.remove(id);
  p.rolling.drop(index);
  p.bodies[index] = {};
}

template <class T, class Space>
void Simulation<T, Space>::step(T dt) {
  SimulationParts<T, Space>& p = *parts_;
  if (!(dt > T(0)) || !(dt <= p.settings.longest_step))
    validate::fail("dt", "a number > 0 and at most longest_step", static_cast<double>(dt));
  const auto start = Clock::now();
  p.last = {};
  p.world.update();
  p.found_at.assign(p.world.bodies().poses().begin(), p.world.bodies().poses().end());
  p.before.resize(p.bodies.size());
  bool rolling_resisted = false, pieces = false;
  for (std::size_t i = 0; i < p.bodies.size(); ++i) {
    const SimulatedBody<T, Space>& body = p.bodies[i];
    p.before[i] = body.free;
    pieces = pieces || body.pieces;
    rolling_resisted =
        rolling_resisted || body.any_material([](const auto& material) { return material.rolling_friction > T(0); });
  }
  p.cut.clear();
  if (pieces) p.cut_manifolds();
  p.rolling.carry_over(p, rolling_resisted);
  p.shares.assign(p.bodies.size(), T(1));
  const auto collided = Clock::now();
  p.usual_step = greatest(dt, usual_step_kept<T> * p.usual_step);
  p.find_islands();
  p.pass_blows_on(dt);
  const auto prepared = Clock::now();
  p.solve_islands(dt);
  p.rolling.keep(p);
  const auto solved = Clock::now();
  if (p.settings.continuous) p.hold_back(dt);
  const auto held = Clock::now();
  p.put_to_sleep(dt);
  p.move_world();
  for (SimulatedBody<T, Space>& body : p.bodies) {
    body.force = {};
    body.torque = {};
  }
  p.last_step = dt;
  p.last.collide_ms = milliseconds(start, collided);
  p.last.prepare_ms = milliseconds(collided, prepared);
  p.last.solve_ms = milliseconds(prepared, solved);
  p.last.continuous_ms = milliseconds(solved, held);
  p.last.whole_ms = milliseconds(start, Clock::now());
}

template <class T, class Space>
void Simulation<T, Space>::apply_impulse(BodyId id, const typename Space::Vec& impulse,
                                         const typename Space::Vec& point) {
  SimulatedBody<T, Space>& body = parts_->bodies[parts_->checked(id)];
  checked_vector(impulse, "impulse");
  checked_vector(point, "point");
  if (body.movable) push(body, impulse * body.mass.inverse_mass, cross(point - body.free.center, impulse));
  parts_->wake(id.index);
}
template <class T, class Space>
void Simulation<T, Space>::apply_angular_impulse(BodyId id, const typename Space::Turning& impulse) {
  SimulatedBody<T, Space>& body = parts_->bodies[parts_->checked(id)];
  checked_vector(impulse, "impulse");
  if (body.movable) push(body, typename Space::Vec{}, impulse);
  parts_->wake(id.index);
}
template <class T, class Space>
void Simulation<T, Space>::apply_force(BodyId id, const typename Space::Vec& force) {
  SimulatedBody<T, Space>& body = parts_->bodies[parts_->checked(id)];
  body.force += checked_vector(force, "force");
  parts_->wake(id.index);
}
template <class T, class Space>
void Simulation<T, Space>::apply_torque(BodyId id, const typename Space::Turning& torque) {
  SimulatedBody<T, Space>& body = parts_->bodies[parts_->checked(id)];
  body.torque += checked_vector(torque, "torque");
  parts_->wake(id.index);
}
template <class T, class Space>
void Simulation<T, Space>::set_velocity(BodyId id, const typename Space::Velocity& velocity) {
  const std::uint32_t index = parts_->checked(id);
  checked_vector(velocity.linear, "linear");
  checked_vector(velocity.angular, "angular");
  if (!parts_->bodies[index].moves) return;
  const typename Space::Pose pose = parts_->world.bodies().poses()[index];
  parts_->world.move(id, pose, velocity.linear, velocity.angular);
  const FreeBodyIn<Space> there = parts_->bodies[index].free;
  parts_->place(index, pose, velocity);
  parts_->bodies[index].free.center = there.center;
  parts_->bodies[index].free.rotation = there.rotation;
  parts_->wake(index);
}
template <class T, class Space>
void Simulation<T, Space>::set_pose(BodyId id, const typename Space::Pose& pose) {
  const std::uint32_t index = parts_->checked(id);
  const MotionIn<Space> motion = parts_->motion(index);
  parts_->world.move(id, pose);
  parts_->wake_around(index);
  parts_->place(index, parts_->world.bodies().poses()[index], {});
  SimulatedBody<T, Space>& body = parts_->bodies[index];
  body.placed = true;
  body.free.linear = motion.linear;
  body.spin = motion.angular;
  if (body.movable) set_angular_velocity(body.free, motion.angular);
}
template <class T, class Space>
void Simulation<T, Space>::move_to(BodyId id, const typename Space::Pose& pose, T dt) {
  const std::uint32_t index = parts_->checked(id);
  if (!(dt > T(0)) || !std::isfinite(dt)) validate::fail("dt", "a finite number > 0", static_cast<double>(dt));
  const typename Space::Pose to = Space::checked(pose);
  SimulatedBody<T, Space>& body = parts_->bodies[index];
  if (body.movable || !body.moves)
    validate::fail("body", "a kinematic one", body.moves ? "one with mass" : "a fixed one");
  const typename Space::Vec center = to.translation + rotate(to.rotation, body.mass.principal.translation);
  const typename Space::Vec linear = (center - body.free.center) / dt;
  const auto spin = turning_between(parts_->world.bodies().poses()[index].rotation, to.rotation, dt);
  body.free.linear = checked_vector(linear, "velocity to the pose");
  body.spin = checked_vector(spin, "angular velocity to the pose");
  parts_->wake(index);
}
template <class T, class Space>
void Simulation<T, Space>::set_material(BodyId id, const MaterialIn<T, Space>& material) {
  check(material);
  const std::uint32_t index = parts_->checked(id);
  parts_->bodies[index].material = material;
  parts_->bodies[index].pieces = nullptr;
  parts_->wake_around(index);
}
template <class T, class Space>
void Simulation<T, Space>::set_filter(BodyId id, const Filter& filter) {
  parts_->wake_around(parts_->checked(id));
  parts_->world.set_filter(id, filter);
}
template <class T, class Space>
void Simulation<T, Space>::wake(BodyId id) {
  parts_->wake(parts_->checked(id));
}

template <class T, class Space>
std::span<const typename Space::Pose> Simulation<T, Space>::poses() const {
  return parts_->world.bodies().poses();
}
template <class T, class Space>
MotionIn<Space> Simulation<T, Space>::motion(BodyId id) const {
  return parts_->motion(parts_->checked(id));
}
template <class T, class Space>
typename Space::Turning Simulation<T, Space>::angular_momentum(BodyId id) const {
  return parts_->bodies[parts_->checked(id)].free.angular_momentum;
}
template <class T, class Space>
T Simulation<T, Space>::mass(BodyId id) const {
  const SimulatedBody<T, Space>& body = parts_->bodies[parts_->checked(id)];
  return body.movable ? body.mass.mass : std::numeric_limits<T>::infinity();
}
template <class T, class Space>
bool Simulation<T, Space>::asleep(BodyId id) const {
  return parts_->bodies[parts_->checked(id)].asleep;
}
template <class T, class Space>
int Simulation<T, Space>::sub_steps(BodyId id) const {
  return parts_->bodies[parts_->checked(id)].sub_steps;
}
template <class T, class Space>
std::vector<JointId> Simulation<T, Space>::joints() const {
  std::vector<JointId> out;
  for (std::uint32_t i = 0; i < parts_->joints.size(); ++i)
    if (const JointPlace<T, Space>& place = parts_->joints[i]; place.alive) out.push_back({i, place.generation});
  return out;
}

template <class T, class Space>
const Joint<T, Space>& Simulation<T, Space>::joint(JointId id) const {
  return parts_->joints[parts_->checked(id)].in_place.joint;
}
template <class T, class Space>
std::span<const T> Simulation<T, Space>::joint_impulses(JointId id) const {
  return parts_->joints[parts_->checked(id)].in_place.impulses;
}
template <class T, class Space>
const World<T, Space>& Simulation<T, Space>::world() const {
  return parts_->world;
}
template <class T, class Space>
const SimulationSettings<T, Space>& Simulation<T, Space>::settings() const {
  return parts_->settings;
}
template <class T, class Space>
void Simulation<T, Space>::set_gravity(const typename Space::Vec& gravity) {
  parts_->settings.gravity = checked_vector(gravity, "gravity");
  for (std::uint32_t i = 0; i < parts_->bodies.size(); ++i) parts_->wake(i);
}

#define GRAZE_SIMULATION(T, Space)                                                                                     \
  template struct SimulationParts<T, Space>;                                                                           \
  template void check(const SimulationSettings<T, Space>&);                                                            \
  template class Simulation<T, Space>;
GRAZE_SIMULATION(float, Space<float>)
GRAZE_SIMULATION(double, Space<double>)
GRAZE_SIMULATION(float, plane::Space<float>)
GRAZE_SIMULATION(double, plane::Space<double>)
#undef GRAZE_SIMULATION

}  // namespace graze
