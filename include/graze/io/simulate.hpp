// A scene played: its bodies fall, collide, are joined and driven as KHR_physics_rigid_bodies describes them.
//
// Guarantee: frames are a function of the scene and the options alone, bit for bit, whatever executor runs the steps.
// Nodes that the file's first animation moves follow it. What the scene holds that no simulation can have (a mass of a
// body without volume, a restitution above 1) throws `InvalidValue` that names the node; nothing is played then.
//
// A body whose colliders differ in filter or material is held together as parts, each with its share of the mass about
// the same centre, so that the whole has the mass and inertia that it should have.
#pragma once

#include <functional>
#include <iosfwd>

#include "graze/executor.hpp"
#include "graze/io/recording.hpp"

namespace graze::io {

/// What may be told.
struct SimulateOptions {
  double seconds = 10;                                ///< to play; >= 0
  double rate = 60;                                   ///< steps and frames a second; at least 1
  Vec3d gravity{0, -9.81, 0};                         ///< an acceleration
  int sub_steps = 4;                                  ///< of a step, at least; a power of two
  Precision precision = Precision::double_precision;  ///< in which scalar it is computed
  Executor* executor = nullptr;                       ///< who runs the tasks; null for this thread
  /// Gets a capture of what the scene's simulation is told (`graze/capture.hpp`), unless null.
  std::ostream* capture = nullptr;
};

/// What playing took, and how it went.
struct SimulateSummary {
  std::size_t bodies = 0;                                                                ///< with a motion
  std::size_t joints = 0, steps = 0;                                                     ///< how many there were
  std::size_t awake = 0;                                                                 ///< of the bodies, at the end
  double collide_ms = 0, prepare_ms = 0, solve_ms = 0, continuous_ms = 0, whole_ms = 0;  ///< a step, on the average
  double slowest_ms = 0;                                                                 ///< of a step, by the clock
  double deepest = 0, deepest_time = 0;                                                  ///< penetration, and when
  double kinetic_energy = 0, potential_energy = 0, first_energy = 0;  ///< at the end; their sum at the beginning
  int most_sub_steps = 0;                                             ///< that any island took
  std::vector<std::string> notices;                                   ///< what a reader should know of the run
};

/// A simulation takes no more frames than this, so that their times are different floats.
inline constexpr double most_frames = 1 << 23;

/// How many frames there are, the one at time 0 included. Throws `InvalidValue` for seconds and a rate that are none.
GRAZE_API std::size_t frame_count(const SimulateOptions& options);

/// Plays the scene and calls `each` for every frame, the first at time 0. Throws `InvalidValue`.
GRAZE_API SimulateSummary simulate(const Scene& scene, const SimulateOptions& options,
                                   const std::function<void(const SimulationFrame&)>& each);

}  // namespace graze::io
