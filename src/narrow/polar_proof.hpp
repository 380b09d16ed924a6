// Whether an overlap of two sums of boxes and ellipsoids is the least in all directions, seen from the direction n in
// which it was found.
//
// Every other direction is N = n (1 - s^2) + 2 s t up to its length 1 + s^2, t a unit tangent at n and s the tangent of
// half the angle between. The overlap h is the sum of what each part of the cores adds, so that
//   (h(N) - depth |N|) / 2 = j(t) s - depth s^2 + sum of e(s, t),
// where j is the slope from n along t, which only the parts have that meet n in a crease, and e >= 0 is by how much each
// other part exceeds its support point at n: a segment of half length l and axis a, from where it turns over,
//   l max(0, |a.n| (s^2 - 1) - 2 s a.t sign(a.n)),
// an ellipsoid |R n| with support point p, where X = p.n (1 - s^2) + 2 s p.t and Y^2 = 4 s^2 (|R t|^2 - (p.t)^2),
//   Y^2 / (2 sqrt(X^2 + Y^2) + 2 X).
//
// Guarantee: true only if no term can make the sum negative anywhere: the tangents are taken in sectors and s in
// intervals, each term at its least there; a sector that this leaves in doubt is halved a few times.
#pragma once

#include <array>

#include "narrow/core_sum.hpp"
#include "narrow/fixed_vector.hpp"

namespace graze {

class PolarProof {
 public:
  /// `least_bend`: what the ellipsoids exceed their support points by is no less than this times s^2.
  explicit PolarProof(double depth, double least_bend = 0) : depth_(depth), least_bend_(least_bend) {}

  /// A vector of the tangent plane by its products with the two vectors of a basis.
  struct Tangent {
    double u, v;
  };

  /// A crease that n lies on, its axis seen on the tangent plane: the slope is `up` times the way along the axis, and
  /// `down` times that against it.
  void add_crease(const Tangent& axis, double up, double down) { creases_.push_back({axis, up, down}); }
  /// A disc that n is the axis of: the slope is its radius and what the other parts have.
  void add_cap(double radius, const Tangent& slope) {
    cap_ = radius;
    cap_slope_ = slope;
  }
  /// A segment: its axis on the tangent plane and along n, both times the sign of the latter.
  void add_segment(const Tangent& axis, double along, double half) { segments_.push_back({axis, along, half}); }
  /// An ellipsoid: its extent along n, its support point there and |R t|^2 - (p.t)^2 as a form in t.
  void add_round(double extent, const Tangent& point, const TangentForm& across) {
    rounds_.push_back({extent, point, across});
  }

  /// Whether no direction has less. If not, tells `doubt` of one that may have, by t and s.
  template <class Doubt>
  bool holds(const Doubt& doubt) const {
    constexpr double h = 0.70710678118654752440;
    constexpr Tangent around[] = {{1, 0}, {h, h}, {0, 1}, {-h, h}, {-1, 0}, {-h, -h}, {0, -1}, {h, -h}, {1, 0}};
    for (int i = 0; i < 8; ++i)
      if (!holds_in(around[i], around[i + 1], halvings, doubt)) return false;
    return true;
  }

 private:
  static constexpr int halvings = 4;

  struct Crease {
    Tangent axis;
    double up, down;
  };
  struct Segment {
    Tangent axis;
    double along, half;
  };
  struct Round {
    double extent;
    Tangent point;
    TangentForm across;
  };

  /// The tangents between two; they lie in the triangle of both and of the point where their own tangents meet, which
  /// bounds linear terms.
  struct Sector {
    Tangent first, last;
    double meet;  ///< of the sum of the two

    double most(const Tangent& x) const {
      const double a = x.u * first.u + x.v * first.v, b = x.u * last.u + x.v * last.v;
      return greatest(greatest(a, b), (a + b) * meet);
    }
    double least(const Tangent& x) const { return -most({-x.u, -x.v}); }
    /// The least slope over a crease.
    double slope_over(const Crease& c) const {
      const double a = c.axis.u * first.u + c.axis.v * first.v, b = c.axis.u * last.u + c.axis.v * last.v;
      if (a > 0 && b > 0) return (a < b ? a : b) * c.up;
      return a < 0 && b < 0 ? (a > b ? -a : -b) * c.down : 0;
    }
  };
  static Sector sector(const Tangent& a, const Tangent& b) { return {a, b, 1 / (1 + a.u * b.u + a.v * b.v)}; }
  static Tangent doubled(const Tangent& t) { return {t.u * t.u - t.v * t.v, 2 * t.u * t.v}; }

  /// What a sector leaves of the terms.
  struct Bounds {
    double slope = 0;
    struct Turn {
      double along, axis, half;
    };
    FixedVector<Turn, 6> turns;
    struct Bend {
      double extent, point, turns_at, least_across, most_across;
    };
    FixedVector<Bend, 2> bends;
  };

  template <class Doubt>
  bool holds_in(const Tangent& a, const Tangent& b, int left, const Doubt& doubt) const {
    double doubtful = 0;
    if (holds_between(a, b, doubtful)) return true;
    const double scale = 1 / std::sqrt(2 + 2 * (a.u * b.u + a.v * b.v));
    const Tangent middle{(a.u + b.u) * scale, (a.v + b.v) * scale};
    if (left == 0) {
      doubt(middle, doubtful);
      return false;
    }
    return holds_in(a, middle, left - 1, doubt) && holds_in(middle, b, left - 1, doubt);
  }
  /// Between two tangents; if not, for which s that is in doubt.
  bool holds_between(const Tangent& a, const Tangent& b, double& doubtful) const;
  Bounds bounds(const Tangent& a, const Tangent& b) const;
  bool holds_between(const Bounds& bounds, double from, double to, int left, double& doubtful) const;
  bool holds_beyond(const Bounds& bounds, double from) const;

  double depth_, least_bend_, cap_ = 0;
  Tangent cap_slope_{};
  FixedVector<Crease, 2> creases_;
  FixedVector<Segment, 6> segments_;
  FixedVector<Round, 2> rounds_;
};

}  // namespace graze
