#include "scene_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/error.hpp"
#include "graze/io/plane_scene.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace graze::cli {

void SceneOptions::add_to(CLI::App& command) {
  command.add_option("SCENE", files, "Scenes: .gltf, .glb, .obj, .stl, .ply; several are put together at the origin")
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

namespace {

std::string words(const Sphere<double>& s) { return fmt::format("radius {:.6g}", s.radius()); }
std::string words(const Capsule<double>& c) {
  return fmt::format("height {:.6g}, radii {:.6g} and {:.6g}", 2 * c.half_height(), c.radius_bottom(), c.radius_top());
}
std::string words(const Cylinder<double>& c) {
  return fmt::format("height {:.6g}, radii {:.6g} and {:.6g}", 2 * c.half_height(), c.radius_bottom(), c.radius_top());
}
std::string words(const Box<double>& b) {
  const Vec3d s = b.half_extents() * 2.0;
  return fmt::format("{:.6g} x {:.6g} x {:.6g}", s.x, s.y, s.z);
}
std::string words(const Rectangle<double>& r) {
  const Vec3d s = r.as_box().half_extents() * 2.0;
  return fmt::format("{:.6g} x {:.6g}", s.x, s.z);
}
std::string words(const Ellipsoid<double>& e) {
  return fmt::format("radii {:.6g}, {:.6g}, {:.6g}", e.radii().x, e.radii().y, e.radii().z);
}
std::string words(const ConvexHull<double>& h) {
  return fmt::format("{} vertices, {} faces", h.data().vertices.size(), h.data().planes.size());
}
std::string words(const Mesh<double>& m) { return counted(m.triangles().size(), "triangle"); }
std::string words(const HeightField<double>& f) { return fmt::format("{} x {} heights", f.columns(), f.rows()); }
std::string words(const Compound<double>& c) {
  return c.children().size() == 1 ? "of one " + told(c.children()[0].shape)
                                  : fmt::format("{} children", c.children().size());
}
template <class C>
std::string words(const C&) {
  return "";
}

}  // namespace

std::string told(const Shaped& shape) {
  const std::string detail = shape.visit([](const auto& c) { return words(c); });
  return detail.empty() ? shape.name() : fmt::format("{} ({})", shape.name(), detail);
}

}  // namespace graze::cli
