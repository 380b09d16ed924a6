// The fourth stage of a world: pairs sorted by the types of their shapes.
//
// Guarantee: every pair stands in one bin, the pairs of a bin in their own order. What runs over a bin meets one kind
// of pair after the other and foresees its branches.
#pragma once

#include <span>
#include <vector>

#include "graze/broad_phase.hpp"
#include "graze/world/space.hpp"

namespace graze {

/// The pairs of two types of shapes: `order[begin]` to `order[end - 1]`.
struct Bin {
  std::uint8_t type_a, type_b;  ///< places in `ShapeList`
  std::uint32_t begin, end;     ///< of `order`
};

/// Pairs sorted by the kinds of their shapes.
struct Bins {
  static constexpr std::uint8_t unseen = 255;  ///< the type of a shape that was never in a pair
  std::vector<std::uint32_t> order;            ///< places among the pairs
  std::vector<Bin> bins;                       ///< those that are not empty, by type
  std::vector<std::uint8_t> types;             ///< of each shape in a pair: its place in `ShapeList`
};

/// Sorts `pairs` of places in `shapes` by counting: linear in their number.
template <class T, class Space = graze::Space<T>>
GRAZE_API void bin_pairs(std::span<const IdPair> pairs, std::span<const typename Space::Shape> shapes, Bins& out);

}  // namespace graze
