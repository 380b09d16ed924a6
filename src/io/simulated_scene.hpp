// A scene as a simulation.
#pragma once

#include <memory>

#include "graze/capture.hpp"
#include "graze/io/simulate.hpp"
#include "io/collider_motion.hpp"
#include "io/trigger_watch.hpp"

namespace graze::io {

template <class T>
class SimulatedScene {
 public:
  /// Builds the simulation. Throws `InvalidValue`. The scene outlives this.
  SimulatedScene(const Scene& scene, const SimulateOptions& options);

  /// Steps to `time`, which is `dt` after the last one.
  void step(double time, double dt);
  SimulationFrame frame(double time) const;
  StepReport<T> report() const { return simulation_.simulation().report(); }
  /// Appends what came into triggers and left them in the last step, whose contacts are those at `time`.
  void note_triggers(double time, std::vector<TriggerEvent>& out) {
    watch_.note(simulation_.world().events(), body_of_part_, time, out);
  }
  std::size_t awake() const;
  std::size_t joints() const { return joints_; }
  const std::vector<std::string>& notices() const { return notices_; }

 private:
  /// A body of the simulation that is all or some of a scene's body.
  struct Part {
    BodyId id;
    Posed to_body;                            ///< the pose of the scene's body seen from this one
    std::optional<std::uint32_t> collider{};  ///< that an animation moves, and the part with it
  };

  /// A trigger, which moves along with one of the scene's bodies.
  struct Trigger {
    BodyId id;
    std::uint32_t body, collider;  ///< in the scene
    Posed in_body;                 ///< its pose seen from the body
  };

  void add_fixed(std::uint32_t body);
  void add_moving(std::uint32_t body);
  void add_animated(std::uint32_t body);
  void add_animated_anchor(std::uint32_t body);
  void add_part(std::uint32_t body, const std::vector<std::uint32_t>& colliders, const Dynamics<double>& whole,
                std::size_t parts);
  void add_trigger(std::uint32_t collider);
  void move_triggers();
  void hold_together(std::uint32_t body);
  void add_joint(const Joint& joint);
  Part part_of(const std::optional<std::uint32_t>& body);
  void known_as(std::uint32_t body, const Part& part);
  void find_animated();
  Posed pose_of(const Part& part) const;
  Posed animated_pose(std::uint32_t body, const Part& part) const;
  void follow(double dt);

  const Scene& scene_;
  CapturedSimulation<T> simulation_;
  std::vector<std::uint32_t> moving_;
  std::vector<std::vector<Part>> parts_;     ///< by the scene's bodies
  std::vector<std::uint32_t> body_of_part_;  ///< by the simulation's indices
  std::vector<Trigger> triggers_;            ///< those that move
  TriggerWatch watch_;
  std::optional<Part> world_;  ///< the fixed body that joints to the world hold on to
  std::unique_ptr<ColliderMotion> motion_;
  std::vector<char> animated_;  ///< by the scene's bodies
  std::vector<std::string> notices_;
  std::size_t joints_ = 0;
};

}  // namespace graze::io
