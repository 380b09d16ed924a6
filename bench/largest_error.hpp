// The largest error of a query over many questions.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "table.hpp"

namespace graze::bench {

/// The largest error of a query, relative to the size, and how often its answer was the opposite.
struct LargestError {
  double error = 0;
  std::size_t asked = 0, wrong = 0;

  template <class Real>
  void add(Real off) {
    ++asked, error = std::max(error, static_cast<double>(std::abs(off)));
  }
  void add_wrong() { ++asked, ++wrong; }
  std::string text() const {
    if (asked == 0) return "none";
    return bench::error(error) + (wrong > 0 ? " (" + percent(wrong, asked) + ")" : "");
  }
};

}  // namespace graze::bench
