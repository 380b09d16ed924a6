// Casts in a scene: one body moved through the others, with its hits.
//
// Guarantee: every collider of another body that the filters allow is tested; triggers stop nothing and are left out.
// The answer is a function of the scene and the arguments alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graze/cast.hpp"
#include "graze/io/plane_scene.hpp"
#include "graze/io/protocol.hpp"
#include "graze/io/scene.hpp"

namespace graze::io {

/// A motion of some colliders of a scene.
struct SceneCast {
  std::string from;              ///< the name of a body, or of a collider, which then moves alone
  Velocity<double> velocity{};   ///< in the world, per unit of time
  double duration = 1;           ///< duration of the motion
  std::optional<Vec3d> about{};  ///< point about which the spin turns; by default the origin of the first collider
  CastOptions options{};         ///< options of `graze::cast`
  Precision precision = Precision::double_precision;  ///< scalar of the computation
};

/// The colliders that move, and the point that they turn about.
struct Mover {
  std::vector<std::uint32_t> colliders;  ///< indices of the moving colliders
  Vec3d pivot{};                         ///< the point that they turn about

  /// The pose at time `t` of a moving collider that stands at `pose` before the motion.
  Posed pose_at(const Posed& pose, const Velocity<double>& velocity, double t) const;
};

/// The first contact of a collider of the mover with a collider of the rest.
struct SceneHit {
  double t;                       ///< time of the contact
  std::uint32_t collider, other;  ///< indices of colliders: the mover's, and the one it hits
  Vec3d point{}, normal{};        ///< the normal from the mover to the other
  double depth = 0;               ///< depth at the start, of colliders that overlap there
  Status status = Status::converged;
};

/// The colliders with the name `question.from`. Throws `InvalidValue` when nothing, or more than one body, has it.
GRAZE_API Mover find_mover(const Scene& scene, const SceneCast& question);

/// The first hits of all pairs of colliders, in the order of time. Throws `InvalidValue` as `find_mover` does, and for
/// a half-space that is to spin.
GRAZE_API std::vector<SceneHit> cast_scene(const Scene& scene, const SceneCast& question);
/// First hits in a scene of the plane: the question's vectors lie in it, its spin is about z, and the answer's vectors
/// have z = 0. Throws `InvalidValue` as in space, and for a question that leaves the plane.
GRAZE_API std::vector<SceneHit> cast_scene(const PlaneScene& scene, const SceneCast& question);

/// Writes the scene with the cast drawn into it, as a binary glTF file: the path of the mover as a rod with translucent
/// copies along it, its pose at the hit or, if there is none, at the end, the colliders that it hits tinted, and the
/// contact as a small octahedron with its normal. `source`, the result and the exceptions are those of
/// `write_contacts`.
GRAZE_API std::vector<std::string> write_cast(const std::filesystem::path& file, const Scene& scene,
                                              const SceneCast& question, const std::vector<SceneHit>& hits,
                                              const std::filesystem::path& source = {});

}  // namespace graze::io
