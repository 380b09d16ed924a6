// Bodies and joints of a simulation, what is done to them from outside, and its step.
#include "graze/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "dynamics/simulation_parts.hpp"
#include "shape/reach.hpp"

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

template <class T>
void check(const Material<T>& m) {
  const auto positive = [](T value, const char* path) {
    check_number(value, path, "a finite number >= 0", value >= T(0) && std::isfinite(value));
  };
  positive(m.static_friction, "static_friction");
  positive(m.dynamic_friction, "dynamic_friction");
  positive(m.rolling_friction, "rolling_friction");
  check_number(m.restitution, "restitution", "a number from 0 to 1", m.restitution >= T(0) && m.restitution <= T(1));
  validate::point(m.surface_velocity, "surface_velocity");
}

bool power_of_two(int n) { return n > 0 && n <= 1024 && (n & (n - 1)) == 0; }

template <class T>
void check(const SimulationSettings<T>& s) {
  validate::point(s.gravity, "gravity");
  if (!power_of_two(s.sub_steps)) validate::fail("sub_steps", "a power of two from 1 to 1024", s.sub_steps);
  if (!power_of_two(s.most_sub_steps) || s.most_sub_steps < s.sub_steps)
    validate::fail("most_sub_steps", "a power of two from sub_steps to 1024", s.most_sub_steps);
  check_number(s.longest_step, "longest_step", "a finite number > 0",
               s.longest_step > T(0) && std::isfinite(s.longest_step));
}

/// The least extent of a shape along its axes; infinite for a half-space, and for a surface what it is thick.
template <class T>
T size_of(const Shape<T>& shape) {
  if (shape.template as<HalfSpace<T>>()) return std::numeric_limits<T>::infinity();
  const Aabb<T> box = bounds(shape, Pose<T>{});
  const Vec3<T> extent = box.upper - box.lower;
  T least_extent = std::numeric_limits<T>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
    if (extent[i] > max_abs(extent) * T(1e-3)) least_extent = least(least_extent, extent[i]);
  return least_extent;
}

}  // namespace

template <class T>
std::uint32_t SimulationParts<T>::checked(BodyId id) const {
  if (!world.bodies().contains(id))
    throw InvalidValue("body", "the handle of a body that is in the simulation",
                       std::to_string(id.index) + " of generation " + std::to_string(id.generation));
  return id.index;
}

template <class T>
std::uint32_t SimulationParts<T>::checked(JointId id) const {
  if (id.index >= joints.size() || !joints[id.index].alive || joints[id.index].generation != id.generation)
    throw InvalidValue("joint", "the handle of a joint that is in the simulation",
                       std::to_string(id.index) + " of generation " + std::to_string(id.generation));
  return id.index;
}

template <class T>
Pose<T> SimulationParts<T>::pose_of(std::uint32_t index) const {
  const SimulatedBody<T>& body = bodies[index];
  const Quat<T> rotation = normalized(body.free.rotation * conjugate(body.mass.principal.rotation));
  return {body.free.center - rotate(rotation, body.mass.principal.translation), rotation};
}

template <class T>
void SimulationParts<T>::place(std::uint32_t index, const Pose<T>& pose, const Velocity<T>& velocity) {
  SimulatedBody<T>& body = bodies[index];
  const Vec3<T> arm = rotate(pose.rotation, body.mass.principal.translation);
  body.free.center = pose.translation + arm;
  body.free.rotation = normalized(pose.rotation * body.mass.principal.rotation);
  body.free.linear = velocity.linear + cross(velocity.angular, arm);
  body.spin = velocity.angular;
  if (body.movable) set_angular_velocity(body.free, velocity.angular);
}

template <class T>
Motion<T> SimulationParts<T>::motion(std::uint32_t index) const {
  const SimulatedBody<T>& body = bodies[index];
  return {body.free.linear, body.movable ? angular_velocity(body.free) : body.spin, body.free.center};
}

