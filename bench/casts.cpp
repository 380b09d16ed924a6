// Shapes that move along a line, one at a time on one thread, side by side with Bullet's three methods; and rays and
// casts in worlds of boxes, with what ten times as many of them cost.
//
//   bench_casts [--pairs N] [--rounds N] [--largest N]
//
// Pairs: box and box, hulls of 32 points; about every other one meets. Told is how often an answer misses a hit, finds
// one where there is none, or says a time at which the shapes are further apart or deeper than a thousandth of their
// size, and than a hundredth. The reference is the least distance on the way, by section of `graze::distance` in
// double, which is a convex function of time; pairs that miss or meet by less than a hundredth are not counted.
// Worlds: boxes of 0.5 to 1.5, one in each 27 cubes of length 1 whatever their number; rays and casts go 30 far.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#ifdef GRAZE_BENCH_BULLET
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#endif

#include "bullet_shape.hpp"
#include "command_line.hpp"
#include "graze/cast.hpp"
#include "graze/world.hpp"
#include "graze_shape.hpp"
#include "judges.hpp"
#include "random.hpp"

namespace graze::bench {

namespace {

/// Answers when the pair of a number first meets.
struct Contender {
  std::string name;
  std::function<double(std::size_t)> time;
  std::vector<double> answers{};
  std::vector<double> seconds{};
};

double seconds_of(const std::function<void()>& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

Contender graze_casts(const std::vector<Pair>& ways) {
  struct Item {
    Shape<float> a, b;
    Posef pose_a, pose_b;
    Velocity<float> velocity;
  };
  auto items = std::make_shared<std::vector<Item>>();
  for (const Pair& way : ways)
    items->push_back({graze_shape<float>(way.a),
                      graze_shape<float>(way.b),
                      {converted<float>(way.a.pose.translation), converted<float>(way.a.pose.rotation)},
                      {converted<float>(way.b.pose.translation), converted<float>(way.b.pose.rotation)},
                      {converted<float>(way.motion), {}}});
  return {"graze", [items](std::size_t i) {
            const Item& item = (*items)[i];
            const auto hit = cast<float>(item.a, item.pose_a, item.velocity, item.b, item.pose_b, {}, 1.0f);
            return hit ? static_cast<double>(hit->t) : never;
          }};
}

#ifdef GRAZE_BENCH_BULLET
enum class Method { continuous, gjk, subsimplex };

Contender bullet_casts(const char* name, const std::vector<Pair>& ways, Method method) {
  struct Item {
    std::unique_ptr<btCollisionShape> a, b;
    const btConvexShape& convex_a() const { return static_cast<const btConvexShape&>(*a); }
    const btConvexShape& convex_b() const { return static_cast<const btConvexShape&>(*b); }
    btTransform from, to, still;
  };
  auto items = std::make_shared<std::vector<Item>>();
  for (const Pair& way : ways) {
    Posed end = way.a.pose;
    end.translation += way.motion;
    items->push_back({bullet::shape(way.a), bullet::shape(way.b), bullet::transform(way.a.pose), bullet::transform(end),
                      bullet::transform(way.b.pose)});
  }
  return {name, [items, method](std::size_t i) {
            const Item& item = (*items)[i];
            btVoronoiSimplexSolver simplex;
            btGjkEpaPenetrationDepthSolver depth;
            btConvexCast::CastResult result;
            result.m_fraction = 1;
            const auto ask = [&](btConvexCast&& method_of) {
              return method_of.calcTimeOfImpact(item.from, item.to, item.still, item.still, result);
            };
            const bool hit =
                method == Method::continuous
                    ? ask(btContinuousConvexCollision(&item.convex_a(), &item.convex_b(), &simplex, &depth))
                : method == Method::gjk ? ask(btGjkConvexCast(&item.convex_a(), &item.convex_b(), &simplex))
                                        : ask(btSubsimplexConvexCast(&item.convex_a(), &item.convex_b(), &simplex));
            return hit && result.m_fraction <= 1 ? static_cast<double>(result.m_fraction) : never;
          }};
}
#endif

void measure_pairs(const char* name, Kind kind, std::size_t count, std::size_t rounds) {
  const std::vector<Pair> ways = make_ways(kind, count);
  std::vector<Contender> contenders;
  contenders.push_back(graze_casts(ways));
#ifdef GRAZE_BENCH_BULLET
  contenders.push_back(bullet_casts("bullet continuous", ways, Method::continuous));
  contenders.push_back(bullet_casts("bullet gjk", ways, Method::gjk));
  contenders.push_back(bullet_casts("bullet subsimplex", ways, Method::subsimplex));
#endif
  for (std::size_t round = 0; round < rounds; ++round)
    for (Contender& c : contenders) {
      c.answers.resize(count);
      c.seconds.push_back(seconds_of([&] {
        for (std::size_t i = 0; i < count; ++i) c.answers[i] = c.time(i);
      }));
    }
  std::vector<std::size_t> wrong(contenders.size()), far_off(contenders.size());
  std::size_t asked = 0, meeting = 0;
  const Reference reference(ways);
  for (std::size_t i = 0; i < count; ++i) {
    const double least = least_gap(reference, i);
    if (std::abs(least) <= coarse) continue;
    ++asked;
    meeting += least <= 0;
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      wrong[k] += wrong_cast(reference, i, least, contenders[k].answers[i], fine);
      far_off[k] += wrong_cast(reference, i, least, contenders[k].answers[i], coarse);
    }
  }
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    const double each = quantile(contenders[k].seconds, 0.5) / static_cast<double>(count);
    std::printf("| %-9s | %-17s | %6.0f | %5.2f | %7.2f | %7.2f | %6.2f |\n", name, contenders[k].name.c_str(),
                each * 1e9, quantile(contenders[k].seconds, 0.5) / quantile(contenders[0].seconds, 0.5),
                100 * static_cast<double>(wrong[k]) / static_cast<double>(asked),
                100 * static_cast<double>(far_off[k]) / static_cast<double>(asked),
                100 * static_cast<double>(meeting) / static_cast<double>(asked));
  }
}

struct Probe {
  Vec3d from, way;
};

void measure_world(std::size_t count, std::size_t rounds, double (&last)[2]) {
  constexpr double far = 30;
  constexpr std::size_t probes = 2000;
  const double half = 1.5 * std::cbrt(static_cast<double>(count));
  Random random(13);
  World<float> world;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d size{random.number(0.5, 1.5), random.number(0.5, 1.5), random.number(0.5, 1.5)};
    world.add({Box<float>(converted<float>(size)),
               {converted<float>(random.in_cube(half)), converted<float>(random.rotation())}});
  }
  std::vector<Probe> ways;
  for (std::size_t i = 0; i < probes; ++i) ways.push_back({random.in_cube(half), random.direction() * far});
  const Shape<float> moving = Box<float>({0.5f, 0.5f, 0.5f});
  std::size_t hits[2] = {};
  std::vector<double> seconds[2];
  world.raycast({converted<float>(ways[0].from), converted<float>(ways[0].way)});  // brings its tree up to date
  for (std::size_t round = 0; round < rounds; ++round) {
    hits[0] = hits[1] = 0;
    seconds[0].push_back(seconds_of([&] {
      for (const Probe& p : ways)
        hits[0] +=
            world.raycast({converted<float>(p.from), converted<float>(p.way)}, static_cast<float>(far)).has_value();
    }));
    seconds[1].push_back(seconds_of([&] {
      for (const Probe& p : ways)
        hits[1] += world.cast(moving, {converted<float>(p.from), {}}, {converted<float>(p.way), {}}, 1.0f).has_value();
    }));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const double each = quantile(seconds[k], 0.5) / static_cast<double>(probes);
    std::printf("| %-7s | %7zu | %9.0f | %7.2f | %7.2f |\n", k == 0 ? "raycast" : "cast", count, 1 / each,
                100 * static_cast<double>(hits[k]) / static_cast<double>(probes), last[k] > 0 ? each / last[k] : 1.0);
    last[k] = each;
  }
}

int run(int argc, char** argv) {
  std::size_t pairs = 4000, rounds = 9, largest = 100'000;
  CommandLine(
      "Shapes that move along a line, one at a time on one thread, beside Bullet's methods; and casts in worlds.")
      .number("--pairs", pairs, "pairs of a kind")
      .number("--rounds", rounds, "of which the median is taken")
      .number("--largest", largest, "boxes of the largest world")
      .read(argc, argv);
  std::printf("| pair      | library           | ns     | times | > 0.1%%  | > 1%%    | meet %% |\n");
  std::printf("|-----------|-------------------|-------:|------:|--------:|--------:|-------:|\n");
  measure_pairs("box-box", Kind::box, pairs, rounds);
  measure_pairs("hull-hull", Kind::hull, pairs, rounds);
  std::printf("\n| world   | boxes   | in a s    | hit %%   | growth  |\n");
  std::printf("|---------|--------:|----------:|--------:|--------:|\n");
  double last[2] = {};
  for (std::size_t count = 1000; count <= largest; count *= 10) measure_world(count, rounds, last);
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
