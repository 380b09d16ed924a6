#include "resting.hpp"

#include <cmath>

#include "peer.hpp"
#include "random.hpp"

namespace graze::bench {

namespace {

struct Scene {
  const char* name;
  double shift, yaw;
};
constexpr Scene scenes[] = {{"aligned", 0, 0}, {"shifted", 0.1, 0}, {"turned", 0.1, 0.4}};

std::vector<Pair> make_frames(const Scene& scene, std::size_t count) {
  constexpr double tilt = 0.005, jitter = 0.001, depth = 0.001;
  Random random(7);
  std::vector<Pair> frames;
  for (std::size_t i = 0; i < count; ++i) {
    Body below{Kind::box, {1, 1, 1}}, above = below;
    const Vec3d lean = random.in_cube(tilt) * 0.5;
    const Quatd yaw{0, scene.yaw / 2, 0, 1};
    above.pose.rotation = normalized(normalized(Quatd{lean.x, lean.y, lean.z, 1}) * normalized(yaw));
    above.pose.translation = {scene.shift + random.number(-jitter, jitter),
                              1 - depth + random.number(-depth / 2, depth / 2), scene.shift / 2};
    frames.push_back({as_float(below), as_float(above)});
  }
  return frames;
}

/// Whether a normal is that of a face of one of the boxes, to single precision.
bool is_face(const Pair& pair, const Vec3d& normal) {
  constexpr double same = 1e-5;
  for (const Body* body : {&pair.a, &pair.b}) {
    const Vec3d local = abs(rotate(conjugate(body->pose.rotation), normal));
    if (local.x + local.y + local.z - max_abs(local) < same) return true;
  }
  return false;
}

}  // namespace

std::vector<Flicker> measure_flicker(std::size_t frames) {
  std::vector<Flicker> results;
  for (const Scene& scene : scenes) {
    const std::vector<Pair> pairs = make_frames(scene, frames);
    for (const auto& peer : peers()) {
      if (peer->answers_at_once() || !peer->prepare(pairs) || !peer->has(Query::contacts)) continue;
      Flicker flicker{peer->name(), scene.name, frames, 0, 0, 0};
      Answer last;
      bool last_face = false;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Answer now = peer->resting(i);
        const bool face = is_face(pairs[i], now.normal);
        flicker.points += now.points;
        if (i > 0) {
          flicker.kind_changes += face != last_face;
          flicker.count_changes += now.points != last.points;
        }
        last = now;
        last_face = face;
      }
      results.push_back(flicker);
    }
  }
  return results;
}

}  // namespace graze::bench
