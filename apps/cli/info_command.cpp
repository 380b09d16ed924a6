// graze info: the colliders of a scene.
#include <fmt/format.h>

#include "commands.hpp"
#include "output.hpp"
#include "scene_options.hpp"

namespace graze::cli {

namespace {

const char* motion_word(io::MotionType type) {
  return type == io::MotionType::fixed ? "static" : type == io::MotionType::kinematic ? "kinematic" : "dynamic";
}

void print_colliders_as_json(const io::Scene& scene) {
  Json colliders = Json::array();
  for (const io::Collider& c : scene.colliders) {
    const Aabbd box = bounds(c.shape, c.pose);
    const Quatd& q = c.pose.rotation;
    colliders.push_back({{"name", c.name},
                         {"body", scene.bodies[c.body].name},
                         {"motion", motion_word(scene.bodies[c.body].type)},
                         {"trigger", c.trigger},
                         {"shape", told(c.shape)},
                         {"translation", json_of(c.pose.translation)},
                         {"rotation", {q.x, q.y, q.z, q.w}},
                         {"lower", json_of(box.lower)},
                         {"upper", json_of(box.upper)},
                         {"category", c.filter.category},
                         {"mask", c.filter.mask}});
  }
  const Json whole{{"scene", scene.source},
                   {"colliders", colliders},
                   {"collisionSystems", scene.collision_systems},
                   {"notices", scene.notices}};
  print(whole);
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
