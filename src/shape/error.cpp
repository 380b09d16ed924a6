#include "graze/error.hpp"

#include <charconv>
#include <cstdio>
#include <cstdlib>

#include "graze/detail/validate.hpp"

namespace graze {

InvalidValue::InvalidValue(const std::string& path, const std::string& expectation, const std::string& found)
    : std::invalid_argument((path.empty() ? "" : path + ": ") +
                            (expectation.empty() ? found : "expected " + expectation + ", got " + found)),
      path_(path),
      expectation_(expectation),
      found_(found) {}

InvalidValue InvalidValue::below(const std::string& outer) const {
  const bool joined = path_.empty() || outer.empty() || path_.front() == '[';
  return {outer + (joined ? "" : ".") + path_, expectation_, found_};
}

namespace validate {

std::string number(double value) {
  char text[32];
#if defined(__cpp_lib_to_chars)
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
#else
  // A standard library without `to_chars` of numbers: the fewest digits that give the same number again.
  for (int digits = 1; digits < 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) return text;
  }
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
#endif
}

void fail(const std::string& path, const std::string& expectation, double found) {
  throw InvalidValue(path, expectation, number(found));
}

void fail(const std::string& path, const std::string& expectation, const std::string& found) {
  throw InvalidValue(path, expectation, found);
}

}  // namespace validate
}  // namespace graze
