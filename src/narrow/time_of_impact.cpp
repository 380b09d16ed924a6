#include "narrow/time_of_impact.hpp"

#include "narrow/convex_pair.hpp"
#include "narrow/general.hpp"
#include "narrow/separation.hpp"

namespace graze {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A translation takes some ten steps, one that just passes by some thirty. A shape that turns at a gap of d times its
/// radius takes 2 pi / sqrt(2 d) steps a turn: this many are three turns at a millionth or a hundred at a thousandth, and
/// cost some milliseconds.
constexpr int most_steps = 1 << 14;

/// The slope, relative to the speed of a motion, up to which it counts as sliding along. Normals of curved shapes are no
/// better than the square root of their distance.
template <class T>
constexpr double sliding = 1e-6;
template <>
constexpr double sliding<float> = 1e-4;

template <class T>
bool is_half_space(const Piece<T>& piece) {
  return piece.shape.template as<HalfSpace<T>>() != nullptr;
}

template <class T>
double radius_of(const Piece<T>& piece) {
  return piece.shape.visit([&](const auto& c) {
    return static_cast<double>(rounding_radius(c, T(0))) + static_cast<double>(piece.shape.margin());
  });
}

template <class T>
double core_reach(const Piece<T>& piece) {
  if (is_half_space(piece)) return infinity;
  return length(piece.local.translation) +
         piece.shape.visit([](const auto& c) { return static_cast<double>(c.core_extent()); });
}

/// The unit quaternion that turns the unit vector `axis` to +Y: half way of a half turn about what lies between them.
Quatd to_y(const Vec3d& axis) {
  const Vec3d between = unit(axis + Vec3d{0, axis.y < 0 ? -1.0 : 1.0, 0});
  return {between.x, between.y, between.z, 0};  // half a turn swaps the two, up to sign of Y
}

/// No point of the core is further than this from the axis about which its body turns.
template <class T>
double turning_radius(const Piece<T>& piece, const Turning& turning) {
  if (turning.none()) return 0;
  if (is_half_space(piece)) return infinity;
  const Vec3d axis = unit(rotate(conjugate(turning.start), turning.angular));
  const Posed upright = compose(Posed{{}, to_y(axis)}, piece.local);
  const double reach = core_reach(piece);
  const Vec3d far = piece.shape.visit([&](const auto& c) {
    const Aabb<T> box = c.core_bounds(cast<T>(upright));
    return cast<double>(greatest(abs(box.lower), abs(box.upper)));
  });
  constexpr double slack = 64 * static_cast<double>(std::numeric_limits<T>::epsilon());
  return least(reach, std::sqrt(far.x * far.x + far.z * far.z) + slack * reach);
}

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

template <class T>
class Advancement {
 public:
  Advancement(const PairMotion& motion, const Piece<T>& a, const Piece<T>& b, double tolerance, Separating separating)
      : motion_(motion),
        a_(a),
        b_(b),
        radius_a_(radius_of(a)),
        radius_b_(radius_of(b)),
        turning_radius_a_(turning_radius(a, motion.a)),
        turning_radius_b_(turning_radius(b, motion.b)),
        tolerance_(tolerance),
        separating_(separating) {}

  std::optional<Impact> first(const Interval& interval) const {
    double t = interval.begin, floor = 0;
    std::optional<Impact> pressing;  // where the contact that is under way began to press
    for (int i = 0;; ++i) {
      const PieceAt<T> a(a_, motion_.a.at(t)), b(b_, motion_.b.at(t));
      Impact impact = at(t, a, b);
      const Separation<T> separation(a, b, radius_a_ + radius_b_, impact.normal, motion_.offset_at(t), motion_.velocity,
                                     {impact.normal, motion_.a.angular, turning_radius_a_},
                                     {impact.normal, motion_.b.angular, turning_radius_b_});
      const double left = interval.end - t;
      const bool touch = impact.distance <= tolerance_;
      double step = 0;
      if (!touch) {
        pressing.reset();
        step = separation.stays_above(tolerance_ / 2, tolerance_ / 8, left);
        if (step >= left) return std::nullopt;
      } else {
        if (separating_ == Separating::hit) return impact;
        // The distance of convex shapes is a convex function of a translation: one that does not fall never will.
        if (still() && separation.opening() >= 0) return std::nullopt;
        if (i == 0) floor = least(0.0, impact.distance) - sinking * tolerance_;
        const double fell = pressing ? pressing->distance - impact.distance : 0;
        if (!approaching(separation))
          pressing.reset();
        else if (!pressing)
          pressing = impact;
        if (impact.distance < floor) return pressing ? pressing : impact;
        if (!(left > 0)) return fell > tolerance_ ? pressing : std::nullopt;
        step = least(left, separation.stays_above(floor - sinking * tolerance_ / 2, tolerance_ / 8, left));
      }
      if (i == most_steps || !(t + step > t)) {
        impact.status = Status::bounded;
        return impact;
      }
      t = step < left ? t + step : interval.end;
    }
  }

