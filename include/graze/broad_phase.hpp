// Broad phases: which of many boxes overlap.
//
// Guarantee: exactly the pairs whose closed boxes overlap, each once with the smaller id first, sorted; a function of
// the boxes and ids alone. They know boxes and ids and no shapes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/error.hpp"

namespace graze {

/// Two ids, the smaller first.
struct IdPair {
  std::uint32_t a, b;

  friend constexpr bool operator==(const IdPair&, const IdPair&) = default;
  friend constexpr auto operator<=>(const IdPair&, const IdPair&) = default;
};

/// The interface that all broad phases share. Ids are the caller's own.
template <class T>
class BroadPhase {
 public:
  virtual ~BroadPhase() = default;

  /// Adds a box under an id that is not in use. Infinite sides are allowed; NaN is not. Throws `InvalidValue`.
  virtual void insert(std::uint32_t id, const Aabb<T>& box) = 0;
  /// Throws `InvalidValue` for an id that is not there.
  virtual void remove(std::uint32_t id) = 0;
  virtual void move(std::uint32_t id, const Aabb<T>& box) = 0;

  /// All overlapping pairs, sorted.
  virtual void pairs(std::vector<IdPair>& out) = 0;
  /// The ids of all boxes that overlap `box`, sorted.
  virtual void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const = 0;
};

/// Sort and sweep along the axis on which the boxes vary most (Baraff 1992, "Dynamic simulation of non-penetrating
/// rigid bodies", section 5; Ericson 2005, "Real-time collision detection", section 7.5).
template <class T>
std::unique_ptr<BroadPhase<T>> make_sort_and_sweep();

}  // namespace graze
