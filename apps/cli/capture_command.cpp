// graze capture: a scene played, and every call of its simulation recorded.
#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

#include "checked.hpp"
#include "commands.hpp"
#include "graze/error.hpp"
#include "graze/io/file.hpp"
#include "graze/io/plane_simulate.hpp"
#include "graze/io/simulate.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scene_options.hpp"

namespace graze::cli {

namespace {

struct CaptureArguments {
  SceneOptions scene;
  double seconds = 10, rate = 60;
  int sub_steps = 4;
  std::string precision = "double", out;
};

/// The file of a capture. What comes before the first frame is held back, so that a scene that cannot be played leaves
/// the file as it was. Its stream and its functions throw `InvalidValue` when it takes no more, with the reason.
class CaptureFile : private std::streambuf {
 public:
  explicit CaptureFile(const std::string& name) : name_(name) {
    io::check_writable(name);
    stream_.exceptions(std::ios::badbit);
  }

  std::ostream& stream() { return stream_; }
  /// Opens the file, once, with what was held back.
  void open() {
    if (file_) return;
    file_.emplace(name_);
    file_->write(held_);
    file_->flush();
  }
  std::size_t bytes() const { return bytes_; }  ///< written so far
  void close() {
    open();
    file_->close();
  }

 private:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    const std::string_view some(bytes, static_cast<std::size_t>(count));
    bytes_ += some.size();
    if (file_)
      file_->write(some);
    else
      held_ += some;
    return count;
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    if (!traits_type::eq_int_type(c, traits_type::eof())) xsputn(&byte, 1);
    return traits_type::not_eof(c);
  }
  int sync() override {
    if (file_) file_->flush();
    return 0;
  }

  std::string name_, held_;
  std::size_t bytes_ = 0;
  std::optional<io::FileWriter> file_;
  std::ostream stream_{this};
};

/// Plays a scene, of space or of the plane, into the file.
template <class Frame, class AnyScene>
void capture(const AnyScene& scene, const CaptureArguments& options, io::SimulateOptions& how) {
  const std::size_t frames = io::frame_count(how);
  CaptureFile file(options.out);
  how.capture = &file.stream();
  Progress progress("capturing");
  std::size_t done = 0;
  const io::SimulateSummary summary = io::simulate(scene, how, [&](const Frame&) {
    file.open();
    progress(++done, frames);
  });
  file.close();
  print_notes(scene.notices);
  print_notes(summary.notices);
  fmt::print("{}: {} of {} and {}, {} bytes\n", options.out, counted(summary.steps, "frame"),
             counted(summary.bodies, "moving body"), counted(summary.joints, "joint"), file.bytes());
}

void run_with(const CaptureArguments& options) {
  io::SimulateOptions how;
  how.seconds = options.seconds;
  how.rate = options.rate;
  how.sub_steps = options.sub_steps;
  how.precision = precision_of(options.precision);
  io::frame_count(how);  // refused before anything is read
  if (!options.scene.is_in_plane()) {
    capture<io::SimulationFrame>(options.scene.load(true, true), options, how);
    return;
  }
  const io::PlaneScene scene = io::load_plane_scene(options.scene.files[0]);
  if (scene.gravity) how.gravity = {scene.gravity->x, scene.gravity->y, 0};
  capture<io::PlaneSimulationFrame>(scene, options, how);
}

int run_capture(const CaptureArguments& options) {
  static constexpr std::pair<const char*, const char*> options_of_values[] = {{"seconds", "--seconds"},
                                                                              {"rate", "--rate"},
                                                                              {"dt", "--rate"},
                                                                              {"sub_steps", "--substeps"},
                                                                              {"most_sub_steps", "--substeps"}};
  check_output("--out", options.out, options.scene.files);
  check_ending("--out", options.out, ".capture");
  try {
    run_with(options);
  } catch (const InvalidValue& e) {
    throw_renamed(e, options_of_values);
  }
  return 0;
}

}  // namespace

Run add_capture(CLI::App& app) {
  auto options = std::make_shared<CaptureArguments>();
  CLI::App* command = app.add_subcommand("capture", "Play a scene and write down all that its simulation is told");
  options->scene.add_to(*command);
  command->add_option("--out", options->out, "The capture to write (.capture)")->required();
  command->add_option("--seconds", options->seconds, "How long to play")->capture_default_str();
  command->add_option("--rate", options->rate, "Steps, and frames, a second")->capture_default_str();
  command->add_option("--substeps", options->sub_steps, "Sub-steps of a step, a power of two")->capture_default_str();
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->footer(
      "A program of your own captures with graze/capture.hpp. Exit code: 0, or 2 when a file or an option\n"
      "cannot be used.\n\n"
      "Examples:\n  graze capture scene.gltf --seconds 20 --out scene.capture && graze replay scene.capture\n"
      "  graze capture examples/scenes/plane.svg --seconds 5 --out plane.capture");
  return [options] { return run_capture(*options); };
}

}  // namespace graze::cli