template <class T>
void SimulationParts<T>::move_world() {
  const auto alive = world.bodies().alive();
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    SimulatedBody<T>& body = bodies[i];
    if (alive[i] == 0 || !body.moves || body.asleep) continue;
    Pose<T> pose = pose_of(i);
    const Motion<T> m = motion(i);
    Vec3<T> linear = m.linear + cross(m.angular, pose.translation - m.center), angular = m.angular;
    // What has left the numbers that are accepted stays where it was.
    const T reached = greatest(max_abs(pose.translation), greatest(max_abs(linear), max_abs(angular)));
    if (!(reached <= largest_magnitude<T>) || !std::isfinite(pose.rotation.w)) {
      pose = world.bodies().poses()[i];
      linear = angular = {};
      body.free.angular_momentum = {};
      place(i, pose, {});
    }
    world.move(world.bodies().id(i), pose, linear, angular);
  }
}

template <class T>
void SimulationParts<T>::mute() {
  std::sort(muted.begin(), muted.end());
  if (muted.empty()) return world.set_allow({});
  world.set_allow([this](BodyId a, BodyId b) {
    const IdPair pair{std::min(a.index, b.index), std::max(a.index, b.index)};
    return !std::binary_search(muted.begin(), muted.end(), pair);
  });
}

template <class T>
Simulation<T>::Simulation(const SimulationSettings<T>& settings, Executor* executor) {
  check(settings);
  parts_ = std::make_unique<SimulationParts<T>>(settings, executor);
}
template <class T>
Simulation<T>::~Simulation() = default;

template <class T>
BodyId Simulation<T>::add(Body<T> body, const Dynamics<T>& dynamics, const Material<T>& material) {
  check(material);
  const bool movable = !body.fixed && !dynamics.kinematic && !body.trigger;
  SimulatedBody<T> simulated;
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
  simulated.radius = reach_of(body.shape) + length(simulated.mass.principal.translation);
  simulated.free.inverse_inertia = simulated.mass.inverse_inertia;
  const Velocity<T> velocity{body.fixed ? Vec3<T>{} : body.linear, body.fixed ? Vec3<T>{} : body.angular};
  const BodyId id = parts_->world.add(std::move(body));
  if (parts_->bodies.size() <= id.index) parts_->bodies.resize(id.index + 1);
  parts_->bodies[id.index] = std::move(simulated);
  parts_->place(id.index, parts_->world.bodies().poses()[id.index], velocity);
  return id;
}

template <class T>
JointId Simulation<T>::add(const Joint<T>& joint) {
  SimulationParts<T>& p = *parts_;
  const std::uint32_t a = p.checked(joint.a), b = p.checked(joint.b);
  if (a == b) validate::fail("b", "another body than a", std::to_string(b));
  graze::check(joint);
  std::uint32_t index{};
  if (p.free_joints.empty()) {
    index = static_cast<std::uint32_t>(p.joints.size());
    p.joints.emplace_back();
  } else {
    index = p.free_joints.back();
    p.free_joints.pop_back();
  }
  JointPlace<T>& place = p.joints[index];
  place.alive = true;
  const auto in_principal = [&](std::uint32_t body, const Pose<T>& frame) {
    return compose(inverse(p.bodies[body].mass.principal),
                   Pose<T>{frame.translation, validate::rotation(frame.rotation, "frame.rotation")});
  };
  place.in_place = {joint, a, b, in_principal(a, joint.frame_a), in_principal(b, joint.frame_b), {}, T(0)};
  p.wake(a);
  p.wake(b);
  if (!joint.enable_collision) {
    p.muted.push_back({std::min(a, b), std::max(a, b)});
    p.mute();
  }
  return {index, place.generation};
}

template <class T>
void Simulation<T>::remove(JointId id) {
  SimulationParts<T>& p = *parts_;
  JointPlace<T>& place = p.joints[p.checked(id)];
  const std::uint32_t a = place.in_place.a, b = place.in_place.b;
  p.wake(a);
  p.wake(b);
  if (!place.in_place.joint.enable_collision) {
    const IdPair pair{std::min(a, b), std::max(a, b)};
    p.muted.erase(std::lower_bound(p.muted.begin(), p.muted.end(), pair));
    p.mute();
  }
  place.alive = false;
  ++place.generation;
  place.in_place = {};
  p.free_joints.push_back(id.index);
}

