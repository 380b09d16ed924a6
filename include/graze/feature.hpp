// Features: the vertex, edge or face of a shape that a contact point lies on, by its number.
//
// Guarantee: the 14-bit numbers are unique within shapes of up to 16,384 vertices, edges or faces of a kind.
#pragma once

#include <cstdint>

#include "graze/detail/standard.hpp"

namespace graze {

/// The kind of a feature.
enum class FeatureKind : std::uint8_t { none, vertex, edge, face };

/// The feature of one shape: half of a contact point's `feature`.
struct Feature {
  /// `none` for smooth shapes, which have no features, and, where a shape has several pieces, for a point whose number
  /// another piece's point in the same manifold has too: `number` then tells it apart and names no feature.
  FeatureKind kind = FeatureKind::none;
  /// The number of the vertex or the face; for an edge, a code of its own, in the plane the number of its first vertex.
  std::uint32_t number = 0;
};

/// The feature of A that a contact point lies on.
constexpr Feature feature_of_a(std::uint32_t feature) {
  return {static_cast<FeatureKind>(feature >> 30), feature >> 16 & 0x3fff};
}
/// The feature of B that a contact point lies on.
constexpr Feature feature_of_b(std::uint32_t feature) { return feature_of_a(feature << 16); }

}  // namespace graze
