#include "graze/io/plane_simulate.hpp"

#include <cmath>

#include "graze/plane/capture.hpp"
#include "io/frame_contacts.hpp"
#include "io/playing.hpp"
#include "io/scene_world.hpp"
#include "io/single_plane_shape.hpp"
#include "io/trigger_watch.hpp"

namespace graze::io {

namespace {

using plane::Pose2d;

template <class T>
plane::SimulationSettings<T> settings_of(const SimulateOptions& options) {
  plane::SimulationSettings<T> settings;
  settings.gravity = {static_cast<T>(options.gravity.x), static_cast<T>(options.gravity.y)};
  settings.sub_steps = options.sub_steps;
  settings.most_sub_steps = std::max(settings.most_sub_steps, options.sub_steps);
  return settings;
}

/// A scene as a simulation.
template <class T>
class SimulatedPlaneScene {
 public:
  SimulatedPlaneScene(const PlaneScene& scene, const SimulateOptions& options)
      : scene_(scene),
        captured_(options.capture, settings_of<T>(options), options.executor),
        simulation_(captured_.simulation()),
        moving_(moving_bodies(scene)) {
    std::vector<std::vector<const PlaneCollider*>> colliders(scene.bodies.size());
    for (const PlaneCollider& c : scene.colliders)
      if (!c.trigger) colliders[c.body].push_back(&c);
    ids_.resize(scene.bodies.size());
    firsts_.resize(scene.bodies.size());
    for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
      try {
        if (scene.bodies[b].type != MotionType::fixed)
          add_moving(b, colliders[b]);
        else
          for (const PlaneCollider* c : colliders[b]) add(b, in_precision<T>(c->shape), *c, true);
      } catch (const InvalidValue& e) {
        throw e.below(scene.source + ": " + scene.bodies[b].name);
      }
    }
    for (std::uint32_t c = 0; c < scene.colliders.size(); ++c)
      if (scene.colliders[c].trigger) add_trigger(c);
  }

  void step(double, double dt) {
    captured_.step(static_cast<T>(dt));
    move_triggers();
  }
  void note_triggers(double time, std::vector<TriggerEvent>& out) {
    watch_.note(simulation_.world().events(), body_of_, time, out);
  }
  plane::StepReport<T> report() const { return simulation_.report(); }
  std::size_t awake() const {
    return static_cast<std::size_t>(std::count_if(
        moving_.begin(), moving_.end(), [&](std::uint32_t b) { return ids_[b] && !simulation_.asleep(*ids_[b]); }));
  }

  PlaneSimulationFrame frame(double time) const {
    PlaneSimulationFrame frame;
    frame.time = time;
    for (const std::uint32_t b : moving_) {
      PlaneBodyState state;
      if (ids_[b]) {
        const Pose2d pose = plane::converted<double>(simulation_.poses()[ids_[b]->index]);
        const auto motion = simulation_.motion(*ids_[b]);
        state = {pose.translation, std::atan2(pose.rotation.sine, pose.rotation.cosine),
                 plane::converted<double>(motion.linear), static_cast<double>(motion.angular),
                 simulation_.asleep(*ids_[b])};
      }
      frame.bodies.push_back(state);
    }
    frame.contacts = frame_contacts(simulation_.world().contacts(), body_of_);
    const plane::StepReport<T> report = simulation_.report();
    frame.kinetic_energy = static_cast<double>(report.kinetic_energy);
    frame.potential_energy = static_cast<double>(report.potential_energy);
    return frame;
  }

 private:
  /// Adds a moving body: all of its colliders are one shape in the frame of the first.
  void add_moving(std::uint32_t b, const std::vector<const PlaneCollider*>& colliders) {
    if (colliders.empty()) return;  // triggers alone, of which the first moves
    const PlaneCollider& first = *colliders.front();
    if (colliders.size() == 1) return add(b, in_precision<T>(first.shape), first, false);
    std::vector<plane::Placed<T>> children;
    for (const PlaneCollider* c : colliders) {
      if (!(c->filter == first.filter))
        throw InvalidValue(c->name, "the collision systems of the body's other shapes, to be played", "others");
      children.push_back({in_precision<T>(c->shape), plane::converted<T>(relative(first.pose, c->pose))});
    }
    add(b, plane::Compound<T>(std::move(children)), first, false);
  }

