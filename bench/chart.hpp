// The figures of the headline as a picture: the time for a pair, beside the fastest of the other libraries.
#pragma once

#include <string>
#include <vector>

namespace graze::bench {

struct ChartRow {
  std::string name;
  std::string other;       ///< another library
  double nanoseconds = 0;  ///< its time
  double wrong = 0;        ///< the share of its answers that are wrong
  double one = 0;          ///< of Graze, a pair at a time
  double batch = 0;        ///< of Graze, all pairs at once; 0 where there is none
};

/// An SVG of its own, for a light page and a dark one: bars on one logarithmic scale, on which the same ratio is the
/// same length everywhere.
std::string chart(const std::string& title, const std::string& note, const std::vector<ChartRow>& rows);

}  // namespace graze::bench
