// What the comparison found, as tables that read the same on a terminal and in Markdown.
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"
#include "resting.hpp"

namespace graze::bench {

/// The queries of the comparison.
inline constexpr Query queries[] = {Query::overlap, Query::distance, Query::contacts};

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

std::string report(const Conditions& conditions, const std::vector<Column>& columns, const std::vector<Row>& rows,
                   const std::vector<Flicker>& flickers);
/// The part of it that sums up.
std::string summary(const std::vector<Column>& columns, const std::vector<Row>& rows,
                    const std::vector<Flicker>& flickers);

}  // namespace graze::bench
