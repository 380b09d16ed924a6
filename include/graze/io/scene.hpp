// Scenes: colliders read from files.
//
// Guarantee: a loader returns valid scenes: finite poses, built shapes, filters in range. An invalid file, whatever its
// bytes, raises `InvalidValue` naming file, place, expectation and finding; nothing crashes, hangs or allocates without
// bound.
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

/// KHR_physics_rigid_bodies' motion, in the frame of its body (`Body::pose`); values absent in the file are absent
/// here.
struct BodyMotion {
  bool kinematic = false;                 ///< whether it follows its given velocity, and not forces
  std::optional<double> mass;             ///< > 0; infinite where the file says 0
  std::optional<Vec3d> center_of_mass;    ///< in units of the world, the node's scale applied
  std::optional<Vec3d> inertia_diagonal;  ///< about the centre of mass, each > 0; infinite where the file says 0
  Quatd inertia_orientation{};            ///< rotation from the principal axes to the body's frame
  Vec3d linear_velocity{};                ///< velocity of the centre of mass, in world axes
  Vec3d angular_velocity{};               ///< in world axes
  double gravity_factor = 1;              ///< multiple of the gravity
};

/// KHR_physics_rigid_bodies' physics material. A combine mode that the file does not name is unset.
using Material = graze::Material<double>;

/// A body: the node that moves. Colliders of one body never collide with each other.
struct Body {
  std::string name;                     ///< its name in the file; may be empty
  int node = -1;                        ///< its node in the file, or -1
  MotionType type = MotionType::fixed;  ///< fixed, kinematic or dynamic
  std::optional<BodyMotion> motion;     ///< its motion; none if it is fixed
  Posed pose{};                         ///< pose of its node in the world, without scale
};

/// One shape of a body, at its pose in the world.
struct Collider {
  std::string name;                  ///< its name in the file; may be empty
  int node = -1;                     ///< its node in the file, or -1
  std::uint32_t body = 0;            ///< index into `Scene::bodies`
  Shaped shape;                      ///< its shape
  Posed pose{};                      ///< pose in the world
  Filter filter{};                   ///< category and mask of collisions
  bool trigger = false;              ///< whether it only reports overlaps
  std::optional<Material> material;  ///< its material, where the file has one
};

/// One limit of KHR_physics_rigid_bodies' joints, on the second frame relative to the first: the distance along one
/// axis of the first (from a line with two axes, from a point with three) or the angle about it (with two axes between
/// the third axes, with three of the whole rotation) stays from `min` to `max`.
struct JointLimit {
  bool angular = false;                                   ///< whether it limits angles, and not distances
  std::array<bool, 3> axes{};                             ///< at least one
  double min = -std::numeric_limits<double>::infinity();  ///< the least value, or -infinity
  double max = std::numeric_limits<double>::infinity();   ///< the greatest value, or infinity
  std::optional<double> stiffness;                        ///< stiffness of the spring that holds it; none for a hard
                                                          ///< limit
  double damping = 0;                                     ///< damping of the limit
};

/// A damped spring or motor of a joint, along or about one axis of the first frame.
struct JointDrive {
  bool angular = false;       ///< whether it turns about its axis, and does not push along it
  bool acceleration = false;  ///< stiffness and damping are for a unit of effective mass
  std::uint8_t axis = 0;      ///< X, Y or Z: 0, 1 or 2.
  double max_force = std::numeric_limits<double>::infinity();  ///< largest force or torque
  /// Targets of the position and of the velocity, and the gains towards them.
  double position_target = 0, velocity_target = 0, stiffness = 0, damping = 0;
};

/// A joint of two bodies, or of one and the world.
struct Joint {
  std::string name;                             ///< its name in the file; may be empty
  int node = -1;                                ///< its node in the file, or -1
  std::optional<std::uint32_t> body_a, body_b;  ///< indices into `Scene::bodies`; none for the world
  Posed frame_a{}, frame_b{};                   ///< each in its body's frame; for the world, in the world at rest
  bool enable_collision = false;                ///< whether the two joined bodies may collide
  std::vector<JointLimit> limits;               ///< bounds on the relative position
  std::vector<JointDrive> drives;               ///< motors
};

struct AnimationTracks;

/// An animation of colliders, to be played by `collide_frames`. The colliders of the scene itself are at rest.
struct Animation {
  std::string name;                               ///< its name in the file; may be empty
  double duration = 0;                            ///< seconds, from 0 to the last keyframe
  std::uint32_t first_collider = 0;               ///< index in the scene of the first collider of its file
  std::uint32_t first_body = 0;                   ///< index in the scene of the first body of its file
  std::shared_ptr<const AnimationTracks> tracks;  ///< the loader's data for `collide_frames`
};

/// The content of a file.
struct Scene {
  std::string source;                          ///< name of the file
  std::vector<Body> bodies;                    ///< in the order of the file
  std::vector<Collider> colliders;             ///< in the order of the file
  std::vector<Joint> joints;                   ///< in the order of the file
  std::vector<Animation> animations;           ///< empty unless `LoadOptions::animations`
  std::vector<std::string> notices;            ///< a sentence for each thing skipped or approximated
  std::vector<std::string> collision_systems;  ///< the names behind the filters' bits
};

/// The collider made of a mesh in a scene without physics of its own.
enum class MeshColliders : std::uint8_t { hull, mesh, box, sphere };

/// Options of a loader.
struct LoadOptions {
  MeshColliders mesh_colliders = MeshColliders::mesh;  ///< collider of meshes
  bool animations = false;                             ///< reads the animations of glTF, too
  bool physics_only = false;  ///< leaves out the meshes of a file that has motions but no colliders, as mere pictures
  bool chosen = false;        ///< whether `mesh_colliders` is a choice of the user's, not the default: a notice then
                              ///< says that a file's own colliders stay
};

/// Reads a scene file. glTF 2.0 (.gltf, .glb) with KHR_implicit_shapes and KHR_physics_rigid_bodies; OBJ, STL and PLY
/// as one mesh each.
GRAZE_API Scene load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

/// Reads a glTF file from memory, as `load_scene` does (for tests and fuzzing); external files are not opened.
GRAZE_API Scene load_gltf(const std::string& bytes, const std::string& source_name, const LoadOptions& options = {});

/// Adds the bodies, colliders, joints and animations of `other` behind those of `scene`, and joins their collision
/// systems by name.
GRAZE_API void append(Scene& scene, Scene other);

}  // namespace graze::io
