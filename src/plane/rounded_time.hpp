// Times of contacts in the scalar of the answer.
//
// Guarantee: no answer is later than the time, of those from 0 to infinity.
#pragma once

#include <cstdint>
#include <type_traits>

namespace graze::plane {

/// A time of at least 0 in T that is not later. The number below one is that of its bits less one: without a branch,
/// since whether a time is rounded up is not foreseen.
template <class T>
T rounded_down(double t) {
  using Bits = std::conditional_t<sizeof(T) == sizeof(std::uint32_t), std::uint32_t, std::uint64_t>;
  const T rounded = static_cast<T>(t);
  // The compiler's own, as not every standard library has `std::bit_cast`.
  return __builtin_bit_cast(T, __builtin_bit_cast(Bits, rounded) - static_cast<Bits>(double(rounded) > t ? 1 : 0));
}

}  // namespace graze::plane
