// Scenes: colliders read from files.
//
// Guarantee: what a loader returns is valid: finite poses, built shapes, filters in range. A file that is not, whatever
// its bytes, raises `InvalidValue` naming file, place, what was expected and what was found; nothing crashes, hangs or
// allocates without bound.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graze/filter.hpp"
#include "graze/shape.hpp"

namespace graze::io {

enum class MotionType : std::uint8_t { fixed, kinematic, dynamic };  ///< `fixed` is glTF's static

/// KHR_physics_rigid_bodies' motion, kept as data for a solver.
struct Motion {
  bool kinematic = false;
  std::optional<double> mass;
  Vec3d center_of_mass{}, inertia_diagonal{}, linear_velocity{}, angular_velocity{};
  Quatd inertia_orientation{};
  double gravity_factor = 1;
};

/// KHR_physics_rigid_bodies' physics material.
struct Material {
  double static_friction = 0.6, dynamic_friction = 0.6, restitution = 0;
  std::string friction_combine = "average", restitution_combine = "average";
};

/// A body: the node that moves. Colliders of one body never collide with each other.
struct Body {
  std::string name;
  int node = -1;
  MotionType type = MotionType::fixed;
  std::optional<Motion> motion;
};

/// One shape of a body, at its pose in the world.
struct Collider {
  std::string name;
  int node = -1;
  std::uint32_t body = 0;  ///< index into `Scene::bodies`
  Shaped shape;
  Posed pose{};
  Filter filter{};
  bool trigger = false;
  std::optional<Material> material;
};

struct AnimationTracks;

/// What moves colliders over time, to be played by `collide_frames`. The colliders of the scene stand at rest.
struct Animation {
  std::string name;
  double duration = 0;                            ///< seconds, from 0 to the last keyframe
  std::uint32_t first_collider = 0;               ///< of its file, in the scene
  std::shared_ptr<const AnimationTracks> tracks;  ///< what the loader read, for `collide_frames`
};

struct Scene {
  std::string source;
  std::vector<Body> bodies;
  std::vector<Collider> colliders;
  std::vector<Animation> animations;           ///< when `LoadOptions::animations` asked for them
  std::vector<std::string> notices;            ///< what was skipped or approximated, one sentence each
  std::vector<std::string> collision_systems;  ///< the names behind the filters' bits
};

/// What becomes a collider in a scene that has no physics of its own.
enum class MeshColliders : std::uint8_t { hull, mesh, box, sphere };

struct LoadOptions {
  MeshColliders mesh_colliders = MeshColliders::mesh;
  bool animations = false;  ///< read those of glTF too
  bool chosen = false;      ///< asked for, not the default: a file with colliders of its own, which stay, says so
};

/// Reads a scene file. glTF 2.0 (.gltf, .glb) with KHR_implicit_shapes and KHR_physics_rigid_bodies; OBJ, STL and PLY
/// as one mesh each.
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

/// As `load_scene`, from memory (for tests and fuzzing); external files are not opened.
Scene load_gltf(const std::string& bytes, const std::string& source_name, const LoadOptions& options = {});

/// Adds the bodies, colliders and animations of `other` behind those of `scene`, and joins their collision systems by
/// name.
void append(Scene& scene, Scene other);

}  // namespace graze::io
