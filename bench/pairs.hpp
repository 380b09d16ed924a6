// The pairs that every library is asked about, described in numbers that each of them understands.
//
// Guarantee: the same pairs on every machine and from every compiler: integer random numbers, IEEE-exact arithmetic.
// Every number is a `float`, so that a library in single precision is given the same shapes as one in double.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "graze/pose.hpp"

namespace graze::bench {

/// Meshes stand behind those that are paired with each other.
enum class Kind { sphere, capsule, box, cylinder, cone, ellipsoid, hull, triangle, half_space, mesh };
inline constexpr std::size_t kind_count = 9;
inline constexpr const char* kind_names[kind_count] = {"sphere",    "capsule", "box",      "cylinder",  "cone",
                                                       "ellipsoid", "hull32",  "triangle", "half-space"};

/// The vertices of a hull, of a triangle or of a mesh.
struct Corners {
  std::vector<Vec3d> points;
  std::vector<std::array<int, 3>> faces;  ///< triangles, counter-clockwise seen from outside
};

/// A shape about its own origin, and where it stands. Heights run along Y, a cone's apex is on top; the half-space is
/// y <= 0.
struct Body {
  Kind kind{};
  Vec3d size{};                              ///< box: edge lengths; ellipsoid: radii; else x the radius, y the height
  std::shared_ptr<const Corners> corners{};  ///< of hulls, triangles and meshes, which may share them
  Posed pose{};

  /// The radius about the shape's own origin; 0 for the half-space and for meshes, on which bodies are small.
  double reach() const;
};

struct Pair {
  Body a, b;
  /// What A moves by for a cast; for a ray, which begins at B's place and meets A, the way from its begin to its end.
  Vec3d motion{};

  /// What errors are measured by: the larger of the two radii.
  double size() const;
};

/// Tells of two bodies at two poses whether they touch; made once for two bodies, asked at several poses.
using Touching = std::function<bool(const Posed&, const Posed&)>;
using MakeTouching = std::function<Touching(const Body&, const Body&)>;

/// `count` pairs of these kinds, every other one overlapping: A is pushed along a random direction to where the two
/// just touch (by `make_touching`), and from there by up to a quarter of the size, in or out. All lengths are
/// multiplied by `scale`. There are no more different hulls and triangles than `different`, shared by all pairs.
std::vector<Pair> make_pairs(Kind a, Kind b, std::size_t count, double scale, const MakeTouching& make_touching,
                             std::size_t different = std::numeric_limits<std::size_t>::max());

/// Boxes nearly face to face, as in a stack: A on a face of B, turned about its normal at will, tilted by up to a
/// degree, the middle of
/// the faces between 0.02 deep and 0.01 apart, half edges of 0.2 to 1.
std::vector<Pair> make_stacked(std::size_t count);

/// Pairs with hulls of so many vertices in place of 32; else as `make_pairs` at scale 1.
std::vector<Pair> make_hull_pairs(std::size_t vertices, std::size_t count, const MakeTouching& make_touching,
                                  std::size_t different);

/// Bodies of a kind, half edges and radii 0.25 to 1, at the surface of one mesh: a ball of radius 10 with bumps, of
/// 70,688 triangles. Their middles are up to 0.5 of their least half edge inside and up to 1.5 outside.
std::vector<Pair> make_on_mesh(Kind kind, std::size_t count, std::size_t different);

/// Two of a kind, boxes or hulls; A moves past B so that about every other pair meets on the way.
std::vector<Pair> make_ways(Kind kind, std::size_t count,
                            std::size_t different = std::numeric_limits<std::size_t>::max());

/// Rays at shapes of a kind, A; about every other one hits. B, where they begin, is a small ball.
std::vector<Pair> make_rays(Kind kind, std::size_t count,
                            std::size_t different = std::numeric_limits<std::size_t>::max());

}  // namespace graze::bench
