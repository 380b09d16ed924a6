// Scenes of the plane: shapes drawn in SVG or written as JSON, which of them touch, and a picture of that.
//
// Guarantee: what a loader returns is valid: finite poses, built shapes, filters in range. A file that is not, whatever
// its bytes, raises `InvalidValue` naming file, line, element, what was expected and what was found; nothing crashes,
// hangs or allocates without bound. The plane's Y axis points up, and so SVG's is turned over: a point (x, y) of a
// drawing is (x, -y) here, and pictures look as the drawing does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "graze/filter.hpp"
#include "graze/io/collide.hpp"
#include "graze/plane/shape.hpp"

namespace graze::io {

/// How a body of the plane is moved, when the scene is played.
struct PlaneMotion {
  plane::Vec2d linear{};          ///< velocity of the origin of its first collider
  double angular = 0;             ///< counter-clockwise with Y up
  std::optional<double> mass;     ///< by default of its area
  std::optional<double> inertia;  ///< by default that of its shape with its mass
  double gravity_factor = 1;      ///< how much of gravity it feels
  double friction = 0.6;          ///< Coulomb's, of its material
  double restitution = 0;         ///< from 0 to 1

  friend bool operator==(const PlaneMotion&, const PlaneMotion&) = default;
};

/// What moves as one. Its colliders never collide with each other.
struct PlaneSceneBody {
  std::string name;                     ///< its name in the file; may be empty
  MotionType type = MotionType::fixed;  ///< whether it is fixed, or how it moves
  PlaneMotion motion{};                 ///< how it is moved, when the scene is played
};

/// One shape of a body, at its pose in the world.
struct PlaneCollider {
  std::string name;        ///< its name in the file; may be empty
  std::uint32_t body = 0;  ///< index into `PlaneScene::bodies`
  plane::Shaped shape;     ///< its shape
  plane::Pose2d pose{};    ///< where it stands
  Filter filter{};         ///< what it may meet
  bool trigger = false;    ///< whether it only tells of overlaps
};

/// A drawing of bodies in the plane.
struct PlaneScene {
  std::string source;                          ///< the file it was read from
  std::vector<PlaneSceneBody> bodies;          ///< in the order of the file
  std::vector<PlaneCollider> colliders;        ///< in the order of the file
  std::vector<std::string> notices;            ///< what was skipped, one sentence each
  std::vector<std::string> collision_systems;  ///< the names behind the filters' bits
  std::optional<plane::Vec2d> gravity;         ///< where the file says one
};

/// Whether a file's ending is that of a scene of the plane: .svg or .json.
GRAZE_API bool is_plane_scene(const std::filesystem::path& file);

/// Reads a scene file of the plane.
GRAZE_API PlaneScene load_plane_scene(const std::filesystem::path& file);

/// An SVG document, from memory. docs/plane.md says which elements and attributes are read.
GRAZE_API PlaneScene load_plane_svg(const std::string& bytes, const std::string& source_name);

/// A JSON document `{"dimension": 2, "bodies": [...]}` with the protocol's shapes of the plane, from memory.
GRAZE_API PlaneScene load_plane_json(const std::string& bytes, const std::string& source_name);

/// The scene as such a document as `load_plane_json` reads: the same bodies, colliders and filters, to the bit but for
/// the angles of poses, which may differ by a rounding. Notices are left out.
GRAZE_API std::string to_json(const PlaneScene& scene);

/// As `collide` of scenes in space, by a `plane::World`; vectors of the answer have z = 0. Throws `InvalidValue` for
/// what is too large for the precision.
GRAZE_API std::vector<TouchingPair> collide(const PlaneScene& scene, const CollideOptions& options = {});

/// The scene with its contacts and their normals.
GRAZE_API std::string draw_picture(const PlaneScene& scene, const std::vector<TouchingPair>& pairs);

}  // namespace graze::io
