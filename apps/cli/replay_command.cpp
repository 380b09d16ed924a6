// graze replay: a capture run again.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "graze/capture.hpp"
#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "thread_executor.hpp"

namespace graze::cli {

namespace {

struct ReplayArguments {
  std::string file;
  int threads = 1;
  bool json = false;
};

/// A name as JSON has it, between quotes: a file may name its bodies by any bytes, and a terminal obeys some of them.
std::string in_quotes(std::string_view name) {
  return Json(std::string(name)).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void print_as_json(const ReplayReport& report) {
  Json whole{{"of", report.simulation ? "simulation" : "world"},
             {"dimension", report.plane ? 2 : 3},
             {"precision", report.single ? "float" : "double"},
             {"frames", report.frames},
             {"calls", report.calls},
             {"cut", report.cut},
             {"same", !report.difference}};
  if (const auto& d = report.difference) {
    Json& difference = whole["difference"] = {{"frame", d->frame}, {"call", d->call}, {"what", d->what}};
    if (d->body) difference["body"] = d->body->index;
  }
  for (const auto& [id, name] : report.names.all()) whole["names"].push_back({{"body", id.index}, {"name", name}});
  print(whole);
}

/// Prints the names of bodies: "bodies: "floor", "box 1" and 7 more"; nothing where none has a name.
void print_names(const BodyNames& names) {
  constexpr std::size_t most = 8;
  std::string line;
  std::size_t shown = 0;
  for (const auto& [id, name] : names.all()) {
    if (shown == most) break;
    if (shown++ > 0) line += ", ";
    line += in_quotes(name);
  }
  if (shown == 0) return;
  const std::size_t rest = names.all().size() - shown;
  fmt::print("bodies: {}{}\n", line, rest > 0 ? fmt::format(" and {} more", rest) : "");
}

void print_as_text(const std::string& file, const ReplayReport& report) {
  fmt::print("{}: {} of a {}{} in {}, {}\n", file, counted(report.frames, "frame"),
             report.simulation ? "simulation" : "world", report.plane ? " of the plane" : "",
             report.single ? "float" : "double", report.difference ? "then something else" : "the same bits");
  if (const auto& d = report.difference) {
    const std::string_view name = d->body ? report.names.of(*d->body) : std::string_view();
    fmt::print("frame {}, call {}: {}{}\n", d->frame, d->call, d->what, name.empty() ? "" : ", of " + in_quotes(name));
  }
  print_names(report.names);
  if (report.cut) print_notes({fmt::format("{}: ends within a frame, which was left out", file)});
}

int run_replay(const ReplayArguments& options) {
  if (options.threads < 1 || options.threads > 1024)
    throw InvalidValue("--threads", "a number from 1 to 1024", std::to_string(options.threads));
  ThreadExecutor executor(static_cast<std::size_t>(options.threads));
  std::ifstream file = io::open_file(options.file);
  std::optional<Progress> progress("replaying");
  const ReplayReport report = replay(file, options.file, {}, &executor);
  progress.reset();
  if (report.frames == 0 && !report.difference)
    throw InvalidValue(options.file, "a capture of one frame at least", "none that is whole");
  options.json ? print_as_json(report) : print_as_text(options.file, report);
  return report.difference ? 1 : 0;
}

}  // namespace

Run add_replay(CLI::App& app) {
  auto options = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand("replay", "Run a capture again and compare every frame, bit by bit");
  command->add_option("FILE", options->file, "What graze capture or a program wrote")->required();
  command->add_option("--threads", options->threads, "Threads; the result is the same")->capture_default_str();
  command->add_flag("--json", options->json, "Print the report as JSON");
  command->footer(
      "Exit code: 0 when all frames came out the same, 1 when one did not, 2 when the file is no capture, is\n"
      "damaged or has no whole frame.\n\n"
      "Example:\n  graze replay scene.capture");
  return [options] { return run_replay(*options); };
}

}  // namespace graze::cli
