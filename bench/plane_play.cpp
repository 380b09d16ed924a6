// How long engines take for a step of a scene of the plane, and how well bodies and hinges hold.
//
// Time is that of the processor. Depths are measured alike for all, by Graze's contacts in double, with the bodies
// where the engine left them.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <regex>

#include "plane_scene.hpp"
#include "table.hpp"

namespace graze::plane {

namespace {

/// The deepest contact of any two bodies, but for those that no impulse moves.
double deepest(const Engine& engine, const Scene& scene) {
  World<double> world;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Body<double> body = scene.bodies[i].body;
    body.pose = engine.pose(i);
    body.fixed = body.fixed || scene.bodies[i].kinematic;
    world.add(std::move(body));
  }
  world.update();
  double most = 0;
  for (const auto& point : world.contacts().points) most = std::max(most, -point.distance);
  return most;
}

/// The widest hinge: how far its point on one body is from that on the other.
double widest(const Engine& engine, const Scene& scene) {
  double most = 0;
  for (const SceneHinge& hinge : scene.hinges) {
    const auto now = [&](std::size_t body) {
      return transform(engine.pose(body), inverse_transform(scene.bodies[body].body.pose, hinge.at));
    };
    most = std::max(most, length(now(hinge.a) - now(hinge.b)));
  }
  return most;
}

/// The mean of the middle half of the numbers: of scenes whose steps grow dearer as well as of those that stand.
double middle_mean(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const std::size_t from = times.size() / 4, to = times.size() - from;
  double sum = 0;
  for (std::size_t i = from; i < to; ++i) sum += times[i];
  return sum / double(to - from);
}

double processor_milliseconds() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

void print_scenes(const std::string& names, double scale, std::size_t most_steps) {
  bench::Table table({"scene", "engine", "bodies", "steps", "time of a step", "deepest", "widest"}, 2);
  std::string what;
  const std::regex wanted(names);
  for (const Scene& scene : played_scenes(scale)) {
    if (!std::regex_search(scene.name, wanted)) continue;
    what += "- " + scene.name + ": " + scene.what + "\n";
    const std::size_t steps = std::min(scene.steps, most_steps);
    for (const auto& engine_with : engines_of_the_plane()) {
      const Engine engine = engine_with(scene);
      std::vector<double> times;
      for (std::size_t i = 0; i < steps; ++i) {
        const double start = processor_milliseconds();
        engine.step();
        times.push_back(processor_milliseconds() - start);
      }
      table.add({scene.name, engine.name, std::to_string(scene.bodies.size()), std::to_string(steps),
                 bench::printed("%.2f ms", middle_mean(times)), bench::printed("%.2f mm", 1e3 * deepest(engine, scene)),
                 scene.hinges.empty() ? "" : bench::printed("%.2f mm", 1e3 * widest(engine, scene))});
    }
  }
  std::printf(
      "\n## Scenes of the plane\n\n"
      "By `bench_plane --scene .`. Box2D takes 8 passes over velocities and 3 over positions. The time is the mean "
      "of the\nmiddle half of all steps; `deepest` is the deepest contact and `widest` the widest hinge after the "
      "last step.\n\n%s\n%s",
      what.c_str(), table.text().c_str());
}

}  // namespace graze::plane
