// Results of queries: signed distances, nearest points and hits of rays, each with its status.
//
// Guarantee: plain aggregates without invariants. Normals are unit vectors that point from A to B; distances are
// signed: positive between separated shapes, negative when they overlap, and then minus the length of the shortest
// translation that separates them. Contacts have a header of their own, `contact.hpp`.
#pragma once

#include <cstdint>

#include "graze/vec3.hpp"

namespace graze {

/// Largest error of an answer, relative to the size of the pair. Half of `float`'s is rounding of poses.
template <class T>
inline constexpr T tolerance = T(1e-10);
/// Largest relative error in single precision.
template <>
inline constexpr float tolerance<float> = 1e-5f;

/// Certainty of an answer.
enum class Status : std::uint8_t {
  converged,  ///< right within the tolerance
  bounded,    ///< the iteration bound was reached first: right within `error`
  unbounded,  ///< two half-spaces that are not opposite: they overlap without a finite depth
};

/// The signed distance of two shapes and the points that realise it, in world space.
template <class T>
struct Distance {
  T distance{};      ///< signed: positive between separated shapes, negative when they overlap
  Vec3<T> normal{};  ///< unit, from A to B; moving B by -distance * normal makes the shapes touch
  Vec3<T> a{}, b{};  ///< on the surfaces: b - a = distance * normal
  Status status = Status::converged;
  T error{};  ///< a proven bound of |distance - truth| when the status is `bounded`
};

/// A convex piece of A and one of B, and their distance.
template <class T>
struct PieceDistance {
  std::uint32_t piece_a = 0, piece_b = 0;  ///< the triangle of a mesh or the child of the outermost compound, else 0
  Distance<T> distance{};                  ///< between the two pieces
};

/// The point of a shape's surface nearest to a point of the world.
template <class T>
struct Closest {
  T distance{};      ///< signed: negative inside a solid
  Vec3<T> point{};   ///< on the surface
  Vec3<T> normal{};  ///< unit, outward: the queried point - point = distance * normal
  Status status = Status::converged;
  T error{};  ///< a proven bound of |distance - truth| when the status is `bounded`
};

/// The hit of a ray with a shape, in world space.
template <class T>
struct RayHit {
  T t{};            ///< distance along the ray, in units of length (not in multiples of its direction)
  Vec3<T> point{};  ///< on the surface; the ray's origin when that lies inside a solid
  /// Unit, against the ray (by rounding across it); minus the ray's direction when its origin lies inside a solid.
  Vec3<T> normal{};
  std::uint32_t piece = 0;  ///< the triangle of a mesh or the child of the outermost compound, else 0
};

/// Treatment of rays that meet a triangle, alone or of a mesh, from behind: from the side on which its vertices run
/// clockwise. Triangles with a margin are solids and have no back.
enum class BackFaces : std::uint8_t {
  hit,     ///< hit as from the front, with the normal turned against the ray
  ignored  ///< not hit
};

}  // namespace graze
