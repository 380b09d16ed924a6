// Certificate of a least depth: whether an overlap of two sums of boxes and ellipsoids is the least in all directions,
// given the direction n in which it was found.
//
// Every other direction is N = n (1 - s^2) + 2 s t up to its length 1 + s^2, t a unit tangent at n and s the tangent of
// half the angle between. The overlap h is the sum of what each part of the cores adds, so that
//   (h(N) - depth |N|) / 2 = j(t) s - depth s^2 + sum of e(s, t),
// where j is the slope from n along t, to which only parts contribute that n meets in a crease, and e >= 0 is by how
// much each other part exceeds its support point at n: a segment of half length l and axis a, from where it turns over,
//   l max(0, |a.n| (s^2 - 1) - 2 s a.t sign(a.n)),
// an ellipsoid |R n| with support point p, where X = p.n (1 - s^2) + 2 s p.t and Y^2 = 4 s^2 (|R t|^2 - (p.t)^2),
//   Y^2 / (2 sqrt(X^2 + Y^2) + 2 X).
//
// Guarantee: true only if bounds of the terms show that the sum is negative nowhere; the same answer and doubt at every
// level of the instruction set. Mostly some ten, at most 400 bundles of eight cells of directions are tested, with 20
// to 60 operations a term and cell.
#pragma once

#include "graze/fixed_vector.hpp"
#include "narrow/depth/core_sum.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// A vector of the tangent plane at n by its products with the two vectors of a basis.
struct PolarTangent {
  double u, v;
};

/// The parts of the overlap.
struct PolarTerms {
  /// A crease at n, by its axis in the tangent plane: the slope is `up` times the component along the axis, and `down`
  /// times that against it.
  struct Crease {
    PolarTangent axis;
    double up, down;
  };
  /// The axis of a segment in the tangent plane and along n, both times the sign of the latter; `along` is not
  /// negative.
  struct Segment {
    PolarTangent axis;
    double along, half;
  };
  /// An ellipsoid: its extent along n, its support point there and |R t|^2 - (p.t)^2 as a form in t.
  struct Round {
    double extent;
    PolarTangent point;
    TangentForm across;
  };

  double depth;              ///< overlap along n
  double least_bend = 0;     ///< the ellipsoids exceed their support points by at least this times s^2
  double cap = 0;            ///< radius of a disc whose axis is n: its contribution to the slope along any tangent
  PolarTangent cap_slope{};  ///< contribution of all other parts, as a vector
  FixedVector<Crease, 2> creases{};
  FixedVector<Segment, 6> segments{};
  FixedVector<Round, 2> rounds{};
};

/// A direction that may have less overlap; s = 0, n itself, for none.
struct PolarDoubt {
  PolarTangent t;
  double s;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Whether no direction has less overlap. If not, sets `doubt` to one that may have, unless the search was given
    /// up.
    bool no_less_around(const PolarTerms& terms, PolarDoubt& doubt);)
// clang-format on

}  // namespace graze
