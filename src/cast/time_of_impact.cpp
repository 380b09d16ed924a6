#include "cast/time_of_impact.hpp"

#include "cast/linear_cast.hpp"
#include "cast/sliding.hpp"
#include "narrow/general.hpp"
#include "narrow/gjk/gjk.hpp"
#include "narrow/pair_table.hpp"
#include "narrow/pairs/box_box/linear_cast.hpp"
#include "narrow/pairs/half_space_distance.hpp"
#include "narrow/sat/polyhedral_pair.hpp"

namespace graze {

namespace {

/// The most steps. A translation takes one step or two. A shape that turns takes ten to twenty, but at a gap of d times
/// its radius, which is not that of its envelope, 2 pi / sqrt(2 d) a turn: this many are three turns at a millionth or
/// a hundred at a thousandth, and cost some milliseconds.
constexpr int most_steps = 1 << 14;

/// The slope, relative to the speed of a motion, up to which it counts as sliding along. Normals of curved shapes are
/// no better than the square root of their distance.
template <class T>
constexpr double sliding = 1e-6;
template <>
constexpr double sliding<float> = 1e-4;

/// The cosine up to which two normals are those of one side of a shape: half of a right angle and more apart, one may
/// be that of the edge over which it came.
constexpr double same_normal = 0.7;

/// The part of the interval in which the balls about the bodies' origins that hold the pieces come within `margin`.
std::optional<Interval> when_near(const PairMotion& motion, double radii, Interval interval, double margin) {
  // The balls are taken a little larger, so that rounding excludes nothing.
  const double r = radii * 1.0001 + 2 * margin, speed = length(motion.velocity);
  if (!(r < infinity)) return interval;
  if (!(speed > 0)) return length(motion.offset) <= r ? std::optional(interval) : std::nullopt;
  const Vec3d along = motion.velocity / speed;
  const double middle = -dot(motion.offset, along), aside = length(motion.offset + along * middle);
  if (aside > r) return std::nullopt;
  const double half = std::sqrt((r - aside) * (r + aside));
  interval = {greatest(interval.begin, (middle - half) / speed), least(interval.end, (middle + half) / speed)};
  return interval.begin <= interval.end ? std::optional(interval) : std::nullopt;
}

/// The part of the tolerance within which a distance counts as contact: that of curved shapes is itself known to a
/// tenth of the tolerance, and steps end where the shapes stay more than half of it apart.
constexpr double touching = 0.875;

/// The part of the tolerance within which GJK finds the distance at an impact. Where nothing is rounded the distance is
/// about half the tolerance, so known to 2e-4 of itself, and the nearest point lies within the root of twice that of
/// the true one, relative to its distance: the normal is right to 0.02.
constexpr double impact_goal = 1e-4;

template <class T>
class Advancement {
 public:
  Advancement(const PairMotion& motion, const Piece<T>& a, const Piece<T>& b, const Interval& interval,
              const CastRule& rule)
      : motion_(motion),
        a_(a),
        b_(b),
        turning_radius_a_(turning_radius(a, motion.a)),
        turning_radius_b_(turning_radius(b, motion.b)),
        envelope_a_(a, motion.a, turning_radius_a_),
        envelope_b_(b, motion.b, turning_radius_b_),
        away_(greatest(length(motion.offset_at(interval.begin)), length(motion.offset_at(interval.end))) +
              least(a.core_reach, b.core_reach)),
        tolerance_(rule.tolerance),
        coarse_(rule.coarse),
        slack_(rule.slack),
        separating_(rule.separating),
        seams_{rule.seams_a, rule.seams_b} {}

