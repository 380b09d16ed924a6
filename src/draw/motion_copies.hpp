// The number of copies of a shape that show a motion.
//
// Guarantee: enough that a turn is seen, and no more than the eye tells apart.
#pragma once

#include <algorithm>

namespace graze::draw_detail {

/// The copies along a motion that turns at that rate, in radians per unit of time, until that time.
inline int motion_copies(double rate, double until) {
  constexpr double turn = 6.283185307179586, a_turn = 12, fewest = 4, most = 24;
  return static_cast<int>(std::clamp(rate * until / turn * a_turn, fewest, most));
}

}  // namespace graze::draw_detail
