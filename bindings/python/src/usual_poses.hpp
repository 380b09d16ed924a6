// A quick look at rows of poses that are used where they stand.
#pragma once

#include <cstddef>
#include <utility>

#include "convert.hpp"

namespace graze::python {

template <std::size_t... I>
double sum_of_squares(const double* numbers, std::index_sequence<I...>) {
  return (... + (numbers[I] * numbers[I]));
}

/// Whether `count` rows of `width` numbers, of which the first `coordinates` are a translation and the others a
/// rotation of unit length, are certainly poses; few that are make it doubt, and so does a number of rows that four
/// does not divide. No row is told from others on the way: sums of squares over all of them are in bounds only if each
/// number is, and not where one is NaN. Four rows at a time have sums of their own, which compilers put into lanes.
template <std::size_t coordinates, std::size_t width>
bool are_usual(const double* rows, std::size_t count) {
  constexpr std::size_t lanes = 4;
  double far[lanes] = {}, off[lanes] = {};
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double* row = rows + (i + lane) * width;
      const double square = sum_of_squares(row + coordinates, std::make_index_sequence<width - coordinates>());
      far[lane] += sum_of_squares(row, std::make_index_sequence<coordinates>());
      off[lane] += (square - 1) * (square - 1);
    }
  constexpr double reach = largest_magnitude<double> / 2;
  bool usual = i == count;
  for (std::size_t lane = 0; lane < lanes; ++lane)
    usual &= far[lane] <= reach * reach && off[lane] <= unit_slack * unit_slack;
  return usual;
}

}  // namespace graze::python
