// The numbers of features: the parts of A and of B that touch at a point of contact.
//
// Guarantee: a number is unique among the vertices, edges or faces of a shape of up to 16,384 of them. In larger ones
// numbers wrap, with the sole effect that two features that touch at the same time may share a number.
#pragma once

#include <cstdint>

#include "graze/contact.hpp"

namespace graze {

namespace detail {

/// A feature takes 16 bits: two for its kind, fourteen for its number.
inline constexpr std::uint32_t feature_number_bits = 14;
constexpr std::uint32_t feature_of_kind(std::uint32_t kind, std::uint32_t number) {
  return (kind << feature_number_bits) | (number & ((1u << feature_number_bits) - 1));
}

}  // namespace detail

constexpr std::uint32_t vertex_feature(std::uint32_t vertex) { return detail::feature_of_kind(1, vertex); }
constexpr std::uint32_t edge_feature(std::uint32_t vertex, std::uint32_t other) {
  const std::uint32_t low = vertex < other ? vertex : other, high = vertex < other ? other : vertex;
  return detail::feature_of_kind(2, low * 127 + high);
}
constexpr std::uint32_t face_feature(std::uint32_t face) { return detail::feature_of_kind(3, face); }

/// Bound of the kernels' part numbers, which stand for a shape's features.
inline constexpr std::size_t most_parts = 64;

/// One number for the features of A and B that touch: a half each, so that swapping the shapes swaps the halves.
constexpr std::uint32_t feature_id(std::uint32_t of_a, std::uint32_t of_b) { return (of_a << 16) | of_b; }
constexpr std::uint32_t swapped_feature_id(std::uint32_t id) { return (id << 16) | (id >> 16); }

/// A point of contact with A and B exchanged.
template <class T>
ContactPoint<T> mirrored(const ContactPoint<T>& p) {
  return {p.b, p.a, p.distance, swapped_feature_id(p.feature), T(1) - p.weight};
}

}  // namespace graze
