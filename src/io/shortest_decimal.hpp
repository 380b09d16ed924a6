// The decimal of the fewest digits that reads back to the same number.
//
// Guarantee: of all decimals that round to the number one with the fewest digits, and of those the nearest; of two that
// are as near the even one. Exact: multiplied by a power of ten, the number and the middles between it and its
// neighbours are whole multiples of a power of two, and 128 bits hold them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace graze::io {

/// digits · 10^exponent; the last digit is not zero.
struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
};

namespace detail {

__extension__ using Wide128 = unsigned __int128;

/// The powers of five that fit, up to the 27th.
inline constexpr auto powers_of_five = [] {
  std::array<std::uint64_t, 28> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 5 * powers[i - 1];
  return powers;
}();

/// A positive number times a power of ten, and the numbers that round to it, all in units of 2^-shift.
struct Scaled {
  Wide128 value, lowest, highest;
  int shift;

  bool has(std::uint64_t whole) const {
    const Wide128 w = static_cast<Wide128>(whole) << shift;
    return lowest <= w && w <= highest;
  }
  /// The nearest multiple of `step` that rounds to the number, or 0.
  std::uint64_t nearest(std::uint64_t step) const {
    const std::uint64_t below = static_cast<std::uint64_t>(value >> shift) / step, above = below + 1;
    const Wide128 down = value - (static_cast<Wide128>(below * step) << shift);
    const Wide128 up = (static_cast<Wide128>(above * step) << shift) - value;
    const bool prefers_above = up < down || (up == down && above % 2 == 0);
    const std::uint64_t first = step * (prefers_above ? above : below), second = step * (prefers_above ? below : above);
    return has(first) ? first : has(second) ? second : 0;
  }
};

}  // namespace detail

/// The shortest decimal of a positive number from 2^-34 up to where whole numbers begin to have gaps; others would take
/// more bits, and have none.
template <class T>
std::optional<Decimal> shortest_decimal(T number) {
  constexpr int own_bits = std::numeric_limits<T>::digits, wide_bits = 53;
  if (!(number >= T(0x1p-34)) || number >= std::ldexp(T(1), own_bits)) return std::nullopt;
  // number = significand · 2^(exponent - 53), whatever its type.
  int exponent = 0;
  const auto significand =
      static_cast<std::uint64_t>(std::ldexp(std::frexp(static_cast<double>(number), &exponent), wide_bits));
  // 10^tens · number has 17 or 18 digits: 1233 / 4096 is the logarithm of two closely enough for these exponents.
  const int tens = 16 - (((exponent - 1) * 1233) >> 12);
  const detail::Wide128 five = detail::powers_of_five[static_cast<std::size_t>(tens)];

  // In quarters of the significand's unit, so that the middles to both neighbours are whole: a power of two has its
  // lower one half as far away. A decimal in such a middle is read as the number if that is even.
  const std::uint64_t gap = std::uint64_t(4) << (wide_bits - own_bits);
  const bool is_power_of_two = significand == std::uint64_t(1) << (wide_bits - 1);
  const bool is_even = significand / (gap / 4) % 2 == 0;
  const detail::Wide128 value = five * (4 * significand), excluded = is_even ? 0 : 1;
  const detail::Scaled scaled{value, value - five * (is_power_of_two ? gap / 4 : gap / 2) + excluded,
                              value + five * (gap / 2) - excluded, wide_bits + 2 - exponent - tens};

  std::uint64_t step = 1, found = scaled.nearest(step);
  int zeros = 0;
  for (std::uint64_t next = scaled.nearest(10); next != 0; next = scaled.nearest(10 * step)) {
    step *= 10;
    ++zeros;
    found = next;
  }
  return Decimal{found / step, zeros - tens};
}

}  // namespace graze::io
