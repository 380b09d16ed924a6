// The part of a shape that a point of contact names: a vertex, an edge or a face, by its number.
//
// Guarantee: of a shape's 14-bit numbers each names one part alone in shapes of up to 16,384 of them.
#pragma once

#include <cstdint>

namespace graze {

/// The kind of part that a shape touches with.
enum class FeatureKind : std::uint8_t { none, vertex, edge, face };

/// The part of one shape, half of the `feature` of a contact point.
struct Feature {
  FeatureKind kind = FeatureKind::none;  ///< none of what is smooth and has no parts
  /// The number of the vertex or the face; an edge has one in a form of its own, in the plane that of its first vertex.
  std::uint32_t number = 0;
};

/// The part of A that a point of contact lies on.
constexpr Feature feature_of_a(std::uint32_t feature) {
  return {static_cast<FeatureKind>(feature >> 30), feature >> 16 & 0x3fff};
}
/// The part of B that a point of contact lies on.
constexpr Feature feature_of_b(std::uint32_t feature) { return feature_of_a(feature << 16); }

}  // namespace graze
