// The point of a simplex nearest to the origin: GJK's subproblem.
//
// By Voronoi regions (Ericson 2005, "Real-time collision detection", sections 5.1.5 and 5.1.6). In the interior of a
// triangle the point is made from the triangle's normal and not from its barycentric coordinates: its direction then
// keeps all its digits however close to the origin the triangle lies.
#pragma once

#include <array>

#include "narrow/minkowski.hpp"

namespace graze {

/// Up to four points of a Minkowski difference with the weights of the point nearest to the origin.
struct Simplex {
  std::array<SupportPoint, 4> point;
  std::array<double, 4> weight{};
  int size = 0;

  void push(const SupportPoint& p) { point[static_cast<std::size_t>(size++)] = p; }
  bool contains(const SupportPoint& p) const {
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i)
      if (point[i].w == p.w) return true;
    return false;
  }
  Vec3d point_a() const { return weighted(&SupportPoint::a); }
  Vec3d point_b() const { return weighted(&SupportPoint::b); }

 private:
  Vec3d weighted(Vec3d SupportPoint::*member) const {
    Vec3d sum;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) sum += point[i].*member * weight[i];
    return sum;
  }
};

/// The nearest point, and the face of the simplex that carries it: what `simplex` is reduced to.
/// `enclosed` when the simplex is a tetrahedron that holds the origin; it is left whole then.
struct Nearest {
  Vec3d point;
  bool enclosed = false;
};

Nearest reduce_to_nearest(Simplex& simplex);

}  // namespace graze
