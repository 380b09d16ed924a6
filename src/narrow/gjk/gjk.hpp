// GJK: the distance of two convex cores (Gilbert, Johnson, Keerthi 1988, "A fast procedure for computing the distance
// between complex objects in three-dimensional space"; bounds and termination after van den Bergen 2003, "Collision
// detection in interactive 3D environments", section 4.3).
//
// Guarantee: at most `gjk_iterations` support queries a shape. When the cores are apart, `lower` <= true distance <=
// `upper` up to rounding, and `upper - lower` is within the tolerance unless the result says so.
#pragma once

#include "narrow/gjk/observer.hpp"
#include "narrow/gjk/simplex.hpp"

namespace graze {

/// Largest number of iterations. Polyhedra end after at most a few tens, smooth shapes gain a digit in two or three;
/// this is far above either need and bounds the cost of a faulty support function.
inline constexpr int gjk_iterations = 128;

/// Steps without progress that GJK takes before it stops; a simplex has at most four vertices to exchange.
inline constexpr int idle_steps = 4;

enum class GjkEnd {
  apart,     ///< the distance is known within the tolerance
  touching,  ///< the origin lies in the difference, or within rounding of it
  stalled,   ///< rounding or the iteration bound stopped it first; the bounds hold
};

struct GjkResult {
  GjkEnd end = GjkEnd::touching;
  Simplex simplex;  ///< carries the nearest point, or the origin when touching
  Vec3d nearest;    ///< point of the difference nearest to the origin: b - a of the closest points
  Vec3d normal;     ///< unit: the direction of `nearest`, or an earlier one along which the shapes are further apart
  double lower = 0, upper = 0;
  double along = 0;  ///< separation along `normal`, the proof that goes with it

