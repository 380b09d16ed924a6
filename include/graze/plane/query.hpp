// Queries on two shapes of the plane: overlap, signed distance, contacts, and the nearest point of a surface.
//
// Guarantee: that of `graze/query.hpp`. Every query answers for every pair of shapes, right within `tolerance<T>` times
// the size of the pair (the larger radius about a shape's own origin), or its status says that it is not. Answers are
// computed in double, in a frame relative to the pair: moving the scene does not change them. Nothing throws, aborts or
// prints. Safe from any thread.
//
// Normals are unit vectors that point from A to B; distances are signed: positive between separated shapes, negative
// when they overlap, and then minus the length of the shortest translation that separates them.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/plane/shape.hpp"
#include "graze/result.hpp"
#include "graze/small_vector.hpp"
#include "graze/trace.hpp"

namespace graze::plane {

/// The signed distance of two shapes and the points that realise it, in world space.
template <class T>
struct Distance {
  T distance{};      ///< signed: positive between separated shapes, negative when they overlap
  Vec2<T> normal{};  ///< unit, from A to B; moving B by -distance * normal makes the shapes touch
  Vec2<T> a{}, b{};  ///< on the surfaces: b - a = distance * normal
  Status status = Status::converged;
  T error{};  ///< a proven bound of |distance - truth| when the status is `bounded`
};

/// One point of contact, in world space.
template <class T>
struct ContactPoint {
  Vec2<T> a{}, b{};         ///< points on the surfaces of A and of B: b - a = distance * normal
  T distance{};             ///< signed: negative is penetration
  std::uint32_t feature{};  ///< identifies the features of A (high half) and of B (low half) that touch
  T weight = T(0.5);        ///< position of `position()` between a (0) and b (1)

  /// The contact position for a solver: the midpoint of a and b; for two circles the radius-weighted point P with |P -
  /// c1| / |P - c2| = r1 / r2.
  Vec2<T> position() const { return a + (b - a) * weight; }
};

/// Points of contact that share a normal.
template <class T>
struct Manifold {
  Vec2<T> normal{};                        ///< unit, from A to B
  SmallVector<ContactPoint<T>, 2> points;  ///< at most two
  std::uint32_t piece_a = 0, piece_b = 0;  ///< the child or piece of the outermost shape that touches, else 0
  Status status = Status::converged;       ///< `bounded` where the distance of the two pieces is not proven
  T error{};                               ///< bound on the error of the points' distances where `bounded`
};

template <class T>
using Manifolds = std::vector<Manifold<T>>;

/// Keeps the `count` deepest points, in their order; the first of equally deep ones.
template <class T>
GRAZE_API void reduce(Manifold<T>& manifold, std::size_t count);

/// Whether the shapes touch: distance <= 0.
template <class T>
GRAZE_API bool overlap(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                       Trace* trace = nullptr);

/// The signed distance. For compounds the smallest over their children. Cost: linear in the vertices of both.
template <class T>
GRAZE_API Distance<T> distance(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b,
                               Trace* trace = nullptr);

/// Appends the manifolds of all points of contact that are up to `margin` >= 0 apart, one for each pair of convex
/// pieces; for polygons and chains one for all pieces side by side that share a normal, along normals of their
/// outlines. Returns whether the shapes overlap (distance <= 0, whatever the margin, and on either side of a chain).
///
/// Two edges that face each other give a manifold with a point at both ends of the stretch that they share; its feature
/// names the vertices of both edges at that end, so that it is the same whichever edge ends first, and mirrored when
/// the shapes are swapped. The deepest point is as deep as `distance`, but of polygons, chains and compounds deep in
/// each other, whose ways out are those of their outlines, it may be less deep.
///
/// Two half-planes that are not opposite overlap without a depth and so without points.
template <class T>
GRAZE_API bool contacts(const Shape<T>& a, const Pose2<T>& pose_a, const Shape<T>& b, const Pose2<T>& pose_b, T margin,
                        Manifolds<T>& manifolds, Trace* trace = nullptr);

/// A margin for `contacts` with which a body at rest keeps its points from frame to frame: a hundredth of the smaller
/// shape (the radius about its own origin; for a compound half the diagonal of its bounds). A half-plane has no size:
/// the other shape decides, and for two half-planes the margin is 0.
template <class T>
GRAZE_API T contact_margin(const Shape<T>& a, const Shape<T>& b);

/// The point of a shape's surface nearest to a point of the world.
template <class T>
struct Closest {
  T distance{};      ///< signed: negative inside a solid
  Vec2<T> point{};   ///< on the surface
  Vec2<T> normal{};  ///< unit, outward: the queried point - point = distance * normal
  Status status = Status::converged;
  T error{};  ///< as in `Distance`
};

/// The point of the shape's surface nearest to `point`, and the signed distance to it. Where children of a compound or
/// rounded segments of a chain lie over each other, a point inside is answered for the one in which it lies deepest by
/// itself. A `trace` is filled after the answer.
template <class T>
GRAZE_API Closest<T> closest(const Shape<T>& shape, const Pose2<T>& pose, const Vec2<T>& point, Trace* trace = nullptr);

}  // namespace graze::plane