  std::optional<Impact> first(const Interval& interval) const {
    double t = interval.begin;
    std::optional<Impact> known;  // the impact at t, when it is there already
    if (const auto boxes = free_boxes(interval)) {
      if (boxes->way.t == infinity) return std::nullopt;
      t = least(interval.begin + boxes->way.t, interval.end);
      known = boxes->impact(t);
      if (known && touches(*known) && separating_ == Separating::hit) return known;
    } else if (still() && !is_half_space(a_) && !is_half_space(b_)) {
      MovingDifference difference(*this, interval.begin);
      const FreeTranslation free = difference.free(interval.end - interval.begin);
      if (free.t == infinity) return std::nullopt;
      t = least(interval.begin + free.t, interval.end);
      known = difference.impact(free, t);
      if (known && touches(*known) && separating_ == Separating::hit) return known;
    }
    Sliding<T> sliding_along(motion_, a_, b_, tolerance_, slack_, seams_);
    // The contact that is under way: the impact at which it began to press, and the one at which it last slid.
    std::optional<Impact> pressing, slid;
    for (int i = 0;; ++i) {
      const PieceAt<T> a(a_, motion_.a.at(t)), b(b_, motion_.b.at(t));
      Impact impact = known ? *known : at(t, a, b);
      known.reset();
      const Vec3d offset = motion_.offset_at(t);
      const bool touch = touches(impact);
      const bool over_seam = touch && separating_ == Separating::ignored && seams_.crossed_at(impact, a, b, offset);
      if (over_seam) impact = along_face(impact, a, b);
      Separation<T> separation(a, b, radii(), impact.normal, offset, gap_motion(impact.normal, offset));
      const double left = interval.end - t;
      double step = 0;
      const std::optional<Impact>& before = slid ? slid : pressing;
      const auto pressed = [&] { return pressing ? pressing : slid; };
      if (!touch) {
        if (before && sliding_along.passed_out(*before, impact, a, b)) return pressed();
        pressing.reset();
        slid.reset();
        step = greatest(separation.stays_above(tolerance_ / 2, tolerance_ / 8, left),
                        stays_outside(impact.normal, t, a, b));
        if (step >= left) return std::nullopt;
      } else {
        if (separating_ == Separating::hit) return impact;
        // An overlap without end gets no deeper.
        if (impact.status == Status::unbounded) return std::nullopt;
        // The distance of convex shapes is a convex function of a translation: one that does not fall never will.
        const bool over = still() && separation.opening() >= 0;
        if (over && !before) return std::nullopt;
        // A body that comes over a seam is as deep in the triangle before it.
        if (i == 0 || (over_seam && !before)) sliding_along.start(impact);
        const double sink = sliding_along.may_sink(impact.normal, a, b), floor = sliding_along.base() - sink;
        if (impact.distance < floor) return pressing ? pressing : impact;
        if (before && sliding_along.passed(*before, impact, a, b)) return pressed();
        if (over) return std::nullopt;
        const double fell = pressing ? pressing->distance - impact.distance : 0;
        const bool approaches = approaching(separation);
        if (!approaches) {
          // A body that was pressed in along much the same normal and rocks back a little is not out again.
          if (!(fell > tolerance_) || dot(pressing->normal, impact.normal) < same_normal) pressing.reset();
          slid = impact;
        } else if (!pressing) {
          pressing = impact;
          slid.reset();
        }
        // A body that falls by less than D in each of many casts must not come through in the end either.
        if (!(left > 0)) {
          const bool deeper = fell > tolerance_ || (fell > 0 && impact.distance < -tolerance_);
          return approaches && deeper ? pressing : std::nullopt;
        }
        step = least(left, separation.stays_above(floor - greatest(sink, tolerance_ / 2) / 2, tolerance_ / 8, left));
      }
      if (i == most_steps || !(t + step > t)) {
        // The points may still be as near as they have to be where a distance is not known well
        // enough for another step.
        const bool near_enough = !touch && i < most_steps && impact.distance <= coarse_;
        impact.status = near_enough ? Status::converged : Status::bounded;
        return impact;
      }
      t = step < left ? t + step : interval.end;
    }
  }

