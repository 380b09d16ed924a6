#include "scene_options.hpp"

#include <algorithm>

#include "graze/error.hpp"
#include "graze/io/plane_scene.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace graze::cli {

void SceneOptions::add_to(CLI::App& command, bool or_plane) {
  command
      .add_option("SCENE", files,
                  std::string("Scenes: .gltf, .glb, .obj, .stl, .ply; several are put together at the origin") +
                      (or_plane ? ". Or one of the plane: .svg, .json" : ""))
      ->required();
  command
      .add_option("--colliders", colliders,
                  "What the meshes of a file without colliders of its own become: their triangles (the default), their "
                  "convex hull, a tight box, a bounding sphere")
      ->check(CLI::IsMember({"hull", "mesh", "box", "sphere"}));
}

io::LoadOptions SceneOptions::load_options(bool animations, bool physics_only) const {
  io::LoadOptions options;
  options.animations = animations;
  options.physics_only = physics_only;
  options.chosen = !colliders.empty();
  if (colliders == "hull") options.mesh_colliders = io::MeshColliders::hull;
  if (colliders == "box") options.mesh_colliders = io::MeshColliders::box;
  if (colliders == "sphere") options.mesh_colliders = io::MeshColliders::sphere;
  return options;
}

io::Scene SceneOptions::load(bool animations, bool physics_only) const {
  const io::LoadOptions options = load_options(animations, physics_only);
  const Progress progress("reading");
  io::Scene scene;
  for (const std::string& file : files) io::append(scene, io::load_scene(file, options));
  return scene;
}

bool SceneOptions::is_in_plane() const {
  if (std::none_of(files.begin(), files.end(), [](const std::string& file) { return io::is_plane_scene(file); }))
    return false;
  if (files.size() > 1) throw InvalidValue("SCENE", "one .svg or .json alone", counted(files.size(), "file"));
  if (!colliders.empty()) throw InvalidValue("--colliders", "a scene in space", "one of the plane");
  return true;
}

}  // namespace graze::cli
