#include "narrow/general.hpp"

#include "narrow/direct_depth.hpp"
#include "narrow/epa.hpp"
#include "narrow/gjk.hpp"
#include "narrow/hull_depth.hpp"
#include "narrow/pairs/box_distance.hpp"
#include "narrow/polyhedral_pair.hpp"
#include "narrow/scanned_shape.hpp"
#include "shape/expect_faces.hpp"

namespace graze {

namespace {

/// What the iterations aim at: well within the library's tolerance, since closest points and normals of smooth shapes
/// lose half the digits of the distance.
constexpr double distance_goal = 1e-13;
constexpr double depth_goal = 1e-11;

template <class T>
using Difference = MinkowskiDifference<ShapeCore<T>, ShapeCore<T>>;

/// Half the answer on each side of the middle of the two points, so that b - a = distance * normal holds to the last
/// bits whatever the iteration left.
CoreDistance<double> centered(double distance, const Vec3d& normal, const Vec3d& a, const Vec3d& b) {
  const Vec3d middle = (a + b) * 0.5, half = normal * (distance * 0.5);
  return {distance, normal, middle - half, middle + half};
}

/// Two shapes whose corners are scanned.
template <class T>
struct ScannedPair {
  ScannedPair(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a)
      : corners_a(a),
        corners_b(b),
        difference(corners_a.view(), corners_b.view(), greatest(corners_a.extent(), corners_b.extent()), b_in_a) {}

  ScannedShape<T> corners_a, corners_b;
  HullDifference<T> difference;
};
/// A hull and another such shape: all others have routines of their own.
template <class T>
bool are_scanned(const Shape<T>& a, const Shape<T>& b) {
  return (is_hull(a) || is_hull(b)) && is_scannable(a) && is_scannable(b);
}

template <class Difference>
GeneralDistance judged(const Difference& difference, const CoreDistance<double>& core, double gap, double noise) {
  const double allowed = 0.5 * tolerance<double> * difference.size() + rounding * difference.reach();
  return {core, gap <= allowed ? Status::converged : Status::bounded, greatest(gap, 0.0), noise};
}

/// Of cores of which one at least has an ellipsoid or a disc in it, where the descent answers within the tolerance. The
/// depths of boxes and points are known without.
template <class T>
std::optional<GeneralDistance> directly(const Difference<T>& difference, const ShapeCore<T>& a, const ShapeCore<T>& b,
                                        const Posed& b_in_a, double limit, double noise) {
  const auto sum_a = a.summed(), sum_b = b.summed();
  if (!sum_a || !sum_b || !(max_abs(sum_a->radii) > 0 || max_abs(sum_b->radii) > 0)) return std::nullopt;
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), direct_depth);
  const auto found = kernel(*sum_a, *sum_b, b_in_a, limit + noise);
  if (!found) return std::nullopt;
  const double distance = -found->depth;
  if (distance > limit + noise) return GeneralDistance{{distance, found->normal, {}, {}}, Status::converged, 0, noise};
  const auto answer =
      judged(difference, centered(distance, found->normal, found->a, found->b), found->depth - found->lower, noise);
  if (answer.status != Status::converged) return std::nullopt;
  return answer;
}

GjkGoal distance_goals(double size, double noise, double limit) {
  return {distance_goal * size + noise, greatest(limit + noise, noise)};
}

template <class Difference>
GjkResult search(const Difference& difference, const GjkGoal& goal, Trace* trace) {
  return gjk(difference, goal, trace);
}
template <class T>
GjkResult search(HullDifference<T>& difference, const GjkGoal& goal, Trace* trace) {
  return gjk_spread(difference, goal, trace);
}

template <class Difference>
EpaResult depth_of(const Difference& difference, const Simplex& start, double goal, Trace* trace) {
  return epa(difference, start, goal, trace);
}
/// On lanes, unless the general EPA has to.
template <class T>
EpaResult depth_of(const HullDifference<T>& difference, const Simplex& start, double goal, Trace* trace) {
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), hull_depth<T>);
  const double noise = rounding * difference.reach();
  EpaResult found;
  const bool proven =
      start.size() == 4 && kernel(difference.hulls(), difference.placed(), start.points.data(), noise, goal, found);
  if (proven && !trace) return found;
  const EpaResult stepped = epa(difference, start, goal, trace);  // or the picture
  return proven ? found : stepped;
}

