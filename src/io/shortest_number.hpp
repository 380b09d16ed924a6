// The shortest text that reads back to the same number, where the standard library has no `std::to_chars` for it.
//
// Guarantee: the text of `std::to_chars`: the fewest digits that read back, of fixed and scientific notation the
// shorter one, and fixed where both are as long. Below 2^-34 and above whole numbers without gaps, at powers of two,
// one digit more is possible; and up to three conversions are taken there, of denormal numbers up to seventeen.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "io/shortest_decimal.hpp"

namespace graze::io {
namespace detail {

/// Writes a decimal whose exponent in scientific notation has at most two digits, in the shorter notation.
inline char* write_decimal(const Decimal& decimal, char* text) {
  char reversed[20];
  int count = 0;
  for (std::uint64_t rest = decimal.digits; rest != 0; rest /= 10)
    reversed[count++] = static_cast<char>('0' + rest % 10);
  const auto put = [&](int n) {
    for (; n > 0; --n) *text++ = reversed[--count];
  };
  const auto zeros = [&](int n) { text = std::fill_n(text, std::max(n, 0), '0'); };
  const int exponent = count - 1 + decimal.exponent;  // of scientific notation
  const int decimals = std::max(0, -decimal.exponent), integers = std::max(exponent + 1, 1);
  const int fixed = integers + (decimals > 0 ? 1 + decimals : 0);
  const int scientific = count + (count > 1 ? 1 : 0) + 4;
  if (fixed > scientific) {
    put(1);
    if (count > 0) *text++ = '.';
    put(count);
    *text++ = 'e';
    *text++ = exponent < 0 ? '-' : '+';
    *text++ = static_cast<char>('0' + std::abs(exponent) / 10);
    *text++ = static_cast<char>('0' + std::abs(exponent) % 10);
    return text;
  }
  if (exponent < 0) zeros(1);
  put(std::min(count, std::max(exponent + 1, 0)));
  zeros(decimal.exponent);
  if (decimals > 0) *text++ = '.';
  zeros(std::min(-exponent - 1, decimals));
  put(count);
  return text;
}

/// The text of any finite number. Digits are tried one after the other, each time rounded correctly.
template <class T>
char* write_by_trying(T value, char* text) {
  constexpr std::size_t room = 40;
  const auto wide = static_cast<double>(value);
  // A decimal of up to `digits10` digits comes back when its nearest normal number is rounded to `digits10` digits: if
  // these read back, they hold the fewest, before zeros.
  const bool normal = std::abs(value) >= std::numeric_limits<T>::min();
  int digits = normal ? std::numeric_limits<T>::digits10 : 1;
  const auto print = [&] { return std::snprintf(text, room, "%.*e", digits - 1, wide); };
  const auto reads_back = [&] {
    const T read = sizeof(T) == sizeof(float) ? static_cast<T>(std::strtof(text, nullptr))
                                              : static_cast<T>(std::strtod(text, nullptr));
    return read == value;
  };
  int scientific = print();
  for (; digits < std::numeric_limits<T>::max_digits10 && !reads_back(); scientific = print()) ++digits;
  int mark = 0;
  while (text[mark] != 'e') ++mark;
  int zeros = 0;
  while (digits > 1 && text[mark - 1 - zeros] == '0') ++zeros;
  if (zeros > 0) {
    digits -= zeros;
    scientific = print();
    while (text[mark] != 'e') --mark;
  }
  const int exponent = std::atoi(text + mark + 1);
  const int decimals = digits - 1 - exponent;
  const int integer = exponent < 0 ? 1 : exponent + 1;
  const int fixed = (value < 0 ? 1 : 0) + integer + (decimals > 0 ? 1 + decimals : 0);
  if (fixed > scientific) return text + scientific;
  return text + std::snprintf(text, room, "%.*f", decimals > 0 ? decimals : 0, wide);
}

}  // namespace detail

/// Writes the finite `value` without an end of its own to `text`, of at least 40 characters; returns where it ends.
template <class T>
char* write_shortest(T value, char* text) {
  if (value == T(0)) {
    *text = '0';
    return text + 1;
  }
  const std::optional<Decimal> decimal = shortest_decimal(std::abs(value));
  if (!decimal) return detail::write_by_trying(value, text);
  if (value < 0) *text++ = '-';
  return detail::write_decimal(*decimal, text);
}

}  // namespace graze::io
