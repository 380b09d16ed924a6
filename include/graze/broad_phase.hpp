// Broad phases: which of many boxes overlap.
//
// Guarantee: exactly the pairs whose closed boxes overlap, each once with the smaller id first, sorted; a function of
// the boxes and ids alone, whichever structure finds them and however it came about. They know boxes and ids and no
// shapes. Nothing is dropped: every array grows.
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
  std::uint32_t depth;  ///< of the node below the root, whose depth is 0; cells of a grid have none
};

/// The interface that all broad phases share. Ids are the caller's own; those that lie close together cost least.
template <class T>
class GRAZE_API BroadPhase {
 public:
  virtual ~BroadPhase() = default;

  /// Adds a box under an id that is not in use. Infinite sides are allowed; NaN is not. Throws `InvalidValue`.
  virtual void insert(std::uint32_t id, const Aabb<T>& box) = 0;
  /// Throws `InvalidValue` for an id that is not there.
  virtual void remove(std::uint32_t id) = 0;
  virtual void move(std::uint32_t id, const Aabb<T>& box) = 0;  ///< the box of `id` from now on

  /// All overlapping pairs, sorted. What moved counts as still from then on.
  virtual void pairs(std::vector<IdPair>& out) = 0;
  /// Those of them of which at least one was inserted or moved since this or `pairs` was last called; the same order.
  virtual void moved_pairs(std::vector<IdPair>& out) = 0;

  /// How many boxes the last call of `pairs` or `moved_pairs` compared with another, bounds of several among them, for
  /// comparison of structures. What it takes to sort and to keep a structure up is not in it.
  virtual std::uint64_t tests() const = 0;

  /// The ids of all boxes that overlap `box`, sorted.
  virtual void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const = 0;
  /// The ids of all boxes that `box` touches while it moves by `motion`, sorted. A point as `box` makes it a ray; with
  /// no motion it is `query`. Touching counts; a box that rounding cannot tell from touched may be among them.
  virtual void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const = 0;

  /// Bytes that the structure holds, for comparison.
  virtual std::size_t memory() const = 0;

  /// The parts of the structure as it is now, parents before their children, for drawing: the bounds of the nodes of a
  /// tree and of a space partition, the cells of a grid and of an octree that hold something. Linear in what is held,
  /// but for the grid's cells, which are sorted. Sorted axes have no parts.
  virtual void parts(std::vector<BroadPhasePart<T>>& out) const { out.clear(); }
};

/// A tree of bounds, eight children a node: `DynamicTree` in graze/dynamic_tree.hpp, the one to take unless something
/// speaks for another. Any sizes, any mix of what moves and what does not, and fast queries.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_dynamic_tree();

/// Sort and sweep along the axis on which the boxes vary most (Baraff 1992, "Dynamic simulation of non-penetrating
/// rigid bodies", section 5; Ericson 2005, "Real-time collision detection", section 7.5). Kept sorted from call to
/// call, so that what moves little costs little. No structure to keep up; box queries look at everything.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_sort_and_sweep();

/// Sweep and prune along all three axes: pairs are kept from call to call, and only ends that pass each other while
/// they are sorted in change them (Cohen, Lin, Manocha, Ponamgi 1995, "I-COLLIDE"). For scenes in which little moves.
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

/// An axis-aligned binary space partition, a k-d tree, built anew when boxes have moved (Bentley 1975,
/// "Multidimensional binary search trees used for associative searching"). For what stands still.
template <class T>
GRAZE_API std::unique_ptr<BroadPhase<T>> make_bsp();

}  // namespace graze
