// The time for which a plane between two moving convex shapes stays between them.
//
// Along a fixed direction n a point p that turns about its body's origin lies at n.p(t), whose rate is n.(w x p) and
// whose second derivative is no more than |w| |n x w| r, r the point's distance from the axis. So p stays below n.p +
// dt (n x w).p + dt^2/2 |w| |n x w| r, and the most of this over all p of the shape is its extent along the tilted
// direction n + dt (n x w): one support query. The gap along n is then at least a function q(dt) that is concave,
// extents being convex. Where q is positive at both ends of an interval it is positive throughout, and one test at its
// end proves the interval free of contact. A ball about a core does not take part in the turning.
//
// A half-space that turns has no bounded extent along a direction that stands still, but a constant one along its own
// normal. So there n turns with it: n.p changes by (w x n).p as well, w the half-space's turning, and the other shape's
// extent is taken along a direction that tilts by that much more.
#pragma once

#include "cast/time_of_impact.hpp"
#include "narrow/core/minkowski.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// A piece's core at one time, in world axes about its body's origin.
template <class T>
class PieceAt {
 public:
  PieceAt(const Piece<T>& piece, const Quatd& turned)
      : core_(piece.shape),
        pose_{rotate(turned, piece.local.translation), turned * piece.local.rotation},
        matrix_(rotation_matrix(pose_.rotation)) {}

  const Posed& pose() const { return pose_; }
  Vec3d support(const Vec3d& direction) const {
    return pose_.translation + matrix_ * core_.core_support(transposed_times(matrix_, direction));
  }

 private:
  ShapeCore<T> core_;
  Posed pose_;
  Mat3d matrix_;
};

/// A bound for the motion of a shape's extent along a direction by its turning.
struct TurnBound {
  Vec3d tilt{};          ///< n x w
  double speed = 0;      ///< no point moves faster along n
  double curvature = 0;  ///< nor with a larger second derivative

  TurnBound() = default;
  /// `radius`: the distance of the shape's points from the axis; infinite for a half-space, whose plane has no bound
  /// unless it turns about its own normal.
  TurnBound(const Vec3d& n, const Vec3d& angular, double radius) : tilt(cross(n, angular)) {
    const double rate = length(tilt), whole = length(angular);
    if (rate == 0 || (radius == std::numeric_limits<double>::infinity() && rate <= rounding_error * whole)) {
      tilt = {};
      return;
    }
    speed = rate * radius;
    curvature = speed * whole;
  }
};

/// A bound for the motion of the gap between two shapes along a direction.
struct GapMotion {
  Vec3d tilt_a{}, tilt_b{};  ///< the change of the directions along which their extents are taken
  double opening = 0;        ///< the speed at which the gap grows where no extent changes
  double closing = 0;        ///< the gap falls no faster
  double curvature = 0;      ///< nor with a larger second derivative
};

/// The motion along the direction `n`, which stands still.
inline GapMotion along_fixed(const Vec3d& n, const Vec3d& velocity, const TurnBound& a, const TurnBound& b) {
  const double opening = dot(n, velocity);
  return {a.tilt, b.tilt, opening, a.speed + b.speed - opening, a.curvature + b.curvature};
}

/// A bounded shape seen from a half-space, about whose origin its own origin moves.
struct BesideHalfSpace {
  Vec3d angular{};    ///< the shape's turning
  double radius = 0;  ///< of its points about the axis of that
  double away = 0;    ///< no point of it is further from the half-space's origin
};

/// The motion along a half-space's normal `n`, which turns with it by `angular`. The tilt is that of the other shape,
/// and to be given to its side.
inline GapMotion along_turning(const Vec3d& n, const Vec3d& angular, const BesideHalfSpace& other, const Vec3d& offset,
                               const Vec3d& velocity) {
  const Vec3d swing = cross(angular, n);
  const double rate = length(swing), spin = length(other.angular);
  const double fastest = length(velocity) + spin * other.radius;
  const Vec3d tilt = swing + cross(n, other.angular);
  return {tilt, tilt, dot(n, velocity) + dot(swing, offset), rate * other.away + fastest,
          rate * (length(angular) * other.away + 2 * fastest) + spin * spin * other.radius};
}

