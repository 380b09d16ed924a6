// A bundle of pairs in lanes: shapes and poses gathered from the addresses in `PairRef`s. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/layouts.hpp"
#include "narrow/batch/pair_kernels.hpp"
#include "narrow/core/core.hpp"
#include "simd/gather.hpp"

namespace graze::GRAZE_ISA {

// The numbers of a shape, as its class holds them; `row(lane)` is the address of a lane's.
template <class T, class Row>
[[gnu::always_inline]] inline auto load(const Row& row, const Sphere<T>*) {
  Lanes<T> n[4];
  gather<T>(row, 0, n);
  return Rounded<PointCore<Lanes<T>>, Lanes<T>>{{{n[0], n[1], n[2]}}, n[3]};
}
template <class T, class Row>
[[gnu::always_inline]] inline auto load(const Row& row, const Capsule<T>*) {
  using S = Lanes<T>;
  S n[2];
  gather<T>(row, 0, n);
  return Rounded<AxisCore<S>, S>{{n[0]}, n[1]};
}
template <class T, class Row>
[[gnu::always_inline]] inline auto load(const Row& row, const Box<T>*) {
  Lanes<T> n[3];
  gather<T>(row, 0, n);
  return Rounded<BoxCore<Lanes<T>>, Lanes<T>>{{{n[0], n[1], n[2]}}, Lanes<T>(0)};
}
template <class T, class Row>
[[gnu::always_inline]] inline auto load(const Row& row, const Triangle<T>*) {
  Lanes<T> n[4], m[4], last[1];
  gather<T>(row, 0, n);
  gather<T>(row, 4 * sizeof(T), m);
  gather<T>(row, 8 * sizeof(T), last);
  return Rounded<TriangleCore<Lanes<T>>, Lanes<T>>{{{{n[0], n[1], n[2]}, {n[3], m[0], m[1]}, {m[2], m[3], last[0]}}},
                                                   Lanes<T>(0)};
}
template <class T, class Row>
[[gnu::always_inline]] inline auto load(const Row&, const HalfSpace<T>*) {
  return Rounded<PlaneCore, Lanes<T>>{{}, Lanes<T>(0)};
}
template <class T, class Row>
[[gnu::always_inline]] inline Pose<Lanes<T>> load(const Row& row, const Pose<T>*) {
  Lanes<T> t[4], q[4];  // a row of four is loaded at once, a row of three is not
  gather<T>(row, 0, t);
  gather<T>(row, 3 * sizeof(T), q);
  return {{t[0], t[1], t[2]}, {q[0], q[1], q[2], q[3]}};
}

/// A row function for unevaluated types.
struct Nowhere {
  const void* operator()(std::size_t lane) const;
};

/// A bundle of pairs of A and B, one a lane. Lanes without a pair repeat the last one.
template <class A, class B, class T>
struct PairBundle {
  using S = Lanes<T>;
  static constexpr std::size_t lanes = lanes_of<T>;

  std::size_t count;
  decltype(load(Nowhere(), static_cast<const A*>(nullptr))) a;
  decltype(load(Nowhere(), static_cast<const B*>(nullptr))) b;
  Pose<S> pose_a, pose_b;
  S margin;

  [[gnu::always_inline]] PairBundle(const PairRef<T>* pairs, std::size_t left) : count(left < lanes ? left : lanes) {
    // One test for empty lanes, not one for each lane.
    PairRef<T> filled[lanes];
    if (left < lanes) {
      for (std::size_t i = 0; i < lanes; ++i) filled[i] = pairs[i < left ? i : left - 1];
      pairs = filled;
    }
    for (std::size_t i = 0; i < lanes; ++i) margin.set(static_cast<int>(i), pairs[i].margin);
    const auto row = [pairs](auto member) __attribute__((always_inline)) {
      return [=](std::size_t lane) __attribute__((always_inline)) { return pairs[lane].*member; };
    };
    a = load(row(&PairRef<T>::a), static_cast<const A*>(nullptr));
    b = load(row(&PairRef<T>::b), static_cast<const B*>(nullptr));
    pose_a = load(row(&PairRef<T>::pose_a), static_cast<const Pose<T>*>(nullptr));
    pose_b = load(row(&PairRef<T>::pose_b), static_cast<const Pose<T>*>(nullptr));
  }
};

/// Writes the first `count` lanes, those with a pair, to a column of a block.
template <class T>
[[gnu::always_inline]] inline void put(T* column, const Lanes<T>& v, std::size_t count) {
  if (count == static_cast<std::size_t>(lanes_of<T>)) return v.store(column);
  for (std::size_t i = 0; i < count; ++i) column[i] = v[static_cast<int>(i)];
}

/// The vector of one lane, rounded to T.
template <class T, class S>
[[gnu::always_inline]] inline Vec3<T> lane(const Vec3<S>& v, int i) {
  return {static_cast<T>(v.x[i]), static_cast<T>(v.y[i]), static_cast<T>(v.z[i])};
}

}  // namespace graze::GRAZE_ISA
