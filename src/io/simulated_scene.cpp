#include "io/simulated_scene.hpp"

#include <algorithm>

#include "io/body_distribution.hpp"
#include "io/frame_contacts.hpp"
#include "io/scene_world.hpp"

namespace graze::io {

namespace {

constexpr Filter nobody{0, 0, 0};

template <class T>
SimulationSettings<T> settings_of(const SimulateOptions& options) {
  SimulationSettings<T> settings;
  settings.gravity = converted<T>(options.gravity);
  settings.sub_steps = options.sub_steps;
  settings.most_sub_steps = std::max(settings.most_sub_steps, options.sub_steps);
  return settings;
}

template <class T>
graze::Material<T> in_precision(const Material& m) {
  return {static_cast<T>(m.static_friction),
          static_cast<T>(m.dynamic_friction),
          static_cast<T>(m.restitution),
          static_cast<T>(m.rolling_friction),
          m.friction_combine,
          m.restitution_combine,
          converted<T>(m.surface_velocity)};
}

/// The mass of a part, in its own frame: `to_body` is the body's frame there. `count` parts share it, about one centre.
template <class T>
Dynamics<T> share_of(const Dynamics<double>& whole, const Posed& to_body, std::size_t count) {
  const auto share = static_cast<T>(count);
  Dynamics<T> d;
  d.kinematic = whole.kinematic;
  d.gravity_factor = static_cast<T>(whole.gravity_factor);
  d.center_of_mass = converted<T>(transform(to_body, *whole.center_of_mass));
  if (whole.mass) d.mass = static_cast<T>(*whole.mass) / share;
  if (whole.inertia_diagonal) d.inertia_diagonal = converted<T>(*whole.inertia_diagonal) / share;
  d.inertia_orientation = converted<T>(to_body.rotation * whole.inertia_orientation);
  return d;
}

/// The element of that index in the scene, of a list that is sorted by it.
template <class Moved>
const Moved& found_at(std::span<const Moved> list, std::uint32_t index) {
  return *std::lower_bound(list.begin(), list.end(), index,
                           [](const Moved& moved, std::uint32_t i) { return moved.index < i; });
}

bool same(const Material& a, const Material& b) {
  return a.static_friction == b.static_friction && a.dynamic_friction == b.dynamic_friction &&
         a.restitution == b.restitution && a.friction_combine == b.friction_combine &&
         a.restitution_combine == b.restitution_combine;
}

/// The different materials of some colliders, and for each collider the place of its own.
struct Materials {
  std::vector<Material> different;
  std::vector<std::uint32_t> of_collider;
};
Materials materials_of(const Scene& scene, const std::vector<std::uint32_t>& colliders) {
  Materials all;
  for (const std::uint32_t c : colliders) {
    const Material own = scene.colliders[c].material.value_or(Material{});
    const auto known =
        std::find_if(all.different.begin(), all.different.end(), [&](const Material& m) { return same(m, own); });
    all.of_collider.push_back(static_cast<std::uint32_t>(known - all.different.begin()));
    if (known == all.different.end()) all.different.push_back(own);
  }
  return all;
}

template <class T>
graze::Joint<T> in_precision(const Joint& joint) {
  graze::Joint<T> out;
  out.enable_collision = joint.enable_collision;
  const auto space = [](bool angular) { return angular ? JointSpace::angular : JointSpace::linear; };
  for (const JointLimit& l : joint.limits) {
    graze::JointLimit<T> limit{space(l.angular),      l.axes, static_cast<T>(l.min),
                               static_cast<T>(l.max), {},     static_cast<T>(l.damping)};
    if (l.stiffness) limit.stiffness = static_cast<T>(*l.stiffness);
    out.limits.push_back(limit);
  }
  for (const JointDrive& d : joint.drives)
    out.drives.push_back({space(d.angular), d.acceleration ? DriveMode::acceleration : DriveMode::force, d.axis,
                          static_cast<T>(d.position_target), static_cast<T>(d.velocity_target),
                          static_cast<T>(d.stiffness), static_cast<T>(d.damping), static_cast<T>(d.max_force)});
  return out;
}

}  // namespace

template <class T>
SimulatedScene<T>::SimulatedScene(const Scene& scene, const SimulateOptions& options)
    : scene_(scene),
      simulation_(options.capture, settings_of<T>(options), options.executor),
      moving_(moving_bodies(scene)),
      parts_(scene.bodies.size()),
      animated_(scene.bodies.size(), 0) {
  find_animated();
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    try {
      if (animated_[b])
        add_animated(b);
      else if (scene.bodies[b].motion)
        add_moving(b);
      else
        add_fixed(b);
    } catch (const InvalidValue& e) {
      throw e.below(scene.source + ": " + scene.bodies[b].name);
    }
  }
  for (const Joint& joint : scene.joints) add_joint(joint);
  for (std::uint32_t c = 0; c < scene.colliders.size(); ++c)
    if (scene.colliders[c].trigger) add_trigger(c);
  move_triggers();
}

