#include "dynamics/islands.hpp"

#include <utility>

namespace graze {

/// The first body of the island, as far as it is known; shortens the way there.
std::uint32_t Islands::root(std::uint32_t i) {
  while (parent_[i] != i) {
    parent_[i] = parent_[parent_[i]];
    i = parent_[i];
  }
  return i;
}

void Islands::find(std::span<const std::uint8_t> movable, std::span<const IslandLink> links) {
  const auto count = static_cast<std::uint32_t>(movable.size());
  parent_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) parent_[i] = i;
  for (const IslandLink& link : links) {
    if (movable[link.a] == 0 || movable[link.b] == 0) continue;
    std::uint32_t a = root(link.a), b = root(link.b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }
  ranges_.clear();
  island_.assign(count, ~std::uint32_t{0});
  for (std::uint32_t i = 0; i < count; ++i) {
    if (movable[i] == 0) continue;
    const std::uint32_t first = root(i);
    if (first == i) {
      island_[i] = static_cast<std::uint32_t>(ranges_.size());
      ranges_.push_back({0, 0, 0, 0});
    }
    island_[i] = island_[first];
    ++ranges_[island_[i]].body_count;
  }
  const auto island_of = [&](const IslandLink& link) { return island_[movable[link.a] != 0 ? link.a : link.b]; };
  for (const IslandLink& link : links) ++ranges_[island_of(link)].link_count;
  std::uint32_t bodies = 0, sum = 0;
  for (Range& r : ranges_) {
    r.first_body = bodies;
    bodies += std::exchange(r.body_count, 0);
    r.first_link = sum;
    sum += std::exchange(r.link_count, 0);
  }
  bodies_.resize(bodies);
  links_.resize(sum);
  for (std::uint32_t i = 0; i < count; ++i)
    if (movable[i] != 0) {
      Range& r = ranges_[island_[i]];
      bodies_[r.first_body + r.body_count++] = i;
    }
  for (std::uint32_t i = 0; i < links.size(); ++i) {
    Range& r = ranges_[island_of(links[i])];
    links_[r.first_link + r.link_count++] = i;
  }
}

}  // namespace graze
