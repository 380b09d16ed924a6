// The fourth stage of a world: pairs sorted by the types of their shapes.
//
// Guarantee: every pair is in one bin, the pairs of a bin in their own order. A loop over a bin meets one kind of pair,
// so that its branches are predicted.
#pragma once

#include <span>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/world/space.hpp"

namespace graze {

/// The pairs of two types of shapes: `order[begin]` to `order[end - 1]`.
struct Bin {
  std::uint8_t type_a, type_b;  ///< indices in `ShapeList`
  std::uint32_t begin, end;     ///< range of `order`
};

/// Pairs sorted by the kinds of their shapes.
struct Bins {
  static constexpr std::uint8_t unseen = 255;  ///< type of a shape that was never in a pair
  std::vector<std::uint32_t> order;            ///< indices of pairs
  std::vector<Bin> bins;                       ///< bins that are not empty, by type
  std::vector<std::uint8_t> types;             ///< for each shape in a pair its index in `ShapeList`
};

/// Sorts `pairs` of indices of `shapes` by counting: linear in their number.
template <class T, class Space = graze::Space<T>>
GRAZE_API void bin_pairs(std::span<const IdPair> pairs, std::span<const typename Space::Shape> shapes, Bins& out);

}  // namespace graze
