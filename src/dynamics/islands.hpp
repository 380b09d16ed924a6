// Islands: bodies that touch or are joined, directly or through others that can be pushed.
//
// Guarantee: every body that can be pushed is in one island, and every contact or joint of one in that island; islands
// stand in the order of their first bodies, and what is in them in its own order. A body that cannot be pushed joins
// nothing. Nearly linear in the number of links (Tarjan 1975).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graze/detail/standard.hpp"

namespace graze {

/// Two bodies that move together.
struct IslandLink {
  std::uint32_t a, b;
};

class Islands {
 public:
  struct Range {
    std::uint32_t first_body, body_count;
    std::uint32_t first_link, link_count;
  };

  /// Finds the islands. `movable[i]`: whether body i is looked at. A link has at least one body that is.
  void find(std::span<const std::uint8_t> movable, std::span<const IslandLink> links);

  std::span<const Range> ranges() const { return ranges_; }
  /// Indices of bodies, and places among the links.
  std::span<const std::uint32_t> bodies_of(const Range& r) const {
    return std::span(bodies_).subspan(r.first_body, r.body_count);
  }
  std::span<const std::uint32_t> links_of(const Range& r) const {
    return std::span(links_).subspan(r.first_link, r.link_count);
  }

 private:
  std::uint32_t root(std::uint32_t i);

  std::vector<std::uint32_t> parent_, island_, bodies_, links_;
  std::vector<Range> ranges_;
};

}  // namespace graze
