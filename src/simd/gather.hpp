// Rows of a few numbers that stand scattered in memory, loaded into lanes: each from a place of its own, transposed in
// registers; and the way back. Only for `*.kernel.cpp`.
//
// Guarantee: reads and writes these numbers and nothing behind them.
#pragma once

#include <cstdint>
#include <cstring>
#include <utility>

#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace gathering {

template <class T, std::size_t N>
struct Vector {
  typedef T type __attribute__((vector_size(N * sizeof(T))));
};
template <class T>
using Four = typename Vector<T, 4>::type;

/// `count` numbers, and zeros, put together in registers: g++ puts three copied into four together in memory, and
/// reading back more at once than was written waits for the writes.
template <class T, std::size_t count>
[[gnu::always_inline]] inline Four<T> row_of(const char* from) {
  Four<T> row{};
  if constexpr (count == 4) {
    std::memcpy(&row, from, sizeof row);
  } else if constexpr (count >= 2 && sizeof(T) == 4) {
    typedef std::int64_t Halves __attribute__((vector_size(16)));
    std::int64_t two;
    std::memcpy(&two, from, sizeof two);
    row = reinterpret_cast<Four<T>>(Halves{two, 0});
  } else if constexpr (count >= 2) {
    typename Vector<T, 2>::type two;
    std::memcpy(&two, from, sizeof two);
    row = __builtin_shufflevector(two, typename Vector<T, 2>::type{}, 0, 1, 2, 3);
  }
  if constexpr (count % 2 == 1) {
    T last;
    std::memcpy(&last, from + (count - 1) * sizeof last, sizeof last);
    row[count - 1] = last;
  }
  return row;
}

template <class V, std::size_t... I>
[[gnu::always_inline]] inline auto joined(const V& a, const V& b, std::index_sequence<I...>) {
  return __builtin_shufflevector(a, b, I...);
}
/// Rows `first`, `first + 4`, `first + 8` and so on, one behind the other.
template <class T, std::size_t N>
[[gnu::always_inline]] inline typename Vector<T, N>::type every_fourth(const Four<T>* rows) {
  if constexpr (N == 4)
    return rows[0];
  else
    return joined(every_fourth<T, N / 2>(rows), every_fourth<T, N / 2>(rows + N / 2), std::make_index_sequence<N>());
}
/// The first two or the last two of each four numbers of `a` and `b`, in turns.
template <std::size_t Half, class V, std::size_t... I>
[[gnu::always_inline]] inline V interleaved(const V& a, const V& b, std::index_sequence<I...>) {
  constexpr std::size_t n = sizeof...(I);
  return __builtin_shufflevector(a, b, (I / 4 * 4 + Half * 2 + I % 4 / 2 + (I % 2) * n)...);
}
/// The first two or the last two of each four numbers of `a` and then of `b`.
template <std::size_t Half, class V, std::size_t... I>
[[gnu::always_inline]] inline V paired(const V& a, const V& b, std::index_sequence<I...>) {
  constexpr std::size_t n = sizeof...(I);
  return __builtin_shufflevector(a, b, (I / 4 * 4 + Half * 2 + I % 2 + (I % 4 / 2) * n)...);
}

/// The columns of four rows of four numbers each, which stand side by side in the vectors' fours.
template <class V, std::size_t... I>
[[gnu::always_inline]] inline void transpose(const V& r0, const V& r1, const V& r2, const V& r3, V (&out)[4],
                                             std::index_sequence<I...> all) {
  const V low01 = interleaved<0>(r0, r1, all), low23 = interleaved<0>(r2, r3, all),
          high01 = interleaved<1>(r0, r1, all), high23 = interleaved<1>(r2, r3, all);
  out[0] = paired<0>(low01, low23, all);
  out[1] = paired<1>(low01, low23, all);
  out[2] = paired<0>(high01, high23, all);
  out[3] = paired<1>(high01, high23, all);
}

}  // namespace gathering

/// `count` <= 4 numbers of type T at byte `offset` of each lane's row, which `row(lane)` points to, each number in a
/// `Lanes` of its own.
template <class T, class Row, std::size_t count>
[[gnu::always_inline]] inline void gather(const Row& row, std::size_t offset, Lanes<T> (&out)[count]) {
  constexpr std::size_t lanes = lanes_of<T>;
  const auto at = [&](std::size_t lane) __attribute__((always_inline)) {
    const void* const start = row(lane);
    return static_cast<const char*>(start) + offset;
  };
  if constexpr (lanes >= 4) {
    using namespace gathering;
    Four<T> loaded[lanes];
    for (std::size_t i = 0; i < lanes; ++i) loaded[i] = row_of<T, count>(at(i));
    typename Vector<T, lanes>::type columns[4];
    transpose(every_fourth<T, lanes>(loaded), every_fourth<T, lanes>(loaded + 1), every_fourth<T, lanes>(loaded + 2),
              every_fourth<T, lanes>(loaded + 3), columns, std::make_index_sequence<lanes>());
    for (std::size_t k = 0; k < count; ++k) out[k] = Lanes<T>::of(columns[k]);
  } else {
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < lanes; ++i) {
        T value;
        std::memcpy(&value, at(i) + k * sizeof(T), sizeof value);
        out[k].set(static_cast<int>(i), value);
      }
  }
}

/// Writes four numbers of each lane, a row of four for each, the rows `stride` bytes apart.
[[gnu::always_inline]] inline void scatter(const Lanes<float>& x, const Lanes<float>& y, const Lanes<float>& z,
                                           const Lanes<float>& w, void* to, std::size_t stride) {
  using namespace gathering;
  constexpr std::size_t lanes = lanes_of<float>;
  typename Vector<float, lanes>::type rows[4];
  transpose(x.v, y.v, z.v, w.v, rows, std::make_index_sequence<lanes>());
  // The i-th four of rows[k] belongs to lane 4 i + k.
  for (std::size_t i = 0; i < lanes; ++i)
    std::memcpy(static_cast<char*>(to) + i * stride, reinterpret_cast<const float*>(&rows[i % 4]) + i / 4 * 4, 16);
}

}  // namespace graze::GRAZE_ISA
