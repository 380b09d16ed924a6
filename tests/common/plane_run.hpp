// The bits of answers in the plane as one number: of every query, alone and in batches, and of worlds that move.
//
// Guarantee: needs nothing but the library, and random numbers that every standard library makes the same.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "common/hash.hpp"
#include "graze/plane/batch.hpp"
#include "graze/plane/cast.hpp"
#include "graze/plane/simulation.hpp"

namespace graze::testing {

/// The hash of the run below, from every compiler, at every level of optimisation and of the instruction set, on every
/// processor. It changes only with the arithmetic of a kernel, and whoever changes that writes it anew.
template <class T>
inline constexpr std::uint64_t golden_plane_bits = 0;
template <>
inline constexpr std::uint64_t golden_plane_bits<float> = 9704311080204393405u;
template <>
inline constexpr std::uint64_t golden_plane_bits<double> = 11658807889925581475u;

}  // namespace graze::testing

namespace graze::plane::long_run {

using graze::testing::Hash;

/// Numbers of which the standard says every bit, as it does not of distributions.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(engine_() >> 32) % bound; }
  template <class T>
  T within(float reach) {
    return T(reach * (static_cast<float>(engine_() >> 40) * 0x1p-23f - 1));
  }
  template <class T>
  T size(float least, float reach) {
    return T(least) + std::abs(within<T>(reach));
  }
  template <class T>
  Vec2<T> vector(float reach) {
    const T x = within<T>(reach);
    return {x, within<T>(reach)};
  }
  template <class T>
  Pose2<T> pose(float reach) {
    const Vec2<T> at = vector<T>(reach), turn = vector<T>(1);
    return {at, below(3) == 0 ? Rot2<T>{} : normalized(Rot2<T>{turn.x, turn.y})};
  }

 private:
  std::mt19937_64 engine_;
};

/// A square, as a shape of the user's own.
template <class T>
class Square final : public SupportFunction<T> {
 public:
  Vec2<T> support(const Vec2<T>& d) const override { return {d.x < T(0) ? T(-1) : T(1), d.y < T(0) ? T(-1) : T(1)}; }
};

template <class T>
std::vector<Vec2<T>> points(std::uint32_t count, Random& random) {
  std::vector<Vec2<T>> out;
  for (std::uint32_t i = 0; i < count; ++i) out.push_back(random.vector<T>(1));
  return out;
}

inline constexpr std::uint32_t kinds = 12;

/// A shape of each kind in turn, every fourth rounded.
template <class T>
Shape<T> shape(std::uint32_t i, Random& random) {
  const T w = random.size<T>(0.2f, 1), h = random.size<T>(0.2f, 1), r = random.size<T>(0.1f, 0.5f);
  const T rounding = random.below(4) == 0 ? r / T(4) : T(0);
  switch (i % kinds) {
  case 0: return {Circle<T>(r), rounding};
  case 1: return {Box<T>({w, h}), rounding};
  case 2: return {Capsule<T>(w, r), rounding};
  case 3: return {Capsule<T>(w, r, r / T(2)), rounding};
  case 4: return {Segment<T>({-w, h}, {h, -r}), rounding};
  case 5: return {ConvexPolygon<T>(points<T>(6 + random.below(3), random)), rounding};
  case 6: return {ConvexPolygon<T>(points<T>(100, random)), rounding};
  case 7: return {Ellipse<T>({w, h}), rounding};
  case 8: return {Polygon<T>(std::vector<Vec2<T>>{{-w, -h}, {w, -h}, {w, h}, {T(0), -h / T(2)}, {-w, h}}), rounding};
  case 9:
    return {Chain<T>(std::vector<Vec2<T>>{{-w, h}, {T(0), T(0)}, {w, h}, {T(2) * w, h}}, false,
                     random.below(2) == 0 ? ChainSides::one : ChainSides::both),
            rounding};
  case 10: return Compound<T>({{Box<T>({w, h}), {{-w, T(0)}, {}}}, {Circle<T>(r), {{w, T(0)}, {}}}});
  default: return random.below(4) == 0 ? Shape<T>(HalfPlane<T>()) : UserConvex<T>(std::make_shared<Square<T>>());
  }
}

template <class T>
void add(Hash& hash, const Distance<T>& d) {
  hash.add(d.distance), hash.add(d.normal), hash.add(d.a), hash.add(d.b);
}
template <class T>
void add(Hash& hash, const ContactPoint<T>& p) {
  hash.add(p.a), hash.add(p.b), hash.add(p.distance), hash.add(p.feature), hash.add(p.weight);
}
template <class T>
void add(Hash& hash, const std::optional<RayHit<T>>& hit) {
  hash.add(hit.has_value());
  if (hit) hash.add(hit->t), hash.add(hit->point), hash.add(hit->normal), hash.add(hit->piece);
}
template <class T>
void add(Hash& hash, const std::optional<CastHit<T>>& hit) {
  hash.add(hit.has_value());
  if (hit) hash.add(hit->t), hash.add(hit->point), hash.add(hit->normal), hash.add(hit->depth);
}