 private:
  /// Whether points of both shapes are near enough; then it does not matter how good a bound of the depth or of the gap
  /// has been found.
  bool touches(Impact& impact) const {
    if (impact.distance > touching * tolerance_) return false;
    if (impact.status == Status::bounded) impact.status = Status::converged;
    return true;
  }
  /// B - A of the cores of two bodies that do not turn, in world axes about A's moving origin.
  class MovingDifference {
   public:
    MovingDifference(const Advancement& asked, double begin)
        : asked_(asked),
          a_(asked.a_, asked.motion_.a.start),
          b_(asked.b_, asked.motion_.b.start),
          offset_(asked.motion_.offset_at(begin)) {}

    SupportPoint support(const Vec3d& n) const {
      const Vec3d a = a_.support(n), b = b_.support(-n) + offset_;
      return {a, b, b - a};
    }
    double reach() const { return greatest(asked_.a_.core_reach, asked_.b_.core_reach) + max_abs(offset_); }

    /// The translation until which the cores stay half the tolerance apart.
    FreeTranslation free(double duration) const {
      const double radii = asked_.radii(), tolerance = asked_.tolerance_;
      return free_translation([this](const Vec3d& n) { return support(n); }, offset_, asked_.motion_.velocity,
                              radii + tolerance / 2, radii + tolerance, duration);
    }

    /// The impact by GJK from the simplex that is left then; nothing where it does not prove the cores
    /// apart as well as it should.
    std::optional<Impact> impact(const FreeTranslation& free, double t) {
      offset_ += asked_.motion_.velocity * free.t;
      const double exact = asked_.tolerance_ * impact_goal, radii = asked_.radii();
      const GjkResult g = gjk_from(free.simplex, *this, {exact});
      if (g.end == GjkEnd::touching || !(g.lower > 0) || g.upper - g.lower > asked_.tolerance_ / 4) return std::nullopt;
      return Impact{t,
                    g.upper - radii,
                    g.normal,
                    g.simplex.point_a() + g.normal * asked_.a_.radius,
                    g.simplex.point_b() - g.normal * asked_.b_.radius,
                    Status::converged};
    }

   private:
    const Advancement& asked_;
    PieceAt<T> a_, b_;
    Vec3d offset_;
  };

  /// The motion of the gap along `n`, with which a half-space turns unless it does so about its own normal.
  GapMotion gap_motion(const Vec3d& n, const Vec3d& offset) const {
    const TurnBound turn_a(n, motion_.a.angular, turning_radius_a_), turn_b(n, motion_.b.angular, turning_radius_b_);
    const bool half_a = is_half_space(a_);
    const TurnBound& turn = half_a ? turn_a : turn_b;
    if (half_a == is_half_space(b_) || turn.speed == 0) return along_fixed(n, motion_.velocity, turn_a, turn_b);
    const Turning &own = half_a ? motion_.a : motion_.b, &other = half_a ? motion_.b : motion_.a;
    const double radius = half_a ? turning_radius_b_ : turning_radius_a_;
    GapMotion seen = along_turning(n, own.angular, {other.angular, radius, away_}, offset, motion_.velocity);
    (half_a ? seen.tilt_a : seen.tilt_b) = {};
    return seen;
  }

  Posed pose_of(const Piece<T>& piece, const Turning& turning) const {
    return compose(Posed{{}, turning.start}, piece.local);
  }

  /// The translation of two boxes with sharp edges that do not turn until which they stay half the tolerance apart.
  struct FreeBoxes {
    Posed pose_a;
    BoxTranslation way;

    std::optional<Impact> impact(double t) const {
      if (!way.impact) return std::nullopt;
      const CoreDistance<double>& d = *way.impact;
      return Impact{t,
                    d.distance,
                    rotate(pose_a.rotation, d.normal),
                    transform(pose_a, d.a),
                    transform(pose_a, d.b),
                    Status::converged};
    }
  };
  std::optional<FreeBoxes> free_boxes(const Interval& interval) const {
    const auto *box_a = a_.shape.template as<Box<T>>(), *box_b = b_.shape.template as<Box<T>>();
    if (!box_a || !box_b || !still() || radii() > 0) return std::nullopt;
    const Posed pose_a = pose_of(a_, motion_.a);
    Posed pose_b = pose_of(b_, motion_.b);
    pose_b.translation += motion_.offset_at(interval.begin);
    const auto boxes = as_boxes(a_.shape, b_.shape, relative(pose_a, pose_b));
    const auto way = box_translation(*boxes, rotate(conjugate(pose_a.rotation), motion_.velocity), tolerance_ / 2,
                                     interval.end - interval.begin, tolerance_ / 4);
    return way ? std::optional(FreeBoxes{pose_a, *way}) : std::nullopt;
  }