template <class T>
void Simulation<T>::remove(BodyId id) {
  SimulationParts<T>& p = *parts_;
  const std::uint32_t index = p.checked(id);
  p.wake_around(index);
  for (std::uint32_t j = 0; j < p.joints.size(); ++j)
    if (p.joints[j].alive && (p.joints[j].in_place.a == index || p.joints[j].in_place.b == index))
      remove(JointId{j, p.joints[j].generation});
  p.world.remove(id);
  p.bodies[index] = {};
}

template <class T>
void Simulation<T>::step(T dt) {
  SimulationParts<T>& p = *parts_;
  if (!(dt > T(0)) || !(dt <= p.settings.longest_step))
    validate::fail("dt", "a number > 0 and at most longest_step", static_cast<double>(dt));
  const auto start = Clock::now();
  p.last = {};
  p.world.update();
  p.found_at.assign(p.world.bodies().poses().begin(), p.world.bodies().poses().end());
  p.before.resize(p.bodies.size());
  for (std::size_t i = 0; i < p.bodies.size(); ++i) p.before[i] = p.bodies[i].free;
  p.shares.assign(p.bodies.size(), T(1));
  const auto collided = Clock::now();
  p.find_islands();
  p.pass_blows_on(dt);
  const auto prepared = Clock::now();
  p.solve_islands(dt);
  const auto solved = Clock::now();
  if (p.settings.continuous) p.hold_back(dt);
  const auto held = Clock::now();
  p.put_to_sleep(dt);
  p.move_world();
  for (SimulatedBody<T>& body : p.bodies) body.force = body.torque = {};
  p.last_step = dt;
  p.last.collide_ms = milliseconds(start, collided);
  p.last.prepare_ms = milliseconds(collided, prepared);
  p.last.solve_ms = milliseconds(prepared, solved);
  p.last.continuous_ms = milliseconds(solved, held);
  p.last.whole_ms = milliseconds(start, Clock::now());
}