/// The gap of two shapes along `n` from a time on.
template <class T>
class Separation {
 public:
  Separation(const PieceAt<T>& a, const PieceAt<T>& b, double radii, const Vec3d& n, const Vec3d& offset,
             const GapMotion& motion)
      : a_(a),
        b_(b),
        n_(n),
        tilt_a_(motion.tilt_a),
        tilt_b_(motion.tilt_b),
        gap_(dot(n, offset) - radii),
        opening_(motion.opening),
        curvature_(motion.curvature),
        closing_(motion.closing) {}

  /// The speed at which the gap grows where no extent changes: of bodies that do not turn the whole of it.
  double opening() const { return opening_; }

  /// The speed at which the gap closes to first order: for all points extreme within a turn of `lean`.
  double closing(double lean) {
    if (tilt_a_ == Vec3d{} && tilt_b_ == Vec3d{}) return -opening_;
    const double dt = lean / greatest(length(tilt_a_), length(tilt_b_));
    return (start().value - linear(dt).value) / dt;
  }

  /// A time, up to `most`, for which the gap is proven not to fall below `target` but for `slack`.
  double stays_above(double target, double slack, double most) {
    const double room = start().value - target;
    if (!(room > 0)) return 0;
    const double by_speed = closing_ > 0 ? least(most, room / closing_) : most;
    if (by_speed >= most || !(curvature_ < std::numeric_limits<double>::infinity())) return by_speed;
    return greatest(by_speed, root({0, room, start().slope}, target, slack, most));
  }

 private:
  struct Sample {
    double dt, value, slope;
  };

  /// The sample of q at 0, computed once: its supports are half of those of a step of shapes in contact.
  const Sample& start() {
    if (!start_) start_ = at(0);
    return *start_;
  }
  /// A sample of q without its quadratic term.
  Sample linear(double dt) const {
    const Vec3d along_a = n_ + tilt_a_ * dt, along_b = n_ + tilt_b_ * dt;
    const Vec3d a = a_.support(along_a), b = b_.support(-along_b);
    return {dt, gap_ + dt * opening_ + dot(along_b, b) - dot(along_a, a), opening_ + dot(tilt_b_, b) - dot(tilt_a_, a)};
  }
  Sample at(double dt) const {
    Sample s = linear(dt);
    s.value -= curvature_ * dt * dt / 2;
    s.slope -= curvature_ * dt;
    return s;
  }

  /// The place where a parabola of q's curvature through the sample falls to 0: not before q, whose other part is
  /// concave.
  double parabola_root(const Sample& s) const {
    const double d = std::sqrt(s.slope * s.slope + 2 * curvature_ * s.value);
    if (s.slope < 0) return s.dt + 2 * s.value / (d - s.slope);
    return curvature_ > 0 ? s.dt + (s.slope + d) / curvature_ : std::numeric_limits<double>::infinity();
  }

  /// The last dt <= most with q(dt) >= target - slack, approached from below: between a chord of q, which falls to the
  /// target before q does, and a parabola, which does so after. Exact for a translation; else as exact as pays, since
  /// the plane is to be replaced by a better one anyway.
  double root(Sample low, double target, double slack, double most) const {
    const double enough = greatest(slack, low.value * 1e-3);
    // A digit or more an iteration, as chord and parabola close in from both sides.
    constexpr int most_iterations = 12;
    for (int i = 0; i < most_iterations && low.value > enough; ++i) {
      const double high = least(most, parabola_root(low));
      Sample end = at(high);
      end.value -= target;
      if (end.value >= -slack) return high;
      Sample middle = at(low.dt + (high - low.dt) * (low.value / (low.value - end.value)));
      middle.value -= target;
      if (!(middle.value > 0 && middle.dt > low.dt)) break;
      low = middle;
    }
    return low.dt;
  }

  std::optional<Sample> start_;
  const PieceAt<T>&a_, &b_;
  Vec3d n_, tilt_a_, tilt_b_;
  double gap_, opening_, curvature_, closing_;
};

}  // namespace graze