/// Finds bodies that an animation moves: through the body's own node, or that of a fixed body through any node above
/// it.
template <class T>
void SimulatedScene<T>::find_animated() {
  if (scene_.animations.empty()) return;
  const Animation& animation = scene_.animations.front();
  motion_ = std::make_unique<ColliderMotion>(scene_, animation);
  const auto& channels = animation.tracks->channels;
  for (const MovedBody& moved : motion_->bodies()) {
    const Body& body = scene_.bodies[moved.index];
    const bool own = std::any_of(channels.begin(), channels.end(),
                                 [&](const Channel& c) { return static_cast<int>(c.node) == body.node; });
    if (!body.motion || own) animated_[moved.index] = 1;
  }
  if (scene_.animations.size() > 1)
    notices_.push_back("of " + std::to_string(scene_.animations.size()) + " animations the first is followed");
  motion_->go_to(0);
}

/// Records that a body of the simulation is one of the scene's bodies, or a part of it, and gives it its name in a
/// capture.
template <class T>
void SimulatedScene<T>::known_as(std::uint32_t body, const Part& part) {
  parts_[body].push_back(part);
  body_of_part_.resize(std::max<std::size_t>(body_of_part_.size(), part.id.index + 1));
  body_of_part_[part.id.index] = body;
  simulation_.set_name(part.id, scene_.bodies[body].name);
}

template <class T>
void SimulatedScene<T>::add_part(std::uint32_t body, const std::vector<std::uint32_t>& colliders,
                                 const Dynamics<double>& whole, std::size_t parts) {
  const Body& of = scene_.bodies[body];
  graze::Body<T> part{Shape<T>(Sphere<T>(T(0))), converted<T>(of.pose)};
  Posed pose = of.pose;
  part.filter = nobody;
  const Materials materials = materials_of(scene_, colliders);
  if (colliders.size() == 1) {
    pose = scene_.colliders[colliders[0]].pose;
    part = in_world<T>(scene_, scene_.colliders[colliders[0]], false);
  } else if (!colliders.empty()) {
    Collider all = scene_.colliders[colliders[0]];
    std::vector<Placed<double>> children;
    children.reserve(colliders.size());
    for (const std::uint32_t c : colliders)
      children.push_back({scene_.colliders[c].shape, relative(of.pose, scene_.colliders[c].pose)});
    all.shape = Compound<double>(std::move(children));
    all.pose = of.pose;
    part = in_world<T>(scene_, all, false);
  }
  const BodyMotion& motion = *of.motion;
  const Vec3d center = transform(of.pose, *whole.center_of_mass);
  part.linear = converted<T>(motion.linear_velocity + cross(motion.angular_velocity, pose.translation - center));
  part.angular = converted<T>(motion.angular_velocity);
  const Posed to_body = relative(pose, of.pose);
  std::vector<graze::Material<T>> different;
  for (const Material& m : materials.different) different.push_back(in_precision<T>(m));
  if (different.empty()) different.emplace_back();
  const BodyId id = simulation_.add(std::move(part), share_of<T>(whole, to_body, parts), different[0]);
  if (different.size() > 1) simulation_.set_materials(id, different, materials.of_collider);
  known_as(body, {id, to_body, {}});
}

