// The pairs that the comparison asks every library about, described in numbers that each of them understands.
//
// Guarantee: the same pairs on every machine and from every compiler: integer random numbers, IEEE-exact arithmetic.
// Every number is a `float`, so that a library in single precision is given the same shapes as one in double.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "graze/pose.hpp"

namespace graze::bench {

enum class Kind { sphere, capsule, box, cylinder, cone, ellipsoid, hull, triangle, half_space };
inline constexpr std::size_t kind_count = 9;
inline constexpr const char* kind_names[kind_count] = {"sphere",    "capsule", "box",      "cylinder",  "cone",
                                                       "ellipsoid", "hull32",  "triangle", "half-space"};

/// A shape about its own origin, and where it stands. Heights run along Y, a cone's apex is on top; the half-space is
/// y <= 0.
struct Body {
  Kind kind{};
  Vec3d size{};                           ///< box: edge lengths; ellipsoid: radii; else x the radius, y the height
  std::vector<Vec3d> points;              ///< hull: 32 vertices; triangle: 3
  std::vector<std::array<int, 3>> faces;  ///< hull: its triangles, counter-clockwise seen from outside
  Posed pose{};

  /// The radius about the shape's own origin; 0 for the half-space.
  double reach() const;
};

struct Pair {
  Body a, b;
  /// What errors are measured by: the larger of the two radii.
  double size() const;
};

/// Tells of two bodies at two poses whether they touch; made once for two bodies, asked at several poses.
using Touching = std::function<bool(const Posed&, const Posed&)>;
using MakeTouching = std::function<Touching(const Body&, const Body&)>;

/// `count` pairs of these kinds, every other one overlapping: A is pushed along a random direction to where the two
/// just touch (by `make_touching`), and from there by up to a quarter of the size, in or out. All lengths are
/// multiplied by `scale`.
std::vector<Pair> make_pairs(Kind a, Kind b, std::size_t count, double scale, const MakeTouching& make_touching);

}  // namespace graze::bench
