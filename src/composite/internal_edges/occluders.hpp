// Occluders: neighbours that lie over a contact, so that it is none of the surface that the pieces make together.
//
// A shape whose middle is above a floor and that meets, below the floor, the side of something has been let through by
// the floor and not by that side. So one looks from the contact to the middle of the shape: what lies between is the
// surface. That needs no inside: a sheet of triangles covers as a solid does.
//
// Guarantee: a wall that goes on above the floor at its foot is not covered, be it a step of four ten-thousandths of
// the smaller of the wall and the shape (and of what coordinates lose by rounding).
#pragma once

#include <optional>

#include "composite/internal_edges/leaf_in_context.hpp"

namespace graze {

/// A place on a surface, and its normal there (unit, world) on the side of what touches it.
template <class T>
struct OnSurface {
  Vec3<T> point, normal;
  bool outside_region = false;  ///< something rises above it: the normal is none of the surface's after all
};

/// The distance of a place of the world from a convex piece; negative inside a solid one.
template <class T>
T distance_to(const LeafInContext<T>& self, const Vec3<T>& place);

/// The point at which a neighbour hides a contact of `self`, at `point` with the normal `outward`, from the middle of
/// `other`, if one does that continues the surface: it rises above the plane through the contact, and `self`
/// does not go on above it. A search along a line for each contact asked about; no allocation.
template <class T>
std::optional<OnSurface<T>> surface_over(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                         const LeafInContext<T>& other);

/// Whether `surface_over` finds something for a triangle of a mesh or height field that is the whole and has nothing
/// beside it. It ends at the first that covers, and looks across the edges of the triangle before it searches.
template <class T>
bool is_covered(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                const LeafInContext<T>& other);

/// The surface of the solid `self` itself that is seen from the middle of `other` where it looks at the contact, if
/// nothing rises above that.
template <class T>
std::optional<OnSurface<T>> own_surface(const LeafInContext<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                        const LeafInContext<T>& other);

}  // namespace graze
