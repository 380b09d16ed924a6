// Fixed bodies side by side as one ground: the outline that a piece of one has among the others.
//
// Guarantee: an edge is no part of the ground's outline where the bodies beside it cover all of it that faces the body
// that moves, and a vertex has the normals alone that lead into none of them, as within a solid polygon. What nothing
// beside it touches stays as it is. Polygons, boxes, segments, chains and half-planes count as ground; what is round
// does not, and the ends of chains are not joined to others.
#pragma once

#include <span>

#include "graze/plane/query.hpp"
#include "graze/small_vector.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

/// Height of a step between two bodies up to which they are one ground, relative to the smaller of the body that moves
/// and the piece that it meets; as between solids (`composite/internal_edges`).
inline constexpr double seam_step = 4e-4;

/// The convex pieces of the ground near a body that moves, of all bodies but one.
template <class T>
class Ground {
 public:
  /// `around`: the fixed bodies, `own` among them, which is left out. `mover` stands at `pose`.
  Ground(std::span<const PlacedRef<T>> around, const Shape<T>& own, const Shape<T>& mover, const Pose2d& pose);
  bool empty() const { return pieces_.empty(); }
  /// Whether a shape overlaps any of the bodies.
  bool overlaps(const Shape<T>& shape, const Pose2<T>& pose) const;

  /// Sets `outline` to that of a piece of the body left out, at `pose`, as far as it faces `mover` at `mover_pose`, and
  /// makes it the core's; an empty one where nothing beside it matters. `size`: the smaller of the two.
  void outline(Core<T>& core, const Pose2d& pose, const Core<T>& mover, const Pose2d& mover_pose, double size,
               SmallVector<OutlineVertex, 8>& outline) const;

 private:
  struct Piece {
    Core<T> core;
    Pose2d pose;
  };
  bool covers(const Core<T>& core, const Pose2d& pose, std::uint32_t edge, const Core<T>& mover, const Pose2d& mover_in,
              double step) const;
  bool restrict_normals(const Core<T>& core, const Pose2d& pose, std::uint32_t i, const Vec2d& mover_center,
                        double step, OutlineVertex& vertex) const;

  std::span<const PlacedRef<T>> around_;
  const Shape<T>& own_;
  SmallVector<Piece, 4> pieces_;
};

/// Appends the contacts of two bodies, of which those in `of_a` or `of_b` stand beside A or B and are one ground with
/// it; each list has the body itself, or nobody. Returns whether the two overlap. A body that overlaps another one of
/// the ground, too, has no contacts here where none is on the ground's outline.
template <class T>
bool contacts_beside(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T margin,
                     Manifolds<T>& manifolds, std::span<const PlacedRef<T>> of_a, std::span<const PlacedRef<T>> of_b);

}  // namespace graze::plane
