// How the cost of a hull's support query grows with its vertices: the hierarchy answers in logarithmic time.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "graze/shape.hpp"

namespace {

using graze::Vec3d;

Vec3d on_sphere(int i, int count) {
  const double y = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - y * y), turn = 2.399963229728653 * i;
  return {r * std::cos(turn), y, r * std::sin(turn)};
}

graze::ConvexHull<double> ball_of(int vertices) {
  std::vector<Vec3d> points;
  for (int i = 0; i < vertices; ++i) points.push_back(on_sphere(i, vertices));
  return graze::ConvexHull<double>(points);
}

void support(benchmark::State& state) {
  const auto hull = ball_of(static_cast<int>(state.range(0)));
  std::vector<Vec3d> directions;  // far from one another: no query finds the last one's vertices in the cache
  for (int i = 0; i < 1000; ++i) directions.push_back(on_sphere(i * 379 % 1000, 1000));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(hull.support_vertex(directions[i]));
    i = (i + 1) % directions.size();
  }
}
BENCHMARK(support)->Arg(16)->Arg(32)->Arg(100)->Arg(1000)->Arg(10000)->Arg(100000);

void build(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(ball_of(static_cast<int>(state.range(0))));
}
BENCHMARK(build)->Arg(100)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
