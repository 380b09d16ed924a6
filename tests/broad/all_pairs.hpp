// The overlapping pairs of boxes by a look at all pairs.
#pragma once

#include <vector>

#include "graze/aabb.hpp"
#include "graze/broad_phase.hpp"

namespace graze {

template <class T>
std::vector<IdPair> all_pairs(const std::vector<Aabb<T>>& boxes) {
  std::vector<IdPair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
      if (overlap(boxes[i], boxes[j])) pairs.push_back({i, j});
  return pairs;
}

}  // namespace graze
