// EPA: the penetration depth of two convex cores (van den Bergen 2001, "Proximity queries and penetration depth
// computation on 3D game objects"; the expanding polytope in his 2003 book, section 4.3.8).
//
// Guarantee: `upper` is the length of a translation that does separate the cores (it is measured by a support query),
// and no shorter one than `lower` exists. They meet within the tolerance unless the expansion bound is reached, as it
// is only where very many directions give nearly the same depth (bodies of revolution, concentric and alike): then
// `upper` is good and only its proof is missing.
#pragma once

#include "narrow/polytope.hpp"

namespace graze {

inline constexpr int epa_expansions = 240;

struct EpaResult {
  Vec3d normal;            ///< unit, from A to B
  Vec3d a, b;              ///< the deepest points: b - a = -upper * normal up to the tolerance
  double lower, upper;     ///< bounds of the depth; about zero where the cores merely touch
};

/// The nearest facet that can still be expanded, or none.
inline Facet* nearest_open(Polytope& polytope) {
  Facet* best = nullptr;
  for (Facet& f : polytope.facets())
    if (f.live && !f.final && (!best || f.offset < best->offset)) best = &f;
  return best;
}

template <class Difference>
EpaResult epa(const Difference& difference, const Simplex& start, double tolerance, Trace* trace = nullptr) {
  const double noise = rounding * difference.reach();
  Polytope polytope(noise);
  EpaResult r{};
  if (const Flat flat = polytope.begin(difference, start); flat.is) {
    // The difference has no inside: the cores touch, and the normal of its plane separates them at once.
    r.normal = flat.normal;
    r.a = flat.a;
    r.b = flat.b;
    r.lower = r.upper = flat.depth;
    return r;
  }

  r.upper = std::numeric_limits<double>::infinity();
  r.lower = -r.upper;
  Vec3d outward;
  for (int i = 0; i < epa_expansions; ++i) {
    Facet* facet = nearest_open(polytope);
    if (!facet) break;
    r.lower = facet->offset;
    if (r.upper - r.lower <= tolerance) break;

    const Vec3d normal = facet->normal;
    const double offset = facet->offset;
    const SupportPoint found = difference.support(-normal);
    const double depth = dot(found.w, normal);
    if (depth < r.upper) {
      r.upper = depth;
      outward = normal;
    }
    if (depth - offset <= noise) {
      facet->final = true;  // a facet of the difference itself
      r.upper = least(r.upper, depth);
    } else if (!polytope.expand(*facet, found)) {
      facet->final = true;
    }
    if (trace) trace->epa.push_back({-normal, offset, depth, traced(found), polytope.live_count()});
  }
  r.lower = least(r.lower, r.upper);
  r.normal = -outward;
  polytope.pierce(outward, r.a, r.b);
  if (trace) polytope.describe(*trace);
  return r;
}

}  // namespace graze
