// graze collide: the contacts of a scene.
#include <fmt/format.h>

#include "checked.hpp"
#include "collide_frames.hpp"
#include "commands.hpp"
#include "graze/io/collide.hpp"
#include "graze/io/file.hpp"
#include "graze/io/picture.hpp"
#include "graze/io/plane_scene.hpp"
#include "graze/io/scene_writer.hpp"
#include "graze/io/solid.hpp"
#include "output.hpp"
#include "pair_json.hpp"
#include "progress.hpp"
#include "scene_options.hpp"

namespace graze::cli {

namespace {

struct CollideArguments {
  SceneOptions scene;
  FramesOptions frames;
  bool json = false, solid = false;
  std::optional<double> margin;
  std::string points;
  std::string precision = "double", out, svg;
  std::vector<double> direction{1, 0.7, 1.2};
};

/// A vector with as many coordinates as the scene has.
Json vector_of(const io::Scene&, const Vec3d& v) { return json_of(v); }
Json vector_of(const io::PlaneScene&, const Vec3d& v) { return {v.x, v.y}; }
std::string words_of(const io::Scene&, const Vec3d& v) { return shown(v, 7); }
std::string words_of(const io::PlaneScene&, const Vec3d& v) {
  return fmt::format("{:7.4f} {:7.4f}", v.x + 0.0, v.y + 0.0);
}

template <class AnyScene>
void print_pairs_as_json(const AnyScene& scene, const std::vector<io::TouchingPair>& pairs) {
  Json out = Json::array();
  for (const io::TouchingPair& pair : pairs) {
    Json told{{"a", scene.colliders[pair.a].name},
              {"b", scene.colliders[pair.b].name},
              {"colliderA", pair.a},
              {"colliderB", pair.b}};
    told.update(json_of_touch(pair, [&](const Vec3d& v) { return vector_of(scene, v); }));
    out.push_back(std::move(told));
  }
  const Json whole{
      {"scene", scene.source}, {"colliders", scene.colliders.size()}, {"pairs", out}, {"notices", scene.notices}};
  print(whole);
}

template <class AnyScene>
void print_pairs_as_table(const AnyScene& scene, const std::vector<io::TouchingPair>& pairs) {
  print_notes(scene.notices);
  fmt::print("{}: {} in {}, {} in contact\n", scene.source, counted(scene.colliders.size(), "collider"),
             counted(scene.bodies.size(), "body"), counted(io::count_in_contact(pairs), "pair"));
  if (pairs.empty()) return;
  std::size_t a = 1, b = 1;
  for (const io::TouchingPair& p : pairs) {
    a = std::max(a, scene.colliders[p.a].name.size());
    b = std::max(b, scene.colliders[p.b].name.size());
  }
  fmt::print("\n{:<{}}  {:<{}}  {:<23}  {:>24}  {:>6}\n", "A", a, "B", b, "", "normal from A to B", "points");
  for (const io::TouchingPair& p : pairs) {
    const double d = p.manifolds.empty() ? 0 : p.distance();
    const std::string state = p.trigger         ? (p.overlap ? "in trigger" : "near trigger")
                              : !p.in_contact() ? "overlap without contact"
                                                : fmt::format("{} {:.6g}", p.overlap ? "depth" : "gap", std::abs(d));
    const std::string normal = words_of(scene, p.normal());
    fmt::print("{:<{}}  {:<{}}  {:<23}  {:>24}  {:>6}\n", scene.colliders[p.a].name, a, scene.colliders[p.b].name, b,
               state, normal, p.point_count());
  }
}

template <class AnyScene>
std::vector<io::TouchingPair> touching_pairs(const AnyScene& scene, io::CollideOptions how) {
  Progress progress("colliding");
  how.progress = std::ref(progress);
  return io::collide(scene, how);
}

/// Whether the scene is one of the plane, which is one file.
bool is_in_plane(const CollideArguments& options) {
  std::size_t count = 0;
  for (const std::string& file : options.scene.files) count += io::is_plane_scene(file);
  if (count == 0) return false;
  if (options.scene.files.size() > 1)
    throw InvalidValue("SCENE", "one .svg or .json alone", counted(options.scene.files.size(), "file"));
  const char* other = options.frames.frames              ? "--frames"
                      : options.solid                    ? "--solid"
                      : !options.out.empty()             ? "--out"
                      : !options.scene.colliders.empty() ? "--colliders"
                                                         : nullptr;
  if (other) throw InvalidValue(other, "a scene in space", "one of the plane");
  return true;
}

int run_in_plane(const CollideArguments& options, const io::CollideOptions& how) {
  const io::PlaneScene scene = io::load_plane_scene(options.scene.files[0]);
  const std::vector<io::TouchingPair> pairs = touching_pairs(scene, how);
  options.json ? print_pairs_as_json(scene, pairs) : print_pairs_as_table(scene, pairs);
  if (!options.svg.empty()) io::write_file(options.svg, io::draw_picture(scene, pairs));
  return 0;
}

int run_collide(const CollideArguments& options) {
  io::CollideOptions how;
  how.precision = precision_of(options.precision);
  how.margin = checked_length("--margin", options.margin.value_or(0), how.precision);
  if (!options.points.empty()) how.points_per_pair = checked_count("--points", options.points);
  const Vec3d direction = checked_direction(options.direction);
  check_ending("--svg", options.svg, ".svg");
  check_ending("--out", options.out, ".glb");
  check_output("--svg", options.svg, options.scene.files);
  check_output("--out", options.out, options.scene.files);
  if (is_in_plane(options)) return run_in_plane(options, how);
  if (options.frames.frames) {
    io::Scene scene = options.scene.load(true);
    if (options.solid) io::make_solid(scene);
    print_frames(scene, options.frames, options.margin, how.precision, options.json);
    return 0;
  }
  io::Scene scene = options.scene.load();
  if (options.solid) io::make_solid(scene);
  const std::vector<io::TouchingPair> pairs = touching_pairs(scene, how);
  for (std::string& sentence : io::unseen_inside(scene)) scene.notices.push_back(std::move(sentence));
  options.json ? print_pairs_as_json(scene, pairs) : print_pairs_as_table(scene, pairs);
  const Progress progress("drawing");
  if (!options.svg.empty()) io::write_picture(options.svg, scene, pairs, direction);
  if (!options.out.empty()) print_notes(io::write_contacts(options.out, scene, pairs, options.scene.only_file()));
  return 0;
}

}  // namespace

Run add_collide(CLI::App& app) {
  auto options = std::make_shared<CollideArguments>();
  CLI::App* command = app.add_subcommand("collide", "Find the contacts of a scene");
  options->scene.add_to(*command);
  CLI::Option* frames = options->frames.add_to(*command);
  command->add_flag("--json", options->json, "Print all manifolds, or all events and frames, as JSON");
  command
      ->add_option("--margin", options->margin,
                   "Also report what is up to this far apart; with --frames, what touched goes on until it is further "
                   "apart, by default by a small part of its size")
      ->default_str("0");
  command->add_flag("--solid", options->solid,
                    "Closed meshes are solid: what lies wholly inside them touches. A mesh that is not closed stays a "
                    "surface, and a note says so");
  command
      ->add_option("--points", options->points,
                   "At most so many points of contact a pair: the deepest, and those that span most; by default all")
      ->excludes(frames);
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_option("--out", options->out, "Write the scene with the contacts drawn into it (.glb)")
      ->excludes(frames);
  command->add_option("--svg", options->svg, "Draw a picture of the scene and its contacts (.svg)")->excludes(frames);
  command->add_option("--direction", options->direction, "Where the picture is seen from: x,y,z")
      ->delimiter(',')
      ->expected(3)
      ->capture_default_str();
  command->footer("Pairs of one body and pairs that collision filters forbid are left out; where anything can move, so "
                  "are pairs of\n"
                  "which neither can. Exit code: 0, or 2 when a file or an option cannot be used.\n\n"
                  "A scene of the plane is an SVG (rect, circle, ellipse, line, polyline, polygon, path; class static, "
                  "kinematic,\n"
                  "dynamic, trigger; data-body, data-systems, data-collide-with and more) or JSON with \"dimension\": "
                  "2 and bodies\n"
                  "in the protocol's shapes; docs/plane.md has both. Y points up: a drawing's (x, y) is (x, -y).\n\n"
                  "--frames plays an animation of glTF: nodes that its channels move take their colliders along. Each "
                  "frame is\n"
                  "looked at by itself: what flies through something between two frames is not seen (try more --fps, "
                  "or graze cast).\n\n"
                  "Examples:\n  graze collide scene.glb --margin 0.01 --svg contacts.svg --out contacts.glb\n"
                  "  graze collide examples/scenes/plane.svg --svg contacts.svg\n"
                  "  graze collide scene.glb --frames --fps 60 --animation walk --json");
  return [options] { return run_collide(*options); };
}

}  // namespace graze::cli
