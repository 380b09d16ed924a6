#include "collide_frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "graze/error.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace graze::cli {

namespace {

struct Event {
  double time;
  io::FrameEvent what;
};

/// All events and pairs of the frames.
struct Record {
  std::vector<Event> events;
  std::vector<std::size_t> pairs;  ///< of each frame
  std::vector<double> times;
};

Record play(const io::Scene& scene, const io::FrameOptions& options) {
  Record record;
  Progress progress("colliding");
  io::collide_frames(scene, options, [&](const io::Frame& f) {
    for (const io::FrameEvent& e : f.events) record.events.push_back({f.time, e});
    record.pairs.push_back(f.pairs);
    record.times.push_back(f.time);
    progress(f.index + 1, f.count);
  });
  return record;
}

void print_events_as_json(const io::Scene& scene, const io::FrameOptions& options, const Record& record) {
  Json events = Json::array(), frames = Json::array();
  for (const auto& [time, e] : record.events)
    events.push_back({{"t", time},
                      {"kind", e.begin ? "begin" : "end"},
                      {"a", scene.colliders[e.a].name},
                      {"b", scene.colliders[e.b].name},
                      {"colliderA", e.a},
                      {"colliderB", e.b},
                      {"trigger", e.trigger},
                      {"depth", e.depth ? Json(*e.depth) : Json(nullptr)}});
  for (std::size_t i = 0; i < record.pairs.size(); ++i)
    frames.push_back({{"t", record.times[i]}, {"pairs", record.pairs[i]}});
  const io::Animation& animation = scene.animations[options.animation];
  const Json whole{
      {"scene", scene.source},
      {"colliders", scene.colliders.size()},
      {"animation", {{"index", options.animation}, {"name", animation.name}, {"duration", animation.duration}}},
      {"fps", options.fps},
      {"moved", io::animated_colliders(scene, options.animation)},
      {"events", events},
      {"frames", frames},
      {"notices", scene.notices}};
  print(whole);
}

void print_events_as_table(const io::Scene& scene, const io::FrameOptions& options, const Record& record) {
  const std::size_t moved = io::animated_colliders(scene, options.animation).size();
  print_notes(scene.notices);
  if (moved == 0) print_notes({"the animation moves no collider"});
  fmt::print("{}: {} of {} {} in \"{}\", {} to {:.6g} s, {}\n", scene.source, moved,
             counted(scene.colliders.size(), "collider"), moved == 1 ? "moves" : "move",
             scene.animations[options.animation].name, counted(record.times.size(), "frame"), record.times.back(),
             counted(record.events.size(), "event"));
  if (record.events.empty()) return;
  std::size_t a = 1, b = 1;
  for (const auto& [time, e] : record.events) {
    a = std::max(a, scene.colliders[e.a].name.size());
    b = std::max(b, scene.colliders[e.b].name.size());
  }
  fmt::print("\n{:>10}  {:<5}  {:<{}}  {:<{}}  {}\n", "time", "event", "A", a, "B", b, "depth");
  for (const auto& [time, e] : record.events) {
    const std::string depth = e.trigger ? "trigger" : e.depth ? fmt::format("{:.6g}", *e.depth) : "";
    const std::string line = fmt::format("{:>10.4f}  {:<5}  {:<{}}  {:<{}}  {}", time, e.begin ? "begin" : "end",
                                         scene.colliders[e.a].name, a, scene.colliders[e.b].name, b, depth);
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  }
}

}  // namespace

CLI::Option* FramesOptions::add_to(CLI::App& command) {
  CLI::Option* flag = command.add_flag("--frames", frames,
                                       "Play the scene's animation: who begins and ends to touch when, frame by frame");
  command.add_option("--fps", fps, "Frames a second")->capture_default_str()->needs(flag);
  command.add_option("--duration", duration, "Seconds to play; by default to the last keyframe")->needs(flag);
  command.add_option("--animation", animation, "Which animation, by name or index; by default the first")->needs(flag);
  return flag;
}

void print_frames(const io::Scene& scene, const FramesOptions& options, std::optional<double> margin,
                  io::Precision precision, bool json) {
  io::FrameOptions how;
  how.fps = options.fps;
  how.duration = options.duration;
  how.margin = margin;
  how.precision = precision;
  try {
    if (!options.animation.empty()) how.animation = io::find_animation(scene, options.animation);
    io::frame_count(scene, how);
  } catch (const InvalidValue& e) {  // named as it was given
    const bool own = e.path() == "animation" || e.path() == "fps" || e.path() == "duration";
    throw InvalidValue((own ? "--" : "") + e.path(), e.expectation(), e.found());
  }
  const Record record = play(scene, how);
  json ? print_events_as_json(scene, how, record) : print_events_as_table(scene, how, record);
}

}  // namespace graze::cli
