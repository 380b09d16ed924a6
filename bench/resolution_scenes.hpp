// The scenes of bench_resolution: one function a row, each a figure or two of a simulation that was just made.
//
// Guarantee: 60 Hz, gravity 10 downwards along y, density 1000, friction 0.6 unless said; everything else is the
// library's default, but that nothing sleeps except where a row is about that.
#pragma once

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "graze/query.hpp"
#include "graze/simulation.hpp"

namespace graze::bench {

/// What a row came to.
struct Figure {
  std::string row, what;
  double value;
  std::string target;
  bool reached;
};

template <class T>
struct Scene {
  explicit Scene(bool sleep = false, T restitution = T(0), T friction = T(0.6))
      : simulation(settings(sleep)), material{friction, friction, restitution} {}

  static SimulationSettings<T> settings(bool sleep) {
    SimulationSettings<T> s;
    s.gravity = {T(0), T(-10), T(0)};
    s.sleep = sleep;
    return s;
  }

  BodyId floor(const Quat<T>& rotation = {}) {
    graze::Body<T> body{HalfSpace<T>()};
    body.pose.rotation = rotation;
    body.fixed = true;
    return simulation.add(body, {}, material);
  }
  BodyId wall(Shape<T> shape, const Vec3<T>& at) {
    graze::Body<T> body{std::move(shape), {at, {}}};
    body.fixed = true;
    return simulation.add(body, {}, material);
  }
  BodyId add(Shape<T> shape, const Pose<T>& pose, T density = T(1000), const Velocity<T>& velocity = {}) {
    graze::Body<T> body{std::move(shape), pose, velocity.linear, velocity.angular};
    Dynamics<T> dynamics;
    dynamics.density = density;
    bodies.push_back(simulation.add(body, dynamics, material));
    return bodies.back();
  }
  void run(double seconds, double dt = 1.0 / 60) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / dt)); ++i) simulation.step(static_cast<T>(dt));
  }
  Vec3<T> at(BodyId id) const { return simulation.poses()[id.index].translation; }
  double kinetic() const { return static_cast<double>(simulation.report().kinetic_energy); }
  double deepest() const { return static_cast<double>(simulation.report().deepest); }

  Simulation<T> simulation;
  Material<T> material;
  std::vector<BodyId> bodies;
};

}  // namespace graze::bench