  /// The time for which all places that the bodies ever turn through stay on their sides of the plane across `n`.
  double stays_outside(const Vec3d& n, double t, const PieceAt<T>& a, const PieceAt<T>& b) const {
    const auto unbounded = [](const Piece<T>& piece, const Turning& turning) {
      return is_half_space(piece) && !turning.none();
    };
    if (still() || unbounded(a_, motion_.a) || unbounded(b_, motion_.b)) return 0;
    const double gap = dot(n, motion_.offset_at(t)) - envelope_a_.along(n, a) - envelope_b_.along(-n, b) - a_.radius -
                       b_.radius - tolerance_ / 2;
    if (!(gap > 0)) return 0;
    const double closing = -dot(n, motion_.velocity);
    return closing > 0 ? gap / closing : infinity;
  }

  double radii() const { return a_.radius + b_.radius; }
  bool still() const { return motion_.a.none() && motion_.b.none(); }
  /// Whether the shapes come closer, faster than in sliding along.
  bool approaching(Separation<T>& separation) const {
    const double speed = length(motion_.velocity) + length(motion_.a.angular) * within_reach(turning_radius_a_) +
                         length(motion_.b.angular) * within_reach(turning_radius_b_);
    return separation.closing(sliding<T>) > sliding<T> * speed;
  }
  /// The turning radius or, of a half-space, that of the part which the other shape may meet; zero of two of them.
  double within_reach(double radius) const { return radius < infinity ? radius : away_ < infinity ? away_ : 0; }

  Impact at(double t, const PieceAt<T>& a, const PieceAt<T>& b) const {
    const Posed pose_b{b.pose().translation + motion_.offset_at(t), b.pose().rotation};
    if (is_half_space(a_) && is_half_space(b_)) return of_half_spaces(t, a, b);
    if (is_half_space(a_) || is_half_space(b_)) return on_half_space(t, a, b);
    if constexpr (std::is_same_v<T, double>) {
      const Distance<double> d = convex_distance(a_.shape, a.pose(), b_.shape, pose_b);
      return {t, d.distance, d.normal, d.a, d.b, d.status};
    } else {
      // Closed forms of float shapes are no better than float: the general path answers in double.
      const GeneralDistance g = general_distance(a_.shape, b_.shape, relative(a.pose(), pose_b));
      const Vec3d n = rotate(a.pose().rotation, g.core.normal);
      return {t,
              g.core.distance - a_.radius - b_.radius,
              n,
              transform(a.pose(), g.core.a) + n * a_.radius,
              transform(a.pose(), g.core.b) - n * b_.radius,
              g.status};
    }
  }

  /// An impact whose normal leads over a seam of a triangle, along that triangle's own normal, on the side on which the
  /// middle of the other shape is.
  Impact along_face(const Impact& found, const PieceAt<T>& a, const PieceAt<T>& b) const {
    const bool of_a = PieceSeams<T>::crossed_at(seams_.a, a, found.normal, found.a);
    const PieceAt<T>&face = of_a ? a : b, &other = of_a ? b : a;
    const Vec3d up = unit(rotate(face.pose().rotation, (of_a ? seams_.a : seams_.b)->normal()));
    const Vec3d offset = motion_.offset_at(found.t), middle = (other.support(up) + other.support(-up)) * 0.5;
    const bool above = dot(up, middle - face.support(up) + (of_a ? offset : -offset)) >= 0;
    const Vec3d n = above == of_a ? up : -up;
    const double distance = dot(n, offset + b.support(-n) - a.support(n)) - radii();
    return {found.t, distance, n, found.a, found.b, found.status};
  }

