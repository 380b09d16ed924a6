// What the comparison found, as tables that read the same on a terminal and in Markdown.
#pragma once

#include <string>
#include <vector>

#include "peer.hpp"
#include "resting.hpp"

namespace graze::bench {

/// How one library did on one query for one pair of shapes.
struct Cell {
  /// `absent`: it has no such shape or query. `silent`: it answers, and finds none of the pairs that overlap.
  enum class State { absent, silent, measured };
  State state = State::absent;
  double nanoseconds = 0;                   ///< per pair: the median of the repetitions
  double spread = 0;                        ///< of the repetitions: between their quartiles, relative to the median
  std::size_t asked = 0;                    ///< pairs that are not within the band in which either answer is right
  std::size_t wrong = 0;                    ///< of those, the ones it has wrong or has no answer for
  std::size_t failed = 0;                   ///< the ones it has no answer for
  std::size_t points = 0, overlapping = 0;  ///< points of contact found, in how many pairs
  std::vector<double> errors;  ///< of the signed distance, or of the depth of the deepest contact, relative to the size
};

struct Row {
  Kind a{}, b{};
  Query query{};
  std::vector<Cell> cells;  ///< one a library
};

struct Column {
  std::string name, version;
  bool single_precision = false;
  bool reference = false;  ///< the others' errors are measured against it
};

/// How the run was made, as a list of what and how much.
using Conditions = std::vector<std::pair<std::string, std::string>>;

std::string report(const Conditions& conditions, const std::vector<Column>& columns, const std::vector<Row>& rows,
                   const std::vector<Flicker>& flickers);

/// Of values in any order; 0 of none.
double quantile(std::vector<double> values, double share);

}  // namespace graze::bench