  /// Whether the separation along `normal` is known to be about the distance: for two shapes about to touch, the vector
  /// between the points may have any direction.
  bool tells_normal() const { return lower > upper / 2; }
};

/// The needs of a caller, which decide when GJK may stop.
struct GjkGoal {
  double tolerance;        ///< largest `upper - lower`
  double separation = -1;  ///< stop as soon as the distance is known to exceed this (if >= 0)
  double proximity = -1;   ///< stop as soon as the distance is known not to exceed this (if >= 0)
};

/// Takes the direction of the nearest point, along which the separation is `separation`, as the normal unless an
/// earlier one is better: rounding can keep the direction from settling, and an earlier one's separation may gain more
/// than it costs in agreement with the closest points.
inline void take_normal(GjkResult& r, const Vec3d& direction, double separation) {
  if (separation >= r.lower || length(r.nearest - r.normal * r.upper) >= r.lower - separation) {
    r.normal = by_parts(direction);
    r.along = separation;
  }
  r.lower = greatest(r.lower, separation);
}

/// Iterates from the simplex of `r`, whose points are the difference's.
template <class Difference, class Observer>
void gjk_onward(GjkResult& r, const Difference& difference, const GjkGoal& goal, const Observer& observer) {
  using std::sqrt;
  r.lower = r.along = -std::numeric_limits<double>::infinity();
  const double touching = rounding_error * difference.reach();

  const Nearest first = nearest_to_origin(r.simplex);
  r.end = GjkEnd::touching;
  if (first.enclosed) return;
  reduce(r.simplex, first);
  r.nearest = by_parts(first.point);
  r.upper = sqrt(first.squared);

  const auto ended = [&](GjkEnd end) {
    r.end = end;
    r.simplex.points.pop_back();
  };
  int idle = 0;
  for (int i = 0; i < gjk_iterations; ++i) {
    r.end = GjkEnd::touching;
    if (r.upper <= touching) return;
    if (goal.proximity >= 0 && r.upper <= goal.proximity) return;

    const Vec3d direction = r.nearest / r.upper;
    // Along `r.nearest`, since the direction takes longer: a root and a division.
    const SupportPoint& found = r.simplex.add([&] { return difference.support(r.nearest); });
    const double separation = dot(found.w, direction);
    take_normal(r, direction, separation);
    observer.gjk_step(r.simplex, direction, r.lower, r.upper);
    if (goal.separation >= 0 && r.lower > goal.separation) return ended(GjkEnd::apart);
    // Within the tolerance, and separated along a normal that gives the distance, or within rounding of it.
    if (r.upper - r.lower <= goal.tolerance && (r.tells_normal() || r.upper - separation <= touching))
      return ended(GjkEnd::apart);
    if (r.simplex.repeats()) return ended(GjkEnd::stalled);

    const Nearest nearest = nearest_to_origin(r.simplex);
    if (nearest.enclosed) {
      // A flat tetrahedron is unreliable: the shapes are known to be apart.
      if (r.lower > touching) return ended(GjkEnd::stalled);
      r.nearest = {};
      r.lower = r.upper = 0;
      r.end = GjkEnd::touching;
      return;
    }
    const double upper = sqrt(nearest.squared);
    // A step along a long thin simplex may change the direction and yet shorten it by less than rounding: a few such
    // steps are taken; more of them would cycle.
    if (upper >= r.upper && (upper > r.upper + touching || ++idle > idle_steps)) return ended(GjkEnd::stalled);
    reduce(r.simplex, nearest);
    r.nearest = by_parts(nearest.point);
    r.upper = upper;
  }
  r.end = GjkEnd::stalled;
}

/// Largest relative difference of the gap along the normal and the distance of the points for shapes so close that the
/// goal's tolerance leaves the normal open: a gap that falls short by a part e leans by sqrt(2 e), here 3e-4.
inline constexpr double settled_part = 5e-8;

/// Number of the goal's tolerances by which a search may miss and still be good enough for its answer: the goal is far
/// within the guarantee.
inline constexpr double open_part = 32;

/// Volume of a tetrahedron, relative to the product of three of its edges, below which too few digits are left to
/// decide on which side of its faces the origin lies.
inline constexpr double flat_volume = 1e-5;

/// Distance of the points, relative to the difference's size, below which they are checked against their weights.
inline constexpr double weights_part = 1e-3;

/// More than any search needs that begins near its end, unless it cycles.
inline constexpr int refining_iterations = 64;

inline bool is_flat(const Simplex& s) {
  const Vec3d a = s.w(0) - s.w(3), b = s.w(1) - s.w(3), c = s.w(2) - s.w(3);
  const double volume = dot(cross(a, b), c);
  return !(volume * volume > flat_volume * flat_volume * dot(a, a) * dot(b, b) * dot(c, c));
}

/// Rounding of the gap along a unit vector: that of a support query's rotation and difference, and of a product.
inline double gap_rounding(double reach) { return 4 * std::numeric_limits<double>::epsilon() * reach; }

/// Whether the numbers at the end of the search do not prove its answer: the gap along the normal is not the distance
/// of the points, the points are not those of the weights, or a flat tetrahedron contains the origin.
template <class Difference>
bool is_open(const GjkResult& r, const Difference& difference, const GjkGoal& goal) {
  if (r.end == GjkEnd::touching) return r.simplex.size() == 4 && is_flat(r.simplex);
  if (goal.separation >= 0 && r.along > goal.separation) return false;
  const double apart = r.upper - r.along, noise = gap_rounding(difference.reach());
  if (apart > greatest(noise, least(settled_part * r.upper, open_part * goal.tolerance))) return true;
  // The weights of a triangle that is nearly a segment have fewer digits than its nearest point.
  return r.upper < weights_part * difference.reach() && length(r.simplex.point() - r.nearest) > noise;
}

/// Continues from where rounding ended the search, the nearest point of each simplex in twice the digits.
template <class Difference, class Observer>
[[gnu::noinline]] void gjk_refined(GjkResult& r, const Difference& difference, const GjkGoal& goal,
                                   const Observer& observer) {
  const double noise = gap_rounding(difference.reach()), touching = rounding_error * difference.reach();
  Simplex simplex = r.simplex;
  r.upper = std::numeric_limits<double>::infinity();
  if (r.end == GjkEnd::touching) r.lower = r.along = -std::numeric_limits<double>::infinity();
  r.end = GjkEnd::stalled;
  int idle = 0;
  for (int i = 0; i < refining_iterations; ++i) {
    const ExactNearest found = exactly_nearest_to_origin(simplex);
    if (found.nearest.enclosed) {
      if (r.lower > touching) break;
      r.end = GjkEnd::touching;
      r.simplex = simplex;
      r.nearest = {};
      r.lower = r.upper = 0;
      return;
    }
    if (found.distance >= r.upper && (found.distance > r.upper + noise || ++idle > idle_steps)) break;
    reduce(simplex, found.nearest);
    r.simplex = simplex;
    r.nearest = found.nearest.point;
    r.upper = found.distance;
    if (r.upper <= touching || (goal.proximity >= 0 && r.upper <= goal.proximity)) {
      r.end = GjkEnd::touching;
      return;
    }
    const SupportPoint& next = simplex.add([&] { return difference.support(found.direction); });
    take_normal(r, found.direction, dot(next.w, found.direction));
    observer.gjk_step(simplex, found.direction, r.lower, r.upper);
    const double apart = r.upper - r.along;
    if ((goal.separation >= 0 && r.along > goal.separation) ||
        (apart <= goal.tolerance && apart <= greatest(noise, settled_part * r.upper))) {
      r.end = GjkEnd::apart;
      break;
    }
    if (simplex.repeats()) break;
  }
}

template <class Difference, class Observer>
void refine_if_open(GjkResult& r, const Difference& difference, const GjkGoal& goal, const Observer& observer) {
  if (is_open(r, difference, goal)) gjk_refined(r, difference, goal, observer);
}

/// Starts from a simplex of points of the difference, such as the result for a nearby pose.
template <class Difference>
GjkResult gjk_from(const Simplex& simplex, const Difference& difference, const GjkGoal& goal) {
  GjkResult r;  // not zeroed: most of its simplex is never read
  r.simplex = simplex;
  gjk_onward(r, difference, goal, Unobserved());
  refine_if_open(r, difference, goal, Unobserved());
  return r;
}

/// Adds the support point along the unit vector `n`, found by `query`, to the simplex. Returns whether it separates the
/// shapes by enough at once; a search with an observer goes on all the same.
template <class Observer, class Query>
bool separates_at_once(GjkResult& r, const Query& query, const GjkGoal& goal, const Vec3d& n) {
  const SupportPoint& found = r.simplex.add([&] { return query(n); });
  const double separation = dot(found.w, n);
  if (goal.separation < 0 || !(separation > goal.separation) || Observer::observes) return false;
  r.end = GjkEnd::apart;
  r.nearest = found.w;
  r.normal = n;
  r.lower = r.along = separation;
  r.upper = length(found.w);
  r.simplex.points[0] = found;
  r.simplex.points.truncate(1);
  r.simplex.weight[0] = 1;
  return true;
}

/// Starts from the support point along the line from centre to centre.
template <class Difference, class Observer = Unobserved>
GjkResult gjk(const Difference& difference, const GjkGoal& goal, const Observer& observer = {}) {
  GjkResult r;
  const auto support = [&](const Vec3d& n) { return difference.support(n); };
  if (separates_at_once<Observer>(r, support, goal, unit(difference.center_offset()))) return r;
  gjk_onward(r, difference, goal, observer);
  refine_if_open(r, difference, goal, observer);
  return r;
}

/// Starts from four points: the support point along the line from centre to centre, and three along vectors that lean
/// from it to where that point lies. They have no dependency on each other as steps do, and save about three of these.
/// Polyhedra start so: all their support points are corners. The separations along these vectors answer a goal that
/// they meet; else they are dropped, since the last step of the search proves as much along a better one.
template <class Difference, class Observer = Unobserved>
GjkResult gjk_spread(Difference& difference, const GjkGoal& goal, const Observer& observer = {}) {
  // Unit vectors by their components along that line, towards the point and across: 1, 0.3, 0 and 1, 0.5, +-0.5. Among
  // three dozen sets tried, the one with the fewest steps for random hulls of 32 points.
  constexpr double leans[3][3] = {{0.95782628522115137, 0.28734788556634541, 0},
                                  {0.81649658092772603, 0.40824829046386302, 0.40824829046386302},
                                  {0.81649658092772603, 0.40824829046386302, -0.40824829046386302}};
  using std::sqrt;
  GjkResult r;
  const Vec3d forward = unit(difference.center_offset());
  const auto first_support = [&](const Vec3d& n) { return difference.first_support(n); };
  const auto support = [&](const Vec3d& n) { return difference.support(n); };
  if (separates_at_once<Observer>(r, first_support, goal, forward)) return r;
  difference.place();
  Vec3d u, v;
  tangents_at(forward, u, v);
  const double x = dot(r.simplex.w(0), u), y = dot(r.simplex.w(0), v), beside = sqrt(x * x + y * y);
  const double c = beside > 0 ? x / beside : 1, s = beside > 0 ? y / beside : 0;
  for (const auto& [ahead, toward, across] : leans) {
    const Vec3d n = forward * ahead + u * (c * toward - s * across) + v * (s * toward + c * across);
    if (separates_at_once<Observer>(r, support, goal, n)) return r;
    const Vec3d& found = r.simplex.points.back().w;
    if constexpr (Observer::observes) observer.gjk_step(r.simplex, n, dot(found, n), length(found));
    if (r.simplex.repeats()) r.simplex.points.pop_back();
  }
  gjk_onward(r, difference, goal, observer);
  refine_if_open(r, difference, goal, observer);
  return r;
}

}  // namespace graze
