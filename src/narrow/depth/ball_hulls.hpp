// The signed distance of two hulls of two balls each: of a tapered capsule from another, a capsule or a segment.
//
// Guarantee: a closed form, apart and overlapping alike, exact up to rounding; no iteration, and every case is proven.
// Along a unit vector n from A to B the separation of the hulls is
//
//     g(n) = min over the balls a of A and b of B of (c_b - c_a) . n - (r_a + r_b),
//
// and their signed distance is the largest g over all n. At its maximum, some of these at most four terms are equal and
// the others greater. One term c . n - r is largest along c; two terms are equal on a circle of the sphere and largest
// at its point nearest to c; three are equal at two points. All these directions are tried, and the largest g is right:
// a direction that is not the best gives too little, so that none can do harm.
#pragma once

#include <optional>

#include "graze/shape.hpp"
#include "narrow/core/core.hpp"

namespace graze {

struct Ball {
  Vec3d center;
  double radius;
};

/// The convex hull of two balls, which may be the same.
struct BallHull {
  Ball ball[2];
};

/// The core of a capsule or a segment in its own frame; nothing for other shapes.
template <class T>
std::optional<BallHull> ball_hull_of(const Shape<T>& shape);

/// The signed distance, in the common frame of both. The deepest or nearest points fulfil b - a = distance * normal.
CoreDistance<double> distance_of(const BallHull& a, const BallHull& b);

}  // namespace graze
