// Overlap test of two cores by Minkowski portal refinement (Snethen 2008, "XenoCollide: complex collision made simple",
// Game Programming Gems 7): for many pairs at a time, since a step is a support query and a few dozen operations
// without cases, where GJK's simplex has fifteen. `S` is a lane type of float's.
//
// The test is whether the difference D = B - A, rounded by the reach, contains the origin. A tetrahedron of four points
// of D, the first its `inside`, the others the portal, is moved until the ray from the inside to the origin goes
// through the portal, and the portal is then pushed outwards until the origin lies behind it, or in front of a plane
// that D lies behind.
//
// Guarantee: every answer is proven. All lengths are in units of the pair's size, so that no point of D is further than
// 1 from the line between the origins. A support point along n and its height along n come of some fifty operations on
// numbers of that size, each right within float's 2^-24: its height is the greatest of D along n within some hundred
// such roundings. So is the inner point of as many points as a side may have. `mpr_slack` is three times that. The
// cores are apart where the height shows a gap of more than the slack, and the origin is inside where it is deeper than
// the slack inside all four sides of the tetrahedron, which the rounding of its corners cannot undo. Where the two
// origins are further apart than 2 the roundings grow in proportion, but there every reported gap is right, and a
// reported overlap would have to be wrong by half the distance. Pairs not proven after `mpr_steps`, or out of
// float's range, are unknown.
#pragma once

#include "graze/mat3.hpp"
#include "graze/quat.hpp"
#include "graze/wide.hpp"

namespace graze {

inline constexpr float mpr_slack = 2e-5f;

/// Support queries a pair. Among random pairs of smooth shapes fewer than 1 in 100 need more.
inline constexpr int mpr_steps = 14;

/// Squared length of a vector below which it gives no direction in float: its own square is still a normal number.
inline constexpr float least_square = 1e-24f;

template <class S>
S sum_of(const Vec3<S>& v) {
  return v.x + v.y + v.z;
}

/// A sum of a box and an ellipsoid about the origin. The ellipsoid may be a ball of another size at the box's bottom
/// than at its top, as in a tapered capsule, or a disc, as in a cylinder.
template <class S>
struct MprSum {
  Vec3<S> half, radii;
  S bottom, top;  ///< scale of `radii` at the bottom and at the top

  /// A bound of its points' distances from the origin without squares, which float may not hold.
  S size() const { return sum_of(half) + sum_of(radii); }
  void scale(const S& by) { half *= by, radii *= by; }
  Vec3<S> support(const Vec3<S>& d) const {
    const Vec3<S> v = scaled(radii, d);
    const S squared = length_squared(v), along = sqrt(squared);
    const auto up = half.y * d.y * S(2) + (top - bottom) * along >= S(0);
    // Too short a direction has no component along which the shape is round.
    const S share = select(squared > S(1e-35f), select(up, top, bottom) / along, S(0));
    const auto right = d.x >= S(0), front = d.z >= S(0);
    return scaled(radii, v) * share +
           Vec3<S>{select(right, half.x, -half.x), select(up, half.y, -half.y), select(front, half.z, -half.z)};
  }
  /// An inner point: the centre shifted by these fractions of its extents, each below a quarter.
  Vec3<S> inside(const Vec3<S>& fraction) const { return scaled(half + radii * least(bottom, top), fraction); }
};

/// The hull of three points.
template <class S>
struct MprPoints {
  Vec3<S> point[3];

  S size() const { return greatest(sum_of(abs(point[0])), greatest(sum_of(abs(point[1])), sum_of(abs(point[2])))); }
  void scale(const S& by) { point[0] *= by, point[1] *= by, point[2] *= by; }
  Vec3<S> support(const Vec3<S>& d) const {
    const S first = dot(point[0], d), second = dot(point[1], d), third = dot(point[2], d);
    const Vec3<S> of_two = select(second > first, point[1], point[0]);
    return select(third > greatest(first, second), point[2], of_two);
  }
  Vec3<S> inside(const Vec3<S>& fraction) const {
    const S third(1.0f / 3);
    return point[0] * (third + fraction.x) + point[1] * (third + fraction.y) +
           point[2] * (third - fraction.x - fraction.y);
  }
};

/// The hull of points that the caller holds; lanes with fewer repeat theirs.
template <class S>
struct MprHull {
  Vec3<S>* point;
  std::size_t count;

  S size() const {
    S found(0);
    for (std::size_t k = 0; k < count; ++k) found = greatest(found, sum_of(abs(point[k])));
    return found;
  }
  void scale(const S& by) {
    for (std::size_t k = 0; k < count; ++k) point[k] *= by;
  }
  Vec3<S> support(const Vec3<S>& d) const {
    Vec3<S> furthest = point[0];
    S height = dot(furthest, d);
    for (std::size_t k = 1; k < count; ++k) {
      const S other = dot(point[k], d);
      furthest = select(other > height, point[k], furthest);
      height = greatest(other, height);
    }
    return furthest;
  }
  /// An inner point: a mean of all points, whose weights differ by these fractions in turn.
  Vec3<S> inside(const Vec3<S>& fraction) const {
    Vec3<S> sum{S(0), S(0), S(0)};
    S weights(0);
    for (std::size_t k = 0; k < count; ++k) {
      const S weight = S(1) + S(3) * (k % 3 == 0 ? fraction.x : k % 3 == 1 ? fraction.y : -(fraction.x + fraction.y));
      sum += point[k] * weight;
      weights += weight;
    }
    return sum * (S(1) / weights);
  }
};

/// The difference D, rounded by `reach`, in A's frame.
template <class A, class B, class S>
struct MprDifference {
  A a;
  B b;
  Mat3<S> turn;
  Vec3<S> way;
  S reach;
  bool round;  ///< whether the reach is more than 0 in any lane

