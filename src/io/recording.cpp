#include "graze/io/recording.hpp"

#include <algorithm>

#include "graze/error.hpp"
#include "io/animated_scene.hpp"
#include "io/frame_lines.hpp"
#include "io/gltf_drawing.hpp"
#include "io/late_file.hpp"

namespace graze::io {

namespace {

/// A recording that writes each line when it comes, so that it can be read while the run goes on.
class LineRecording final : public Recording {
 public:
  LineRecording(const std::filesystem::path& file, const Scene& scene, Precision precision)
      : out_(file), scene_(scene), moving_(moving_bodies(scene)), precision_(precision) {}

  void add(const SimulationFrame& frame) override {
    if (frame.bodies.size() != moving_.size())
      throw InvalidValue("bodies", std::to_string(moving_.size()) + " states", std::to_string(frame.bodies.size()));
    out_.write(frame_line(scene_, moving_, frame, precision_));
  }
  void close() override { out_.close(); }

 private:
  LateFile out_;
  const Scene& scene_;
  std::vector<std::uint32_t> moving_;
  Precision precision_;
};

}  // namespace

std::vector<std::uint32_t> moving_bodies(const Scene& scene) {
  std::vector<std::uint32_t> moving;
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].motion) moving.push_back(i);
  std::stable_sort(moving.begin(), moving.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return scene.bodies[a].node < scene.bodies[b].node; });
  return moving;
}

std::unique_ptr<Recording> record(const std::filesystem::path& file, const Scene& scene,
                                  const std::filesystem::path& source, Precision precision) {
  if (is_gltf(file)) return record_animation(file, scene, source);
  if (takes_lines(file)) return std::make_unique<LineRecording>(file, scene, precision);
  throw InvalidValue(file.string(), "a file name that ends in .gltf, .glb or .jsonl",
                     "\"" + file.extension().string() + "\"");
}

}  // namespace graze::io