template <class T>
void SimulatedScene<T>::add_moving(std::uint32_t body) {
  std::vector<std::vector<std::uint32_t>> groups;
  for (std::uint32_t c = 0; c < scene_.colliders.size(); ++c) {
    const Collider& collider = scene_.colliders[c];
    if (collider.body != body || collider.trigger) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) {
      return scene_.colliders[g.front()].filter == collider.filter;
    });
    if (group == groups.end())
      groups.push_back({c});
    else
      group->push_back(c);
  }
  if (groups.empty()) groups.emplace_back();
  const Dynamics<double> whole = distribution_of(scene_, body);
  for (const auto& group : groups) add_part(body, group, whole, groups.size());
  hold_together(body);
}

template <class T>
void SimulatedScene<T>::hold_together(std::uint32_t body) {
  const auto& parts = parts_[body];
  const BodyMotion& motion = *scene_.bodies[body].motion;
  if (motion.kinematic || (motion.mass && !std::isfinite(*motion.mass))) return;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    graze::Joint<T> joint =
        fixed_joint<T>(parts[0].id, converted<T>(parts[0].to_body), parts[i].id, converted<T>(parts[i].to_body));
    joint.enable_collision = true;  // parts of one body do not collide by their filters
    simulation_.add(joint);
  }
}

template <class T>
void SimulatedScene<T>::add_fixed(std::uint32_t body) {
  for (const Collider& c : scene_.colliders) {
    if (c.body != body || c.trigger) continue;
    const auto material = c.material ? in_precision<T>(*c.material) : graze::Material<T>{};
    const BodyId id = simulation_.add(in_world<T>(scene_, c, true), {}, material);
    known_as(body, {id, relative(c.pose, scene_.bodies[body].pose), {}});
  }
}

/// Adds each collider as a body of its own, as channels may move them against each other. They begin where the
/// animation has them at time 0, which need not be where the file has them at rest.
template <class T>
void SimulatedScene<T>::add_animated(std::uint32_t body) {
  const Posed of = animated_pose(body, {});
  for (const MovedCollider& m : motion_->colliders()) {
    if (scene_.colliders[m.index].body != body || scene_.colliders[m.index].trigger) continue;
    Collider c = scene_.colliders[m.index];
    c.shape = m.shape;
    c.pose = m.pose;
    Dynamics<T> dynamics;
    dynamics.kinematic = true;
    const auto material = c.material ? in_precision<T>(*c.material) : graze::Material<T>{};
    const BodyId id = simulation_.add(in_world<T>(scene_, c, false), dynamics, material);
    known_as(body, {id, relative(c.pose, of), m.index});
  }
  if (parts_[body].empty() && scene_.bodies[body].motion) add_animated_anchor(body);
}

/// Adds a trigger, which moves along with its body.
template <class T>
void SimulatedScene<T>::add_trigger(std::uint32_t collider) {
  Collider c = scene_.colliders[collider];
  const bool moves = animated_[c.body] || scene_.bodies[c.body].motion;
  if (animated_[c.body]) c.shape = found_at(motion_->colliders(), collider).shape;
  graze::Body<T> trigger = in_world<T>(scene_, c, !moves);
  trigger.trigger = true;
  const BodyId id = simulation_.add(std::move(trigger));
  simulation_.set_name(id, c.name);
  body_of_part_.resize(std::max<std::size_t>(body_of_part_.size(), id.index + 1));
  body_of_part_[id.index] = c.body;
  watch_.add(id, collider);
  if (moves) triggers_.push_back({id, c.body, collider, relative(scene_.bodies[c.body].pose, c.pose)});
}

/// Puts triggers where their bodies are.
template <class T>
void SimulatedScene<T>::move_triggers() {
  for (const Trigger& t : triggers_) {
    const Posed pose = animated_[t.body] ? animated_pose(t.body, {t.id, {}, t.collider})
                                         : compose(pose_of(parts_[t.body].front()), t.in_body);
    const Pose<T> to = converted<T>(pose);
    if (!(to == simulation_.simulation().poses()[t.id.index])) simulation_.set_pose(t.id, to);
  }
}

/// Adds a body that nothing collides with, for one without colliders: joints may hold on to it.
template <class T>
void SimulatedScene<T>::add_animated_anchor(std::uint32_t body) {
  graze::Body<T> anchor{Shape<T>(Sphere<T>(T(0))), converted<T>(animated_pose(body, {}))};
  anchor.filter = nobody;
  Dynamics<T> dynamics;
  dynamics.kinematic = true;
  known_as(body, {simulation_.add(std::move(anchor), dynamics), {}, {}});
}

