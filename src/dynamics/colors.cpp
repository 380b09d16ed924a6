#include "dynamics/colors.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace graze {

namespace {

/// The number of colours. A box among boxes touches some twelve, and a body with so many pairs that none is left is
/// rare.
constexpr std::uint32_t most_colors = 63, without_color = most_colors;

}  // namespace

void Coloring::find(std::span<const std::uint8_t> movable, std::span<const IslandLink> pairs) {
  used_.assign(movable.size(), 0);
  color_.resize(pairs.size());
  std::array<std::uint32_t, most_colors + 1> counts{};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    const std::uint64_t used = (movable[a] != 0 ? used_[a] : 0) | (movable[b] != 0 ? used_[b] : 0);
    const auto color = std::min(static_cast<std::uint32_t>(std::countr_one(used)), without_color);
    color_[i] = static_cast<std::uint8_t>(color);
    ++counts[color];
    if (color == without_color) continue;
    used_[a] |= std::uint64_t{1} << color;
    used_[b] |= std::uint64_t{1} << color;
  }
  colors_.clear();
  std::array<std::uint32_t, most_colors + 1> next{};
  std::uint32_t sum = 0;
  for (std::uint32_t color = 0; color <= most_colors; ++color) {
    next[color] = sum;
    if (counts[color] != 0) colors_.push_back({sum, sum + counts[color], color == without_color});
    sum += counts[color];
  }
  order_.resize(pairs.size());
  for (std::uint32_t i = 0; i < pairs.size(); ++i) order_[next[color_[i]]++] = i;
}

}  // namespace graze
