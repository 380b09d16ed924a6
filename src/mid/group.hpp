// Manifolds of neighbouring pieces that share a normal become one.
#pragma once

#include <algorithm>
#include <limits>
#include <numeric>

#include "graze/contact.hpp"

namespace graze {

/// Two normals are one when they differ by less than the rounding of a quaternion's rotation, some ten operations.
template <class T>
inline constexpr T same_normal = T(64) * std::numeric_limits<T>::epsilon();

/// Joins the manifolds from `first` on that share a normal, keeping the order of the first of each group; points that
/// coincide on both shapes (a vertex that two triangles share) are kept once. Sorted by normal, so n log n.
template <class T>
void group_by_normal(Manifolds<T>& manifolds, std::size_t first) {
  const std::size_t count = manifolds.size() - first;
  if (count < 2) return;
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), first);
  const auto key = [&](std::size_t i) { return manifolds[i].normal; };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i).x < key(j).x; });

  // Each manifold that has no leader yet leads all those of its normal, the first of them in front.
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> leader(manifolds.size(), none);
  for (std::size_t i = 0; i < count; ++i) {
    if (leader[order[i]] != none) continue;
    std::vector<std::size_t> group;
    for (std::size_t j = i; j < count && key(order[j]).x - key(order[i]).x <= same_normal<T>; ++j)
      if (leader[order[j]] == none && max_abs(key(order[j]) - key(order[i])) <= same_normal<T>)
        group.push_back(order[j]);
    const std::size_t front = *std::min_element(group.begin(), group.end());
    for (const std::size_t member : group) leader[member] = front;
  }

  std::size_t kept = first;
  std::vector<std::size_t> place(manifolds.size());
  for (std::size_t i = first; i < manifolds.size(); ++i) {
    const std::size_t root = leader[i];
    if (root == i) {
      place[i] = kept;
      if (kept != i) manifolds[kept] = manifolds[i];
      ++kept;
      continue;
    }
    Manifold<T>& into = manifolds[place[root]];
    for (const ContactPoint<T>& p : manifolds[i].points) {
      const auto same = [&](const ContactPoint<T>& q) { return q.a == p.a && q.b == p.b; };
      if (std::none_of(into.points.begin(), into.points.end(), same)) into.points.push_back(p);
    }
  }
  manifolds.resize(kept);
}

}  // namespace graze
