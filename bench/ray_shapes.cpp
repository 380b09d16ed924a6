// Rays at single shapes, one at a time and many at a time, on one thread.
//
//   bench_ray_shapes [--rays N] [--rounds N] [--only REGEX]
//
// The shapes are of unit size and turned; the rays come from 2 to 3 sizes away and go to points in the shape's cube, so
// that most hit. Told are nanoseconds of the processor's time for a ray, by the median round.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <regex>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "graze/batch_raycast.hpp"
#include "random.hpp"

namespace graze::bench {

namespace {

template <class F>
double nanoseconds(std::size_t rays, std::size_t rounds, const F& f) {
  std::vector<double> times;
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::clock_t start = std::clock();
    f();
    times.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e9 / static_cast<double>(rays));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

/// Hills all over a square of unit size.
template <class T>
HeightField<T> hills() {
  constexpr std::size_t side = 513;
  std::vector<T> heights;
  for (std::size_t i = 0; i < side * side; ++i) {
    const double u = static_cast<double>(i % side) / side, v = static_cast<double>(i / side) / side;
    heights.push_back(static_cast<T>(0.1 * std::sin(16 * u) * std::cos(10 * v) + 0.02 * std::sin(100 * u + 65 * v)));
  }
  return {side, side, heights, T(1) / T(side - 1), T(1) / T(side - 1)};
}

template <class T>
void measure(const char* scalar, std::size_t count, std::size_t rounds, const std::regex& only) {
  Random random(1);
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 32; ++i) points.push_back(converted<T>(random.direction() * 0.6));
  const std::vector<Shape<T>> shapes = {
      Sphere<T>(T(0.5)),
      Box<T>(Vec3<T>{T(0.5), T(0.4), T(0.3)}),
      Capsule<T>(T(0.3), T(0.25)),
      Triangle<T>({T(-0.7), T(0), T(-0.5)}, {T(0.7), T(0.1), T(-0.5)}, {T(0), T(-0.2), T(0.8)}),
      HalfSpace<T>(),
      Cylinder<T>(T(0.4), T(0.4)),
      Ellipsoid<T>(Vec3<T>{T(0.6), T(0.5), T(0.3)}),
      ConvexHull<T>(points),
      hills<T>()};
  const Pose<T> pose{{T(1), T(2), T(3)}, converted<T>(random.rotation())};
  std::vector<Ray<T>> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d from = converted<double>(pose.translation) + random.direction() * random.number(2, 3);
    rays.push_back(
        {converted<T>(from), converted<T>(converted<double>(pose.translation) + random.in_cube(0.4) - from)});
  }
  std::vector<std::optional<RayHit<T>>> hits(count);
  for (const Shape<T>& shape : shapes) {
    if (!std::regex_search(shape.name(), only)) continue;
    const double single = nanoseconds(count, rounds, [&] {
      for (std::size_t i = 0; i < count; ++i) hits[i] = raycast(shape, pose, rays[i]);
    });
    const double batch = nanoseconds(count, rounds, [&] { raycast<T>(shape, pose, rays, hits); });
    const auto met = static_cast<double>(std::count_if(hits.begin(), hits.end(), [](const auto& h) { return !!h; }));
    std::printf("| %-12s | %-6s | %6.1f | %6.1f | %4.0f %% |\n", shape.name(), scalar, single, batch,
                100 * met / static_cast<double>(count));
  }
}

int run(int argc, char** argv) {
  std::size_t count = 100'000, rounds = 15;
  std::string only = ".*";
  CommandLine("Rays at single shapes, one at a time and many at a time, on one thread.")
      .number("--rays", count, "rays a shape")
      .number("--rounds", rounds, "of which the median is taken")
      .expression("--only", only, "only shapes whose names match")
      .read(argc, argv);
  std::printf("| shape        | scalar | alone  | batch  | hit    |\n");
  std::printf("|--------------|--------|-------:|-------:|-------:|\n");
  measure<float>("float", count, rounds, std::regex(only));
  measure<double>("double", count, rounds, std::regex(only));
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
