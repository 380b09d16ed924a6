// A bundle of pairs in lanes: shapes and poses gathered from where they stand. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "lanes/gather.hpp"
#include "narrow/core.hpp"
#include "narrow/pair_kernels.hpp"

namespace graze::GRAZE_ISA {

// The numbers of a shape, as its class holds them.
template <class T>
[[gnu::always_inline]] inline auto load(const void* const* rows, const Sphere<T>*) {
  static_assert(sizeof(Sphere<T>) == 4 * sizeof(T));
  Lanes<T> n[4];
  gather<T>(rows, 0, n);
  return Rounded<PointCore<Lanes<T>>, Lanes<T>>{{{n[0], n[1], n[2]}}, n[3]};
}
template <class T>
[[gnu::always_inline]] inline auto load(const void* const* rows, const Capsule<T>*) {
  static_assert(sizeof(Capsule<T>) == 3 * sizeof(T));
  using S = Lanes<T>;
  S n[2];
  gather<T>(rows, 0, n);
  return Rounded<AxisCore<S>, S>{{n[0]}, n[1]};
}
template <class T>
[[gnu::always_inline]] inline auto load(const void* const* rows, const Box<T>*) {
  static_assert(sizeof(Box<T>) == 3 * sizeof(T));
  Lanes<T> n[3];
  gather<T>(rows, 0, n);
  return Rounded<BoxCore<Lanes<T>>, Lanes<T>>{{{n[0], n[1], n[2]}}, Lanes<T>(0)};
}
template <class T>
[[gnu::always_inline]] inline auto load(const void* const* rows, const Triangle<T>*) {
  static_assert(sizeof(Triangle<T>) == 9 * sizeof(T));
  Lanes<T> n[4], m[4], last[1];
  gather<T>(rows, 0, n);
  gather<T>(rows, 4 * sizeof(T), m);
  gather<T>(rows, 8 * sizeof(T), last);
  return Rounded<TriangleCore<Lanes<T>>, Lanes<T>>{{{{n[0], n[1], n[2]}, {n[3], m[0], m[1]}, {m[2], m[3], last[0]}}},
                                                   Lanes<T>(0)};
}
/// A half-space is all in its pose.
struct Nothing {};
template <class T>
[[gnu::always_inline]] inline Nothing load(const void* const*, const HalfSpace<T>*) {
  return {};
}
template <class T>
[[gnu::always_inline]] inline Pose<Lanes<T>> load(const void* const* rows, const Pose<T>*) {
  static_assert(sizeof(Pose<T>) == 7 * sizeof(T));
  Lanes<T> t[4], q[4];  // a row of four is loaded at once, a row of three is not
  gather<T>(rows, 0, t);
  gather<T>(rows, 3 * sizeof(T), q);
  return {{t[0], t[1], t[2]}, {q[0], q[1], q[2], q[3]}};
}

/// A bundle of pairs of A and B, one a lane. Lanes without a pair repeat the last one.
template <class A, class B, class T>
struct PairBundle {
  using S = Lanes<T>;
  static constexpr std::size_t lanes = lanes_of<T>;

  std::size_t count;
  decltype(load(nullptr, static_cast<const A*>(nullptr))) a;
  decltype(load(nullptr, static_cast<const B*>(nullptr))) b;
  Pose<S> pose_a, pose_b;
  S margin;

  [[gnu::always_inline]] PairBundle(const PairRef<T>* pairs, std::size_t left) : count(left < lanes ? left : lanes) {
    const void* rows[4][lanes];
    for (std::size_t i = 0; i < lanes; ++i) {
      const PairRef<T>& pair = pairs[i < count ? i : count - 1];
      rows[0][i] = pair.a;
      rows[1][i] = pair.b;
      rows[2][i] = pair.pose_a;
      rows[3][i] = pair.pose_b;
      margin.set(static_cast<int>(i), pair.margin);
    }
    a = load(rows[0], static_cast<const A*>(nullptr));
    b = load(rows[1], static_cast<const B*>(nullptr));
    pose_a = load(rows[2], static_cast<const Pose<T>*>(nullptr));
    pose_b = load(rows[3], static_cast<const Pose<T>*>(nullptr));
  }
};

/// Writes the first `count` lanes, those that hold a pair, to a column of a block.
template <class T>
[[gnu::always_inline]] inline void put(T* column, const Lanes<T>& v, std::size_t count) {
  if (count == static_cast<std::size_t>(lanes_of<T>)) return v.store(column);
  for (std::size_t i = 0; i < count; ++i) column[i] = v[static_cast<int>(i)];
}

/// A lane, rounded to T.
template <class T, class S>
[[gnu::always_inline]] inline Vec3<T> lane(const Vec3<S>& v, int i) {
  return {static_cast<T>(v.x[i]), static_cast<T>(v.y[i]), static_cast<T>(v.z[i])};
}
/// Writes the lanes that hold a pair, of distances or of those of cores.
template <class T, class D>
[[gnu::always_inline]] inline void put(const D& d, std::size_t count, Distance<T>* to) {
  for (std::size_t k = 0; k < count; ++k) {
    const int i = static_cast<int>(k);
    to[k] = {static_cast<T>(d.distance[i]), lane<T>(d.normal, i), lane<T>(d.a, i), lane<T>(d.b, i)};
  }
}

/// Writes the points that were found of a bundle, the `first`-th pair's on, to a block of them.
template <class T, class Found>
[[gnu::always_inline]] inline void put(const Found& found, std::size_t first, std::size_t count,
                                       BoxPointBlock<T>& block) {
  const auto vector = [&](auto& columns, const Vec3<Lanes<T>>& v) {
    for (std::size_t k = 0; k < 3; ++k) put(columns[k] + first, v[k], count);
  };
  vector(block.normal, found.normal);
  put(block.filled + first, found.filled, count);
  put(block.known + first, found.known, count);
  for (std::size_t i = 0; i < most_block_points; ++i) {
    const auto& slot = found.slots[i];
    vector(block.slots[i].a, slot.a);
    vector(block.slots[i].b, slot.b);
    put(block.slots[i].distance + first, slot.distance, count);
    put(block.slots[i].part_a + first, slot.part_a, count);
    put(block.slots[i].part_b + first, slot.part_b, count);
  }
}

}  // namespace graze::GRAZE_ISA
