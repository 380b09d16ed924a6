// Broad phases: the pairs of overlapping boxes among many.
//
// Guarantee: exactly the pairs whose closed boxes overlap, each once with the smaller id first, sorted; a function of
// the boxes and ids alone, whatever the structure and its history. Broad phases hold boxes and ids, no shapes. Every
// array grows as needed, so that nothing is dropped.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "graze/aabb.hpp"
#include "graze/error.hpp"
#include "graze/lines.hpp"

namespace graze {

/// Two ids, the smaller first.
struct IdPair {
  std::uint32_t a, b;  ///< the two ids

  friend constexpr bool operator==(const IdPair&, const IdPair&) = default;
  friend constexpr auto operator<=>(const IdPair&, const IdPair&) = default;
};

/// A part of a broad phase's structure: the bounds of a node, or a cell.
template <class T>
struct BroadPhasePart {
  Aabb<T> box;          ///< the bounds or the cell
  std::uint32_t depth;  ///< depth of the node, 0 for the root; cells of a grid have none
};

/// The interface that all broad phases share. Ids are the caller's own; those that lie close together cost least.
template <class T>
class GRAZE_API BroadPhase {
 public:
  virtual ~BroadPhase() = default;

  /// Adds a box under an id that is not in use. Infinite sides are allowed; NaN is not. Throws `InvalidValue`.
  virtual void insert(std::uint32_t id, const Aabb<T>& box) = 0;
  /// Removes the box of an id. Throws `InvalidValue` for an id that is not in use.
  virtual void remove(std::uint32_t id) = 0;
  virtual void move(std::uint32_t id, const Aabb<T>& box) = 0;  ///< replaces the box of `id`

  /// Sets `out` to all overlapping pairs, sorted. Boxes count as unmoved from then on.
  virtual void pairs(std::vector<IdPair>& out) = 0;
  /// Sets `out` to the overlapping pairs of which a box was inserted or moved since the last call of this or of
  /// `pairs`, sorted.
  virtual void moved_pairs(std::vector<IdPair>& out) = 0;

  /// Number of boxes that the last call of `pairs` or `moved_pairs` compared with another, bounds of several boxes
  /// included, for comparing structures. Sorting and maintaining a structure do not count.
  virtual std::uint64_t tests() const = 0;

  /// The ids of all boxes that overlap `box`, sorted.
  virtual void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const = 0;
  /// The ids of all boxes that `box` touches while it moves by `motion`, sorted. A point as `box` makes it a ray; with
  /// no motion it is `query`. Touching counts; a box within rounding of a touch may be reported.
  virtual void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const = 0;

  /// Bytes that the structure holds, for comparison.
  virtual std::size_t memory() const = 0;

  /// The parts of the structure as it is now, parents before their children, for drawing: the bounds of the nodes of a
  /// tree and of a space partition, the occupied cells of a grid and of an octree. Linear in the number of boxes,
  /// except for the grid's cells, which are sorted. Sorted axes have no parts.
  virtual void parts(std::vector<BroadPhasePart<T>>& out) const { out.clear(); }
};

/// A tree of bounds, eight children a node: `DynamicTree` in graze/dynamic_tree.hpp, the default choice. Takes boxes of
/// any sizes, any mix of moving and resting ones, and has fast queries.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_dynamic_tree();

/// Sort and sweep along the axis on which the boxes vary most (Baraff 1992, "Dynamic simulation of non-penetrating
/// rigid bodies", section 5; Ericson 2005, "Real-time collision detection", section 7.5). The order is kept from call
/// to call, so that small motions cost little. No structure to maintain; box queries visit every box.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_sort_and_sweep();

/// Sweep and prune along all three axes: pairs are kept from call to call, and change only where interval ends pass
/// each other during insertion sort (Cohen, Lin, Manocha, Ponamgi 1995, "I-COLLIDE"). For scenes in which little moves.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_sweep_and_prune();

/// A hashed uniform grid (Teschner and others 2003, "Optimized spatial hashing for collision detection of deformable
/// objects"), its cell size chosen from the boxes. For boxes of similar sizes, wherever they are.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_hashed_grid();

/// A loose octree: cells of twice their size, so that a box belongs to just one (Ulrich 2000, "Loose octrees", Game
/// Programming Gems). For boxes of very different sizes.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_loose_octree();

/// An axis-aligned binary space partition, a k-d tree, rebuilt after boxes have moved (Bentley 1975, "Multidimensional
/// binary search trees used for associative searching"). For static scenes.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_bsp();

}  // namespace graze
