// Contact manifolds: the points at which two shapes touch, and how deep.
//
// Guarantee: for every point b - a = distance * normal, up to rounding; the normal is a unit vector from A to B; a
// feature number stays the same while the same features touch (in a manifold of several pieces: and no other piece has
// the same number), and none repeats within a manifold. The points of a cap (of a cylinder, a cone or a truncated cone)
// that stands whole on a face reach at least cos(pi / 8) = 0.923 of the cap's radius in every direction, and the whole
// radius in the direction in which it leans by a milliradian to two degrees; of a rounded one, of its flat part.
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
  Vec3<T> a{}, b{};         ///< points on the surfaces of A and of B
  T distance{};             ///< signed: negative is penetration
  std::uint32_t feature{};  ///< identifies the features of A and B that touch
  T weight = T(0.5);        ///< position of `position()` between a (0) and b (1)

  /// The contact position for a solver: the midpoint of a and b; for two spheres the radius-weighted point P with |P -
  /// c1| / |P - c2| = r1 / r2.
  Vec3<T> position() const { return a + (b - a) * weight; }
};

/// Points of contact that share a normal.
template <class T>
struct Manifold {
  Vec3<T> normal{};                        ///< unit, from A to B
  SmallVector<ContactPoint<T>, 8> points;  ///< points of contact
  std::uint32_t piece_a = 0, piece_b = 0;  ///< the triangle or child of a composite that touches, else 0
  /// `bounded` where the distance of two convex pieces that touch here is not proven.
  Status status = Status::converged;
  T error{};  ///< bound on the error of the points' distances where `bounded`; the largest over several such pairs of
              ///< pieces

  /// Written out, because before an implicit constructor all the memory for points would be set to zero.
  Manifold() {}  // NOLINT(modernize-use-equals-default)
};

/// The manifolds of a query, one for each pair of pieces, in the order in which they are found.
template <class T>
using Manifolds = std::vector<Manifold<T>>;

/// Keeps the `count` points of largest area: the deepest, the one furthest from it across the normal, and then each
/// time the one that adds most area to their hull. The order of the points stays. Costs `count` times the number of
/// points.
template <class T>
GRAZE_API void reduce(Manifold<T>& manifold, std::size_t count);

}  // namespace graze
