// Rays, segments and planes: the plain data of the elementary queries (`geometry.hpp`) and of ray casts.
//
// Guarantee: plain aggregates without invariants; the functions that take them state their requirements.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// The points origin + t direction with t >= 0.
template <class T>
struct Ray {
  Vec3<T> origin{}, direction{};  ///< starting point, and direction of any length
};

/// The straight piece between two points, both included; a point when they are equal.
template <class T>
struct Segment {
  Vec3<T> a{}, b{};  ///< the two ends
};

/// The points p with dot(normal, p) = offset; `normal` is of unit length and points out of the solid side.
template <class T>
struct Plane {
  Vec3<T> normal{T(0), T(1), T(0)};  ///< unit length, pointing away from the solid side
  T offset{};                        ///< dot(normal, p) of every point p of the plane
};

/// The distance of `p` in front of the plane; negative behind it.
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
