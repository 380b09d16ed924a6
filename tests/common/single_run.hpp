// The bits of answers to one question each, in space, as one number: of every query at shapes of every kind.
//
// Guarantee: needs nothing but the library, and random numbers that every standard library makes the same.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "common/hash.hpp"
#include "graze/cast.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"

namespace graze::testing {

/// The hash of the run below, from every compiler, at every level of optimisation and of the instruction set, on every
/// processor. It changes only with the arithmetic of a query, and whoever changes that writes it anew.
template <class T>
inline constexpr std::uint64_t golden_single_bits = 0;
template <>
inline constexpr std::uint64_t golden_single_bits<float> = 9669195406108903504u;
template <>
inline constexpr std::uint64_t golden_single_bits<double> = 1283458823056977205u;

/// Shapes of every kind, poses, and questions about them.
template <class T>
class SingleRun {
 public:
  std::uint64_t hash() {
    const std::vector<Shape<T>> shapes = all_shapes();
    for (const Shape<T>& a : shapes) {
      for (int i = 0; i < 40; ++i) ask_alone(a, pose(1));
      for (const Shape<T>& b : shapes)
        for (int i = 0; i < 6; ++i) {
          const Pose<T> at_a = pose(0.7f), at_b = pose(0.7f);
          ask_pair(a, at_a, b, at_b);
        }
    }
    return hash_.value();
  }

 private:
  T within(float reach) { return T(reach * (static_cast<float>(random_() >> 40) * 0x1p-23f - 1)); }
  Vec3<T> vector(float reach) {
    const T x = within(reach), y = within(reach);
    return {x, y, within(reach)};
  }
  Pose<T> pose(float reach) {
    const Vec3<T> at = vector(reach), axis = vector(1);
    return {at, normalized(Quat<T>{axis.x, axis.y, axis.z, within(1)})};
  }

  /// A square of hills, as heights and as triangles.
  std::pair<HeightField<T>, Mesh<T>> hills() {
    constexpr std::uint32_t side = 6;
    std::vector<T> heights;
    std::vector<Vec3<T>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t row = 0; row < side; ++row)
      for (std::uint32_t column = 0; column < side; ++column) {
        heights.push_back(within(0.2f));
        points.push_back({T(column) * T(0.5f), heights.back(), T(row) * T(0.5f)});
        if (row == 0 || column == 0) continue;
        const std::uint32_t d = row * side + column, c = d - 1, b = d - side, a = b - 1;
        triangles.push_back({a, c, b});
        triangles.push_back({b, c, d});
      }
    return {HeightField<T>(side, side, heights, T(0.5f), T(0.5f)), Mesh<T>(points, triangles)};
  }

  std::vector<Shape<T>> all_shapes() {
    std::vector<Vec3<T>> cloud;
    for (int i = 0; i < 12; ++i) cloud.push_back(vector(0.8f));
    const Box<T> box({T(1), T(0.5f), T(1.5f)});
    auto [field, mesh] = hills();
    return {Sphere<T>(T(0.5f), {T(0.25f), T(0), T(0)}),
            Capsule<T>(T(1), T(0.25f)),
            Capsule<T>(T(1), T(0.25f), T(0.5f)),
            box,
            {box, T(0.125f)},
            Rectangle<T>(T(1), T(2)),
            Cylinder<T>(T(1), T(0.5f)),
            Cylinder<T>(T(1), T(0.75f), T(0)),
            Ellipsoid<T>({T(0.5f), T(0.25f), T(0.75f)}),
            LineSegment<T>({T(-1), T(0), T(0)}, {T(1), T(0.5f), T(0)}),
            Triangle<T>({T(-1), T(0), T(0)}, {T(1), T(0), T(0.25f)}, {T(0), T(1), T(0.5f)}),
            ConvexHull<T>(cloud),
            HalfSpace<T>(),
            field,
            mesh,
            Compound<T>({{box, {{T(-0.5f), T(0), T(0)}, {}}}, {Sphere<T>(T(0.5f)), {{T(0.75f), T(0), T(0)}, {}}}})};
  }

  void ask_alone(const Shape<T>& shape, const Pose<T>& at) {
    const Ray<T> ray{vector(4), vector(1)};
    const std::optional<RayHit<T>> hit = raycast(shape, at, ray);
    hash_.add(hit.has_value());
    if (hit) hash_.add(hit->t), hash_.add(hit->point), hash_.add(hit->normal), hash_.add(hit->piece);
    const Closest<T> near = closest(shape, at, vector(2));
    hash_.add(near.distance), hash_.add(near.point), hash_.add(near.normal);
  }

  void ask_pair(const Shape<T>& a, const Pose<T>& at_a, const Shape<T>& b, const Pose<T>& at_b) {
    hash_.add(overlap(a, at_a, b, at_b));
    const Distance<T> apart = distance(a, at_a, b, at_b);
    hash_.add(apart.distance), hash_.add(apart.normal), hash_.add(apart.a), hash_.add(apart.b);
    manifolds_.clear();
    contacts(a, at_a, b, at_b, T(0.05f), manifolds_);
    for (const auto& m : manifolds_) {
      hash_.add(m.normal);
      for (const auto& p : m.points) hash_.add(p.a), hash_.add(p.b), hash_.add(p.distance), hash_.add(p.feature);
    }
    const Vec3<T> start = vector(4);
    const std::optional<CastHit<T>> hit =
        cast(a, at_a, {}, b, {start, at_b.rotation}, {at_a.translation - start, {}}, T(2));
    hash_.add(hit.has_value());
    if (hit) hash_.add(hit->t), hash_.add(hit->point), hash_.add(hit->normal);
  }

  std::mt19937_64 random_{1};
  Hash hash_;
  Manifolds<T> manifolds_;
};

template <class T>
std::uint64_t hash_of_a_single_run() {
  return SingleRun<T>().hash();
}

}  // namespace graze::testing
