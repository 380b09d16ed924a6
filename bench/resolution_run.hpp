// A scene of the table in an engine, and what can be measured of it alike in all engines.
#pragma once

#include "resolution_engine.hpp"

namespace graze::bench {

constexpr double dt = 1.0 / 60, g = 10;
constexpr int seconds = 60;  // in steps

Thing floor_with(double friction = 0.6, double restitution = 0);
Thing box(const Vec3d& at, const Vec3d& size = {1, 1, 1}, double density = 1000);
Thing round(Form form, const Vec3d& at, double radius, double height = 0);
Quatd about(const Vec3d& axis, double angle);

/// What is measured here follows from poses and velocities alone.
class Run {
 public:
  Run(const EngineKind& kind, std::vector<Thing> things, const EngineOptions& options = {});
  void steps(int count) {
    for (int i = 0; i < count; ++i) engine_->step(dt);
  }
  Moving moving(std::size_t i) const { return engine_->moving(i); }
  Vec3d at(std::size_t i) const { return moving(i).pose.translation; }
  Engine& engine() { return *engine_; }
  const std::vector<Thing>& things() const { return things_; }

  Vec3d angular_momentum(std::size_t i) const;
  double kinetic_energy() const;
  double potential_energy() const;
  double greatest_move() const;  ///< the furthest that a body has moved from where it was put
  /// The greatest depth of any two bodies as they are now, by a world of contacts in double precision.
  double deepest() const;

 private:
  std::vector<Thing> things_;
  EngineOptions options_;
  std::unique_ptr<Engine> engine_;
};

std::string millimetres(double metres);
std::string joules(double energy);

}  // namespace graze::bench
