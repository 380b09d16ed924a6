// The shortest text that reads back to the same number, where the standard library has no `std::to_chars` for it.
//
// Guarantee: the text of `std::to_chars`: the fewest digits that read back, of fixed and scientific notation the
// shorter one, and fixed where both are as long. At powers of two, below which numbers lie twice as close as above, one
// digit more is possible. Takes up to three conversions, of denormal numbers up to seventeen.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace graze::io {

/// Writes the finite `value` without an end of its own to `text`, of at least 40 characters; returns where it ends.
template <class T>
char* write_shortest(T value, char* text) {
  constexpr std::size_t room = 40;
  const auto wide = static_cast<double>(value);
  // Digits are tried one after the other, each time rounded correctly. A decimal of up to `digits10` digits comes back
  // when its nearest normal number is rounded to `digits10` digits: if these read back, they hold the fewest, before
  // zeros.
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

}  // namespace graze::io
