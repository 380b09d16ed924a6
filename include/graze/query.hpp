// Queries on two shapes: overlap, signed distance, contacts, and the nearest point of a surface.
//
// Guarantee: every query answers for every pair of shapes. An answer is right within `tolerance<T>` times the size of
// the pair (the larger radius about a shape's own origin), or its status says that it is not and `error` bounds the
// error. Answers are computed in a frame relative to the pair: moving the scene does not change them. Nothing throws,
// aborts, prints or allocates, except to store the results. Safe from any thread. All this for poses, points and
// margins that are finite and no larger than `largest_magnitude`, which queries do not check. Sizes below
// `smallest_magnitude` are zero: such a shape is a point, and answers are right to a few times that number.
//
// Normals are unit vectors that point from A to B; distances are signed: positive between separated shapes, negative
// when they overlap, and then minus the length of the shortest translation that separates them.
#pragma once

#include <optional>
#include <vector>

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "graze/trace.hpp"

namespace graze {

/// Whether the shapes touch: distance <= 0. Cheaper than the distance.
template <class T>
GRAZE_API bool overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                       Trace* trace = nullptr);

/// A preliminary test, cheaper than `overlap` and conservative: false only where the shapes do not touch. Two boxes are
/// tested along their six face normals without the nine products of their edges; of random boxes that do not touch and
/// whose bounding spheres do, one in thirteen (7.7 %) passes. Other pairs are answered as by `overlap`.
template <class T>
GRAZE_API bool may_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// The signed distance. For composites the smallest over their convex pieces; for a shape wholly inside a solid mesh
/// (see `Mesh::solid`) minus the length of a translation that takes it out, an upper bound of the depth: the points are
/// then the last one to leave the mesh, and its place after the translation.
template <class T>
GRAZE_API Distance<T> distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                               Trace* trace = nullptr);

/// The signed distance of shapes that are no further apart than `limit` >= 0, the same bits as `distance`; nothing for
/// shapes further apart. The cost for composites is that of the pieces within the limit: the others are not visited.
template <class T>
GRAZE_API std::optional<Distance<T>> distance_up_to(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                                    const Pose<T>& pose_b, T limit);

/// Whether the shapes are no further apart than `limit` >= 0: distance <= limit. Cheaper than `distance_up_to`, since
/// the first pair of pieces within the limit ends it.
template <class T>
GRAZE_API bool within(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T limit);

/// Appends every pair of convex pieces that is no further apart than `margin` >= 0, with its distance, in the same
/// order for the same input; two convex shapes have one pair. The inside of a solid mesh is disregarded here.
template <class T>
GRAZE_API void near_pieces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                           std::vector<PieceDistance<T>>& pieces);

/// Appends the manifolds of all points of contact that are up to `margin` >= 0 apart; a pair of convex shapes has at
/// most one. Returns whether the shapes overlap (distance <= 0, whatever the margin), as far as they have contacts:
/// false where all of these lie on sides of a surface that do not count, though `overlap` is true there. A surface with
/// `Sides::front` counts where it is met from the front, and a closed mesh from outside, unless the middle of the other
/// shape is in the mesh's bounds and these are at least as wide as it: then either side of the surface pushes.
///
/// The normal of a manifold is that of a face where this separates the shapes nearly as well as the best direction;
/// each point has its own true distance along that normal. The deepest point is as deep as `distance` up to a
/// two-hundredth of the smaller shape (the radius about its own origin), either way: deeper along a face's normal than
/// along the best direction, or less deep, where the deepest corner of one shape projects beyond the rim of the other's
/// face and so has no point of that face opposite it. Such a corner gets no point, which would come and go with the
/// rounding of poses wherever edges of stacked boxes about coincide.
///
/// A shape wholly inside a solid mesh (see `Mesh::solid`) has one point there, that of `distance`. A convex one
/// that pokes out with its middle inside is pushed out by the points that lie behind the triangle through which it
/// leaves soonest, as deep as that way is; `distance` is that of the deepest pair of pieces.
///
/// Two half-spaces that are not opposite overlap without a depth and so without points: they have no manifold, alone or
/// as children of compounds, and the answer is still that the shapes overlap.
template <class T>
GRAZE_API bool contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                        Manifolds<T>& manifolds, Trace* trace = nullptr);

/// A margin for `contacts` with which a body at rest keeps its points from frame to frame: a hundredth of the smaller
/// shape (the radius about its own origin). A solver lets bodies rest a few thousandths of their size deep and lean by
/// a few milliradians, which lifts the far corners of a face by as much: with this margin they stay points of contact.
template <class T>
GRAZE_API T contact_margin(const Shape<T>& a, const Shape<T>& b);

/// The point of a shape's surface nearest to a point of the world. The distance is negative inside of a convex shape,
/// of a closed mesh, solid or not (see `Mesh::closed`; its winding decides which side is inside), and of a compound
/// that has such a child there; other meshes and height fields have no inside. On a mesh's surface the normal is the
/// surface's own.
template <class T>
GRAZE_API Closest<T> closest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& point, Trace* trace = nullptr);

}  // namespace graze
