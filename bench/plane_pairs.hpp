// Pairs of shapes of the plane to be measured, and how they are.
//
// Pairs: numbers of PCG32 (seed 42, the first two thrown away). Of each shape h and w in [0.25, 1): circles of radius
// h, capsules of half length h and radius w / 2, boxes of half sizes h and w (rounded ones by 0.1), polygons on
// circles of radius h, each vertex up to a fifth of a step off; the centres so far apart that half the pairs overlap.
// Stacked boxes stand edge on edge, up to 5 mm apart or deep and 0.01 rad tilted. Where something moves, B starts 4 m
// off on the line of centres, up to 1.8 m beside it, and goes 8 m along that line; where it turns, by up to 0.7 rad.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "graze/plane/batch.hpp"
#include "graze/plane/cast.hpp"

namespace graze::plane {

enum class Kind { circle, capsule, box, rounded_box, hexagon, octagon, segment };

struct Item {
  Shapef shape = Circle<float>(1);
  double radius = 1;  ///< that bounds it
  Vec2d half{};
  std::vector<Vec2f> vertices{};
};

/// Pairs of a row of the table.
struct Pairs {
  std::vector<Item> items_a, items_b;
  std::vector<Shapef> a, b;
  std::vector<Pose2f> pose_a, pose_b;
  std::vector<Pose2f> start_b;            ///< from where B moves
  std::vector<Velocity<float>> motion_b;  ///< and how, in a unit of time
};

/// The centres are up to `spread` times the bounding radii apart.
Pairs make_pairs(Kind kind_a, Kind kind_b, double spread, bool stacked, std::size_t count);

struct Options {
  std::size_t pairs = 100000, cached = 2000, rounds = 12, steps = 600;
  double scale = 1;
};

/// The least time of a pair, in ns, of `turns` passes over `count` pairs.
double least_time(const Options& options, std::size_t count, std::size_t turns, const std::function<void()>& pass);

inline volatile double kept = 0;  ///< what answers add up to, so that none is left out

/// How many times a small number of pairs is gone through in a round.
inline std::size_t turns_of(std::size_t count) { return std::max<std::size_t>(1, 40000 / count); }

/// Calls `f` for each of the first `count` pairs.
template <class F>
auto for_each_of(std::size_t count, const F& f) {
  return [=] {
    for (std::size_t i = 0; i < count; ++i) f(i);
  };
}

/// A row of the table of contacts and distances, and one of casts, times of impact and rays.
void print_contacts_row(const Options& options, const std::string& name, const Pairs& pairs);
void print_motion_head();
void print_motion_row(const Options& options, const std::string& name, const Pairs& pairs);
/// A line on casts of pairs of all rows in no order.
void print_mixed_casts(const Options& options, const std::vector<Pairs>& rows);

}  // namespace graze::plane
