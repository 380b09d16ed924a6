// A pyramid of the plane beside Box2D: how long a step takes, and how still it stands.
//
// Boxes of 1 m and 1,000 kg/m² on a floor, those of a row 5 cm apart, each on two of the row below, friction 0.6, g =
// 10 m/s², 60 steps a second, nothing sleeps. Box2D takes 8 passes over velocities and 3 over positions, as it
// recommends. Time is that of the processor; depths are measured alike, by Graze's contacts in double.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "graze/plane/simulation.hpp"
#include "plane_pairs.hpp"
#include "table.hpp"

#ifdef GRAZE_BENCH_BOX2D
#include <box2d/b2_body.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>
#endif

namespace graze::plane {

namespace {

constexpr double gravity = 10, friction = 0.6, density = 1000, gap = 0.05;
/// The floor is a box so wide and half as high, with its top at y = 0.
constexpr double floor_width = 400, floor_height = 200;

std::vector<Vec2d> pyramid(std::size_t base) {
  std::vector<Vec2d> centers;
  for (std::size_t row = 0; row < base; ++row)
    for (std::size_t i = 0; i + row < base; ++i)
      centers.push_back({(double(i) - 0.5 * double(base - row - 1)) * (1 + gap), 0.5 + double(row)});
  return centers;
}

/// An engine with the pyramid in it.
struct Engine {
  std::string name;
  std::function<void()> step;
  std::function<Pose2d(std::size_t)> pose;
};

template <class T>
Engine graze_engine(const char* name, const std::vector<Vec2d>& centers) {
  SimulationSettings<T> settings;
  settings.gravity = {T(0), T(-gravity)};
  settings.sleep = false;
  const auto simulation = std::make_shared<Simulation<T>>(settings);
  Material<T> material;
  material.static_friction = material.dynamic_friction = T(friction);
  Body<T> floor{Box<T>({T(floor_width), T(floor_height)}), {{T(0), T(-floor_height / 2)}, {}}};
  floor.fixed = true;
  simulation->add(floor, {}, material);
  auto ids = std::make_shared<std::vector<BodyId>>();
  Dynamics<T> dynamics;
  dynamics.density = T(density);
  for (const Vec2d& center : centers)
    ids->push_back(simulation->add({Box<T>({T(1), T(1)}), {converted<T>(center), {}}}, dynamics, material));
  return {name, [simulation] { simulation->step(T(1) / T(60)); },
          [simulation, ids](std::size_t i) {
            const Pose2<T>& pose = simulation->poses()[(*ids)[i].index];
            return Pose2d{converted<double>(pose.translation), converted<double>(pose.rotation)};
          }};
}

#ifdef GRAZE_BENCH_BOX2D
Engine box2d_engine(const std::vector<Vec2d>& centers) {
  const auto world = std::make_shared<b2World>(b2Vec2(0, float(-gravity)));
  world->SetAllowSleeping(false);
  const auto add = [&](b2BodyType type, const Vec2d& at, float half_width, float half_height) {
    b2BodyDef definition;
    definition.type = type;
    definition.position.Set(float(at.x), float(at.y));
    b2Body* body = world->CreateBody(&definition);
    b2PolygonShape shape;
    shape.SetAsBox(half_width, half_height);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = float(density);
    fixture.friction = float(friction);
    body->CreateFixture(&fixture);
    return body;
  };
  add(b2_staticBody, {0, -floor_height / 2}, float(floor_width / 2), float(floor_height / 2));
  auto bodies = std::make_shared<std::vector<b2Body*>>();
  for (const Vec2d& center : centers) bodies->push_back(add(b2_dynamicBody, center, 0.5f, 0.5f));
  return {"Box2D 2.4", [world] { world->Step(1.0f / 60, 8, 3); },
          [world, bodies](std::size_t i) {
            const b2Transform& at = (*bodies)[i]->GetTransform();
            return Pose2d{{double(at.p.x), double(at.p.y)}, {double(at.q.c), double(at.q.s)}};
          }};
}
#endif

/// The deepest contact of any two boxes, and of boxes with the floor.
double deepest(const Engine& engine, const std::vector<Vec2d>& centers) {
  World<double> world;
  Body<double> floor{Box<double>({floor_width, floor_height}), {{0, -floor_height / 2}, {}}};
  floor.fixed = true;
  world.add(floor);
  for (std::size_t i = 0; i < centers.size(); ++i) world.add({Box<double>({1, 1}), engine.pose(i)});
  world.update();
  double most = 0;
  for (const auto& point : world.contacts().points) most = std::max(most, -point.distance);
  return most;
}

double processor_milliseconds() { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; }

void add_row(bench::Table& table, const Engine& engine, const std::vector<Vec2d>& centers, std::size_t steps) {
  std::vector<double> times;
  for (std::size_t i = 0; i < steps; ++i) {
    const double start = processor_milliseconds();
    engine.step();
    times.push_back(processor_milliseconds() - start);
  }
  double drift = 0;
  for (std::size_t i = 0; i < centers.size(); ++i)
    drift = std::max(drift, length(engine.pose(i).translation - centers[i]));
  std::nth_element(times.begin(), times.begin() + std::ptrdiff_t(steps / 2), times.end());
  table.add({engine.name, bench::printed("%.1f ms", times[steps / 2]),
             bench::printed("%.2f mm", 1e3 * deepest(engine, centers)), bench::printed("%.2f mm", 1e3 * drift)});
}

}  // namespace

void print_pyramid(std::size_t base, std::size_t steps) {
  const std::vector<Vec2d> centers = pyramid(base);
  bench::Table table({"", "time of a step", "deepest", "moved"}, 1);
  add_row(table, graze_engine<float>("Graze, float", centers), centers, steps);
  add_row(table, graze_engine<double>("Graze, double", centers), centers, steps);
#ifdef GRAZE_BENCH_BOX2D
  add_row(table, box2d_engine(centers), centers, steps);
#endif
  std::printf("\n## A pyramid of the plane\n\n"
              "%zu boxes, %zu in the lowest row, each on two of the row below, %zu steps, by `bench_plane --pyramid`. "
              "Box2D takes\n"
              "8 passes over velocities and 3 over positions. The time is the median of the steps.\n\n%s",
              centers.size(), base, steps, table.text().c_str());
}

}  // namespace graze::plane
