// A bundle of pairs in lanes: shapes and poses gathered from the addresses in `PairRef`s. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/load_shapes.hpp"
#include "narrow/batch/pair_kernels.hpp"

namespace graze::GRAZE_ISA {

/// A bundle of pairs of A and B, one a lane. Lanes without a pair repeat the last one.
template <class A, class B, class T>
struct PairBundle {
  using S = Lanes<T>;
  static constexpr std::size_t lanes = lanes_of<T>;

  std::size_t count;
  decltype(LoadedShapes<A, T>::shapes) a;
  decltype(LoadedShapes<B, T>::shapes) b;
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
      return scattered<T>([=](std::size_t lane) __attribute__((always_inline)) { return pairs[lane].*member; });
    };
    a = load(row(&PairRef<T>::a), static_cast<const A*>(nullptr)).shapes;
    b = load(row(&PairRef<T>::b), static_cast<const B*>(nullptr)).shapes;
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
