// The names of vector operations for turnings of the plane, which are numbers, so that code written once over a space
// reads the same in both.
//
// Guarantee: nothing but names; the numbers of three dimensions keep theirs.
#pragma once

#include <cmath>
#include <concepts>

namespace graze {

template <std::floating_point T>
constexpr T dot(const T& a, const T& b) {
  return a * b;
}
template <class S>
requires requires { typename S::Lane; }
constexpr S dot(const S& a, const S& b) { return a * b; }
template <std::floating_point T>
T length(const T& turning) {
  return std::abs(turning);
}
template <std::floating_point T>
T max_abs(const T& turning) {
  return std::abs(turning);
}

}  // namespace graze
