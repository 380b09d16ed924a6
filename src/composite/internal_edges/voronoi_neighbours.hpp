// The neighbours of a piece that rise above a plane: where there is one, the plane's normal is none of the surface.
//
// Guarantee: a normal of a flat or concave edge always has one, that of a convex edge inside its Voronoi region never,
// up to the tolerances of `leaf_in_context.hpp`.
#pragma once

#include <algorithm>
#include <optional>

#include "composite/internal_edges/leaf_in_context.hpp"
#include "graze/fixed_vector.hpp"

namespace graze {

/// Calls `f(shape, pose)` for the whole and all that is beside it and holds the point, until it returns true.
template <class T, class F>
bool any_around(const LeafInContext<T>& self, const Vec3<T>& point, const F& f) {
  if (!self.whole.convex() && f(self.whole, self.whole_pose)) return true;
  return std::any_of(self.beside.begin(), self.beside.end(), [&](const PlacedRef<T>& other) {
    if (other.shape->template as<Compound<T>>()) return f(*other.shape, *other.pose);  // its tree tells as well
    // In its own frame, where bounds cost nothing.
    const Vec3<T> local = inverse_transform(*other.pose, point);
    const Aabb<T> box = bounds(*other.shape, Pose<T>{});
    const T reach = on_piece<T> * max_abs(box.extent()) + place_noise(point);
    return overlap(inflated(box, reach), Aabb<T>{local, local}) && f(*other.shape, *other.pose);
  });
}

/// Whether a convex piece touches `point` and rises above the plane through it. World space; `outward` unit.
template <class T>
bool piece_rises_above(const Shape<T>& piece, const Pose<T>& pose, const Vec3<T>& point, const Vec3<T>& outward);

/// The pieces that may be a neighbour that rises: all but the piece itself, or all.
enum class Among { others, all };

/// A neighbour of the piece that rises above the plane through the point.
template <class T>
std::optional<Placed<T>> neighbour_outside_region(const LeafInContext<T>& self, const Vec3<T>& point,
                                                  const Vec3<T>& outward, Among among = Among::others);

/// Whether a triangle that shares an edge with one of a mesh or height field rises above the plane through a point on
/// this: then `neighbour_outside_region` finds one, too. In the surface's frame; `noise`: what the point may be off by
/// for where the surface is. Nothing is searched, and false says nothing.
template <class T>
bool rises_across_edge(const Shape<T>& surface, std::uint32_t triangle, const Vec3<T>& point, const Vec3<T>& outward,
                       T noise);

/// The directions that the fronts of a mesh's triangles have where they touch a point, in the world: each once, and no
/// more than there is room for.
template <class T>
FixedVector<Vec3<T>, 16> faces_around(const LeafInContext<T>& self, const Vec3<T>& point);

}  // namespace graze
