// JSON values with their paths, so that every error names the place.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "graze/detail/validate.hpp"
#include "graze/error.hpp"
#include "graze/pose.hpp"

namespace graze::io {

using Json = nlohmann::json;

/// Parses one JSON text. Throws `InvalidValue` (without a path) for a text that is none, or is nested deeper than
/// `max_json_depth`. A number too large for a double becomes a marked string, so that it can be named where it stands.
Json parse_json(std::string_view text);

/// The value of a key of a JSON object as it is written there, on one line; of duplicate keys the last, which counts.
/// `text` has been parsed before, and is an object with that key.
std::string member_text(std::string_view text, std::string_view key);

/// Bounds recursion over a parsed value to a fraction of the usual eight megabytes of stack.
inline constexpr int max_json_depth = 2000;

/// Words as a text of JSON, in quotes; bytes that are no UTF-8 are replaced.
std::string json_quoted(const std::string& words);

/// A value as it appears in an error: compact, and shortened when long.
std::string shown(const Json& value);

/// A value of a question and its path.
class JsonValue {
 public:
  JsonValue(const Json& json, std::string path) : json_(&json), path_(std::move(path)) {}

  const Json& json() const { return *json_; }
  const std::string& path() const { return path_; }

  [[noreturn]] void fail(const std::string& expectation) const {
    throw InvalidValue(path_, expectation, shown(*json_));
  }

  /// Checks that this is an object with no keys but these (and `comment`).
  const JsonValue& keys(std::initializer_list<std::string_view> known) const;

  bool has(const char* key) const { return json_->is_object() && json_->contains(key); }
  /// The value of a key that must be there.
  JsonValue at(const char* key) const;
  /// The value of a key, or nothing.
  std::optional<JsonValue> find(const char* key) const;

  /// The elements of an array, of exactly `count` when that is given.
  std::vector<JsonValue> elements(std::optional<std::size_t> count = {}) const;

  std::string string() const;
  bool boolean() const;
  std::size_t whole_number(std::size_t least = 0) const;
  /// The index of an element of a list of `count`.
  std::size_t index_below(std::size_t count) const;

  /// A number that is finite in T.
  template <class T>
  T number() const {
    if (!json_->is_number()) fail("a finite number");
    const T value = static_cast<T>(json_->get<double>());
    if (!std::isfinite(value)) fail("a finite number");
    return value;
  }
  /// A number that is finite in T and >= 0.
  template <class T>
  T positive_or_zero() const {
    const T value = json_->is_number() ? static_cast<T>(json_->get<double>()) : T(-1);
    if (!(value >= T(0) && std::isfinite(value))) fail("a finite number >= 0");
    return value;
  }
  /// A length, no larger than `largest_magnitude`, as all coordinates are.
  template <class T>
  T length() const {
    const T value = positive_or_zero<T>();
    if (const char* expectation = validate::fault_of_length(value)) fail(expectation);
    return value;
  }
  template <class T>
  T coordinate() const {
    const T value = number<T>();
    if (const char* expectation = validate::fault_of_coordinate(value)) fail(expectation);
    return value;
  }
  template <class T>
  Vec3<T> vector() const {
    const auto parts = elements(3);
    return {parts[0].coordinate<T>(), parts[1].coordinate<T>(), parts[2].coordinate<T>()};
  }
  /// Two coordinates, in the plane z = 0.
  template <class T>
  Vec3<T> plane_vector() const {
    const auto parts = elements(2);
    return {parts[0].coordinate<T>(), parts[1].coordinate<T>(), T(0)};
  }
  template <class T>
  Vec3<T> lengths() const {
    const auto parts = elements(3);
    return {parts[0].length<T>(), parts[1].length<T>(), parts[2].length<T>()};
  }

 private:
  const Json* json_;
  std::string path_;
};

}  // namespace graze::io
