#include "narrow/general.hpp"

#include "narrow/core/core_inside.hpp"
#include "narrow/depth/ball_hulls.hpp"
#include "narrow/depth/coaxial_depth.hpp"
#include "narrow/depth/newton_depth.hpp"
#include "narrow/general_search.hpp"
#include "narrow/gjk/epa.hpp"
#include "narrow/gjk/hull_depth.hpp"
#include "narrow/pairs/box_box/distance.hpp"
#include "narrow/sat/polyhedral_pair.hpp"
#include "shape/expect_faces.hpp"

namespace graze {

namespace {

/// Puts half of the distance on each side of the middle of the two points, so that b - a = distance * normal holds to
/// the last bits whatever the iteration left.
CoreDistance<double> centered(double distance, const Vec3d& normal, const Vec3d& a, const Vec3d& b) {
  const Vec3d middle = (a + b) * 0.5, half = normal * (distance * 0.5);
  return {distance, normal, middle - half, middle + half};
}

template <class Difference>
GeneralDistance judged(const Difference& difference, const CoreDistance<double>& core, double gap, double noise) {
  const double allowed = 0.5 * tolerance<double> * difference.size() + rounding_error * difference.reach();
  if (gap <= allowed) return {core, Status::converged, greatest(gap, 0.0), noise};
  return {core, Status::bounded, gap + noise, noise};  // rounding may also reduce the gap along the normal
}

/// The result of Newton's descent, perhaps unproven, for cores of which one at least contains an ellipsoid or a disc.
/// The depths of boxes and points are known without it.
template <class T>
std::optional<GeneralDistance> directly(const Difference<T>& difference, const ShapeCore<T>& a, const ShapeCore<T>& b,
                                        const Posed& b_in_a, double limit, double noise) {
  const auto sum_a = a.summed(), sum_b = b.summed();
  if (!sum_a || !sum_b || !(max_abs(sum_a->radii) > 0 || max_abs(sum_b->radii) > 0)) return std::nullopt;
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), newton_depth);
  const auto found = kernel(*sum_a, *sum_b, b_in_a, limit + noise);
  if (!found) return std::nullopt;
  const double distance = -found->depth;
  if (distance > limit + noise) return GeneralDistance{{distance, found->normal, {}, {}}, Status::converged, 0, noise};
  return judged(difference, centered(distance, found->normal, found->a, found->b), found->depth - found->lower, noise);
}

/// The smaller depth of two answers for cores that overlap, with the better proof of both.
template <class Difference>
GeneralDistance better_of(const Difference& difference, const GeneralDistance& one, const GeneralDistance& other) {
  if (one.core.distance > 0 || other.core.distance > 0) return other;
  const double lower = greatest(-one.core.distance - one.error, -other.core.distance - other.error);
  const GeneralDistance& less = one.core.distance >= other.core.distance ? one : other;
  return judged(difference, less.core, -less.core.distance - lower, less.noise);
}

/// The distance of capsules and segments in closed form: tapered capsules have no core that is a box.
template <class T>
std::optional<CoreDistance<double>> distance_of_ball_hulls(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a) {
  const auto hull_a = ball_hull_of(a);
  if (!hull_a) return std::nullopt;
  auto hull_b = ball_hull_of(b);
  if (!hull_b) return std::nullopt;
  for (Ball& ball : hull_b->ball) ball.center = transform(b_in_a, ball.center);
  return distance_of(*hull_a, *hull_b);
}

template <class Difference>
EpaResult depth_of(const Difference& difference, const Simplex& start, double goal) {
  return epa(difference, start, goal);
}
/// EPA across lanes, or the general EPA where that fails.
template <class T>
EpaResult depth_of(const HullDifference<T>& difference, const Simplex& start, double goal) {
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), hull_depth<T>);
  const double noise = rounding_error * difference.reach();
  EpaResult found;
  const bool proven =
      start.size() == 4 && kernel(difference.hulls(), difference.placed(), start.points.data(), noise, goal, found);
  return proven ? found : epa(difference, start, goal);
}

