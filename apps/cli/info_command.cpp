// graze info: the colliders of a scene.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "scene_options.hpp"

namespace graze::cli {

namespace {

using Json = nlohmann::ordered_json;

const char* word(io::MotionType type) {
  return type == io::MotionType::fixed ? "static" : type == io::MotionType::kinematic ? "kinematic" : "dynamic";
}

Json array(const Vec3d& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

void print_json(const io::Scene& scene) {
  Json colliders = Json::array();
  for (const io::Collider& c : scene.colliders) {
    const Aabbd box = bounds(c.shape, c.pose);
    const Quatd& q = c.pose.rotation;
    colliders.push_back({{"name", c.name},
                         {"body", scene.bodies[c.body].name},
                         {"motion", word(scene.bodies[c.body].type)},
                         {"trigger", c.trigger},
                         {"shape", told(c.shape)},
                         {"translation", array(c.pose.translation)},
                         {"rotation", {q.x, q.y, q.z, q.w}},
                         {"lower", array(box.lower)},
                         {"upper", array(box.upper)},
                         {"category", c.filter.category},
                         {"mask", c.filter.mask}});
  }
  const Json whole{{"scene", scene.source},
                   {"colliders", colliders},
                   {"collisionSystems", scene.collision_systems},
                   {"notices", scene.notices}};
  fmt::print("{}\n", whole.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_table(const io::Scene& scene) {
  for (const std::string& notice : scene.notices) fmt::print(stderr, "note: {}\n", notice);
  fmt::print("{}: {} colliders in {} bodies\n\n", scene.source, scene.colliders.size(), scene.bodies.size());
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
               word(scene.bodies[c.body].type), told(c.shape), shape, t.x, t.y, t.z, c.trigger ? "  (trigger)" : "");
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
    options->json ? print_json(scene) : print_table(scene);
    return 0;
  };
}

}  // namespace graze::cli
