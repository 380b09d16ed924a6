// graze info: the colliders of a scene.
#include <fmt/format.h>

#include <cmath>

#include "commands.hpp"
#include "graze/io/plane_scene.hpp"
#include "graze/shape/mesh_findings.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "shape_words.hpp"

namespace graze::cli {

namespace {

const char* motion_word(io::MotionType type) {
  return type == io::MotionType::fixed ? "static" : type == io::MotionType::kinematic ? "kinematic" : "dynamic";
}

Json mesh_as_json(const Mesh<double>& mesh) {
  const MeshFindings found = findings(mesh);
  return {{"bytes", mesh.memory()},
          {"triangles", found.triangles},
          {"repeatedTriangles", found.repeated_triangles},
          {"withoutArea", found.without_area},
          {"slivers", found.slivers},
          {"repeatedPoints", found.repeated_points},
          {"edges", found.edges()},
          {"flat", found.flat_edges},
          {"convex", found.convex_edges},
          {"concave", found.concave_edges},
          {"open", found.open_edges},
          {"irregular", found.irregular_edges},
          {"tJunctions", found.t_junctions}};
}

/// The collider's mesh, if it is one; the plane has none.
const Mesh<double>* mesh_of(const io::Collider& c) { return c.shape.as<Mesh<double>>(); }
const Mesh<double>* mesh_of(const io::PlaneCollider&) { return nullptr; }

Json as_json(const Vec3d& v) { return json_of(v); }
Json as_json(const Quatd& q) { return {q.x, q.y, q.z, q.w}; }
Json as_json(const plane::Vec2d& v) { return {v.x + 0.0, v.y + 0.0}; }
/// The angle of a rotation, counter-clockwise, as the protocol has it.
Json as_json(const plane::Rot2d& r) { return std::atan2(r.sine, r.cosine); }

template <class AnyScene, class AnyCollider>
Json collider_as_json(const AnyScene& scene, const AnyCollider& c) {
  const auto box = bounds(c.shape, c.pose);
  Json out{{"name", c.name},
           {"body", scene.bodies[c.body].name},
           {"motion", motion_word(scene.bodies[c.body].type)},
           {"trigger", c.trigger},
           {"shape", told(c.shape)},
           {"translation", as_json(c.pose.translation)},
           {"rotation", as_json(c.pose.rotation)},
           {"lower", as_json(box.lower)},
           {"upper", as_json(box.upper)},
           {"category", c.filter.category},
           {"mask", c.filter.mask}};
  if (const Mesh<double>* mesh = mesh_of(c)) out["mesh"] = mesh_as_json(*mesh);
  return out;
}

template <class AnyScene>
void print_colliders_as_json(const AnyScene& scene) {
  Json colliders = Json::array();
  for (const auto& c : scene.colliders) colliders.push_back(collider_as_json(scene, c));
  const Json whole{{"scene", scene.source},
                   {"colliders", colliders},
                   {"collisionSystems", scene.collision_systems},
                   {"notices", scene.notices}};
  print(whole);
}

/// A mesh's edges in words, and all findings that a modeller would not wish.
std::string counts_told(const MeshFindings& found) {
  std::string out = fmt::format("{}: {} flat, {} convex, {} concave, {} open", counted(found.edges(), "edge"),
                                found.flat_edges, found.convex_edges, found.concave_edges, found.open_edges);
  const auto add = [&](std::size_t count, const std::string& noun) {
    if (count != 0) out += fmt::format("; {}", counted(count, noun));
  };
  add(found.irregular_edges, "irregular edge");
  add(found.t_junctions, "T-junction");
  add(found.slivers, "sliver");
  add(found.without_area, "degenerate triangle");
  add(found.repeated_triangles, "repeated triangle");
  add(found.repeated_points, "repeated point");
  return out;
}

template <class AnyScene>
void print_meshes(const AnyScene& scene, std::size_t name) {
  bool first = true;
  for (const auto& c : scene.colliders) {
    const Mesh<double>* mesh = mesh_of(c);
    if (mesh == nullptr) continue;
    if (first) fmt::print("\nmeshes\n");
    first = false;
    fmt::print("{:<{}}  {}\n", c.name, name, counts_told(findings(*mesh)));
  }
}

std::string place_told(const Vec3d& t) { return fmt::format("{:.4g} {:.4g} {:.4g}", t.x, t.y, t.z); }
std::string place_told(const plane::Vec2d& t) { return fmt::format("{:.4g} {:.4g}", t.x, t.y); }

template <class AnyScene>
void print_colliders_as_table(const AnyScene& scene) {
  print_notes(scene.notices);
  fmt::print("{}: {} in {}\n\n", scene.source, counted(scene.colliders.size(), "collider"),
             counted(scene.bodies.size(), "body"));
  std::size_t name = 4, body = 4, shape = 5;
  for (const auto& c : scene.colliders) {
    name = std::max(name, c.name.size());
    body = std::max(body, scene.bodies[c.body].name.size());
    shape = std::max(shape, told(c.shape).size());
  }
  fmt::print("{:<{}}  {:<{}}  {:<9}  {:<{}}  {}\n", "name", name, "body", body, "motion", "shape", shape, "at");
  for (const auto& c : scene.colliders) {
    fmt::print("{:<{}}  {:<{}}  {:<9}  {:<{}}  {}{}\n", c.name, name, scene.bodies[c.body].name, body,
               motion_word(scene.bodies[c.body].type), told(c.shape), shape, place_told(c.pose.translation),
               c.trigger ? "  (trigger)" : "");
  }
  print_meshes(scene, name);
}

}  // namespace

Run add_info(CLI::App& app) {
  struct Options {
    SceneOptions scene;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("info", "List the colliders of a scene");
  options->scene.add_to(*command);
  command->add_flag("--json", options->json, "Print as JSON");
  command->footer("Examples:\n  graze info scene.glb\n  graze info examples/scenes/plane.svg");
  return [options] {
    const auto tell = [&](const auto& scene) {
      options->json ? print_colliders_as_json(scene) : print_colliders_as_table(scene);
    };
    options->scene.is_in_plane() ? tell(io::load_plane_scene(options->scene.files[0])) : tell(options->scene.load());
    return 0;
  };
}

}  // namespace graze::cli
