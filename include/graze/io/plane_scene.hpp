// Scenes of the plane: shapes drawn in SVG or written as JSON, their contacts, and a picture of them.
//
// Guarantee: a loader returns valid scenes: finite poses, built shapes, filters in range. An invalid file, whatever its
// bytes, raises `InvalidValue` naming file, line, element, expectation and finding; nothing crashes, hangs or allocates
// without bound. The plane's Y axis points up, and so SVG's is turned over: a point (x, y) of a drawing is (x, -y)
// here, and pictures look as the drawing does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "graze/filter.hpp"
#include "graze/io/collide.hpp"
#include "graze/plane/shape.hpp"

namespace graze::io {

/// The motion of a body of the plane when the scene is played.
struct PlaneMotion {
  plane::Vec2d linear{};          ///< velocity of the origin of its first collider
  double angular = 0;             ///< counter-clockwise with Y up
  std::optional<double> mass;     ///< by default that of its area
  std::optional<double> inertia;  ///< by default that of its shape with its mass
  double gravity_factor = 1;      ///< multiple of the gravity
  double friction = 0.6;          ///< Coulomb's coefficient of its material
  double restitution = 0;         ///< from 0 to 1

  friend bool operator==(const PlaneMotion&, const PlaneMotion&) = default;
};

/// A body: colliders that move as one, and never collide with each other.
struct PlaneSceneBody {
  std::string name;                     ///< its name in the file; may be empty
  MotionType type = MotionType::fixed;  ///< fixed, kinematic or dynamic
  PlaneMotion motion{};                 ///< motion when the scene is played
};

/// One shape of a body, at its pose in the world.
struct PlaneCollider {
  std::string name;        ///< its name in the file; may be empty
  std::uint32_t body = 0;  ///< index into `PlaneScene::bodies`
  plane::Shaped shape;     ///< its shape
  plane::Pose2d pose{};    ///< pose in the world
  Filter filter{};         ///< category and mask of collisions
  bool trigger = false;    ///< whether it only reports overlaps
};

/// A drawing of bodies in the plane.
struct PlaneScene {
  std::string source;                          ///< name of the file
  std::vector<PlaneSceneBody> bodies;          ///< in the order of the file
  std::vector<PlaneCollider> colliders;        ///< in the order of the file
  std::vector<std::string> notices;            ///< a sentence for each thing skipped
  std::vector<std::string> collision_systems;  ///< the names behind the filters' bits
  std::optional<plane::Vec2d> gravity;         ///< the file's gravity, if it has one
};

/// Whether a file's ending is that of a scene of the plane: .svg or .json.
GRAZE_API bool is_plane_scene(const std::filesystem::path& file);

/// Reads a scene file of the plane.
GRAZE_API PlaneScene load_plane_scene(const std::filesystem::path& file);

/// Reads an SVG document from memory. docs/plane.md lists the elements and attributes that are read.
GRAZE_API PlaneScene load_plane_svg(const std::string& bytes, const std::string& source_name);

/// Reads a JSON document `{"dimension": 2, "bodies": [...]}` with the protocol's shapes of the plane from memory.
GRAZE_API PlaneScene load_plane_json(const std::string& bytes, const std::string& source_name);

/// Writes the scene as a document for `load_plane_json`: the same bodies, colliders and filters, to the bit but for the
/// angles of poses, which may differ by a rounding. Notices are left out.
GRAZE_API std::string to_json(const PlaneScene& scene);

/// The touching pairs, found by a `plane::World`; vectors of the answer have z = 0. Throws `InvalidValue` for numbers
/// too large for the precision.
GRAZE_API std::vector<TouchingPair> collide(const PlaneScene& scene, const CollideOptions& options = {});

/// A picture of the scene with its contacts and their normals.
GRAZE_API std::string draw_picture(const PlaneScene& scene, const std::vector<TouchingPair>& pairs);

}  // namespace graze::io
