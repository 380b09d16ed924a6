// Power-of-two units for lengths of about a size: changing to them loses no digit.
//
// Guarantee: exact, and the same for a single number and in lanes.
#pragma once

#include <cstdint>

#include "graze/wide.hpp"

namespace graze {

/// The greatest power of two that is not above a positive number; zero for a subnormal number.
[[gnu::always_inline]] inline double power_of_two_below(double x) {
  constexpr std::uint64_t exponent = 0x7ff0'0000'0000'0000;
  return __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, x) & exponent);
}
template <int N>
[[gnu::always_inline]] inline Wide<double, N> power_of_two_below(const Wide<double, N>& x) {
  using Bits = typename Wide<double, N>::BitVector;
  constexpr std::int64_t exponent = 0x7ff0'0000'0000'0000;
  return Wide<double, N>::of(
      reinterpret_cast<typename Wide<double, N>::Vector>(reinterpret_cast<Bits>(x.v) & (Bits{} + exponent)));
}

}  // namespace graze
