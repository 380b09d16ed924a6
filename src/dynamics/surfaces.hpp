// Materials of a body's pieces, and the manifolds of a step cut so that each is of one material on either side.
//
// A composite's manifold has the points of all pieces that share a normal: two skids of one compound that stand on a
// floor, or two triangles of one floor. Each point is of the piece whose surface is nearest to it, whatever the order
// in which pieces were found.
//
// Guarantee: bodies of one material cost nothing; of others each point of contact costs a search of their pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "graze/material.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

template <class T, class Space>
using MaterialIn = Material<T, typename Space::Vec>;

/// The materials of a body's pieces.
template <class T, class Space>
struct PieceMaterials {
  std::vector<MaterialIn<T, Space>> materials;
  std::vector<std::uint32_t> of_piece;  ///< by piece, places among `materials`
};

/// Manifolds that were cut.
template <class T, class Space>
struct CutManifolds {
  /// The materials of a manifold's two bodies.
  struct Sides {
    const MaterialIn<T, Space>*a, *b;

    ContactMaterial<T> combined() const { return graze::combined(*a, *b); }
    friend bool operator==(const Sides&, const Sides&) = default;
  };
  /// A pair of which either body has materials of its pieces, and the range of its manifolds.
  struct Cut {
    std::uint32_t pair;  ///< among the contact pairs
    std::uint32_t first, count;
  };

  std::vector<Cut> pairs;                            ///< by pair
  std::vector<ContactManifold<T, Space>> manifolds;  ///< pair by pair
  std::vector<Sides> sides;                          ///< side by side with the manifolds

  void clear() {
    pairs.clear();
    manifolds.clear();
    sides.clear();
  }
};

}  // namespace graze
