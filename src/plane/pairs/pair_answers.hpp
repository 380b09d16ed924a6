// Answers of kernels for one pair, in the order in which its shapes stand.
//
// Guarantee: the answer of a pair that was taken the other way round is mirrored, and no distance is computed anew.
#pragma once

#include "graze/plane/query.hpp"
#include "plane/pairs/pair_kernels.hpp"

namespace graze::plane {

template <class T, std::size_t N>
Vec2<T> vector_at(const double (&columns)[2][N], std::size_t i) {
  return {static_cast<T>(columns[0][i]), static_cast<T>(columns[1][i])};
}

template <class T, std::size_t N>
Distance<T> distance_at(const DistanceColumns<N>& found, std::size_t i, bool turned) {
  Distance<T> out;
  out.distance = static_cast<T>(found.distance[i]);
  const Vec2<T> n = vector_at<T>(found.normal, i), a = vector_at<T>(found.a, i), b = vector_at<T>(found.b, i);
  out.normal = turned ? -n : n;
  out.a = turned ? b : a;
  out.b = turned ? a : b;
  return out;
}

template <class T, std::size_t N>
Vec2<T> normal_at(const ContactColumns<N>& found, std::size_t i, bool turned) {
  const Vec2<T> n = vector_at<T>(found.normal, i);
  return turned ? -n : n;
}

/// The first or the second point of the i-th pair, whether it is filled or not.
template <class T, std::size_t N>
ContactPoint<T> point_at(const ContactColumns<N>& found, std::size_t i, std::size_t point, bool turned) {
  const auto number = [&](std::size_t column) { return static_cast<T>(found.points[point][column][i]); };
  const auto feature = static_cast<std::uint32_t>(found.points[point][5][i]);
  const Vec2<T> a{number(0), number(1)}, b{number(2), number(3)};
  if (turned) return {b, a, number(4), swapped_feature_id(feature), T(1) - number(6)};
  return {a, b, number(4), feature, number(6)};
}

}  // namespace graze::plane
