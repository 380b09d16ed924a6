#include "narrow/gjk/hull_depth.hpp"

#include <limits>

#include "narrow/core/hull_scan.hpp"
#include "narrow/gjk/lane_polytope.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// Limits of the number range, not tolerances: the noise is `rounding`, 7e-15, times the difference's reach, which so
/// lies between 1e-26 and 2e54, and the squares of areas of that size, its fourth powers, between 1e-104 and 1e217.
constexpr double least_noise = 1e-40, most_noise = 1e40;

}  // namespace

template <class T>
[[gnu::flatten]] bool hull_depth(const HullPair<T>& hulls, const PlacedVertices& placed,
                                 const SupportPoint* tetrahedron, double noise, double tolerance, EpaResult& r) {
  if (!(noise > least_noise && noise < most_noise)) return false;
  LanePolytope polytope(noise);
  polytope.begin(tetrahedron);
  r.upper = std::numeric_limits<double>::infinity();
  std::size_t deepest = 0;
  const auto proven = [&] {
    const Vec3d outward = polytope.normal(deepest);
    r.lower = least(r.lower, r.upper);
    r.normal = -outward;
    return polytope.witness(outward, deepest, r.a, r.b);
  };
  while (polytope.has_room()) {
    const std::size_t facet = polytope.nearest_open();
    if (!polytope.open(facet)) return false;
    r.lower = polytope.offset(facet);
    if (r.upper - r.lower <= tolerance) return proven();
    const SupportPoint& found = polytope.next_point() = support_of(hulls, placed, -polytope.outward(facet));
    const double depth = dot(found.w, polytope.normal(facet));
    deepest = depth < r.upper ? facet : deepest;
    r.upper = least(r.upper, depth);
    if (depth - r.lower <= noise) {
      // A facet of the difference itself, and no other is nearer.
      if (r.upper - r.lower <= tolerance) return proven();
      polytope.close(facet);
    } else if (!polytope.expand()) {
      return false;
    }
  }
  return false;
}

template bool hull_depth(const HullPair<float>&, const PlacedVertices&, const SupportPoint*, double, double,
                         EpaResult&);
template bool hull_depth(const HullPair<double>&, const PlacedVertices&, const SupportPoint*, double, double,
                         EpaResult&);

}  // namespace graze::GRAZE_ISA
