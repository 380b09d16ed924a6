// Rays, segments and planes: the plain data of the small exact questions (`geometry.hpp`) and of ray casts.
//
// Guarantee: plain aggregates without invariants; the questions that take them say what they need of them.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// The points origin + t direction with t >= 0.
template <class T>
struct Ray {
  Vec3<T> origin{}, direction{};  ///< where it begins, and where to
};

/// The straight piece between two points, both included; a point when they are equal.
template <class T>
struct Segment {
  Vec3<T> a{}, b{};  ///< the two ends
};

/// The points p with dot(normal, p) = offset; `normal` is of unit length and points out of the solid side.
template <class T>
struct Plane {
  Vec3<T> normal{T(0), T(1), T(0)};  ///< unit; towards what lies outside
  T offset{};                        ///< the normal times any point of the plane
};

/// How far `p` lies before the plane; negative behind it.
template <class T>
constexpr T signed_distance(const Plane<T>& plane, const Vec3<T>& p) {
  return dot(plane.normal, p) - plane.offset;
}

using Rayf = Ray<float>;
using Rayd = Ray<double>;
using Segmentf = Segment<float>;
using Segmentd = Segment<double>;
using Planef = Plane<float>;
using Planed = Plane<double>;

}  // namespace graze