template <class T, class Difference>
GeneralDistance iteratively(const Shape<T>& a, const Shape<T>& b, Difference& difference, double noise, double limit,
                            Trace* trace) {
  const GjkGoal goal = distance_goals(difference.size(), noise, limit);
  if (trace) trace->method = "gjk";
  const GjkResult g = search(difference, goal, trace);
  if (g.end == GjkEnd::apart && g.lower > limit + noise)
    return {{g.lower, g.normal, {}, {}}, Status::converged, 0, noise};
  if (g.end != GjkEnd::touching && g.tells_normal()) {
    if (trace) trace->reason = "the cores are apart: the nearest point of their difference is not the origin";
    return judged(difference, centered(g.upper, g.normal, g.simplex.point_a(), g.simplex.point_b()), g.upper - g.lower,
                  noise);
  }
  if (trace) {
    trace->method = "gjk + epa";
    trace->reason = "the cores overlap: the facet of their difference nearest to the origin gives the depth";
  }
  if (limit < std::numeric_limits<double>::infinity()) {  // a question of contacts, whose faces come next
    expect_faces(a);
    expect_faces(b);
  }
  const EpaResult e = depth_of(difference, g.simplex, depth_goal * difference.size() + noise, trace);
  return judged(difference, centered(-e.upper, e.normal, e.a, e.b), e.upper - e.lower, noise);
}

}  // namespace

template <class T>
GeneralDistance general_distance(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, Trace* trace,
                                 double limit) {
  const double noise = noise_of(a, b, b_in_a.translation);
  if (are_scanned(a, b)) {
    ScannedPair<T> scanned(a, b, b_in_a);
    return iteratively(a, b, scanned.difference, noise, limit, trace);
  }
  const ShapeCore<T> core_a(a), core_b(b);
  const Difference<T> difference(core_a, core_b, b_in_a);
  // Two boxes' axes and corners cost less than GJK.
  if (const auto boxes = as_boxes(a, b, b_in_a)) {
    if (const BoxNearest<double> nearest = nearest_of_boxes(*boxes, noise); nearest.proven) {
      const CoreDistance<double>& core = nearest.core;
      const bool apart = core.distance > noise;
      if (trace) trace->method = apart ? "gjk" : "separating axes";
      if (trace && apart) gjk(difference, distance_goals(difference.size(), noise, limit), trace);  // the picture
      return judged(difference, centered(core.distance, core.normal, core.a, core.b), 0, noise);
    }
  }
  const auto direct = directly(difference, core_a, core_b, b_in_a, limit, noise);
  if (direct && !trace) return *direct;
  const GeneralDistance iterated = iteratively(a, b, difference, noise, limit, trace);
  return direct ? *direct : iterated;
}

template <class T>
bool general_overlap(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, double reach, Trace* trace) {
  const double noise = noise_of(a, b, b_in_a.translation);
  if (trace) trace->method = "gjk";
  const auto comes_within = [&](auto&& difference) {
    // What rounding cannot tell from touching touches, here as in the distance.
    const GjkGoal goal{distance_goal * difference.size() + noise, reach + noise, reach + noise};
    const GjkResult g = search(difference, goal, trace);
    return g.end == GjkEnd::touching || g.upper <= reach + noise;
  };
  // Few corners are sooner asked one by one than placed before the first question: a ball with a hull takes two thirds
  // of the time, a box the same.
  if (is_hull(a) && is_hull(b) && are_scanned(a, b)) return comes_within(ScannedPair<T>(a, b, b_in_a).difference);
  const ShapeCore<T> core_a(a), core_b(b);
  return comes_within(Difference<T>(core_a, core_b, b_in_a));
}

void to_world(Trace& trace, const Posed& pose_a) {
  const auto point = [&](TraceSupport& p) { p = {transform(pose_a, p.a), transform(pose_a, p.b)}; };
  const auto direction = [&](Vec3d& d) { d = rotate(pose_a.rotation, d); };
  for (TraceGjk& step : trace.gjk) {
    for (TraceSupport& p : step.simplex) point(p);
    direction(step.direction);
    point(step.found);
  }
  for (TraceEpa& step : trace.epa) {
    direction(step.normal);
    point(step.found);
  }
  for (TraceSupport& p : trace.polytope) point(p);
}

template GeneralDistance general_distance(const Shape<float>&, const Shape<float>&, const Posed&, Trace*, double);
template GeneralDistance general_distance(const Shape<double>&, const Shape<double>&, const Posed&, Trace*, double);
template bool general_overlap(const Shape<float>&, const Shape<float>&, const Posed&, double, Trace*);
template bool general_overlap(const Shape<double>&, const Shape<double>&, const Posed&, double, Trace*);

}  // namespace graze