  /// The support point along n.
  Vec3<S> support(const Vec3<S>& n) const {
    const Vec3<S> core = turn * b.support(transposed_times(turn, n)) + way - a.support(-n);
    if (!round) return core;
    const S squared = length_squared(n);
    return core + n * select(squared > S(least_square), reach / sqrt(squared), S(0));
  }
  /// An inner point, not the difference of the centres: for shapes in line the origin would lie on the tetrahedron's
  /// edges.
  Vec3<S> inside() const {
    const Vec3<S> of_a{S(0.11f), S(0.07f), S(-0.13f)}, of_b{S(-0.05f), S(0.09f), S(0.08f)};
    return turn * b.inside(of_b) + way - a.inside(of_a);
  }
};

/// Lanes in which the cores are apart and lanes in which they come within reach; the others are unknown.
template <class S>
struct MprAnswer {
  typename S::Mask apart, touching;
};

/// Whether the origin is deeper than the slack inside the side p, q, r of a tetrahedron whose fourth corner is
/// `opposite`. Measured by the lengths of the side's edges, to which the rounding of its normal is relative.
template <class S>
auto holds_origin(const Vec3<S>& p, const Vec3<S>& q, const Vec3<S>& r, const Vec3<S>& opposite) {
  const Vec3<S> u = q - p, v = r - p, normal = cross(u, v);
  const S origin = -dot(normal, p), inner = dot(normal, opposite - p);
  const S least_height = S(mpr_slack * mpr_slack) * length_squared(u) * length_squared(v);
  return (origin * inner > origin * origin * S(0.5f)) & (origin * origin > least_height) &
         (length_squared(normal) > S(least_square));
}

template <class S, class D>
MprAnswer<S> mpr_overlap(const D& difference) {
  using Mask = typename S::Mask;
  const auto none = S(0) < S(0);
  MprAnswer<S> answer{none, none};
  // Whether the origin is in front of the plane through D's furthest point along n, behind which all of D lies.
  const auto before = [](const Vec3<S>& n, const Vec3<S>& furthest) {
    const S height = dot(n, furthest), squared = length_squared(n);
    return (height < S(0)) & (height * height > S(mpr_slack * mpr_slack) * squared) & (squared > S(least_square));
  };
  const Vec3<S> inside = difference.inside();
  Vec3<S> n = -inside;
  Vec3<S> p = difference.support(n);
  answer.apart = before(n, p);
  n = cross(p, inside);
  Vec3<S> q = difference.support(n);
  answer.apart = answer.apart | before(n, q);
  const auto turned = dot(cross(p - inside, q - inside), inside) > S(0);
  const Vec3<S> first = p;
  p = select(turned, q, p);
  q = select(turned, first, q);
  Vec3<S> r = q;
  Mask open = !answer.apart, portal = none, behind = none;  // `portal`: the ray goes through it
  for (int step = 2; step < mpr_steps && any(open); ++step) {
    // Along the normal of the portal, or, before there is one, of the plane through the inside, p and q.
    const Vec3<S> from = select(portal, p, inside);
    n = cross(select(portal, q, p) - from, select(portal, r, q) - from);
    const S ahead = dot(n, from);
    const auto in = portal & open & (ahead > S(0)) & (ahead * ahead > S(mpr_slack * mpr_slack) * length_squared(n));
    const Vec3<S> found = difference.support(n);
    const auto out = open & before(n, found);
    behind = behind | in;
    answer.apart = answer.apart | (out & !in);
    open = open & !(in | out);
    // The sides of the planes through the inside, the point found and p, q, or r on which the origin lies.
    const Vec3<S> across = cross(found, inside);
    const auto of_p = dot(p, across) > S(0), of_q = dot(q, across) > S(0), of_r = dot(r, across) > S(0);
    const auto against_p = dot(p, across) < S(0);
    const auto to_p = select(portal, (of_p & of_q) | !(of_p | of_r), of_q & !against_p);
    const auto to_q = select(portal, of_r & !of_p, against_p);
    p = select(open & to_p, found, p);
    q = select(open & to_q, found, q);
    const auto to_r = !(to_p | to_q);
    r = select(open & to_r, found, r);
    portal = portal | to_r;
  }
  if (any(behind))
    answer.touching = behind & holds_origin(inside, p, q, r) & holds_origin(inside, q, r, p) &
                      holds_origin(inside, p, r, q) & holds_origin(p, q, r, inside);
  return answer;
}

}  // namespace graze
