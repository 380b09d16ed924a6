// Contact manifolds: where two shapes touch, and how deep.
//
// Guarantee: for every point b - a = distance * normal, up to rounding; the normal is a unit vector from A to B; a
// feature number stays the same while the same features touch. The points of a cap (of a cylinder, a cone or a
// truncated cone) that stands whole on a face reach at least cos(pi / 8) = 0.923 of the cap's radius in every
// direction, and the whole radius in the direction in which it leans by a milliradian to two degrees; of a rounded one,
// of its flat part.
#pragma once

#include <cstdint>
#include <vector>

#include "graze/result.hpp"
#include "graze/small_vector.hpp"
#include "graze/vec3.hpp"

namespace graze {

/// One point of contact, in world space.
template <class T>
struct ContactPoint {
  Vec3<T> a{}, b{};         ///< on the surface of A, and of B
  T distance{};             ///< signed: negative is penetration
  std::uint32_t feature{};  ///< names the features of A and B that touch
  T weight = T(0.5);        ///< how far from a to b `position()` lies

  /// The point between the two that a solver wants: the middle; for two spheres the radius-weighted point P with
  /// |P - c1| / |P - c2| = r1 / r2.
  Vec3<T> position() const { return a + (b - a) * weight; }
};

/// Points of contact that share a normal.
template <class T>
struct Manifold {
  Vec3<T> normal{};                        ///< unit, from A to B
  SmallVector<ContactPoint<T>, 8> points;  ///< where they touch
  std::uint32_t piece_a = 0, piece_b = 0;  ///< of a composite: the triangle or child that touches
  /// `bounded` where the distance of two convex pieces that touch here is not proven.
  Status status = Status::converged;
  T error{};  ///< by how much distances of points may then be off; of several such pairs of pieces the largest

  /// Its own: all the memory kept for points would be set to zero before an implicit one.
  Manifold() {}  // NOLINT(modernize-use-equals-default)
};

/// As contacts are found: one for each pair of pieces.
template <class T>
using Manifolds = std::vector<Manifold<T>>;

/// Keeps the `count` points that span most: the deepest, the one furthest from it across the normal, and then each time
/// the one that adds most area to their hull. Their order stays. Costs `count` times the number of points.
template <class T>
GRAZE_API void reduce(Manifold<T>& manifold, std::size_t count);

}  // namespace graze
