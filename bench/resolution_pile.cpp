// Rows of a pile: its time, on one thread and on two, its depth, and its bits.
#include "resolution_measures.hpp"

#include <cstring>

#include "measure.hpp"
#include "random.hpp"
#include "resolution_run.hpp"
#include "table.hpp"

namespace graze::bench {

namespace {

std::vector<Thing> bin_of_boxes(int count) {
  std::vector<Thing> things{floor_with()};
  const double half = 10;
  for (const double side : {-1.0, 1.0}) {
    things.push_back(box({side * (half + 0.5), 20, 0}, {1, 40, 2 * half + 2}, 0));
    things.push_back(box({0, 20, side * (half + 0.5)}, {2 * half + 2, 40, 1}, 0));
  }
  Random random(3);
  for (int i = 0; i < count; ++i) {
    const int x = i % 16, z = i / 16 % 16, y = i / 256;
    Thing thing = box({(x - 7.5) * 1.23, 1 + y * 1.3, (z - 7.5) * 1.23});
    thing.pose.translation += random.in_cube(0.05);
    const double angle = random.number(-0.3, 0.3);
    thing.pose.rotation = about(random.direction(), angle);
    things.push_back(thing);
  }
  return things;
}

}  // namespace

std::string pile(const EngineKind& kind) {
  constexpr int steps = 480;
  Run run(kind, bin_of_boxes(5000));
  const double start = processor_seconds();
  run.steps(steps / 4 * 3);
  const double paused = processor_seconds(), energy = run.kinetic_energy(), resumed = processor_seconds();
  run.steps(steps / 4);
  const double spent = processor_seconds() - resumed + paused - start;
  return printed("%.0f ms", spent / steps * 1e3) + ", " + millimetres(run.deepest()) + ", " + joules(energy) + ", " +
         joules(run.kinetic_energy());
}

namespace {

/// The pile after it has fallen and come to rest, by Graze in float; at rest.
const std::vector<Thing>& pile_at_rest() {
  static const std::vector<Thing> things = [] {
    std::vector<Thing> fallen = bin_of_boxes(5000);
    Run run(engine_kinds().front(), fallen);
    run.steps(20 * seconds);
    for (std::size_t i = 0; i < fallen.size(); ++i) fallen[i].pose = run.moving(i).pose;
    return fallen;
  }();
  return things;
}

}  // namespace

std::string settled_pile(const EngineKind& kind) {
  Run run(kind, pile_at_rest());
  std::vector<double> times;
  for (int i = 0; i < seconds; ++i) {
    const double start = processor_seconds();
    run.steps(1);
    times.push_back(processor_seconds() - start);
  }
  return printed("%.1f ms", quantile(times, 0.5) * 1e3) + ", " + millimetres(run.deepest());
}

/// The same pile twice, on one thread and on two, which take their steps in turns. Where others use the machine only
/// the quickest steps tell what two threads gain: the ratio of the quickest tenths. The pile has fallen for a while
/// when it begins.
std::string two_threads(const EngineKind& kind) {
  if (!kind.has_threads) return "-";
  constexpr int fallen = 120, measured = 60;
  Run one(kind, bin_of_boxes(5000)), two(kind, bin_of_boxes(5000), {.threads = 2});
  std::vector<double> alone, together;
  for (int i = 0; i < fallen + measured; ++i) {
    const double start = clock_seconds();
    one.steps(1);
    const double between = clock_seconds();
    two.steps(1);
    if (i < fallen) continue;
    alone.push_back(between - start);
    together.push_back(clock_seconds() - between);
  }
  return printed("%.2f", quantile(alone, 0.1) / quantile(together, 0.1));
}

namespace {

std::uint64_t hash_of(const Run& run) {
  std::uint64_t hash = 14695981039346656037u;  // Fowler, Noll and Vo
  for (std::size_t i = 0; i < run.things().size(); ++i) {
    const Moving m = run.moving(i);
    unsigned char bytes[sizeof m];
    std::memcpy(bytes, &m, sizeof m);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211u;
  }
  return hash;
}

std::uint64_t state_hash(const EngineKind& kind, std::size_t threads) {
  Run run(kind, bin_of_boxes(300), {.threads = threads});
  run.steps(3 * seconds);
  return hash_of(run);
}

/// A second after it was put back the pile has the bits that it had a second after it was saved.
std::string put_back(const EngineKind& kind) {
  Run run(kind, bin_of_boxes(300));
  run.steps(1 * seconds);
  const std::function<void()> put = run.engine().saved();
  if (!put) return "; -";
  run.steps(1 * seconds);
  const std::uint64_t first = hash_of(run);
  put();
  run.steps(1 * seconds);
  return first == hash_of(run) ? "; yes" : "; no";
}

}  // namespace

std::string same_bits(const EngineKind& kind) {
  const std::uint64_t first = state_hash(kind, 1);
  std::string answer = first == state_hash(kind, 1) ? "yes" : "no";
  if (kind.has_threads)
    answer +=
        first == state_hash(kind, 2) && first == state_hash(kind, 4) && first == state_hash(kind, 8) ? "; yes" : "; no";
  else
    answer += "; -";
  return answer + put_back(kind);
}

}  // namespace graze::bench
