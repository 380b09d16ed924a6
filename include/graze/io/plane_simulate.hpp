// A scene of the plane played: its bodies fall, collide, slide and rest, as `graze::plane::Simulation` moves them.
//
// Guarantee: frames are a function of the scene and the options alone, bit for bit, whatever executor runs the steps. A
// scene that cannot be simulated (a body without area and without a mass, a restitution above 1) throws `InvalidValue`
// that names the body; nothing is played then. Triggers push nothing and are left out.
#pragma once

#include "graze/io/plane_scene.hpp"
#include "graze/io/simulate.hpp"

namespace graze::io {

/// The state of a body of the plane at a time.
struct PlaneBodyState {
  plane::Vec2d translation{};  ///< origin of its first collider
  double rotation = 0;         ///< angle of its first collider, from -pi to pi
  plane::Vec2d linear{};       ///< velocity of the centre of mass
  double angular = 0;          ///< counter-clockwise with Y up
  bool asleep = false;         ///< whether it rests until something wakes it
};

/// The state of a scene of the plane at a time.
struct PlaneSimulationFrame {
  double time = 0;                     ///< since the start, in the units of gravity
  std::vector<PlaneBodyState> bodies;  ///< in the order of `moving_bodies`
  std::vector<ContactState> contacts;  ///< in the order of pairs
  double kinetic_energy = 0;           ///< sum over all moving bodies
  double potential_energy = 0;         ///< in the gravity of the scene, zero at its origin
};

/// The bodies that are not static, in their order: indices into `PlaneScene::bodies`.
GRAZE_API std::vector<std::uint32_t> moving_bodies(const PlaneScene& scene);

/// Plays the scene and calls `each` for every frame, the first at time 0. The gravity is x and y of that in `options`,
/// whatever the scene's own. Throws `InvalidValue`.
GRAZE_API SimulateSummary simulate(const PlaneScene& scene, const SimulateOptions& options,
                                   const std::function<void(const PlaneSimulationFrame&)>& each);

/// Writes frames in the order of time, as `Recording` does.
class GRAZE_API PlaneRecording {
 public:
  virtual ~PlaneRecording() = default;
  /// Appends a frame. Throws `InvalidValue` for a frame with another number of bodies, and when the file has no room.
  virtual void add(const PlaneSimulationFrame& frame) = 0;
  /// Writes the rest. Throws `InvalidValue` unless the whole file was written.
  virtual void close() = 0;
};

/// A recording, by the ending of the file's name: .svg, a picture that moves in any browser, or .jsonl, lines with as
/// many digits as `precision` needs. Throws `InvalidValue` for another ending, or when `file` cannot be written. The
/// scene must outlive the recording.
GRAZE_API std::unique_ptr<PlaneRecording> record(const std::filesystem::path& file, const PlaneScene& scene,
                                                 Precision precision = Precision::double_precision);

}  // namespace graze::io
