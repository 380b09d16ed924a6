// Numbers and shapes as words, by which ranks and journals compare whether they mean the same.
#pragma once

#include <array>
#include <charconv>
#include <span>
#include <string>

#include "graze/geometry.hpp"
#include "graze/shape.hpp"
#include "mpi/journal.hpp"

namespace graze::mpi {

/// All digits of a number, as many as distinguish it from every other one.
inline std::string digits(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// A number made of the bits of others.
template <class E>
std::string sum_of(std::span<const E> numbers) {
  std::string words = "#";
  return words.append(std::to_string(checksum({reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()})));
}

/// A shape's kind, and a number made of its bounds and its rounding.
template <class T>
std::string words_of(const Shape<T>& shape) {
  const Aabb<T> box = bounds(shape, Pose<T>{});
  const T numbers[] = {box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z, shape.rounding()};
  std::string words = shape.name();
  return words.append(" ").append(sum_of(std::span<const T>(numbers)));
}

}  // namespace graze::mpi