/// Raises the lower bound of a depth to the depth of one core's point inside the other. Where that is the depth, the
/// ball about the point touches the other's boundary along the normal, which gives the second point better than a
/// search.
template <class T>
void prove_by_inside(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, double noise, double tolerance,
                     EpaResult& e) {
  const Mat3d turn = rotation_matrix(b_in_a.rotation);
  const double in_b = inside_core_of(b, transposed_times(turn, e.a - b_in_a.translation)) - noise;
  const double in_a = inside_core_of(a, e.b) - noise;
  if (!(greatest(in_a, in_b) > e.lower)) return;
  e.lower = least(e.upper, greatest(in_a, in_b));
  if (e.upper - e.lower > tolerance) return;
  if (in_b >= in_a)
    e.b = e.a - e.normal * e.upper;
  else
    e.a = e.b + e.normal * e.upper;
}

template <class T, class Difference>
GeneralDistance iteratively(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, Difference& difference,
                            double noise, double limit) {
  const GjkGoal goal = distance_goals(difference.size(), noise, limit);
  const GjkResult g = search(difference, goal);
  if (g.end == GjkEnd::apart && g.lower > limit + noise)
    return {{g.lower, g.normal, {}, {}}, Status::converged, 0, noise};
  if (g.end != GjkEnd::touching && g.tells_normal()) {
    const Vec3d point_a = g.simplex.point_a(), point_b = g.simplex.point_b();
    // Rounding may make the distance to a flat simplex shorter than the one proven along a direction: then its own two
    // points are used.
    const double upper = g.upper < g.lower - noise ? greatest(g.lower, length(point_b - point_a)) : g.upper;
    return judged(difference, centered(upper, g.normal, point_a, point_b), upper - g.along, noise);
  }
  if (limit < std::numeric_limits<double>::infinity()) {  // a query of contacts, whose faces come next
    expect_faces(a);
    expect_faces(b);
  }
  const double tolerable = depth_goal * difference.size() + noise;
  EpaResult e = depth_of(difference, g.simplex, tolerable);
  if (e.upper - e.lower > tolerable) {
    prove_by_inside(a, b, b_in_a, noise, 0.5 * tolerance<double> * difference.size(), e);
    e.lower = greatest(e.lower, least(e.upper, depth_as_coaxial(a, b, b_in_a) - noise));
  }
  return judged(difference, centered(-e.upper, e.normal, e.a, e.b), e.upper - e.lower, noise);
}

}  // namespace

template <class T>
GeneralDistance general_distance(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, double limit) {
  const double noise = noise_of(a, b, b_in_a.translation);
  if (are_scanned(a, b)) {
    ScannedPair<T> scanned(a, b, b_in_a);
    return iteratively(a, b, b_in_a, scanned.difference, noise, limit);
  }
  if (const auto hulls = distance_of_ball_hulls(a, b, b_in_a)) return {*hulls, Status::converged, 0, noise};
  const ShapeCore<T> core_a(a), core_b(b);
  const Difference<T> difference(core_a, core_b, b_in_a);
  // The axes and corners of two boxes cost less than GJK.
  if (const auto boxes = as_boxes(a, b, b_in_a)) {
    if (const BoxNearest<double> nearest = nearest_of_boxes(*boxes, noise); nearest.proven) {
      const CoreDistance<double>& core = nearest.core;
      return judged(difference, centered(core.distance, core.normal, core.a, core.b), 0, noise);
    }
  }
  const auto direct = directly(difference, core_a, core_b, b_in_a, limit, noise);
  if (direct && direct->status == Status::converged) return *direct;
  const GeneralDistance iterated = iteratively(a, b, b_in_a, difference, noise, limit);
  return direct ? better_of(difference, *direct, iterated) : iterated;
}

template <class T>
std::optional<bool> general_overlap(const Shape<T>& a, const Shape<T>& b, const Posed& b_in_a, double reach) {
  const double noise = noise_of(a, b, b_in_a.translation);
  return with_overlap_difference(a, b, b_in_a, [&](auto& difference) {
    const GjkResult g = search(difference, overlap_goals(difference.size(), noise, reach));
    if (g.end == GjkEnd::touching || g.upper <= reach + noise) return std::optional(true);
    return g.lower > reach + noise ? std::optional(false) : std::nullopt;
  });
}

template GeneralDistance general_distance(const Shape<float>&, const Shape<float>&, const Posed&, double);
template GeneralDistance general_distance(const Shape<double>&, const Shape<double>&, const Posed&, double);
template std::optional<bool> general_overlap(const Shape<float>&, const Shape<float>&, const Posed&, double);
template std::optional<bool> general_overlap(const Shape<double>&, const Shape<double>&, const Posed&, double);

}  // namespace graze
