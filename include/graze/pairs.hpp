// From bounds to the pairs worth asking about: candidates, then filters.
//
// Guarantee: every pair whose bounds overlap and whose filters and predicate agree, each once, sorted; nothing is
// dropped, whatever the number. Both stages can be used alone.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/filter.hpp"

namespace graze {

/// Drops from `pairs` those that their filters (`filters[id]`) or `predicate(a, b)` forbid; keeps the order.
template <class Predicate>
void keep_allowed(std::vector<IdPair>& pairs, std::span<const Filter> filters, const Predicate& predicate) {
  std::erase_if(pairs,
                [&](const IdPair& p) { return !may_collide(filters[p.a], filters[p.b]) || !predicate(p.a, p.b); });
}

/// The allowed pairs of boxes that overlap: sort and sweep, then filters. Ids are places in `boxes` and `filters`.
template <class T, class Predicate>
std::vector<IdPair> allowed_pairs(std::span<const Aabb<T>> boxes, std::span<const Filter> filters,
                                  const Predicate& predicate) {
  const auto broad = make_sort_and_sweep<T>();
  for (std::size_t i = 0; i < boxes.size(); ++i) broad->insert(static_cast<std::uint32_t>(i), boxes[i]);
  std::vector<IdPair> pairs;
  broad->pairs(pairs);
  keep_allowed(pairs, filters, predicate);
  return pairs;
}

}  // namespace graze
