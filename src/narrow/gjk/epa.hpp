// EPA: the penetration depth of two convex cores (van den Bergen 2001, "Proximity queries and penetration depth
// computation on 3D game objects"; the expanding polytope in his 2003 book, section 4.3.8).
//
// Guarantee: `upper` is the length of a translation that does separate the cores (measured by a support query), and no
// shorter one than `lower` exists. They meet within the tolerance unless the expansion bound is reached, which happens
// only where very many directions give nearly the same depth (bodies of revolution, concentric and alike): then `upper`
// is good and only its proof is missing.
#pragma once

#include "narrow/gjk/epa_result.hpp"
#include "narrow/gjk/gjk.hpp"
#include "narrow/gjk/polytope.hpp"

namespace graze {

inline constexpr int epa_expansions = 240;
/// Bounds of the final slide; its clearance is far above rounding, and small so that few steps are needed.
inline constexpr int slide_steps = 256;
inline constexpr double slide_stretch = 65536, slide_clearance = 1.0 / 64;

/// A difference with B translated.
template <class Difference>
class Translated {
 public:
  Translated(const Difference& difference, const Vec3d& offset) : difference_(difference), offset_(offset) {}

  SupportPoint support(const Vec3d& direction) const {
    SupportPoint p = difference_.support(direction);
    p.w += offset_;
    return p;
  }
  Vec3d center_offset() const { return offset_; }
  double reach() const { return difference_.reach() + max_abs(offset_); }

 private:
  const Difference& difference_;
  Vec3d offset_;
};

/// Slides along the boundary of the difference to a nearest point of its neighbourhood: B is moved clear of A along the
/// present normal, and the normal of the closest points then is a better one. The depth never grows, and each step is
/// lengthened as long as that pays, until only rounding (`noise`) is left to gain. For shapes that need too many
/// facets: smooth ones, nearly concentric.
template <class Difference>
void slide(const Difference& difference, double noise, EpaResult& r) {
  const double clearance = slide_clearance * difference.size();
  const auto depth_along = [&](const Vec3d& outward) { return dot(difference.support(-outward).w, outward); };
  for (int i = 0; i < slide_steps; ++i) {
    const Vec3d outward = -r.normal;
    const Translated<Difference> clear(difference, r.normal * (r.upper + clearance));
    const GjkResult g = gjk(clear, {noise});
    if (g.end == GjkEnd::touching || !(g.upper > 0)) return;
    r.a = g.simplex.point_a();
    r.b = g.simplex.point_b();
    const Vec3d turn = -g.normal - outward;

    double depth = r.upper;
    Vec3d normal = r.normal;
    for (double stretch = 1; stretch <= slide_stretch; stretch *= 2) {
      const Vec3d further = unit(outward + turn * stretch);
      const double found = depth_along(further);
      if (!(found < depth)) break;
      depth = found;
      normal = -further;
    }
    if (!(r.upper - depth > noise)) return;
    r.upper = depth;
    r.normal = normal;
  }
}

/// Takes one of the axes of the two shapes' frames, or the line between their centres, where that has less depth: a
/// body of revolution may have its face there, which the polytope meets only by chance.
template <class Difference>
void try_axes(const Difference& difference, EpaResult& r) {
  const auto take = [&](const Vec3d& outward) {
    const double depth = dot(difference.support(-outward).w, outward);
    if (!(depth < r.upper)) return;
    r.upper = depth;
    r.normal = -outward;
  };
  take(-unit(difference.center_offset()));
  if constexpr (requires { difference.rotation_of_b(); })
    for (std::size_t i = 0; i < 3; ++i)
      for (const Vec3d& axis : {Mat3d::identity().row[i], difference.rotation_of_b().column(i)}) {
        take(axis);
        take(-axis);
      }
}

template <class Difference, class Observer = Unobserved>
EpaResult epa(const Difference& difference, const Simplex& start, double tolerance, const Observer& observer = {}) {
  const double noise = rounding_error * difference.reach();
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
  const Facet* deepest = nullptr;
  for (int i = 0; i < epa_expansions; ++i) {
    const Facet* facet = polytope.nearest_open();
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
      deepest = facet;
    }
    if (depth - offset <= noise) {
      polytope.close(*facet);  // a facet of the difference itself
      r.upper = least(r.upper, depth);
    } else if (!polytope.expand(*facet, found)) {
      polytope.close(*facet);
    }
    observer.expansion(-normal, offset, depth, found, polytope);
  }
  // Not the last facet's offset, which disregards closed facets, and rounding of a sliver's plane.
  r.lower = polytope.inner_radius(r.upper);
  r.normal = -outward;
  polytope.witness(outward, deepest, r.a, r.b);
  if (r.upper - r.lower > tolerance) {
    try_axes(difference, r);
    slide(difference, noise, r);
  }
  // The boundary of the polytope is no further from the end of the normal than the two bounds are from each other.
  const Vec3d target = r.normal * -r.upper;
  const double missed = length(r.b - r.a - target);
  if (!(missed <= tolerance)) {
    Vec3d a{}, b{};
    polytope.nearest_witness(target, a, b);
    if (!(length(b - a - target) >= missed)) {
      r.a = a;
      r.b = b;
    }
  }
  observer.final_polytope(polytope);
  return r;
}

}  // namespace graze
