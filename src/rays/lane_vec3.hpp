// Vectors of lanes, for kernels: `Vec3`'s operations, in its order of evaluation. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level; a lane has the bits of `Vec3`'s scalar.
#pragma once

#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

template <class S>
struct Lane3 {
  S x, y, z;

  template <class N>
  [[gnu::always_inline]] static Lane3 load(const N (&from)[3], std::size_t at) {
    return {S::load(from[0] + at), S::load(from[1] + at), S::load(from[2] + at)};
  }
  [[gnu::always_inline]] static Lane3 all(const double (&v)[3]) { return {S(v[0]), S(v[1]), S(v[2])}; }
  template <class N>
  [[gnu::always_inline]] void store(N (&to)[3], std::size_t at) const {
    x.store(to[0] + at);
    y.store(to[1] + at);
    z.store(to[2] + at);
  }
  [[gnu::always_inline]] friend Lane3 operator+(const Lane3& a, const Lane3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend Lane3 operator-(const Lane3& a, const Lane3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] friend Lane3 operator-(const Lane3& a) { return {-a.x, -a.y, -a.z}; }
  [[gnu::always_inline]] friend Lane3 operator*(const Lane3& a, const S& s) { return {a.x * s, a.y * s, a.z * s}; }
  [[gnu::always_inline]] friend Lane3 operator/(const Lane3& a, const S& s) { return {a.x / s, a.y / s, a.z / s}; }
};

template <class S>
[[gnu::always_inline]] inline S dot(const Lane3<S>& a, const Lane3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
[[gnu::always_inline]] inline Lane3<S> cross(const Lane3<S>& a, const Lane3<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class S>
[[gnu::always_inline]] inline S length(const Lane3<S>& v) {
  return sqrt(dot(v, v));
}
template <class S>
[[gnu::always_inline]] inline S max_abs(const Lane3<S>& v) {
  return greatest(abs(v.x), greatest(abs(v.y), abs(v.z)));
}
template <class M, class S>
[[gnu::always_inline]] inline Lane3<S> select(const M& condition, const Lane3<S>& yes, const Lane3<S>& no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y), select(condition, yes.z, no.z)};
}
template <class S>
[[gnu::always_inline]] inline Lane3<S> normalized(const Lane3<S>& v, const Lane3<S>& fallback) {
  const S scale = max_abs(v);
  const auto nonzero = scale > S(0);
  const Lane3<S> w = v / select(nonzero, scale, S(1));
  return select(nonzero, w / select(nonzero, length(w), S(1)), fallback);
}
/// By the unit quaternion `vector`, `w`.
template <class S>
[[gnu::always_inline]] inline Lane3<S> rotate(const Lane3<S>& vector, const S& w, const Lane3<S>& v) {
  const Lane3<S> t = cross(vector, v) * S(2);
  return v + t * w + cross(vector, t);
}

/// The number `which` of each of some records of `stride` numbers that lie one behind the other from `from` on; that of
/// the one in the place `last` for any beyond it.
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
