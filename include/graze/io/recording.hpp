// Recordings of a simulation, frame by frame, in a file: an animated glTF scene or JSON lines.
//
// Guarantee: the bytes are a function of the scene and the frames alone. A scene that was a glTF file stays unchanged,
// with all its content, and gets one animation more, "simulation", whose keyframes are the frames: at each of their
// times every body with a motion has, in the world, the pose of its frame, up to the precision of floats, whatever
// scales its ancestors have and whichever of them are bodies of their own. Colliders without a visible mesh are drawn
// and move along. Failures to write throw `InvalidValue`: a file that was closed is whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "graze/io/protocol.hpp"
#include "graze/io/scene.hpp"

namespace graze::io {

/// The state of a body at a time.
struct BodyState {
  Posed pose{};         ///< pose of its node in the world, without scale
  Vec3d linear{};       ///< velocity of the centre of mass
  Vec3d angular{};      ///< in world axes
  bool asleep = false;  ///< whether it is at rest
};

/// The contact of two touching bodies in a step.
struct ContactState {
  std::uint32_t a = 0, b = 0;  ///< indices into `Scene::bodies`
  std::size_t points = 0;      ///< number of contact points
  double impulse = 0;          ///< sum of the normal impulses
  double depth = 0;            ///< penetration of the deepest point; 0 for a gap
};

/// The state of a simulation at one time.
struct SimulationFrame {
  double time = 0;                     ///< since the start
  std::vector<BodyState> bodies;       ///< in the order of `moving_bodies`
  std::vector<ContactState> contacts;  ///< contacts of the step
  /// Sums over the bodies with mass; potential energy counts from the origin up.
  double kinetic_energy = 0, potential_energy = 0;
};

/// The bodies with a motion, in the order of their nodes: indices into `Scene::bodies`.
GRAZE_API std::vector<std::uint32_t> moving_bodies(const Scene& scene);

/// Writes frames in the order of time.
class GRAZE_API Recording {
 public:
  virtual ~Recording() = default;
  /// Appends a frame. Throws `InvalidValue` for a frame with another number of bodies, and when the file has no room.
  virtual void add(const SimulationFrame& frame) = 0;
  /// Writes the rest. Throws `InvalidValue` unless the whole file was written.
  virtual void close() = 0;
  /// A sentence for each thing of the scene that could not be kept.
  virtual std::vector<std::string> notices() const { return {}; }
};

/// A recording, by the ending of the file's name: .gltf, .glb or .jsonl. `source` is the glTF file that the scene was
/// read from; without one the colliders are drawn alone. Lines have as many digits as `precision` needs. Throws
/// `InvalidValue` for another ending, or when `source` cannot be read or `file` not be written. The scene must outlive
/// the recording.
GRAZE_API std::unique_ptr<Recording> record(const std::filesystem::path& file, const Scene& scene,
                                            const std::filesystem::path& source = {},
                                            Precision precision = Precision::double_precision);

}  // namespace graze::io