/// The pose that the animation has for a part at the time it was moved to; of a part without a collider, the body's.
template <class T>
Posed SimulatedScene<T>::animated_pose(std::uint32_t body, const Part& part) const {
  return part.collider ? found_at(motion_->colliders(), *part.collider).pose : found_at(motion_->bodies(), body).pose;
}

template <class T>
auto SimulatedScene<T>::part_of(const std::optional<std::uint32_t>& body) -> Part {
  if (body && !parts_[*body].empty()) return parts_[*body].front();
  if (!world_) {
    graze::Body<T> anchor{Shape<T>(Sphere<T>(T(0)))};
    anchor.fixed = true;
    anchor.filter = nobody;
    world_ = Part{simulation_.add(std::move(anchor)), {}, {}};
    simulation_.set_name(world_->id, "world");
    body_of_part_.resize(std::max<std::size_t>(body_of_part_.size(), world_->id.index + 1));
  }
  return *world_;
}

/// Adds a joint. A body of several parts is held by its first; the others are kept from colliding by joints that hold
/// nothing.
template <class T>
void SimulatedScene<T>::add_joint(const Joint& joint) {
  try {
    graze::Joint<T> held = in_precision<T>(joint);
    const Part a = part_of(joint.body_a), b = part_of(joint.body_b);
    held.a = a.id;
    held.b = b.id;
    held.frame_a = converted<T>(compose(a.to_body, joint.frame_a));
    held.frame_b = converted<T>(compose(b.to_body, joint.frame_b));
    simulation_.add(held);
    ++joints_;
    if (joint.enable_collision || !joint.body_a || !joint.body_b) return;
    for (const Part& p : parts_[*joint.body_a])
      for (const Part& q : parts_[*joint.body_b]) {
        if (p.id == a.id && q.id == b.id) continue;
        graze::Joint<T> apart;
        apart.a = p.id;
        apart.b = q.id;
        simulation_.add(apart);
      }
  } catch (const InvalidValue& e) {
    throw e.below(scene_.source + ": " + joint.name);
  }
}

template <class T>
void SimulatedScene<T>::follow(double dt) {
  for (std::uint32_t b = 0; b < parts_.size(); ++b)
    if (animated_[b])
      for (const Part& part : parts_[b])
        simulation_.move_to(part.id, converted<T>(animated_pose(b, part)), static_cast<T>(dt));
}

template <class T>
void SimulatedScene<T>::step(double time, double dt) {
  if (motion_) {
    motion_->go_to(std::min(time, scene_.animations.front().duration));
    follow(dt);
  }
  simulation_.step(static_cast<T>(dt));
  move_triggers();
}

template <class T>
Posed SimulatedScene<T>::pose_of(const Part& part) const {
  const Posed pose = compose(converted<double>(simulation_.simulation().poses()[part.id.index]), part.to_body);
  return {pose.translation, normalized(pose.rotation)};
}

template <class T>
std::size_t SimulatedScene<T>::awake() const {
  return static_cast<std::size_t>(std::count_if(moving_.begin(), moving_.end(), [&](std::uint32_t b) {
    return !parts_[b].empty() && !simulation_.simulation().asleep(parts_[b].front().id);
  }));
}

template <class T>
SimulationFrame SimulatedScene<T>::frame(double time) const {
  SimulationFrame frame;
  frame.time = time;
  for (const std::uint32_t b : moving_) {
    BodyState state{scene_.bodies[b].pose};
    if (!parts_[b].empty()) {
      const Part& part = parts_[b].front();
      const graze::Motion<T> motion = simulation_.simulation().motion(part.id);
      state = {pose_of(part), converted<double>(motion.linear), converted<double>(motion.angular),
               simulation_.simulation().asleep(part.id)};
    }
    frame.bodies.push_back(state);
  }
  frame.contacts = frame_contacts(simulation_.world().contacts(), body_of_part_);
  const StepReport<T> report = simulation_.simulation().report();
  frame.kinetic_energy = static_cast<double>(report.kinetic_energy);
  frame.potential_energy = static_cast<double>(report.potential_energy);
  return frame;
}

template class SimulatedScene<float>;
template class SimulatedScene<double>;

}  // namespace graze::io
