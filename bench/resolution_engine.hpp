// Engines that move bodies, behind one interface, so that a scene is written once.
//
// Guarantee: an engine gets the same bodies in the same order as every other, with its own default solver and nothing
// damped. Poses and velocities are of the centre of mass, in double precision whatever the engine computes in.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "graze/pose.hpp"
#include "graze/vec3.hpp"

namespace graze::bench {

enum class Form { box, ball, cylinder, floor, bowl };

/// A body of a scene.
struct Thing {
  Form form = Form::box;
  Vec3d size{1, 1, 1};  ///< edges of a box; of others x is the radius and y the height; cylinders stand along y
  Posed pose{};
  double density = 1000;  ///< 0: does not move, as floors and bowls do not
  double friction = 0.6, restitution = 0;
  Vec3d linear{}, angular{};
};

/// Mass and principal moments of a solid thing.
struct ThingMass {
  double mass = 0;
  Vec3d inertia{};
};
ThingMass mass_of(const Thing& thing);

struct Moving {
  Posed pose;
  Vec3d linear, angular;
};

struct EngineOptions {
  Vec3d gravity{0, -10, 0};
  bool sleep = false;
  bool continuous = false;  ///< collision of what is fast, where it has to be asked for
  std::size_t threads = 1;
};

class Engine {
 public:
  virtual ~Engine() = default;
  virtual void add(const Thing& thing) = 0;
  virtual void step(double dt) = 0;
  virtual Moving moving(std::size_t body) const = 0;
  virtual bool asleep(std::size_t body) const = 0;
  /// A function that puts the engine back to how it is now; an empty one where that cannot be done.
  virtual std::function<void()> saved() { return {}; }
};

struct EngineKind {
  std::string name;
  std::function<std::unique_ptr<Engine>(const EngineOptions&)> make;
  bool has_threads = false;  ///< takes as many as it is told
};
/// Graze in both precisions, and of Bullet and ODE what is installed.
std::vector<EngineKind> engine_kinds();

}  // namespace graze::bench
