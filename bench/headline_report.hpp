// What the headline found, as tables, as sentences and as a picture.
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

namespace graze::bench {

struct HeadlineRow {
  std::string name;
  Query query{};
  double meeting = 0;                      ///< share of the pairs that overlap or hit
  std::vector<Cell> cells;                 ///< one for each of `peers()`, as are those below
  std::vector<std::size_t> held, touched;  ///< bytes a pair
};

/// Times and answers. Like the others of `peers()` as they are now.
std::string headline_report(const std::vector<HeadlineRow>& rows);
/// Against the fastest of the other libraries in each row: the mean, and the best and worst row.
std::string headline_short(const std::vector<HeadlineRow>& rows);
std::string headline_memory(const std::vector<HeadlineRow>& rows);
std::string headline_chart(const std::vector<HeadlineRow>& rows, std::size_t pairs);

}  // namespace graze::bench