  void add(std::uint32_t b, plane::Shape<T> shape, const PlaneCollider& collider, bool fixed) {
    const PlaneMotion& motion = scene_.bodies[b].motion;
    plane::Body<T> body{std::move(shape), plane::converted<T>(collider.pose)};
    body.filter = collider.filter;
    body.filter.group = -1 - static_cast<std::int32_t>(b);
    body.fixed = fixed;
    body.trigger = collider.trigger;
    plane::Dynamics<T> dynamics;
    if (!fixed) {
      body.linear = plane::converted<T>(motion.linear);
      body.angular = static_cast<T>(motion.angular);
      if (motion.mass) dynamics.mass = static_cast<T>(*motion.mass);
      if (motion.inertia) dynamics.inertia = static_cast<T>(*motion.inertia);
      dynamics.gravity_factor = static_cast<T>(motion.gravity_factor);
      dynamics.kinematic = scene_.bodies[b].type == MotionType::kinematic;
    }
    plane::Material<T> material;
    material.static_friction = material.dynamic_friction = static_cast<T>(motion.friction);
    material.restitution = static_cast<T>(motion.restitution);
    const BodyId id = captured_.add(std::move(body), dynamics, material);
    known_as(b, id, scene_.bodies[b].name);
    if (!ids_[b]) {
      ids_[b] = id;
      firsts_[b] = &collider;
    }
  }

  void known_as(std::uint32_t b, BodyId id, const std::string& name) {
    captured_.set_name(id, name);
    body_of_.resize(std::max<std::size_t>(body_of_.size(), id.index + 1));
    body_of_[id.index] = b;
  }

  /// Adds a trigger, which moves along with its body; alone, as the body itself.
  void add_trigger(std::uint32_t index) {
    const PlaneCollider& c = scene_.colliders[index];
    const bool fixed = scene_.bodies[c.body].type == MotionType::fixed;
    try {
      if (!fixed && !ids_[c.body]) {
        add(c.body, in_precision<T>(c.shape), c, false);
        return watch_.add(*ids_[c.body], index);
      }
      plane::Body<T> trigger = in_world<T>(scene_, c, fixed);
      trigger.trigger = true;
      const BodyId id = captured_.add(std::move(trigger));
      known_as(c.body, id, c.name);
      watch_.add(id, index);
      if (!fixed) triggers_.push_back({id, *ids_[c.body], relative(firsts_[c.body]->pose, c.pose)});
    } catch (const InvalidValue& e) {
      throw e.below(scene_.source + ": " + c.name);
    }
  }

  /// Puts triggers where their bodies are.
  void move_triggers() {
    for (const auto& [id, body, in_body] : triggers_) {
      const Pose2d of = plane::converted<double>(simulation_.poses()[body.index]);
      const plane::Pose2<T> to = plane::converted<T>(compose(of, in_body));
      if (!(to == simulation_.poses()[id.index])) captured_.set_pose(id, to);
    }
  }

  /// A trigger that moves along with another body of the simulation.
  struct Trigger {
    BodyId id, body;
    Pose2d in_body;
  };

  const PlaneScene& scene_;
  plane::CapturedSimulation<T> captured_;
  const plane::Simulation<T>& simulation_;  ///< the one that is played
  std::vector<std::uint32_t> moving_;
  std::vector<std::optional<BodyId>> ids_;    ///< by the scene's bodies: the first body of each in the simulation
  std::vector<const PlaneCollider*> firsts_;  ///< the colliders of these first bodies
  std::vector<std::uint32_t> body_of_;        ///< by the simulation's indices
  std::vector<Trigger> triggers_;             ///< those that move along
  TriggerWatch watch_;
};

template <class T>
SimulateSummary play_in(const PlaneScene& scene, const SimulateOptions& options,
                        const std::function<void(const PlaneSimulationFrame&)>& each) {
  frame_count(options);  // refused before anything is built
  SimulatedPlaneScene<T> simulated(scene, options);
  SimulateSummary summary = play(simulated, options, each);
  summary.bodies = moving_bodies(scene).size();
  return summary;
}

}  // namespace

std::vector<std::uint32_t> moving_bodies(const PlaneScene& scene) {
  std::vector<std::uint32_t> moving;
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].type != MotionType::fixed) moving.push_back(i);
  return moving;
}

SimulateSummary simulate(const PlaneScene& scene, const SimulateOptions& options,
                         const std::function<void(const PlaneSimulationFrame&)>& each) {
  return options.precision == Precision::double_precision ? play_in<double>(scene, options, each)
                                                          : play_in<float>(scene, options, each);
}

}  // namespace graze::io
