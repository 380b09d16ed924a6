// The one list of special pairs. The table for single pairs, the kernels for batches, the world's bundles and the runs
// of a mesh's triangles are derived from it; a pair of convex shapes that is not in it takes the general path.
//
// To add a pair: a struct as described in `narrow/pairs/pair.hpp` in a file of its own, its include, and its name in
// the list.
#pragma once

#include <cstddef>
#include <type_traits>

#include "narrow/pairs/box_box/pair.hpp"
#include "narrow/pairs/box_rectangle.hpp"
#include "narrow/pairs/box_triangle/pair.hpp"
#include "narrow/pairs/capsule_box.hpp"
#include "narrow/pairs/capsule_capsule.hpp"
#include "narrow/pairs/capsule_rectangle.hpp"
#include "narrow/pairs/capsule_triangle.hpp"
#include "narrow/pairs/on_half_space.hpp"
#include "narrow/pairs/sphere_box.hpp"
#include "narrow/pairs/sphere_capsule.hpp"
#include "narrow/pairs/sphere_cylinder.hpp"
#include "narrow/pairs/sphere_sphere.hpp"
#include "narrow/pairs/sphere_triangle.hpp"
#include "narrow/pairs/triangle_triangle/pair.hpp"

namespace graze {

template <class... P>
struct Pairs {
  static constexpr std::size_t count = sizeof...(P);

  /// Calls `f` with each pair as its template argument.
  template <class F>
  static constexpr void each(const F& f) {
    (f.template operator()<P>(), ...);
  }
  /// Calls `f` with the pair at that index in the list, if there is one.
  template <class F>
  static constexpr void with(std::size_t place, const F& f) {
    std::size_t at = 0;
    (void)((at++ == place ? (f.template operator()<P>(), true) : false) || ...);
  }
};

using PairList =
    Pairs<SphereSphere, SphereCapsule, SphereBox, ClosedFormPair<Sphere, Rectangle>, SphereCylinder,
          ClosedFormPair<Sphere, LineSegment>,
          SphereTriangle,                                                                                       //
          CapsuleCapsule, CapsuleBox, CapsuleRectangle, ClosedFormPair<Capsule, LineSegment>, CapsuleTriangle,  //
          BoxBox, BoxRectangle<Box>, ClosedFormPair<Box, LineSegment>, BoxTriangle,                             //
          BoxRectangle<Rectangle>, ClosedFormPair<Rectangle, LineSegment>,                                      //
          ClosedFormPair<LineSegment, LineSegment>,                                                             //
          TriangleTriangle,                                                                                     //
          OnHalfSpace<Sphere>, OnHalfSpace<Capsule>, OnHalfSpace<Box>, OnHalfSpace<Rectangle>, OnHalfSpace<Cylinder>,
          OnHalfSpace<Ellipsoid>, OnHalfSpace<LineSegment>, OnHalfSpace<Triangle>, OnHalfSpace<ConvexHull>,
          OnHalfSpace<UserConvex>, OnHalfSpace<HalfSpace>>;

}  // namespace graze
