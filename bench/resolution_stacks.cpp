// Rows of what stands: towers, pyramids, heavy on light, cards, and sizes.
#include "resolution_measures.hpp"

#include <algorithm>
#include <cmath>

#include "measure.hpp"
#include "random.hpp"
#include "resolution_run.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

std::vector<Thing> tower(int count, double off) {
  Random random(1);
  std::vector<Thing> things{floor_with()};
  for (int i = 0; i < count; ++i) {
    const double x = random.number(-off, off), z = random.number(-off, off);
    things.push_back(box({off > 0 ? x : 0, 0.5 + i, off > 0 ? z : 0}));
  }
  return things;
}

bool stands(const Run& run) {
  for (std::size_t i = 1; i < run.things().size(); ++i)
    if (!(std::abs(run.at(i).y - run.things()[i].pose.translation.y) < 0.5)) return false;
  return true;
}

}  // namespace

std::string tower_row(const EngineKind& kind, int count, double off) {
  Run run(kind, tower(count, off));
  run.steps(20 * seconds);
  if (!stands(run)) return "falls";
  const Vec3d top = run.at(run.things().size() - 1), put = run.things().back().pose.translation;
  return millimetres(put.y - top.y) + ", " + millimetres(std::hypot(top.x - put.x, top.z - put.z)) + ", " +
         joules(run.kinetic_energy());
}

std::string tallest(const EngineKind& kind, bool sleep) {
  int best = 0;
  for (const int count : {10, 15, 20, 30, 40, 60, 100}) {
    Run run(kind, tower(count, 0), {.sleep = sleep});
    run.steps(20 * seconds);
    if (!stands(run)) break;
    best = count;
  }
  return best == 0 ? "none" : std::to_string(best);
}

std::string pyramid(const EngineKind& kind) {
  std::vector<Thing> things{floor_with()};
  const int base = 20;
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) things.push_back(box({(i - 0.5 * (base - row - 1)) * 1.05, 0.5 + row, 0}));
  Run run(kind, things);
  const double start = processor_seconds();
  run.steps(20 * seconds);
  const double spent = processor_seconds() - start;
  return millimetres(run.deepest()) + ", " + millimetres(run.greatest_move()) + ", " + joules(run.kinetic_energy()) +
         ", " + printed("%.2f ms", spent / (20 * seconds) * 1e3);
}

std::string heavy_on_light(const EngineKind& kind, double ratio, int light) {
  std::vector<Thing> things{floor_with()};
  for (int i = 0; i < light; ++i) things.push_back(box({0, 0.5 + i, 0}));
  things.push_back(box({0, 0.5 + light, 0}, {1, 1, 1}, 1000 * ratio));
  Run run(kind, things);
  run.steps(20 * seconds);
  const double sunk = things.back().pose.translation.y - run.at(things.size() - 1).y;
  if (sunk > 0.5) return "falls";
  return millimetres(run.deepest()) + ", " + joules(run.kinetic_energy());
}

std::string card_house(const EngineKind& kind) {
  constexpr double length_of_card = 2, thick = 0.02, lean = 0.4363323129985824;  // 25 degrees
  const double c = std::cos(lean), s = std::sin(lean), high = 2 * (c + thick / 2 * s), apart = length_of_card + 0.005;
  std::vector<Thing> things{floor_with(0.7)};
  double level = 0;
  const auto card = [&](const Vec3d& at, double angle) {
    Thing thing = box(at, {thick, length_of_card, 1});
    thing.friction = 0.7;
    thing.pose.rotation = about({0, 0, 1}, angle);
    things.push_back(thing);
  };
  for (int storey = 5; storey > 0; --storey) {
    const double beside = s + thick / 2 * c;
    for (int i = 0; i < storey; ++i)
      for (const double side : {-1.0, 1.0})
        card({(i - 0.5 * (storey - 1)) * apart + side * beside, level + high / 2, 0}, side * lean);
    for (int i = 0; i + 1 < storey; ++i)
      card({(i - 0.5 * (storey - 2)) * apart, level + high + thick / 2, 0}, 1.5707963267948966);
    level += high + thick;
  }
  Run run(kind, things);
  run.steps(20 * seconds);
  int fallen = 0;
  double most = 0;
  for (std::size_t i = 1; i < things.size(); ++i) {
    const double way = length(run.at(i) - things[i].pose.translation);
    if (!(way < 0.2)) ++fallen;
    most = std::max(most, way);
  }
  return std::to_string(fallen) + ", " + millimetres(most);
}

std::string sizes(const EngineKind& kind) {
  std::string answer;
  for (const double size : {1e-3, 1e-2, 0.1, 1.0, 100.0}) {
    std::vector<Thing> things{floor_with()};
    for (int i = 0; i < 5; ++i) things.push_back(box({0, (0.5 + i) * size, 0}, {size, size, size}));
    Run run(kind, things);
    run.steps(20 * seconds);
    const double sunk = things.back().pose.translation.y - run.at(5).y, level = std::abs(run.at(5).x) / size;
    answer += answer.empty() ? "" : " / ";
    answer += std::abs(sunk) < 0.5 * size && level < 0.5 ? printed("%.2g %%", 100 * sunk / size) : "no";
  }
  return answer;
}

}  // namespace graze::bench
