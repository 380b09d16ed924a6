// Bodies that poke out of a solid mesh while their middle is inside: the contacts that push them out.
//
// Guarantee: nothing pulls such a body in, if it is convex or a convex child of a compound. Of the triangles that it
// meets from behind it is pushed out through one, the one through which it has left after the least way, by all points
// that stand on the triangle's plane from below. Triangles of other surfaces are met from both sides as ever.
#pragma once

#include <limits>
#include <vector>

#include "composite/leaf_pairs.hpp"
#include "graze/contact.hpp"

namespace graze {

/// The contacts of two shapes, either of which may have solid meshes.
template <class T>
class WaysOut {
 public:
  /// Whether the middle of `body` is inside the solid mesh of `triangle`, which it meets from behind. Its way out
  /// through that triangle is known then. Not of half-spaces, nor of triangles: those of a floor are inside of what has
  /// sunk into it. `body_is_a`: whether `body` is a piece of A.
  bool leads_out(const Part<T>& body, const Part<T>& triangle, bool body_is_a, T margin);

  /// Calls `f(manifold, leaves)` for the least way out of each body.
  template <class F>
  void for_each(const F& f) const {
    for (const Way& way : ways_)
      if (!way.manifold.points.empty()) f(way.manifold, way.leaves);
  }

 private:
  struct Way {
    Vec3<T> middle{};  ///< of the body, by which it is known, in the world
    const MeshData<T>* solid = nullptr;
    bool inside = false;
    T distance = -std::numeric_limits<T>::infinity();  ///< minus the way's length
    Manifold<T> manifold{};
    LeafPair leaves{};
  };

  Way& way_of(const Part<T>& body, const Part<T>& triangle);

  std::vector<Way> ways_;
};

}  // namespace graze
