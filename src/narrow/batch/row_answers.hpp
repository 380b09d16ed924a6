// Results of lanes for pairs in rows with one answer a pair: overlap or distance. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/row_bundle.hpp"

namespace graze::GRAZE_ISA {

/// Writes the first `count` lanes.
template <class T>
[[gnu::always_inline]] inline void put(const CoreDistance<Lanes<T>>& d, std::size_t count, Distance<T>* to) {
  using Found = Distance<T>;
  if constexpr (sizeof(T) == 4) {
    constexpr std::size_t lanes = lanes_of<T>;
    const auto store = [&](void* where) __attribute__((always_inline)) {
      char* const rows = static_cast<char*>(where);
      const Lanes<T> converged(T(0)), error(T(0));
      scatter(d.distance, d.normal.x, d.normal.y, d.normal.z, rows, sizeof(Found));
      scatter(d.a.x, d.a.y, d.a.z, d.b.x, rows + 16, sizeof(Found));
      scatter(d.b.y, d.b.z, converged, error, rows + 32, sizeof(Found));
    };
    if (count == lanes) return store(to);
    char some[lanes * sizeof(Found)];
    store(some);
    std::memcpy(static_cast<void*>(to), some, count * sizeof(Found));
  } else {
    const auto vector = [](const Vec3<Lanes<T>>& v, int i) { return Vec3<T>{v.x[i], v.y[i], v.z[i]}; };
    for (std::size_t k = 0; k < count; ++k) {
      const int i = static_cast<int>(k);
      to[k] = {d.distance[i], vector(d.normal, i), vector(d.a, i), vector(d.b, i)};
    }
  }
}

/// Visits the rows a bundle at a time: `answer(bundle, filled, first)` writes the answers to the pairs from the
/// `first`-th on in the `filled` lanes that hold one, and returns the lanes in which they are known. Returns the number
/// of unknown ones, whose indices are written to `unknown`.
template <class A, class B, class T, class Answer>
inline std::uint32_t answer_rows(const PairRows<T>& rows, std::size_t count, std::uint8_t* unknown,
                                 const Answer& answer) {
  constexpr std::size_t lanes = lanes_of<T>;
  std::uint32_t all_unknown = 0;
  for (std::size_t first = 0; first < count; first += lanes) {
    const auto known = answer(RowBundle<A, B, T>(rows, first), least(lanes, count - first), first);
    append_places(bits_of(!known) & filled_lanes<T>(count - first), first, unknown, all_unknown);
  }
  return all_unknown;
}

}  // namespace graze::GRAZE_ISA
