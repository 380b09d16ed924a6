// The time for which a translation is free of contact: a ray cast against the Minkowski difference of two cores.
//
// Guarantee: until the time returned the cores stay further apart than the gap that is given; every step is proven by a
// plane between them. The time is the one of contact, up to the tolerance, or earlier where GJK stalls.
//
// Method: van den Bergen 2004, "Ray casting against general convex objects with application to continuous collision
// detection": GJK searches the plane nearest to the moving origin, and whenever the plane at hand separates, time goes
// on to where it does no more, without waiting for GJK to end. Ten to fifteen support points do for most casts.
#pragma once

#include "narrow/gjk/simplex.hpp"

namespace graze {

/// The most iterations: more gain less than a fresh start at the time reached.
inline constexpr int translation_iterations = 24;

struct FreeTranslation {
  double t;         ///< time until which the cores are proven to stay apart; infinity when they do throughout
  Simplex simplex;  ///< of their difference at that time
};

/// The translation by `velocity` for `duration` that is free of contact. `support(n)` gives the points of both cores
/// that lie nearest to each other along the unit vector n, at the beginning. The cores are to stay `gap` apart;
/// `enough` is a distance at which there is nothing to gain.
template <class Support>
FreeTranslation free_translation(const Support& support, const Vec3d& start, const Vec3d& velocity, double gap,
                                 double enough, double duration) {
  FreeTranslation free{0, {}};
  Simplex& simplex = free.simplex;
  Vec3d direction = unit(start);
  for (int i = 0; i < translation_iterations; ++i) {
    SupportPoint found = support(direction);
    found.w += velocity * free.t;
    const double room = dot(found.w, direction) - gap;
    if (room > 0) {
      const double closing = -dot(velocity, direction);
      const double step = room / closing;
      if (!(closing > 0) || free.t + step > duration) return {std::numeric_limits<double>::infinity(), {}};
      free.t += step;
      found.w += velocity * step;
      for (SupportPoint& v : simplex.points) v.w += velocity * step;
    }
    const bool known = std::any_of(simplex.points.begin(), simplex.points.end(),
                                   [&](const SupportPoint& p) { return p.a == found.a && p.b == found.b; });
    if (known && !(room > 0)) break;
    if (!known) simplex.push(found);
    const Nearest nearest = nearest_to_origin(simplex);
    if (nearest.enclosed) break;
    reduce(simplex, nearest);
    const double distance = length(nearest.point);
    if (distance <= enough) break;
    direction = nearest.point / distance;
  }
  for (SupportPoint& v : simplex.points) v.b += velocity * free.t;
  return free;
}

}  // namespace graze
