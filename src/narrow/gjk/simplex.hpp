// The point of a simplex nearest to the origin: the distance subproblem of GJK.
//
// Method: Voronoi regions (Ericson 2005, "Real-time collision detection", sections 5.1.5 and 5.1.6). In the interior of
// a triangle the point is computed from the triangle's normal and not from its barycentric coordinates, and on an edge
// it is made orthogonal to it twice: its direction then keeps all its digits however close to the origin the simplex
// lies.
#pragma once

#include <array>
#include <cstdint>
#include <new>

#include "graze/fixed_vector.hpp"
#include "narrow/core/minkowski.hpp"

namespace graze {

/// Up to four points of a Minkowski difference with the weights of the point nearest to the origin.
struct Simplex {
  FixedVector<SupportPoint, 4> points;
  std::array<double, 4> weight{};  ///< weights of the points, of any sum; set by `reduce`

  std::size_t size() const { return points.size(); }
  const Vec3d& w(std::size_t i) const { return points[i].w; }
  void push(const SupportPoint& p) { points.push_back(p); }
  /// Appends a point, made by `query` in its place and not copied there.
  template <class Query>
  const SupportPoint& add(const Query& query) {
    return *::new (&points.emplace_back()) SupportPoint(query());
  }
  /// Whether the last point occurs twice.
  bool repeats() const {
    return std::any_of(points.begin(), points.end() - 1, [&](const SupportPoint& p) { return p.w == points.back().w; });
  }
  Vec3d point_a() const { return weighted(&SupportPoint::a); }
  Vec3d point_b() const { return weighted(&SupportPoint::b); }
  /// The point of the weights, which is the nearest one up to their digits.
  Vec3d point() const { return weighted(&SupportPoint::w); }

 private:
  Vec3d weighted(Vec3d SupportPoint::*member) const {
    double whole = 0;
    for (std::size_t i = 0; i < size(); ++i) whole += weight[i];
    Vec3d sum;
    for (std::size_t i = 0; i < size(); ++i) sum += points[i].*member * (weight[i] / whole);
    return sum;
  }
};

/// The point of a simplex nearest to the origin, and the vertices of the feature it lies on, in ascending order, with
/// its weights, of any sum. `enclosed` when the simplex is a tetrahedron that contains the origin: then all of its
/// vertices count.
template <class S>
struct NearestOf {
  Vec3<S> point;
  S squared = 0;  ///< squared length of the point
  bool enclosed = false;
  std::uint8_t size = 0;
  std::array<std::uint8_t, 3> index{};
  std::array<S, 3> weight{};
};
using Nearest = NearestOf<double>;

Nearest nearest_to_origin(const Simplex& simplex);

/// The nearest point in twice the digits of a double, rounded at the end, the weights of sum 1: its direction and side
/// are right however flat the simplex and however close the origin.
struct ExactNearest {
  Nearest nearest;
  Vec3d direction;  ///< unit vector to the point; any where that is the origin
  double distance = 0;
};
ExactNearest exactly_nearest_to_origin(const Simplex& simplex);

/// Reduces the simplex to the vertices of the nearest feature; a tetrahedron that contains the origin stays as it is.
void reduce(Simplex& simplex, const Nearest& nearest);

}  // namespace graze
