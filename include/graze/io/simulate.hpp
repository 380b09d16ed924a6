// A scene played: its bodies fall, collide, are joined and driven as KHR_physics_rigid_bodies describes them.
//
// Guarantee: frames are a function of the scene and the options alone, bit for bit, whatever executor runs the steps.
// Nodes that the file's first animation moves follow it. A scene that cannot be simulated (a mass of a body without
// volume, a restitution above 1) throws `InvalidValue` that names the node; nothing is played then.
//
// Colliders of one body keep their materials. A body whose colliders differ in filter is held together as parts, each
// with its share of the mass about the same centre, so that the whole has the mass and inertia that it should have.
// Triggers move along with their body, push nothing, and report what comes in and leaves.
#pragma once

#include <functional>
#include <iosfwd>

#include "graze/executor.hpp"
#include "graze/io/recording.hpp"

namespace graze::io {

/// Options of a simulation.
struct SimulateOptions {
  double seconds = 10;                                ///< length of the simulation; >= 0
  double rate = 60;                                   ///< steps and frames per second; at least 1
  Vec3d gravity{0, -9.81, 0};                         ///< an acceleration
  int sub_steps = 4;                                  ///< least number of sub-steps of a step; a power of two
  Precision precision = Precision::double_precision;  ///< scalar of the computation
  Executor* executor = nullptr;                       ///< runs the tasks; null for the calling thread
  /// Receives a capture of the simulation's calls (`graze/capture.hpp`), unless null.
  std::ostream* capture = nullptr;
};

/// A body that comes into a trigger of the scene, or leaves it. A trigger that an animation scales keeps the size that
/// it has at the beginning.
struct TriggerEvent {
  double time = 0;            ///< of the frame in which it was first seen inside, or outside again
  bool begins = true;         ///< it comes in, and does not leave
  std::uint32_t trigger = 0;  ///< index into the scene's `colliders`
  std::uint32_t body = 0;     ///< index into the scene's `bodies`: the other body, which may be a trigger too
};

/// Statistics of a simulation.
struct SimulateSummary {
  std::size_t bodies = 0;                                                                ///< bodies with a motion
  std::size_t joints = 0, steps = 0;                                                     ///< numbers of joints and of
                                                                                         ///< steps
  std::size_t awake = 0;                                                                 ///< bodies awake at the end
  double collide_ms = 0, prepare_ms = 0, solve_ms = 0, continuous_ms = 0, whole_ms = 0;  ///< by the clock, averages
                                                                                         ///< over the steps
  double slowest_ms = 0;                                                                 ///< slowest step, by the clock
  double deepest = 0, deepest_time = 0;                                                  ///< deepest penetration, and
                                                                                         ///< its time
  double kinetic_energy = 0, potential_energy = 0, first_energy = 0;  ///< at the end; the sum of both at the beginning
  int most_sub_steps = 0;                                             ///< largest number of sub-steps of any island
  std::vector<std::string> notices;                                   ///< remarks on the run for the reader
  std::vector<TriggerEvent> triggers;                                 ///< in the order of time
};

/// Largest number of frames of a simulation, below which their times are different floats.
inline constexpr double most_frames = 1 << 23;

/// The number of frames, the one at time 0 included. Throws `InvalidValue` for invalid seconds and rates.
GRAZE_API std::size_t frame_count(const SimulateOptions& options);

/// Plays the scene and calls `each` for every frame, the first at time 0. Throws `InvalidValue`.
GRAZE_API SimulateSummary simulate(const Scene& scene, const SimulateOptions& options,
                                   const std::function<void(const SimulationFrame&)>& each);

}  // namespace graze::io
