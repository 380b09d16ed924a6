// graze simulate: a scene played.
#include <fmt/format.h>

#include <chrono>
#include <memory>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "graze/io/plane_simulate.hpp"
#include "graze/io/simulate.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scene_options.hpp"
#include "simulate_picture.hpp"
#include "simulate_summary.hpp"
#include "thread_executor.hpp"

namespace graze::cli {

namespace {

struct SimulateArguments {
  SceneOptions scene;
  double seconds = 10, rate = 60;
  std::vector<double> gravity;  ///< empty where it is not given
  int threads = 1, sub_steps = 4;
  std::string precision = "double", out, svg, report = "text";
};

/// The values of `io::SimulateOptions` and of a simulation that options hold.
constexpr std::pair<const char*, const char*> options_of_values[] = {
    {"seconds", "--seconds"},         {"rate", "--rate"},      {"dt", "--rate"}, {"sub_steps", "--substeps"},
    {"most_sub_steps", "--substeps"}, {"gravity", "--gravity"}};

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  names.reserve(list.size());
  for (const Named& one : list) names.push_back(one.name);
  return names;
}

/// Plays a scene into a file, if there is one, and prints the summary.
template <class Frame, class AnyScene, class AnyRecording>
void play(AnyScene& scene, const SimulateArguments& options, const io::SimulateOptions& how, AnyRecording& recording,
          Frame& last) {
  const std::size_t frames = io::frame_count(how);
  if (io::moving_bodies(scene).empty()) scene.notices.emplace_back("no body of the scene has a motion: nothing moves");
  const auto begin = std::chrono::steady_clock::now();
  Progress progress("simulating");
  std::size_t done = 0;
  const io::SimulateSummary summary = io::simulate(scene, how, [&](const Frame& frame) {
    if (recording) recording->add(frame);
    if (done + 1 == frames) last = frame;
    progress(++done, frames);
  });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  progress.now("writing");
  if (recording) recording->close();
  if constexpr (requires { recording->notices(); })
    if (recording)
      for (std::string& text : recording->notices()) scene.notices.push_back(std::move(text));
  scene.notices.insert(scene.notices.end(), summary.notices.begin(), summary.notices.end());
  const SummaryOf of{scene.source,           scene.notices, names_of(scene.colliders),
                     names_of(scene.bodies), options.rate,  took.count()};
  options.report == "json" ? print_as_json(of, summary) : print_as_text(of, summary);
}

void run_in_plane(const SimulateArguments& options, io::SimulateOptions& how) {
  io::PlaneScene scene = io::load_plane_scene(options.scene.files[0]);
  if (options.gravity.empty() && scene.gravity) how.gravity = {scene.gravity->x, scene.gravity->y, 0};
  std::unique_ptr<io::PlaneRecording> recording;
  if (!options.out.empty()) recording = io::record(options.out, scene, how.precision);
  io::PlaneSimulationFrame last;
  play(scene, options, how, recording, last);
  if (!options.svg.empty()) write_pictures(options.svg, scene, last);
}

void run_in_space(const SimulateArguments& options, const io::SimulateOptions& how) {
  io::Scene scene = options.scene.load(true, true);
  std::unique_ptr<io::Recording> recording;
  if (!options.out.empty()) recording = io::record(options.out, scene, options.scene.only_file(), how.precision);
  io::SimulationFrame last;
  play(scene, options, how, recording, last);
  if (!options.svg.empty()) write_pictures(options.svg, scene, last);
}

int run_simulate(const SimulateArguments& options) {
  io::SimulateOptions how;
  how.seconds = options.seconds;
  how.rate = options.rate;
  if (!options.gravity.empty()) how.gravity = {options.gravity[0], options.gravity[1], options.gravity[2]};
  how.sub_steps = options.sub_steps;
  how.precision = precision_of(options.precision);
  if (options.threads < 1 || options.threads > 1024)
    throw InvalidValue("--threads", "a number from 1 to 1024", std::to_string(options.threads));
  validate::point(how.gravity, "--gravity");
  check_ending("--svg", options.svg, ".svg");
  check_output("--svg", options.svg, options.scene.files);
  check_output("--out", options.out, options.scene.files);
  ThreadExecutor executor(static_cast<std::size_t>(options.threads));
  how.executor = &executor;
  try {
    io::frame_count(how);  // refused before anything is read
    if (options.scene.is_in_plane())
      run_in_plane(options, how);
    else
      run_in_space(options, how);
  } catch (const InvalidValue& e) {
    throw_renamed(e, options_of_values);
  }
  return 0;
}

}  // namespace

Run add_simulate(CLI::App& app) {
  auto options = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "Play a scene: its bodies fall, collide and rest");
  options->scene.add_to(*command);
  command->add_option("--seconds", options->seconds, "How long to play")->capture_default_str();
  command->add_option("--rate", options->rate, "Steps, and frames of the output, a second")->capture_default_str();
  command->add_option("--gravity", options->gravity, "The acceleration of free fall: x,y,z; of the plane x and y count")
      ->delimiter(',')
      ->expected(3)
      ->default_str("0,-9.81,0");
  command->add_option("--threads", options->threads, "Threads; the result is the same")->capture_default_str();
  command
      ->add_option("--substeps", options->sub_steps,
                   "Sub-steps of a step, a power of two; where much weight rests on little, more are taken")
      ->capture_default_str();
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_option(
      "--out", options->out,
      "Write the motion: the scene with an animation (.gltf, .glb; .svg of the plane), or a line a frame "
      "(.jsonl)");
  command->add_option("--svg", options->svg, "Draw a picture of the scene before and after (.svg)");
  command->add_option("--report", options->report, "How to print the summary")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  command->footer("Motions, materials, joints and filters are those of KHR_physics_rigid_bodies; a node that the "
                  "file's animation moves\n"
                  "follows it. Exit code: 0, or 2 when a file or an option cannot be used.\n\n"
                  "A scene of the plane is an SVG or JSON, as of graze collide, with masses, velocities and materials "
                  "of its own;\ndocs/plane.md has them.\n\n"
                  "Examples:\n  graze simulate scene.gltf --seconds 20 --out moved.glb\n"
                  "  graze simulate examples/scenes/plane.svg --seconds 5 --out moved.svg --svg after.svg");
  return [options] { return run_simulate(*options); };
}

}  // namespace graze::cli