  /// The impact along the half-space's normal: along any other a half-space has no bounded extent.
  Impact on_half_space(double t, const PieceAt<T>& a, const PieceAt<T>& b) const {
    const bool half_a = is_half_space(a_);
    const Vec3d up = rotate((half_a ? a : b).pose().rotation, Vec3d{0, 1, 0});
    const Vec3d n = unit(half_a ? up : -up);
    Vec3d pa = a.support(n) + n * a_.radius, pb = b.support(-n) - n * b_.radius + motion_.offset_at(t);
    const double distance = dot(n, pb - pa);
    (half_a ? pa : pb) = half_a ? pb - n * distance : pa + n * distance;
    return {t, distance, n, pa, pb, Status::converged};
  }

  /// The impact of two half-spaces. Opposite ones have a gap. All others overlap without end, and the point is one in
  /// both: the middle of their origins moved down into each.
  Impact of_half_spaces(double t, const PieceAt<T>& a, const PieceAt<T>& b) const {
    const auto up = [](const PieceAt<T>& at) { return unit(rotate(at.pose().rotation, Vec3d{0, 1, 0})); };
    const Vec3d na = up(a), nb = up(b), origin_a = a.pose().translation,
                origin_b = b.pose().translation + motion_.offset_at(t);
    // Opposite as far as rotations are known in T.
    if (opposite(converted<T>(rotate(conjugate(a.pose().rotation), nb)))) {
      const double distance = dot(na, origin_b - origin_a) - radii();
      const Vec3d pb = origin_b - na * b_.radius;
      return {t, distance, na, pb - na * distance, pb, Status::converged};
    }
    const Vec3d middle = (origin_a + origin_b) * 0.5, down = -(na + nb);
    const double above = greatest(dot(na, middle - origin_a) - a_.radius, dot(nb, middle - origin_b) - b_.radius);
    const Vec3d common = middle + down * (greatest(above, 0.0) / (1 + dot(na, nb)));
    return {t, -infinity, na, common, common, Status::unbounded};
  }

  const PairMotion& motion_;
  const Piece<T>&a_, &b_;
  double turning_radius_a_, turning_radius_b_;
  Envelope<T> envelope_a_, envelope_b_;
  double away_;  ///< of two shapes of which one is bounded: no point of it gets further from the other's origin
  double tolerance_, coarse_, slack_;
  Separating separating_;
  PieceSeams<T> seams_;
};

}  // namespace

Quatd Turning::at(double t) const {
  if (none()) return start;
  return Quatd::from_axis_angle(normalized(angular), length(angular) * t) * start;
}

template <class T>
Piece<T>::Piece(const Shape<T>& of, const Posed& where) : shape(of), local(where) {
  shape.visit([&](const auto& c) {
    core_reach = std::is_same_v<std::decay_t<decltype(c)>, HalfSpace<T>>
                     ? infinity
                     : length(local.translation) + static_cast<double>(c.core_extent());
    radius = static_cast<double>(rounding_radius(c, T(0))) + static_cast<double>(shape.rounding());
  });
}

template <class T>
std::optional<Impact> time_of_impact(const PairMotion& motion, const Piece<T>& a, const Piece<T>& b,
                                     const Interval& interval, const CastRule& rule) {
  const auto near = when_near(motion, a.reach() + b.reach(), interval, rule.tolerance);
  if (!near) return std::nullopt;
  return Advancement<T>(motion, a, b, *near, rule).first(*near);
}

template struct Piece<float>;
template std::optional<Impact> time_of_impact(const PairMotion&, const Piece<float>&, const Piece<float>&,
                                              const Interval&, const CastRule&);
template struct Piece<double>;
template std::optional<Impact> time_of_impact(const PairMotion&, const Piece<double>&, const Piece<double>&,
                                              const Interval&, const CastRule&);

}  // namespace graze