/// Shapes of all kinds in place, and pairs of them.
template <class T>
struct Scene {
  std::vector<Shape<T>> shapes;
  std::vector<Pose2<T>> poses;
  std::vector<IdPair> pairs;

  explicit Scene(Random& random) {
    for (std::uint32_t i = 0; i < 20 * kinds; ++i) {
      shapes.push_back(shape<T>(i, random));
      poses.push_back(random.pose<T>(1.5f));
    }
    for (int i = 0; i < 6000; ++i) {
      const std::uint32_t a = random.below(20 * kinds);
      pairs.push_back({a, random.below(20 * kinds)});
    }
  }
};

template <class T>
void add_batches(Hash& hash, const Scene<T>& scene) {
  const Bodies<T> bodies(scene.shapes, scene.poses);
  const Batch<T> batch(bodies, bodies, scene.pairs);
  std::vector<std::uint8_t> touch;
  std::vector<Distance<T>> distances;
  BatchContacts<T> found;
  overlap(batch, touch);
  distance(batch, distances);
  contacts(batch, T(0.05f), found);
  for (const std::uint8_t t : touch) hash.add(t);
  for (const auto& d : distances) add(hash, d);
  // Pair by pair: which of them stand beside each other in the arrays is a matter of the kernels.
  for (std::size_t i = 0; i < batch.size(); ++i)
    for (const auto& m : found.manifolds_of(i)) {
      hash.add(m.normal), hash.add(m.piece_a), hash.add(m.piece_b);
      for (const auto& p : found.points_of(m)) add(hash, p);
    }
}

/// One question of each other sort for some of the pairs.
template <class T>
void add_queries(Hash& hash, const Scene<T>& scene, Random& random) {
  for (std::size_t i = 0; i < scene.pairs.size(); i += 8) {
    const auto [a, b] = scene.pairs[i];
    const Shape<T>&shape_a = scene.shapes[a], &shape_b = scene.shapes[b];
    const Pose2<T>&at_a = scene.poses[a], &at_b = scene.poses[b];
    const Vec2<T> point = random.vector<T>(3), along = random.vector<T>(1);
    const Closest<T> near = closest(shape_a, at_a, point);
    hash.add(near.distance), hash.add(near.point), hash.add(near.normal);
    add(hash, raycast(shape_a, at_a, {point, along}));
    const Pose2<T> from{at_b.translation + point * T(2), at_b.rotation};
    const T turn = random.below(2) == 0 ? T(0) : random.within<T>(2);
    add(hash, cast<T>(shape_a, at_a, {}, shape_b, from, {point * T(-2), turn}, T(2)));
  }
}

template <class T>
void add_ray_batches(Hash& hash, const Scene<T>& scene, Random& random) {
  std::vector<Ray<T>> rays;
  for (int i = 0; i < 50; ++i) {
    const Vec2<T> from = random.vector<T>(3);
    rays.push_back({from, random.vector<T>(1)});
  }
  std::vector<std::optional<RayHit<T>>> hits(rays.size());
  for (std::size_t i = 0; i < scene.shapes.size(); i += 2) {
    raycast<T>(scene.shapes[i], scene.poses[i], rays, hits);
    for (const auto& hit : hits) add(hash, hit);
  }
}

/// Bodies of all kinds that fall into a valley, for a second.
template <class T>
void add_simulation(Hash& hash, Random& random) {
  Simulation<T> simulation;
  Body<T> valley{
      Chain<T>(std::vector<Vec2<T>>{{T(12), T(6)}, {T(5), T(0.5f)}, {T(0), T(0)}, {T(-5), T(0.5f)}, {T(-12), T(6)}})};
  valley.fixed = true;
  simulation.add(valley);
  std::vector<BodyId> ids;
  for (std::uint32_t i = 0; i < 60; ++i) {
    // Lines have no mass, half-planes no end.
    const bool solid = i % kinds != 4 && i % kinds != 9 && i % kinds != 11;
    Pose2<T> at = random.pose<T>(4);
    at.translation.y += T(5);
    ids.push_back(simulation.add({shape<T>(solid ? i : 0, random), at, random.vector<T>(2), random.within<T>(2)}));
  }
  const T step = T(1) / T(64);
  for (int i = 0; i < 64; ++i) simulation.step(step);
  for (const BodyId id : ids) {
    const Pose2<T>& at = simulation.poses()[id.index];
    hash.add(at.translation), hash.add(at.rotation.cosine), hash.add(at.rotation.sine);
  }
}

}  // namespace graze::plane::long_run

namespace graze::testing {

template <class T>
std::uint64_t hash_of_a_plane_run() {
  using namespace plane::long_run;
  Hash hash;
  for (unsigned seed = 30; seed < 34; ++seed) {
    Random random(seed);
    const Scene<T> scene(random);
    add_batches(hash, scene);
    add_queries(hash, scene, random);
    add_ray_batches(hash, scene, random);
    add_simulation<T>(hash, random);
  }
  return hash.value();
}

}  // namespace graze::testing
