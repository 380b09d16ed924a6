// A node of a `WideTree` as plain data for kernels.
//
// Guarantee: the box that `at` gives for each child, though kept in eight bits a side, contains that child's pieces.
#pragma once

#include <cstddef>
#include <cstdint>

namespace graze {

/// Inner children come first, and stand one behind the other in the array of nodes; then leaves, whose pieces stand one
/// behind the other in the order of pieces. A node lies on two lines of 64 bytes.
template <class T>
struct alignas(32) TreeNode {
  static constexpr std::size_t width = 8, leaf_size = 4;
  static constexpr int deepest = 48;  ///< no node has more above it
  static constexpr unsigned steps = 255;

  T origin[3], step[3];
  std::uint32_t first_child, first_piece;
  std::uint32_t first_leaf;  ///< how many leaves the nodes before it have
  std::uint8_t inner, count;
  std::uint8_t pieces[width];  ///< of a leaf: eight times its first piece's place from `first_piece`, plus how many
  std::uint8_t lower[3][width], upper[3][width];

  /// How many pieces a leaf has, and the place of its first in the order of pieces.
  std::uint32_t pieces_of(std::size_t leaf) const { return pieces[leaf] & 7u; }
  std::uint32_t first_of(std::size_t leaf) const { return first_piece + (pieces[leaf] >> 3); }

  /// The place of a side. The builder and the queries share this expression, so that a box that the builder found to
  /// contain its pieces does contain them.
  T at(std::size_t axis, unsigned q) const { return origin[axis] + static_cast<T>(static_cast<int>(q)) * step[axis]; }
};

}  // namespace graze
