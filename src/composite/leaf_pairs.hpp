// Two shapes, either of which may be a composite, taken apart into the pairs of convex pieces that come near each
// other.
//
// Guarantee: every pair of convex pieces that comes within the limit is visited, in the same order for the same input.
// Two meshes, and two compounds, descend both trees at once: the cost follows from what is near. No allocation but for
// hierarchies deeper than any good one.
#pragma once

#include <concepts>

#include "composite/leaves.hpp"
#include "composite/mesh_patch.hpp"

namespace graze {

/// From where triangles push: from either side; from their front alone, as their surface was told; or from it alone
/// because they bound a body that the other shape comes to from outside, whose inner side is not met.
enum class Pushes : std::uint8_t { either_way, frontward, outward };

/// A piece on its way to being convex, and the number that the outermost composite knows it by.
template <class T>
struct Part {
  const Shape<T>& shape;
  const Pose<T>& pose;
  std::uint32_t number = 0;
  std::uint32_t leaf = 0;  ///< its number among all pieces of the whole shape; 0 for the whole
  bool outermost = true;
  Pushes pushes = Pushes::either_way;   ///< a triangle, or those of an opened surface
  const MeshPatch<T>* patch = nullptr;  ///< of its mesh, if it is a triangle of one
  const MeshData<T>* solid = nullptr;   ///< its mesh, if that is a solid

  Part piece(const Shape<T>& child, const Pose<T>& child_pose, std::uint32_t child_number) const {
    // Multiples of the golden ratio keep apart (Knuth 1973, "The art of computer programming", volume 3, section 6.4):
    // pieces of a child with fewer than 2^32 / (sqrt(5) n) of them, n children, have numbers of their own.
    const std::uint32_t child_leaf = leaf * 2654435769u + child_number + 1;
    return {child, child_pose, outermost ? child_number : number, child_leaf, false, pushes, nullptr, solid};
  }
};

/// The leaves of a pair of pieces (`Part::leaf`).
struct LeafPair {
  std::uint32_t a = 0, b = 0;
};

/// The criterion of pairs that are near enough: up to `distance` apart, which may shrink on the way, and with a
/// `direction`, a unit vector from A to B in the world or zero, no further apart than that along it.
template <class T>
struct Nearness {
  const T& distance;
  const Vec3<T>* direction = nullptr;
  bool with_patches = false;  ///< pieces come with what lies around them; the distance does not shrink

  T operator()() const { return distance; }
};

template <class T>
struct TriangleRun;  // triangle_run.hpp

/// Whom the pairs are shown to: somebody's function, called as `f(part_a, part_b)`, which may return false to end the
/// visit; if it can also be called as `f(run)`, triangles that there are kernels for are shown several at a time. Known
/// by its address alone, so that the descent is compiled once and not for each function; such a call costs two
/// nanoseconds where a pair costs hundreds.
template <class T>
class PairVisitor {
 public:
  template <class F>
  requires(!std::same_as<F, PairVisitor>) explicit PairVisitor(F& f)
      : function_(&f), call_([](void* function, const Part<T>& a, const Part<T>& b) {
          return go_on(*static_cast<F*>(function), a, b);
        }) {
    if constexpr (std::invocable<F&, const TriangleRun<T>&>)
      call_run_ = [](void* function, const TriangleRun<T>& run) { return go_on(*static_cast<F*>(function), run); };
  }

  bool operator()(const Part<T>& a, const Part<T>& b) const { return call_(function_, a, b); }
  bool takes_runs() const { return call_run_ != nullptr; }
  bool operator()(const TriangleRun<T>& run) const { return call_run_(function_, run); }

 private:
  void* function_;
  bool (*call_)(void*, const Part<T>&, const Part<T>&);
  bool (*call_run_)(void*, const TriangleRun<T>&) = nullptr;
};

/// Shows the visitor all pairs of convex pieces that may be near enough; returns whether it went to the end.
template <class T>
bool visit_convex_pairs(const Part<T>& a, const Part<T>& b, const Nearness<T>& limit, const PairVisitor<T>& visitor);

}  // namespace graze
