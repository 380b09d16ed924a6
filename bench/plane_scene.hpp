// Scenes of the plane that are played, and the engines that play them.
//
// Lengths in metres, g = 10 m/s², 60 steps a second, friction 0.6, nothing sleeps. Box2D takes 8 passes over velocities
// and 3 over positions, as it recommends.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "graze/plane/simulation.hpp"

namespace graze::plane {

constexpr double scene_friction = 0.6, steps_per_second = 60;

/// A body: circles, boxes, convex polygons and compounds of these.
struct SceneBody {
  Body<double> body;
  bool kinematic = false;
  double density = 1000;
};

/// Two bodies that turn about a common point, by a limited angle if so told.
struct SceneHinge {
  std::size_t a, b;                                       ///< places in `Scene::bodies`
  Vec2d at;                                               ///< in the world
  double least = -infinite_angle, most = infinite_angle;  ///< bounds of the angle from the first to the second

  static constexpr double infinite_angle = std::numeric_limits<double>::infinity();
};

struct Scene {
  std::string name;
  std::string what;  ///< what is in it, in a few words
  std::size_t steps;
  std::vector<SceneBody> bodies{};
  std::vector<SceneHinge> hinges{};
  Vec2d gravity{0, -10};

  std::size_t add(SceneBody body);
};

/// All scenes, with `scale` times as many bodies along each side as in the table.
std::vector<Scene> played_scenes(double scale);

/// An engine with a scene in it.
struct Engine {
  std::string name;
  std::function<void()> step;
  std::function<Pose2d(std::size_t)> pose;  ///< of a body, by its place in the scene
};

/// One function for each engine that is there, which makes it with a scene in it.
std::vector<std::function<Engine(const Scene&)>> engines_of_the_plane();

/// A table of the scenes whose names match, each played by every engine, for at most so many steps.
void print_scenes(const std::string& names, double scale, std::size_t most_steps);

}  // namespace graze::plane
