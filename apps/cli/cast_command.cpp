// graze cast: one body of a scene moved through the rest.
#include <fmt/format.h>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/io/cast_scene.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scene_options.hpp"

namespace graze::cli {

namespace {

struct CastArguments {
  SceneOptions scene;
  std::string from, precision = "double", out;
  std::vector<double> motion{0, 0, 0}, spin{0, 0, 0}, about;
  double duration = 1;
  bool slide = false, all = false, json = false;
};

Vec3d vector_of(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

template <class AnyScene>
Json json_of_hit(const AnyScene& scene, const io::SceneHit& hit) {
  return {{"t", hit.t},
          {"collider", scene.colliders[hit.collider].name},
          {"hits", scene.colliders[hit.other].name},
          {"colliderA", hit.collider},
          {"colliderB", hit.other},
          {"point", json_of(hit.point)},
          {"normal", json_of(hit.normal)},
          {"depth", hit.depth},
          {"certain", hit.status != Status::bounded}};
}

template <class AnyScene>
void print_hits_as_json(const AnyScene& scene, const io::SceneCast& question, const std::vector<io::SceneHit>& hits) {
  Json list = Json::array();
  for (const io::SceneHit& hit : hits) list.push_back(json_of_hit(scene, hit));
  const Json whole{{"scene", scene.source}, {"from", question.from}, {"duration", question.duration},
                   {"hit", !hits.empty()},  {"hits", list},          {"notices", scene.notices}};
  print(whole);
}

template <class AnyScene>
void print_hits_as_table(const AnyScene& scene, const io::SceneCast& question, const std::vector<io::SceneHit>& hits) {
  print_notes(scene.notices);
  if (hits.empty()) {
    fmt::print("{}: {} hits nothing in {:.6g}\n", scene.source, question.from, question.duration);
    return;
  }
  const io::SceneHit& first = hits.front();
  fmt::print("{}: {} hits {} at {:.6g}\n\n", scene.source, question.from, scene.colliders[first.other].name, first.t);
  std::size_t width = 4;
  for (const io::SceneHit& hit : hits) width = std::max(width, scene.colliders[hit.other].name.size());
  fmt::print("{:>12}  {:<{}}  {:>29}  {:>29}  {:>10}\n", "time", "hits", width, "point", "normal towards it", "depth");
  for (const io::SceneHit& hit : hits)
    fmt::print("{:>12.9g}  {:<{}}  {}  {}  {:>10.4g}{}\n", hit.t, scene.colliders[hit.other].name, width,
               shown(hit.point, 9), shown(hit.normal, 9), hit.depth,
               hit.status != Status::bounded ? "" : "  (not certain: may only come near)");
}

template <class AnyScene>
std::vector<io::SceneHit> hits_of(const AnyScene& scene, const io::SceneCast& question) {
  static constexpr std::pair<const char*, const char*> options_of_values[] = {
      {"motion", "--motion"}, {"spin", "--spin"}, {"about", "--about"}, {"from", "--from"}};
  const Progress progress("casting");
  try {
    return io::cast_scene(scene, question);
  } catch (const InvalidValue& e) {
    throw_renamed(e, options_of_values);
  }
}

int run_cast(const CastArguments& options) {
  check_ending("--out", options.out, ".glb");
  check_output("--out", options.out, options.scene.files);
  const io::Precision precision = precision_of(options.precision);
  io::SceneCast question;
  question.from = options.from;
  question.velocity = {vector_of(options.motion), vector_of(options.spin)};
  question.duration = checked_length("--duration", options.duration, precision);
  if (!options.about.empty()) question.about = vector_of(options.about);
  question.options.separating = options.slide ? Separating::ignored : Separating::hit;
  question.precision = precision;
  const auto tell = [&](const auto& scene, std::vector<io::SceneHit> hits) {
    if (!options.all && hits.size() > 1) hits.resize(1);
    options.json ? print_hits_as_json(scene, question, hits) : print_hits_as_table(scene, question, hits);
  };
  if (options.scene.is_in_plane()) {
    if (!options.out.empty()) throw InvalidValue("--out", "a scene in space", "one of the plane");
    const io::PlaneScene scene = io::load_plane_scene(options.scene.files[0]);
    tell(scene, hits_of(scene, question));
    return 0;
  }
  const io::Scene scene = options.scene.load();
  const std::vector<io::SceneHit> hits = hits_of(scene, question);
  if (!options.out.empty()) print_notes(io::write_cast(options.out, scene, question, hits, options.scene.only_file()));
  tell(scene, hits);
  return 0;
}

CLI::Option* add_vector(CLI::App& command, const char* name, std::vector<double>& value, const char* what) {
  return command.add_option(name, value, what)->delimiter(',')->expected(3);
}

}  // namespace

Run add_cast(CLI::App& app) {
  auto options = std::make_shared<CastArguments>();
  CLI::App* command = app.add_subcommand("cast", "Move one body of a scene and find what it hits first");
  options->scene.add_to(*command);
  command->add_option("--from", options->from, "The body that moves, or one collider, by name")->required();
  add_vector(*command, "--motion", options->motion, "How far it moves a unit of time: x,y,z")->capture_default_str();
  add_vector(*command, "--spin", options->spin, "How it turns a unit of time: the axis times radians, x,y,z")
      ->capture_default_str();
  add_vector(*command, "--about", options->about, "The point it turns about (default: its first collider's origin)");
  command->add_option("--duration", options->duration, "For how long")->capture_default_str();
  command->add_flag("--slide", options->slide, "What it touches and leaves or slides along does not count");
  command->add_flag("--all", options->all, "List everything on its way, not only what is hit first");
  command->add_flag("--json", options->json, "Print as JSON");
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_option("--out", options->out,
                      "Write the scene with the way, the impact and the contact drawn in (.glb)");
  command->footer(
      "Everything else stands still. Triggers and what collision filters forbid are not hit. Exit code: 0, "
      "or 2 when a\n"
      "file cannot be read or the name is not that of one body. In the plane motions have z = 0, spins z alone.\n\n"
      "Examples:\n"
      "  graze cast scene.glb --from \"crate 1\" --motion 8,0,0 --spin 0,3,0 --slide --out cast.glb\n"
      "  graze cast examples/scenes/plane.svg --from ball --motion 300,0,0 --spin 0,0,2");
  return [options] { return run_cast(*options); };
}

}  // namespace graze::cli
