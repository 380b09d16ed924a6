// Structs of numbers, a lane of each from a place of its own, as one struct of lanes: `Vec3<float>`s as a
// `Vec3<Lanes<float>>`. Only for `*.kernel.cpp`.
//
// Guarantee: reads and writes the structs and nothing behind them.
#pragma once

#include "simd/gather.hpp"
#include "simd/lane_of.hpp"

namespace graze::GRAZE_ISA {

/// The number of lanes of a scalar or a lane type.
template <class S>
inline constexpr std::size_t lanes_in = sizeof(S) / sizeof(typename LaneOf<S>::type);

namespace gathering {

template <class T, std::size_t first, std::size_t count, class Row>
[[gnu::always_inline]] inline void gather_numbers(const Row& row, Lanes<T> (&numbers)[count]) {
  constexpr std::size_t here = count - first < 4 ? count - first : 4;
  Lanes<T> part[here];
  gather<T>(row, first * sizeof(T), part);
  for (std::size_t k = 0; k < here; ++k) numbers[first + k] = part[k];
  if constexpr (first + here < count) gather_numbers<T, first + here>(row, numbers);
}

/// Writes `count` <= 4 numbers of each lane to its row.
template <class T, std::size_t count, class Row>
[[gnu::always_inline]] inline void scatter_part(const Lanes<T>* numbers, const Row& row, std::size_t offset) {
  constexpr std::size_t lanes = lanes_of<T>;
  const auto at = [&](std::size_t lane) __attribute__((always_inline)) {
    return static_cast<char*>(row(lane)) + offset;
  };
  if constexpr (lanes >= 4) {
    const auto column = [&](std::size_t k) __attribute__((always_inline)) { return numbers[k < count ? k : 0].v; };
    typename Vector<T, lanes>::type rows[4];
    transpose(column(0), column(1), column(2), column(3), rows, std::make_index_sequence<lanes>());
    // The i-th four of rows[k] belongs to lane 4 i + k.
    for (std::size_t i = 0; i < lanes; ++i)
      std::memcpy(at(i), reinterpret_cast<const T*>(&rows[i % 4]) + i / 4 * 4, count * sizeof(T));
  } else {
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < lanes; ++i) {
        const T value = numbers[k][static_cast<int>(i)];
        std::memcpy(at(i) + k * sizeof(T), &value, sizeof value);
      }
  }
}
template <class T, std::size_t first, std::size_t count, class Row>
[[gnu::always_inline]] inline void scatter_numbers(const Lanes<T> (&numbers)[count], const Row& row) {
  constexpr std::size_t here = count - first < 4 ? count - first : 4;
  scatter_part<T, here>(numbers + first, row, first * sizeof(T));
  if constexpr (first + here < count) scatter_numbers<T, first + here>(numbers, row);
}

}  // namespace gathering

/// The struct over S, a scalar or `Lanes`, made of those that `row(lane)` points to.
template <class S, class Struct, class Row>
[[gnu::always_inline]] inline Struct gathered(const Row& row) {
  static_assert(std::is_trivially_copyable_v<Struct> && sizeof(Struct) % sizeof(S) == 0);
  Struct s;
  if constexpr (lanes_in<S> == 1) {
    const void* const from = row(0);
    std::memcpy(static_cast<void*>(&s), from, sizeof s);
  } else {
    S numbers[sizeof(Struct) / sizeof(S)];
    gathering::gather_numbers<typename S::Lane, 0>(row, numbers);
    std::memcpy(static_cast<void*>(&s), numbers, sizeof s);
  }
  return s;
}

/// Writes each lane's struct to the place that `row(lane)` points to.
template <class S, class Struct, class Row>
[[gnu::always_inline]] inline void scatter_struct(const Struct& s, const Row& row) {
  static_assert(std::is_trivially_copyable_v<Struct> && sizeof(Struct) % sizeof(S) == 0);
  if constexpr (lanes_in<S> == 1) {
    void* const to = row(0);
    std::memcpy(to, static_cast<const void*>(&s), sizeof s);
  } else {
    S numbers[sizeof(Struct) / sizeof(S)];
    std::memcpy(static_cast<void*>(numbers), static_cast<const void*>(&s), sizeof s);
    gathering::scatter_numbers<typename S::Lane, 0>(numbers, row);
  }
}

/// The lanes of S from as many numbers, which stand one behind the other.
template <class S>
[[gnu::always_inline]] inline S loaded_lanes(const typename LaneOf<S>::type* numbers) {
  if constexpr (lanes_in<S> == 1)
    return *numbers;
  else
    return S::load(numbers);
}

}  // namespace graze::GRAZE_ISA
