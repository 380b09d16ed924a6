// Decimal numbers in texts, for standard libraries with and without `std::from_chars` of floating-point numbers.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

namespace graze::io {

struct ParsedNumber {
  double value = 0;        ///< the nearest double
  std::size_t length = 0;  ///< of the number, in characters; 0 where there is none
  std::errc error{};       ///< as of `std::from_chars`: for no number, or one beyond a double's range
};

/// The number that a text begins with: digits with or without a sign, a point and an exponent. No language's own signs
/// count.
inline ParsedNumber parse_number(std::string_view text) {
#ifdef __cpp_lib_to_chars
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return {value, static_cast<std::size_t>(end - text.data()), error};
#else
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t from = at;
    while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
    return at - from;
  };
  if (text.starts_with('-')) ++at;
  std::size_t count = digits();
  if (at < text.size() && text[at] == '.') ++at, count += digits();
  if (count == 0) return {0, 0, std::errc::invalid_argument};
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t before = at++;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    if (digits() == 0) at = before;
  }
  const double value = std::strtod(std::string(text.substr(0, at)).c_str(), nullptr);
  return {value, at, std::isfinite(value) ? std::errc() : std::errc::result_out_of_range};
#endif
}

}  // namespace graze::io
