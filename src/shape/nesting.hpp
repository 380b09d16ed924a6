// Compounds within compounds, in space and in the plane.
//
// Guarantee: no compound holds more than `most_nested` within each other, however deep they are nested: what lies
// deeper is taken apart. Queries call themselves for every compound within another, so that bounds their need of stack.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "graze/error.hpp"

namespace graze {

/// A query of two compounds takes up to 16 KiB of the stack for each: together half of the least that systems give a
/// program, which is a megabyte.
inline constexpr std::uint32_t most_nested = 32;

/// The most pieces that a compound is taken apart into. A shape may stand in a compound any number of times, so that a
/// few dozen compounds hold more pieces than there is memory for.
inline constexpr std::uint64_t most_taken_apart = std::uint64_t{1} << 22;

struct Nesting {
  std::uint32_t depth = 0;   ///< compounds within each other, none for another shape
  std::uint64_t leaves = 0;  ///< shapes in them that are no compounds, each time that they stand there

  void add_child(const Nesting& child) {
    if (child.depth >= depth) depth = child.depth + 1;
    const std::uint64_t room = (std::numeric_limits<std::uint64_t>::max)() - leaves;
    leaves += child.leaves < room ? child.leaves : room;
  }
};

/// The shape with `rounding` beside its own.
template <class Shape, class T>
Shape grown(const Shape& shape, T rounding) {
  if (rounding == T(0)) return shape;
  return shape.visit([&](const auto& concrete) { return Shape(concrete, shape.rounding() + rounding); });
}

/// Appends the shapes in a compound at `pose` that are no compounds, each with the roundings of those that it is in.
template <class Compound, class T, class Pose, class Placed>
void take_apart(const Compound& compound, T rounding, const Pose& pose, std::vector<Placed>& leaves) {
  for (const Placed& child : compound.children()) {
    const Pose at = compose(pose, child.pose);
    if (const auto* inner = child.shape.template as<Compound>())
      take_apart(*inner, rounding + child.shape.rounding(), at, leaves);
    else
      leaves.push_back({grown(child.shape, rounding), at});
  }
}

/// The nesting of a child of a compound. A child as deep as allowed already is replaced by a compound of its leaves.
/// Throws `InvalidValue` below `path` where these are too many or lie too far away.
template <class Compound, class Placed>
Nesting bounded_nesting(Placed& child, const std::string& path) {
  const auto* inner = child.shape.template as<Compound>();
  if (!inner) return {0, 1};
  if (const Nesting nesting = inner->data().nesting; nesting.depth < most_nested) return nesting;
  if (const std::uint64_t leaves = inner->data().nesting.leaves; leaves > most_taken_apart)
    throw InvalidValue(path,
                       "compounds nested at most " + std::to_string(most_nested) + " deep, or of at most " +
                           std::to_string(most_taken_apart) + " shapes",
                       std::to_string(leaves) + " in " + std::to_string(most_nested + 1));
  std::vector<Placed> leaves;
  take_apart(*inner, child.shape.rounding(), decltype(child.pose){}, leaves);
  try {
    child.shape = Compound(std::move(leaves));
  } catch (const InvalidValue& e) {
    throw e.below(path);
  }
  return child.shape.template as<Compound>()->data().nesting;
}

}  // namespace graze
