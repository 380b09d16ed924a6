// What lies over a contact, so that it is none of the surface that the pieces make together.
//
// A solid covers what is inside it. A sheet of triangles has no inside: it covers what it hides from the middle of the
// shape that touches it. A shape whose middle is above a floor and that meets, below the floor, the side of what
// continues the floor has been let through by the sheet and not by the side.
//
// Guarantee: a wall that goes on above the sheet is not covered, be it a step of twice the tolerance of its foot.
#pragma once

#include <optional>

#include "mid/piece_of.hpp"

namespace graze {

/// Whether the face of a solid lies against another solid at the point: a step outward leads into that.
template <class T>
bool is_covered(const PieceOf<T>& self, const Vec3<T>& point, const Vec3<T>& outward);

/// A place on a surface, and its normal there (unit, world) on the side of what touches it.
template <class T>
struct OnSurface {
  Vec3<T> point, normal;
};

/// Where a sheet hides a contact of `self`, at `point` with the normal `outward`, from the middle of `other`, if one does
/// that continues the surface: it rises above the plane through the contact, and `self` does not go on above it.
template <class T>
std::optional<OnSurface<T>> surface_over(const PieceOf<T>& self, const Vec3<T>& point, const Vec3<T>& outward,
                                         const PieceOf<T>& other);

}  // namespace graze
