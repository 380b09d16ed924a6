// graze info: the colliders of a scene.
#include <fmt/format.h>

#include "commands.hpp"
#include "graze/shape/mesh_findings.hpp"
#include "output.hpp"
#include "scene_options.hpp"

namespace graze::cli {

namespace {

const char* motion_word(io::MotionType type) {
  return type == io::MotionType::fixed ? "static" : type == io::MotionType::kinematic ? "kinematic" : "dynamic";
}

Json counts_of(const MeshFindings& found) {
  return {{"triangles", found.triangles},
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

Json collider_as_json(const io::Scene& scene, const io::Collider& c) {
  const Aabbd box = bounds(c.shape, c.pose);
  const Quatd& q = c.pose.rotation;
  Json out{{"name", c.name},
           {"body", scene.bodies[c.body].name},
           {"motion", motion_word(scene.bodies[c.body].type)},
           {"trigger", c.trigger},
           {"shape", told(c.shape)},
           {"translation", json_of(c.pose.translation)},
           {"rotation", {q.x, q.y, q.z, q.w}},
           {"lower", json_of(box.lower)},
           {"upper", json_of(box.upper)},
           {"category", c.filter.category},
           {"mask", c.filter.mask}};
  if (const auto* mesh = c.shape.as<Mesh<double>>()) out["mesh"] = counts_of(findings(*mesh));
  return out;
}

void print_colliders_as_json(const io::Scene& scene) {
  Json colliders = Json::array();
  for (const io::Collider& c : scene.colliders) colliders.push_back(collider_as_json(scene, c));
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

void print_meshes(const io::Scene& scene, std::size_t name) {
  bool first = true;
  for (const io::Collider& c : scene.colliders) {
    const auto* mesh = c.shape.as<Mesh<double>>();
    if (mesh == nullptr) continue;
    if (first) fmt::print("\nmeshes\n");
    first = false;
    fmt::print("{:<{}}  {}\n", c.name, name, counts_told(findings(*mesh)));
  }
}

void print_colliders_as_table(const io::Scene& scene) {
  print_notes(scene.notices);
  fmt::print("{}: {} in {}\n\n", scene.source, counted(scene.colliders.size(), "collider"),
             counted(scene.bodies.size(), "body"));
  std::size_t name = 4, body = 4, shape = 5;
  for (const io::Collider& c : scene.colliders) {
    name = std::max(name, c.name.size());
    body = std::max(body, scene.bodies[c.body].name.size());
    shape = std::max(shape, told(c.shape).size());
  }
  fmt::print("{:<{}}  {:<{}}  {:<9}  {:<{}}  {}\n", "name", name, "body", body, "motion", "shape", shape, "at");
  for (const io::Collider& c : scene.colliders) {
    const Vec3d& t = c.pose.translation;
    fmt::print("{:<{}}  {:<{}}  {:<9}  {:<{}}  {:.4g} {:.4g} {:.4g}{}\n", c.name, name, scene.bodies[c.body].name, body,
               motion_word(scene.bodies[c.body].type), told(c.shape), shape, t.x, t.y, t.z,
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
  command->footer("Example:\n  graze info scene.glb");
  return [options] {
    const io::Scene scene = options->scene.load();
    options->json ? print_colliders_as_json(scene) : print_colliders_as_table(scene);
    return 0;
  };
}

}  // namespace graze::cli
