// Observers of GJK and EPA: the iterations are templates over one and pass it each step.
//
// Guarantee: `Unobserved`, used for every answer, is empty and costs nothing. An observer has no influence on the
// iterations, except that one that observes also receives the steps of a search that could have ended at the first
// support point.
#pragma once

#include "graze/vec3.hpp"
#include "narrow/core/support_point.hpp"

namespace graze {

struct Unobserved {
  static constexpr bool observes = false;

  /// An iteration of GJK: the simplex with the new point as its last, the unit vector along which that was found, and
  /// the present bounds of the distance.
  template <class Simplex>
  void gjk_step(const Simplex&, const Vec3d& /*direction*/, double /*lower*/, double /*upper*/) const {}
  /// An expansion of EPA's polytope: normal (from A to B) and depth of the facet nearest to the origin, and the point
  /// found along its normal, at `found_depth`.
  template <class Polytope>
  void expansion(const Vec3d& /*normal*/, double /*facet_depth*/, double /*found_depth*/, const SupportPoint&,
                 const Polytope&) const {}
  /// EPA's final polytope.
  template <class Polytope>
  void final_polytope(const Polytope&) const {}
};

}  // namespace graze
