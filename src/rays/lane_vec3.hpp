// Vectors of lanes to and from memory. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level; numbers are copied only.
#pragma once

#include "graze/vec3.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

/// The vectors from index `at` on of arrays of coordinates.
template <class S, class N>
[[gnu::always_inline]] inline Vec3<S> load_vec3(const N (&from)[3], std::size_t at) {
  return {S::load(from[0] + at), S::load(from[1] + at), S::load(from[2] + at)};
}
template <class S, class N>
[[gnu::always_inline]] inline void store(const Vec3<S>& v, N (&to)[3], std::size_t at) {
  v.x.store(to[0] + at);
  v.y.store(to[1] + at);
  v.z.store(to[2] + at);
}
/// One vector in all lanes.
template <class S>
[[gnu::always_inline]] inline Vec3<S> broadcast(const double (&v)[3]) {
  return {S(v[0]), S(v[1]), S(v[2])};
}

/// The number `which` of consecutive records of `stride` numbers, from the record `from` on; that of record `last` for
/// any beyond it.
template <int stride, class T>
[[gnu::always_inline]] inline Lanes<double> column(const T* records, std::size_t from, std::size_t last,
                                                   std::size_t which) {
  constexpr int lanes = Lanes<double>::lanes;
  typedef T Narrow __attribute__((vector_size(sizeof(T) * lanes)));
  const auto at = [&](std::size_t i) __attribute__((always_inline)) {
    const std::size_t place = from + i;
    return records[stride * (place < last ? place : last) + which];
  };
  Narrow n;
  if constexpr (lanes == 8)
    n = Narrow{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
  else if constexpr (lanes == 4)
    n = Narrow{at(0), at(1), at(2), at(3)};
  else
    n = Narrow{at(0), at(1)};
  return Lanes<double>::of(__builtin_convertvector(n, Lanes<double>::Vector));
}

}  // namespace graze::GRAZE_ISA
