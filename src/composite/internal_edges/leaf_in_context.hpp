// A piece of a surface among its neighbours, and what counts as lying on it.
//
// Guarantee: where a piece lies decides, not which vertices it shares; all tolerances are relative to sizes and
// coordinates.
#pragma once

#include <limits>
#include <span>

#include "graze/shape.hpp"

namespace graze {

template <class T>
class MeshPatch;

/// A convex piece of a shape, the shape, and what stands still beside it and may continue its surface.
template <class T>
struct LeafInContext {
  const Shape<T>& whole;
  const Pose<T>& whole_pose;
  const Shape<T>& piece;
  const Pose<T>& pose;
  std::span<const PlacedRef<T>> beside = {};
  std::uint32_t number = 0;             ///< of the piece, if the whole is a mesh
  const MeshPatch<T>* patch = nullptr;  ///< of the mesh, where the piece is one of its triangles
  bool of_body = false;                 ///< a triangle of a mesh that bounds a body and is met from outside it
};

/// Whether a shape is a half-space: the normal of one is right wherever it is met.
template <class T>
bool is_ground(const Shape<T>& shape) {
  return shape.template as<HalfSpace<T>>() != nullptr;
}

/// Whether a shape can lie on a surface. Two surfaces cross rather than lie on each other.
template <class T>
bool is_solid(const Shape<T>& shape) {
  return !shape.template as<Triangle<T>>() && !is_ground(shape);
}

/// Whether a piece can lie on a surface: as a solid, or as part of the skin of one.
template <class T>
bool may_lie(const LeafInContext<T>& leaf) {
  return leaf.of_body || is_solid(leaf.piece);
}

/// The middle of the body that a piece is of: of its own, or of the mesh that bounds one.
template <class T>
Vec3<T> middle_of(const LeafInContext<T>& leaf) {
  return leaf.of_body ? bounds(leaf.whole, leaf.whole_pose).center() : bounds(leaf.piece, leaf.pose).center();
}

/// The normal of a half-space's plane in the world.
template <class T>
Vec3<T> plane_normal(const Pose<T>& pose) {
  return rotate(pose.rotation, Vec3<T>{T(0), T(1), T(0)});
}
/// The height of a place above the plane of a half-space; negative below.
template <class T>
T height_above(const Shape<T>& ground, const Pose<T>& pose, const Vec3<T>& place) {
  return dot(plane_normal(pose), place - pose.translation) - ground.rounding();
}

/// The point of a convex shape where it stands that lies furthest along a direction.
template <class T>
Vec3<T> furthest(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& direction) {
  return transform(pose, support(shape, rotate(conjugate(pose.rotation), direction)));
}

/// The face normal of a triangle in its own frame; zero without area.
template <class T>
Vec3<T> face_normal(const Triangle<T>& t) {
  return normalized(cross(t.point(1) - t.point(0), t.point(2) - t.point(0)), Vec3<T>{});
}

/// Sines below this are none: far above the error of a normal in float (curved depths have half the digits), far below
/// what a slope is made of.
template <class T>
inline constexpr T same_direction = T(2e-4);
/// A normal is inside a Voronoi region that it leaves by less than this sine: half the above, so that what is left of
/// it on a flat surface is laid along the face.
template <class T>
inline constexpr T region_slack = same_direction<T> / T(2);
/// Whether two unit vectors are one direction, up to that.
template <class T>
bool leads_along(const Vec3<T>& a, const Vec3<T>& b) {
  return dot(a, b) > T(0) && length_squared(cross(a, b)) <= region_slack<T> * region_slack<T>;
}
/// A point lies on a piece that is nearer than this, relative to the piece: ten times the tolerance of points in float.
template <class T>
inline constexpr T on_piece = T(1e-4);

/// The rounding error of coordinates of this size: a pose seen from another takes some thirty roundings.
template <class T>
T coordinate_noise(T size) {
  return T(64) * std::numeric_limits<T>::epsilon() * size;
}
template <class T>
T place_noise(const Vec3<T>& place) {
  return coordinate_noise(max_abs(place));
}
/// The rounding error of a place of the world that is seen in another frame, where its coordinates may be larger.
template <class T>
T place_noise(const Vec3<T>& place, const Vec3<T>& local) {
  return greatest(place_noise(place), place_noise(local));
}
/// The rounding error of a place of the world that is seen in the frame of a piece.
template <class T>
T place_noise(const LeafInContext<T>& self, const Vec3<T>& place) {
  return place_noise(place, inverse_transform(self.pose, place));
}

}  // namespace graze
