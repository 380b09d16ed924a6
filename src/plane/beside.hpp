// Pieces side by side as one ground: the outline that a piece has among the other children of its compound and, of a
// fixed body, among the fixed bodies beside it.
//
// Guarantee: an edge is no part of the ground's outline where the bodies beside it cover all of it that faces the body
// that moves, and a vertex has the normals alone that lead into none of them, as within a solid polygon. What nothing
// beside it touches stays as it is. Polygons, boxes, segments, chains and half-planes count as ground, rounded or not;
// what has no straight side does not. It does not matter in how many compounds a child lies.
#pragma once

#include <span>

#include "graze/plane/query.hpp"
#include "graze/small_vector.hpp"
#include "plane/leaves.hpp"
#include "plane/seam_step.hpp"

namespace graze::plane {

/// A disc in the world.
struct Disc {
  Vec2d center;
  double radius;

  /// Whether all of it is further than `reach` from a point.
  bool is_beyond(const Vec2d& point, double reach) const {
    const double furthest = radius + reach;
    return length_squared(point - center) > furthest * furthest;
  }
};

/// The convex pieces of the ground near a body that moves: those of a body, if it is of several shapes, and of bodies
/// around it.
template <class T>
class Ground {
 public:
  /// `around`: the fixed bodies, `own` among them, or nobody. `mover` stands at `pose_m`.
  Ground(std::span<const PlacedRef<T>> around, const Shape<T>& own, const Pose2<T>& pose, const Shape<T>& mover,
         const Pose2<T>& pose_m);
  bool empty() const { return pieces_.empty(); }
  /// Whether a shape overlaps any of the bodies around.
  bool overlaps(const Shape<T>& shape, const Pose2<T>& pose) const;

  /// A piece of the body and of what meets it, in place.
  struct Meeting {
    const Pose2d& pose;
    const Core<T>& mover;
    const Pose2d& mover_pose;
    double size;       ///< of the smaller of the two
    double pair_size;  ///< of the two together
  };
  /// Sets `outline` to that of a piece of the body as far as it faces what meets it, of a chain's segment seen from
  /// both sides, and makes it the core's; an empty one where nothing beside it matters.
  void outline(Core<T>& core, const Meeting& meeting, SmallVector<OutlineVertex, 8>& outline) const;

 private:
  struct Piece {
    Core<T> core;
    Pose2d pose;
    bool own;  ///< whether it is one of the body itself
    Disc around;
  };
  static bool is_same(const Piece& piece, const Core<T>& core) { return piece.own && piece.core.leaf == core.leaf; }
  bool covers(const Core<T>& core, std::uint32_t edge, const Meeting& meeting, const Pose2d& mover_in,
              double step) const;
  bool restrict_normals(const Core<T>& core, std::uint32_t i, const Meeting& meeting, const Vec2d& mover_center,
                        double step, OutlineVertex& vertex) const;
  bool is_buried(const Core<T>& core, std::uint32_t i, const Meeting& meeting, double step,
                 const OutlineVertex& vertex) const;
  bool outline_of_side(const Core<T>& core, const Meeting& meeting, double step, std::span<OutlineVertex> side) const;

  std::span<const PlacedRef<T>> around_;
  const Shape<T>& own_;
  SmallVector<Piece, 4> pieces_;
};

/// Appends the contacts of two bodies, of which those in `of_a` or `of_b` stand beside A or B and are one ground with
/// it; each list has the body itself, or nobody. The children of a compound are one ground with each other. Returns
/// whether the two overlap. A body that overlaps another one of the ground, too, has no contacts here where none is on
/// the ground's outline.
template <class T>
bool contacts_beside(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T margin,
                     Manifolds<T>& manifolds, std::span<const PlacedRef<T>> of_a, std::span<const PlacedRef<T>> of_b);

}  // namespace graze::plane