 private:
  bool still() const { return motion_.a.none() && motion_.b.none(); }
  /// Faster than in sliding along.
  bool approaching(const Separation<T>& separation) const {
    const double speed = length(motion_.velocity) + length(motion_.a.angular) * finite(turning_radius_a_) +
                         length(motion_.b.angular) * finite(turning_radius_b_);
    return separation.closing(sliding<T>) > sliding<T> * speed;
  }
  static double finite(double radius) { return radius < infinity ? radius : 0; }

  Impact at(double t, const PieceAt<T>& a, const PieceAt<T>& b) const {
    const Posed pose_b{b.pose().translation + motion_.offset_at(t), b.pose().rotation};
    if (is_half_space(a_) != is_half_space(b_)) return on_half_space(t, a, b);
    if constexpr (std::is_same_v<T, double>) {
      const Distance<double> d = convex_distance(a_.shape, a.pose(), b_.shape, pose_b, nullptr);
      return {t, d.distance, d.normal, d.a, d.b, d.status};
    } else if (is_half_space(a_)) {
      const Distance<T> d = convex_distance(a_.shape, cast<T>(a.pose()), b_.shape, cast<T>(pose_b), nullptr);
      return {t,       static_cast<double>(d.distance), cast<double>(d.normal), cast<double>(d.a), cast<double>(d.b),
              d.status};
    } else {
      // Closed forms of float shapes are no better than float: the general path answers in double.
      const GeneralDistance g = general_distance(a_.shape, b_.shape, relative(a.pose(), pose_b), nullptr);
      const Vec3d n = rotate(a.pose().rotation, g.core.normal);
      return {t,
              g.core.distance - radius_a_ - radius_b_,
              n,
              transform(a.pose(), g.core.a) + n * radius_a_,
              transform(a.pose(), g.core.b) - n * radius_b_,
              g.status};
    }
  }

  /// Along the half-space's normal and no other: any other has no extent to speak of.
  Impact on_half_space(double t, const PieceAt<T>& a, const PieceAt<T>& b) const {
    const bool half_a = is_half_space(a_);
    const Vec3d up = rotate((half_a ? a : b).pose().rotation, Vec3d{0, 1, 0});
    const Vec3d n = unit(half_a ? up : -up);
    Vec3d pa = a.support(n) + n * radius_a_, pb = b.support(-n) - n * radius_b_ + motion_.offset_at(t);
    const double distance = dot(n, pb - pa);
    (half_a ? pa : pb) = half_a ? pb - n * distance : pa + n * distance;
    return {t, distance, n, pa, pb, Status::converged};
  }

  const PairMotion& motion_;
  const Piece<T>&a_, &b_;
  double radius_a_, radius_b_, turning_radius_a_, turning_radius_b_, tolerance_;
  Separating separating_;
};

}  // namespace

Quatd Turning::at(double t) const {
  if (none()) return start;
  return Quatd::from_axis_angle(normalized(angular), length(angular) * t) * start;
}

template <class T>
double reach_of(const Piece<T>& piece) {
  return core_reach(piece) + radius_of(piece);
}

template <class T>
std::optional<Impact> time_of_impact(const PairMotion& motion, const Piece<T>& a, const Piece<T>& b,
                                     const Interval& interval, double tolerance, Separating separating) {
  const auto near = when_near(motion, reach_of(a) + reach_of(b), interval, tolerance);
  if (!near) return std::nullopt;
  return Advancement<T>(motion, a, b, tolerance, separating).first(*near);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template double reach_of(const Piece<T>&);                                                                           \
  template std::optional<Impact> time_of_impact(const PairMotion&, const Piece<T>&, const Piece<T>&, const Interval&,  \
                                                double, Separating);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
