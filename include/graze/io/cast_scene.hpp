// One body of a scene moved through the rest of it: what does it hit, when and where?
//
// Guarantee: every collider of another body that the filters allow is asked about; triggers stop nothing and are left
// out. The answer is a function of the scene and the question alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/cast.hpp"
#include "graze/io/protocol.hpp"
#include "graze/io/scene.hpp"

namespace graze::io {

/// A motion of some colliders of a scene.
struct SceneCast {
  std::string from;              ///< the name of a body, or of a collider that then moves alone
  Velocity<double> velocity{};   ///< in the world, a unit of time
  double duration = 1;           ///< how long it moves
  std::optional<Vec3d> about{};  ///< what the spin turns about; without it the origin of the first collider
  CastOptions options{};         ///< as for `graze::cast`
  Precision precision = Precision::double_precision;  ///< in which scalar it is computed
};

/// The colliders that move, and the point that they turn about.
struct Mover {
  std::vector<std::uint32_t> colliders;  ///< numbers of the colliders that move
  Vec3d pivot{};                         ///< about which they turn

  /// Where one of them, at `pose` before the motion, stands at a time.
  Posed pose_at(const Posed& pose, const Velocity<double>& velocity, double t) const;
};

/// What one collider of the mover hits first in one collider of the rest.
struct SceneHit {
  double t;                       ///< when they touch
  std::uint32_t collider, other;  ///< indices of colliders: the mover's, and the one it hits
  Vec3d point{}, normal{};        ///< the normal from the mover to the other
  double depth = 0;               ///< of colliders that overlap at the start
  Status status = Status::converged;
};

/// Throws `InvalidValue` when nothing, or more than one body, has the name that is asked for.
GRAZE_API Mover find_mover(const Scene& scene, const SceneCast& question);

/// The first hit of every pair of colliders, in the order of time. Throws `InvalidValue` as `find_mover`, and for a
/// half-space that is to spin.
GRAZE_API std::vector<SceneHit> cast_scene(const Scene& scene, const SceneCast& question);

/// Writes the scene with the cast drawn into it, as a binary glTF file: the way of the mover as a rod and as
/// translucent copies on it, its pose where it hits or, if it does not, at the end, what it hits tinted, and the
/// contact as a small octahedron with its normal. `source`, what is returned and what is thrown: as for
/// `write_contacts`.
GRAZE_API std::vector<std::string> write_cast(const std::filesystem::path& file, const Scene& scene,
                                              const SceneCast& question, const std::vector<SceneHit>& hits,
                                              const std::filesystem::path& source = {});

}  // namespace graze::io
