// Answers as text: numbers in the shortest form that reads back to the same value, in the precision of the answer.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "graze/vec3.hpp"
#include "io/shortest_number.hpp"

namespace graze::io {

/// Builds one JSON object or array, a piece at a time; commas are put where they belong.
class JsonWriter {
 public:
  JsonWriter& open(char bracket) {
    comma();
    text_ += bracket;
    first_ = true;
    return *this;
  }
  JsonWriter& close(char bracket) {
    text_ += bracket;
    first_ = false;
    return *this;
  }
  JsonWriter& key(std::string_view name) {
    comma();
    text_ += '"';
    text_ += name;
    text_ += "\":";
    first_ = true;
    return *this;
  }
  /// Text that is JSON already.
  JsonWriter& raw(std::string_view json) {
    comma();
    text_ += json;
    return *this;
  }
  JsonWriter& value(bool b) { return raw(b ? "true" : "false"); }
  /// Writes a number, never as "-0"; an infinity, for which JSON has no word, becomes null.
  template <class T>
  JsonWriter& number(T v) {
    if (!std::isfinite(v)) return raw("null");
    char digits[40];
    const T shown = v == T(0) ? T(0) : v;
#ifdef __cpp_lib_to_chars
    const char* const end = std::to_chars(digits, digits + sizeof digits, shown).ptr;
#else
    const char* const end = write_shortest(shown, digits);
#endif
    return raw({digits, static_cast<std::size_t>(end - digits)});
  }
  template <class T>
  JsonWriter& vector(const Vec3<T>& v, int dimension = 3) {
    open('[').number(v.x).number(v.y);
    if (dimension == 3) number(v.z);
    return close(']');
  }

  std::string take() { return std::move(text_); }

 private:
  void comma() {
    if (!first_) text_ += ',';
    first_ = false;
  }

  std::string text_;
  bool first_ = true;
};

}  // namespace graze::io
