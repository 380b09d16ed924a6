// Scenes: colliders read from files.
//
// Guarantee: what a loader returns is valid: finite poses, built shapes, filters in range. A file that is not, whatever
// its bytes, raises `InvalidValue` naming file, place, what was expected and what was found; nothing crashes, hangs or
// allocates without bound.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graze/filter.hpp"
#include "graze/material.hpp"
#include "graze/shape.hpp"

namespace graze::io {

enum class MotionType : std::uint8_t { fixed, kinematic, dynamic };  ///< `fixed` is glTF's static

/// KHR_physics_rigid_bodies' motion, in the frame of its body (`Body::pose`); what the file leaves out is left out
/// here.
struct BodyMotion {
  bool kinematic = false;                 ///< whether it moves as it is told, and not by forces
  std::optional<double> mass;             ///< > 0; infinite where the file says 0
  std::optional<Vec3d> center_of_mass;    ///< at the size that the body has in the world
  std::optional<Vec3d> inertia_diagonal;  ///< about the centre of mass, each > 0; infinite where the file says 0
  Quatd inertia_orientation{};            ///< turns the principal axes into the body's frame
  Vec3d linear_velocity{};                ///< of the centre of mass, in world axes
  Vec3d angular_velocity{};               ///< in world axes
  double gravity_factor = 1;              ///< how much of gravity it feels
};

/// KHR_physics_rigid_bodies' physics material. A combine mode that the file does not name is unset.
using Material = graze::Material<double>;

/// A body: the node that moves. Colliders of one body never collide with each other.
struct Body {
  std::string name;                     ///< its name in the file; may be empty
  int node = -1;                        ///< its node in the file, or -1
  MotionType type = MotionType::fixed;  ///< whether it is fixed, or how it moves
  std::optional<BodyMotion> motion;     ///< how it moves; none for what is fixed
  Posed pose{};                         ///< of its node in the world, without scale
};

/// One shape of a body, at its pose in the world.
struct Collider {
  std::string name;                  ///< its name in the file; may be empty
  int node = -1;                     ///< its node in the file, or -1
  std::uint32_t body = 0;            ///< index into `Scene::bodies`
  Shaped shape;                      ///< its shape
  Posed pose{};                      ///< where it stands
  Filter filter{};                   ///< what it may meet
  bool trigger = false;              ///< whether it only tells of overlaps
  std::optional<Material> material;  ///< what it is made of, where the file says
};

/// One range of KHR_physics_rigid_bodies' joints: of the second frame seen from the first, the distance along one axis
/// of the first (from a line with two axes, from a point with three) or the angle about it (with two axes between the
/// third axes, with three of the whole turn) stays from `min` to `max`.
struct JointLimit {
  bool angular = false;                                   ///< whether it is about axes, and not along them
  std::array<bool, 3> axes{};                             ///< at least one
  double min = -std::numeric_limits<double>::infinity();  ///< the least value, or -infinity
  double max = std::numeric_limits<double>::infinity();   ///< the greatest value, or infinity
  std::optional<double> stiffness;                        ///< of the spring that holds it; a hard limit without
  double damping = 0;                                     ///< of the limit
};

/// A damped spring or motor of a joint, along or about one axis of the first frame.
struct JointDrive {
  bool angular = false;       ///< whether it is about axes, and not along them
  bool acceleration = false;  ///< stiffness and damping are for a unit of effective mass
  std::uint8_t axis = 0;      ///< X, Y or Z: 0, 1 or 2.
  double max_force = std::numeric_limits<double>::infinity();  ///< what the drive may do, at most
  /// Where the drive pulls to, how fast, and how.
  double position_target = 0, velocity_target = 0, stiffness = 0, damping = 0;
};

/// A joint of two bodies, or of one and the world.
struct Joint {
  std::string name;                             ///< its name in the file; may be empty
  int node = -1;                                ///< its node in the file, or -1
  std::optional<std::uint32_t> body_a, body_b;  ///< indices into `Scene::bodies`; the world without
  Posed frame_a{}, frame_b{};                   ///< in the body's frame; at rest in the world, without one
  bool enable_collision = false;                ///< whether the two joined may collide
  std::vector<JointLimit> limits;               ///< what it holds back
  std::vector<JointDrive> drives;               ///< what pulls it
};

struct AnimationTracks;

/// What moves colliders over time, to be played by `collide_frames`. The colliders of the scene stand at rest.
struct Animation {
  std::string name;                               ///< its name in the file; may be empty
  double duration = 0;                            ///< seconds, from 0 to the last keyframe
  std::uint32_t first_collider = 0;               ///< of its file, in the scene
  std::shared_ptr<const AnimationTracks> tracks;  ///< what the loader read, for `collide_frames`
};

/// What a file holds.
struct Scene {
  std::string source;                          ///< the file it was read from
  std::vector<Body> bodies;                    ///< in the order of the file
  std::vector<Collider> colliders;             ///< in the order of the file
  std::vector<Joint> joints;                   ///< in the order of the file
  std::vector<Animation> animations;           ///< when `LoadOptions::animations` asked for them
  std::vector<std::string> notices;            ///< what was skipped or approximated, one sentence each
  std::vector<std::string> collision_systems;  ///< the names behind the filters' bits
};

/// What becomes a collider in a scene that has no physics of its own.
enum class MeshColliders : std::uint8_t { hull, mesh, box, sphere };

/// What the reader may be told.
struct LoadOptions {
  MeshColliders mesh_colliders = MeshColliders::mesh;  ///< what becomes of meshes
  bool animations = false;                             ///< read those of glTF too
  bool physics_only = false;  ///< the meshes of a file that has motions, and no colliders, are pictures and stay so
  bool chosen = false;        ///< asked for, not the default: a file with colliders of its own, which stay, says so
};

/// Reads a scene file. glTF 2.0 (.gltf, .glb) with KHR_implicit_shapes and KHR_physics_rigid_bodies; OBJ, STL and PLY
/// as one mesh each.
GRAZE_API Scene load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

/// As `load_scene`, from memory (for tests and fuzzing); external files are not opened.
GRAZE_API Scene load_gltf(const std::string& bytes, const std::string& source_name, const LoadOptions& options = {});

/// Adds the bodies, colliders, joints and animations of `other` behind those of `scene`, and joins their collision
/// systems by name.
GRAZE_API void append(Scene& scene, Scene other);

}  // namespace graze::io