template <class T>
void Simulation<T>::apply_impulse(BodyId id, const Vec3<T>& impulse, const Vec3<T>& point) {
  SimulatedBody<T>& body = parts_->bodies[parts_->checked(id)];
  validate::point(impulse, "impulse");
  validate::point(point, "point");
  parts_->wake(id.index);
  if (!body.movable) return;
  body.free.linear += impulse * body.mass.inverse_mass;
  body.free.angular_momentum += cross(point - body.free.center, impulse);
}
template <class T>
void Simulation<T>::apply_angular_impulse(BodyId id, const Vec3<T>& impulse) {
  SimulatedBody<T>& body = parts_->bodies[parts_->checked(id)];
  validate::point(impulse, "impulse");
  parts_->wake(id.index);
  if (body.movable) body.free.angular_momentum += impulse;
}
template <class T>
void Simulation<T>::apply_force(BodyId id, const Vec3<T>& force) {
  SimulatedBody<T>& body = parts_->bodies[parts_->checked(id)];
  body.force += validate::point(force, "force");
  parts_->wake(id.index);
}
template <class T>
void Simulation<T>::apply_torque(BodyId id, const Vec3<T>& torque) {
  SimulatedBody<T>& body = parts_->bodies[parts_->checked(id)];
  body.torque += validate::point(torque, "torque");
  parts_->wake(id.index);
}
template <class T>
void Simulation<T>::set_velocity(BodyId id, const Velocity<T>& velocity) {
  const std::uint32_t index = parts_->checked(id);
  validate::point(velocity.linear, "linear");
  validate::point(velocity.angular, "angular");
  if (!parts_->bodies[index].moves) return;
  const Pose<T> pose = parts_->world.bodies().poses()[index];
  parts_->world.move(id, pose, velocity.linear, velocity.angular);
  const FreeBody<T> there = parts_->bodies[index].free;
  parts_->place(index, pose, velocity);
  parts_->bodies[index].free.center = there.center;
  parts_->bodies[index].free.rotation = there.rotation;
  parts_->wake(index);
}
template <class T>
void Simulation<T>::set_pose(BodyId id, const Pose<T>& pose) {
  const std::uint32_t index = parts_->checked(id);
  const Motion<T> motion = parts_->motion(index);
  parts_->world.move(id, pose);
  parts_->wake_around(index);
  parts_->place(index, parts_->world.bodies().poses()[index], {});
  SimulatedBody<T>& body = parts_->bodies[index];
  body.free.linear = motion.linear;
  body.spin = motion.angular;
  if (body.movable) set_angular_velocity(body.free, motion.angular);
}
template <class T>
void Simulation<T>::move_to(BodyId id, const Pose<T>& pose, T dt) {
  const std::uint32_t index = parts_->checked(id);
  if (!(dt > T(0)) || !std::isfinite(dt)) validate::fail("dt", "a finite number > 0", static_cast<double>(dt));
  const Quat<T> to = validate::rotation(pose.rotation, "pose.rotation");
  validate::point(pose.translation, "pose.translation");
  SimulatedBody<T>& body = parts_->bodies[index];
  if (body.movable || !body.moves) return;
  // The axis times the angle of the turn, the shorter way: in vector part v and w, 2 atan2(|v|, w) v / |v|.
  Quat<T> turn = to * conjugate(parts_->world.bodies().poses()[index].rotation);
  if (turn.w < T(0)) turn = {-turn.x, -turn.y, -turn.z, -turn.w};
  const T sine = length(turn.vector());
  const T per_sine = sine > T(0) ? T(2) * std::atan2(sine, turn.w) / sine : T(2);
  const Vec3<T> center = pose.translation + rotate(to, body.mass.principal.translation);
  body.free.linear = (center - body.free.center) / dt;
  body.spin = turn.vector() * (per_sine / dt);
  parts_->wake(index);
}
template <class T>
void Simulation<T>::set_material(BodyId id, const Material<T>& material) {
  check(material);
  const std::uint32_t index = parts_->checked(id);
  parts_->bodies[index].material = material;
  parts_->wake_around(index);
}
template <class T>
void Simulation<T>::wake(BodyId id) {
  parts_->wake(parts_->checked(id));
}

template <class T>
std::span<const Pose<T>> Simulation<T>::poses() const {
  return parts_->world.bodies().poses();
}
template <class T>
Motion<T> Simulation<T>::motion(BodyId id) const {
  return parts_->motion(parts_->checked(id));
}
template <class T>
Vec3<T> Simulation<T>::angular_momentum(BodyId id) const {
  return parts_->bodies[parts_->checked(id)].free.angular_momentum;
}
template <class T>
T Simulation<T>::mass(BodyId id) const {
  const SimulatedBody<T>& body = parts_->bodies[parts_->checked(id)];
  return body.movable ? body.mass.mass : std::numeric_limits<T>::infinity();
}
template <class T>
bool Simulation<T>::asleep(BodyId id) const {
  return parts_->bodies[parts_->checked(id)].asleep;
}
template <class T>
const Joint<T>& Simulation<T>::joint(JointId id) const {
  return parts_->joints[parts_->checked(id)].in_place.joint;
}
template <class T>
std::span<const T> Simulation<T>::joint_impulses(JointId id) const {
  return parts_->joints[parts_->checked(id)].in_place.impulses;
}
template <class T>
const World<T>& Simulation<T>::world() const {
  return parts_->world;
}
template <class T>
const SimulationSettings<T>& Simulation<T>::settings() const {
  return parts_->settings;
}
template <class T>
void Simulation<T>::set_gravity(const Vec3<T>& gravity) {
  parts_->settings.gravity = validate::point(gravity, "gravity");
  for (std::uint32_t i = 0; i < parts_->bodies.size(); ++i) parts_->wake(i);
}

template struct SimulationParts<float>;
template struct SimulationParts<double>;
template class Simulation<float>;
template class Simulation<double>;

}  // namespace graze
