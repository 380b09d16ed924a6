// Recordings of a simulation of the plane, as lines or as a picture that moves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graze/io/file.hpp"
#include "graze/io/plane_simulate.hpp"
#include "io/drawing.hpp"
#include "io/frame_lines.hpp"
#include "io/late_file.hpp"
#include "io/plane_shapes.hpp"

namespace graze::io {

namespace {

void check_bodies(const PlaneSimulationFrame& frame, std::size_t expected) {
  if (frame.bodies.size() != expected)
    throw InvalidValue("bodies", std::to_string(expected) + " states", std::to_string(frame.bodies.size()));
}

class PlaneLines final : public PlaneRecording {
 public:
  PlaneLines(const std::filesystem::path& file, const PlaneScene& scene, Precision precision)
      : out_(file), scene_(scene), moving_(moving_bodies(scene)), precision_(precision) {}

  void add(const PlaneSimulationFrame& frame) override {
    check_bodies(frame, moving_.size());
    out_.write(frame_line(scene_, moving_, frame, precision_));
  }
  void close() override { out_.close(); }

 private:
  LateFile out_;
  const PlaneScene& scene_;
  std::vector<std::uint32_t> moving_;
  Precision precision_;
};

/// A picture in which each body is drawn once, at its first place, in two groups whose transforms SMIL animates: a way,
/// and a turn about the first place of its origin.
class MovingPicture final : public PlaneRecording {
 public:
  MovingPicture(const std::filesystem::path& file, const PlaneScene& scene)
      : file_(file), scene_(scene), moving_(moving_bodies(scene)), tracks_(moving_.size()) {
    check_writable(file);
  }

  void add(const PlaneSimulationFrame& frame) override {
    check_bodies(frame, moving_.size());
    time_ = frame.time;
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      std::vector<Place>& track = tracks_[i];
      const PlaneBodyState& body = frame.bodies[i];
      double angle = body.rotation;
      // The angle goes on from that of the last frame by less than half a turn.
      if (!track.empty()) angle = track.back().angle + std::remainder(angle - track.back().angle, 2 * std::numbers::pi);
      track.push_back({{body.translation.x, body.translation.y, 0}, angle});
    }
  }

  void close() override {
    Aabbd box = Aabbd::empty();
    for (const PlaneCollider& c : scene_.colliders)
      if (const Aabbd of = plane_bounds(c.shape, c.pose); max_abs(of.extent()) < 1e300) box = merged(box, of);
    if (!(box.lower.x <= box.upper.x)) box = {{-1, -1, 0}, {1, 1, 0}};
    constexpr double border = 40;
    const View view({0, 0, 1}, {box.lower, box.upper},
                    {border, border + 25, picture_width - 2 * border, picture_height - 2 * border - 30});
    const double size = std::max(max_abs(box.extent()), least_size);
    std::string out = svg_head();
    out += drawn(view, box, size, [&](std::uint32_t body) { return scene_.bodies[body].type == MotionType::fixed; });
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      const std::string shapes = drawn(view, box, size, [&](std::uint32_t body) { return body == moving_[i]; });
      out += animated(view, tracks_[i], shapes);
    }
    out += fmt::format("<g font-family=\"system-ui, sans-serif\">\n{}</g>\n</svg>\n",
                       text(24, 32, 17, fmt::format("{}: {:.6g} s", scene_.source, time_)));
    write_file(file_, out);
  }

 private:
  struct Place {
    Vec3d at;
    double angle;
  };

  template <class F>
  std::string drawn(const View& view, const Aabbd& box, double size, const F& is_wanted) const {
    SvgDraw canvas(view, {box.center(), size}, 0.45 * size);
    for (const PlaneCollider& c : scene_.colliders) {
      if (!is_wanted(c.body)) continue;
      const bool fixed = scene_.bodies[c.body].type == MotionType::fixed;
      draw(canvas, c.shape, c.pose,
           c.trigger ? DrawMeaning::trigger
           : fixed   ? DrawMeaning::fixed
                     : DrawMeaning::moving);
    }
    return canvas.faces() + canvas.over();
  }

  /// The animated group of a body. On a picture the Y axis points down, and turns go the other way round.
  std::string animated(const View& view, const std::vector<Place>& track, const std::string& shapes) const {
    if (track.size() < 2 || !(time_ > 0)) return shapes;
    const double x = view.x(track.front().at), y = view.y(track.front().at);
    std::string ways, turns;
    for (const Place& p : track) {
      const char* between = ways.empty() ? "" : ";";
      ways += fmt::format("{}{:.2f} {:.2f}", between, view.x(p.at) - x, view.y(p.at) - y);
      turns += fmt::format("{}{:.3f} {:.2f} {:.2f}", between, (track.front().angle - p.angle) * 180 / std::numbers::pi,
                           x, y);
    }
    const auto animation = [&](const char* type, const std::string& values) {
      return fmt::format("<animateTransform attributeName=\"transform\" type=\"{}\" dur=\"{:.6g}s\" "
                         "repeatCount=\"indefinite\" values=\"{}\"/>\n",
                         type, time_, values);
    };
    return "<g>\n" + animation("translate", ways) + "<g>\n" + animation("rotate", turns) + shapes + "</g>\n</g>\n";
  }

  std::filesystem::path file_;
  const PlaneScene& scene_;
  std::vector<std::uint32_t> moving_;
  std::vector<std::vector<Place>> tracks_;
  double time_ = 0;
};

}  // namespace

std::unique_ptr<PlaneRecording> record(const std::filesystem::path& file, const PlaneScene& scene,
                                       Precision precision) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".svg") return std::make_unique<MovingPicture>(file, scene);
  if (takes_lines(file)) return std::make_unique<PlaneLines>(file, scene, precision);
  throw InvalidValue(file.string(), "a file name that ends in .svg or .jsonl, for a scene of the plane",
                     "\"" + file.extension().string() + "\"");
}

}  // namespace graze::io
