// Triangle against triangle: the signed distance with its two points, across lanes.
//
// Guarantee: where it says `proven`, the distance is right up to rounding, whether the triangles meet or not: no
// direction parts them by more, and the two points, which lie on the triangles, are no further apart. In every lane the
// bits that the pair gives alone. Slivers are never proven.
//
// The difference of two triangles has facets of two kinds: a triangle and a corner of the other, or two edges. Of those
// that meet, the facet nearest to the origin tells the depth (for triangles of one plane the plane itself, along which
// they are zero deep). Of those that are apart, what is nearest is a facet too, which shows the whole distance as a gap,
// or else an edge or a corner and a corner (Ericson 2005, "Real-time collision detection", section 5.1.10). Each answer
// proves itself: its points are as far apart as the triangles are along its normal.
#pragma once

#include "graze/query.hpp"
#include "narrow/flatten.hpp"
#include "narrow/one_of_three.hpp"
#include "narrow/pairs/box_triangle.hpp"
#include "narrow/pairs/sided_triangle.hpp"

namespace graze {

/// A triangle in place, rounded or not.
template <class S>
struct PlacedTriangle {
  TriangleCore<S> core;
  S radius;
  Pose<S> pose;
};

/// The signed distance of two triangles in place, and how far it is known.
template <class S>
struct TriangleDistance {
  using Mask = decltype(S() < S());

  Distance<S> at;
  Mask proven;
  Mask beyond;  ///< further apart than was asked for: the distance is a lower bound, and there are no points
};

namespace detail {

/// Roundings of a coordinate by which a point may miss what it is said to lie on.
inline constexpr double triangle_slack = 16;
/// Lengths between these have tenth powers, which products of two edges and squares of gaps along them are made of.
inline constexpr double least_triangle = 1e-25, largest_triangle = 1e25;
/// Two edges are parallel if the square of the sine between them is less: its direction is rounding.
inline constexpr double parallel_sides =
    4096 * std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();

/// One of the three that `which` names.
template <class S>
Vec3<S> picked(const OneOfThree<S>& which, const OfCorners<S>& v) {
  return which.pick(of_corner(v, 0), of_corner(v, 1), of_corner(v, 2));
}
template <class S>
S picked(const OneOfThree<S>& which, const Several<S, 3>& v) {
  return which.pick(v[0], v[1], v[2]);
}

/// One of the two in the frame of A.
template <class S>
struct FlatTriangle {
  using Three = Several<S, 3>;

  OfCorners<S> point, edge;  ///< an edge leads from its corner to the next
  OfCorners<S> outward;      ///< unit, across the edges in the triangle's plane
  Three squared, per;        ///< of the edges' lengths, and one over that
  Vec3<S> across, normal;    ///< across: as long as twice the area; normal: unit
  decltype(S() < S()) regular;

  FlatTriangle(const OfCorners<S>& points, const OfCorners<S>& edges) : point(points), edge(edges) {
    using std::sqrt;
    using T = typename LaneOf<S>::type;
    constexpr T thin = static_cast<T>(thinnest_triangle * thinnest_triangle);
    const S vanishing(std::numeric_limits<T>::min());
    squared = length_squared(edge);
    across = cross(of_corner(edge, 0), of_corner(edge, 1));
    const S longest = greatest_of(squared), area = length_squared(across);
    regular = (area > longest * longest * S(thin)) & (longest > S(T(least_triangle * least_triangle))) &
              (longest < S(T(largest_triangle * largest_triangle)));
    per = Three(S(1)) / greatest(squared, Three(vanishing));
    normal = across * (S(1) / sqrt(greatest(area, vanishing)));
    outward = cross(edge, for_corners(normal)) * sqrt(per);
  }
};

/// Two triangles in the frame of A.
template <class S>
struct TwoTriangles {
  using Three = Several<S, 3>;

  FlatTriangle<S> a, b;
  S noise;  ///< what rounding may do to a distance

  /// From a corner of A to B's three, or of B to A's.
  OfCorners<S> to_b(int i) const { return b.point - for_corners(of_corner(a.point, i)); }
  OfCorners<S> to_a(int j) const { return a.point - for_corners(of_corner(b.point, j)); }
  /// How far apart they are along a unit vector from A to B.
  S gap_along(const Vec3<S>& n) const {
    const Three m_a = dot(for_corners(n), for_corners(of_corner(a.point, 0)) - a.point),
                m_b = dot(for_corners(n), to_b(0));
    return least_of(m_a) + least_of(m_b);
  }
};

/// What is nearest of the two, or deepest.
template <class S>
struct NearestOfTriangles {
  using Mask = decltype(S() < S());
  CoreDistance<S> core;
  Mask proven;

  void otherwise(const NearestOfTriangles& next) {
    const Mask take = next.proven & (!proven);
    core = select(take, next.core, core);
    proven = proven | take;
  }
};

/// How one triangle sees the corners of the other.
template <class S>
struct SeenFromFace {
  using Three = Several<S, 3>;

  S separation;  ///< along its normal
  S toward;      ///< 1 if the other is on the normal's side, else -1
  S beside;      ///< the largest separation across one of its edges, in its plane
  Three height;  ///< of the other's corners on that side, in so far as they are over it; else infinite

  template <class To>
  SeenFromFace(const FlatTriangle<S>& face, const To& to, const S& slack) {
    using T = typename LaneOf<S>::type;
    const Three along = dot(for_corners(face.normal), to(0));
    const S above = least_of(along), below = -greatest_of(along);
    separation = greatest(above, below);
    toward = select(above < below, S(-1), S(1));
    Three furthest(S(-std::numeric_limits<T>::infinity()));
    beside = S(-std::numeric_limits<T>::infinity());
    for (int i = 0; i < 3; ++i) {
      const Three out = dot(for_corners(of_corner(face.outward, i)), to(i));
      furthest = greatest(furthest, out);
      beside = greatest(beside, least_of(out));
    }
    height = select(furthest <= Three(slack), along * Three(toward), Three(S(std::numeric_limits<T>::infinity())));
  }
  /// The corner that is nearest to the face over it.
  OneOfThree<S> nearest_corner() const {
    const auto first = (height[0] <= height[1]) & (height[0] <= height[2]);
    return OneOfThree<S>::of(first, (!first) & (height[1] <= height[2]));
  }
  S lowest() const { return least_of(height); }
};

/// Where two lines are nearest to each other: `from` + `e` s and, by `r` further, + `f` t.
template <class V>
struct NearestOnLines {
  V s, t;
  NearestOnLines(const Vec3<V>& e, const Vec3<V>& f, const Vec3<V>& r, const Vec3<V>& product, const V& per) {
    s = dot(cross(r, f), product) * per;
    t = dot(cross(r, e), product) * per;
  }
};

/// The best product of two edges: its unit vector from A to B, and which edges.
template <class S>
struct EdgeAxis {
  Vec3<S> normal;
  OneOfThree<S> a, b;
};

template <class S>
EdgeAxis<S> best_edge_axis(const TwoTriangles<S>& p) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  using Three = Several<S, 3>;
  // An edge of A is one place along its products, 0 here, and A's other corner another; and so for B, beyond the two
  // edges' own separation. Separations are compared by their squares with their signs, a product each in place of a root.
  const Three zero(S(0)), of_a = -dot(for_corners(p.a.across), p.b.edge), of_b = dot(for_corners(p.b.across), p.a.edge),
                          low_a = least(of_a, zero), high_a = greatest(of_a, zero), low_b = least(of_b, zero),
                          high_b = greatest(of_b, zero);
  Three gap(S(-std::numeric_limits<T>::infinity())), squared(S(1)), number(S(0)), toward(S(1));
  for (int i = 0; i < 3; ++i) {
    const OfCorners<S> product = cross(for_corners(of_corner(p.a.edge, i)), p.b.edge);
    const Three length = length_squared(product), between = dot(product, p.to_b(i)),
                above = between + Three(low_b[i]) - high_a, below = low_a - (between + Three(high_b[i])),
                apart = greatest(above, below), squares = apart * abs(apart);
    const auto better =
        (length > p.b.squared * Three(p.a.squared[i] * S(T(parallel_sides)))) & (squares * squared > gap * length);
    gap = select(better, squares, gap);
    squared = select(better, length, squared);
    number = select(better, Three(S(T(i))), number);
    toward = select(better, select(above < below, Three(S(-1)), Three(S(1))), toward);
  }
  S best = gap[0], over = squared[0], j(0), i = number[0], side = toward[0];
  for (int k = 1; k < 3; ++k) {
    const auto better = gap[k] * over > best * squared[k];
    best = select(better, gap[k], best);
    over = select(better, squared[k], over);
    j = select(better, S(T(k)), j);
    i = select(better, number[k], i);
    side = select(better, toward[k], side);
  }
  const OneOfThree<S> a(i), b(j);
  const Vec3<S> product = cross(picked(a, p.a.edge), picked(b, p.b.edge));
  return {product * (side / sqrt(over)), a, b};
}

/// Whether a place on an edge, as a part of it, lies on it, but for `slack` squared.
template <class V>
auto on_edge(const V& place, const V& squared, const V& slack_squared) {
  using std::abs;
  const V beyond = greatest(abs(place - V(0.5)) - V(0.5), V(0.0));
  return beyond * beyond * squared <= slack_squared;
}

/// By the two edges of an axis, where those cross as seen along it.
template <class S>
NearestOfTriangles<S> at_edges(const TwoTriangles<S>& p, const EdgeAxis<S>& axis, const S& separation, const S& slack) {
  const Vec3<S> e = picked(axis.a, p.a.edge), f = picked(axis.b, p.b.edge), from = picked(axis.a, p.a.point),
                to = picked(axis.b, p.b.point), product = cross(e, f);
  using T = typename LaneOf<S>::type;
  const S least_square(std::numeric_limits<T>::min()), slack_squared = slack * slack;
  const NearestOnLines<S> on(e, f, to - from, product, S(1) / greatest(length_squared(product), least_square));
  const Vec3<S> q = from + e * on.s, r = to + f * on.t;
  const decltype(S() < S()) met = on_edge(on.s, picked(axis.a, p.a.squared), slack_squared) &
                                  on_edge(on.t, picked(axis.b, p.b.squared), slack_squared) &
                                  (length_squared(r - q - axis.normal * separation) <= slack_squared);
  return {{separation, axis.normal, q, r}, met};
}

/// By a corner of either and an edge, or a corner, of the other. Triangles that are apart.
template <class S>
NearestOfTriangles<S> at_corners(const TwoTriangles<S>& p, const S& slack) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Three = Several<S, 3>;
  const Three zero(S(0)), one(S(1));
  Three least_squared(S(std::numeric_limits<T>::infinity())), number(S(0));
  for (int i = 0; i < 3; ++i) {
    const OfCorners<S> r = p.to_b(i), e = for_corners(of_corner(p.a.edge, i));
    const Three on_a = least(greatest(dot(e, r) * Three(p.a.per[i]), zero), one),
                on_b = least(greatest(-(dot(p.b.edge, r) * p.b.per), zero), one);
    const Three to_edge_a = length_squared(r - e * on_a), to_edge_b = length_squared(r + p.b.edge * on_b);
    const Three of_b = select(to_edge_b < to_edge_a, Three(S(T(i + 3))), Three(S(T(i))));
    const Three nearer = least(to_edge_a, to_edge_b);
    number = select(nearer < least_squared, of_b, number);
    least_squared = least(least_squared, nearer);
  }
  S nearest = least_squared[0], which = number[0], j(0);
  for (int k = 1; k < 3; ++k) {
    const auto nearer = least_squared[k] < nearest;
    nearest = select(nearer, least_squared[k], nearest);
    which = select(nearer, number[k], which);
    j = select(nearer, S(T(k)), j);
  }
  const auto edge_of_b = which >= S(3);
  const OneOfThree<S> of_a(which - select(edge_of_b, S(3), S(0))), of_b(j);
  const Vec3<S> corner_a = picked(of_a, p.a.point), corner_b = picked(of_b, p.b.point),
                edge = select(edge_of_b, picked(of_b, p.b.edge), picked(of_a, p.a.edge)),
                from = select(edge_of_b, corner_b, corner_a), corner = select(edge_of_b, corner_a, corner_b);
  const S per = select(edge_of_b, picked(of_b, p.b.per), picked(of_a, p.a.per));
  const S place = dot(corner - from, edge) * per;
  const auto within = (place > S(0)) & (place < S(1));
  const Vec3<S> on = from + edge * least(greatest(place, S(0)), S(1));
  Vec3<S> off = corner - on;
  // Across an edge to all digits, however near the corner is.
  off = off - edge * select(within, dot(off, edge) * per, S(0));
  const S distance = sqrt(length_squared(off)), scale = S(1) / select(distance > S(0), distance, S(1));
  const Vec3<S> normal = off * select(edge_of_b, -scale, scale);
  const decltype(S() < S()) proven =
      (distance > slack * S(T(roundings_off_edge / triangle_slack))) & (p.gap_along(normal) >= distance - slack);
  return {{distance, normal, select(edge_of_b, corner, on), select(edge_of_b, on, corner)}, proven};
}

/// By any two edges that cross as seen along an axis: what tells where the two planes are parallel and no corner of
/// either lies over the other.
template <class S>
NearestOfTriangles<S> at_crossing(const TwoTriangles<S>& p, const Vec3<S>& normal, const S& separation,
                                  const S& slack) {
  using T = typename LaneOf<S>::type;
  using Three = Several<S, 3>;
  const S slack_squared = slack * slack;
  const Three allowed(slack_squared);
  Three least_missed(S(std::numeric_limits<T>::infinity())), number(S(0));
  const Three infinite = least_missed;
  for (int i = 0; i < 3; ++i) {
    const OfCorners<S> e = for_corners(of_corner(p.a.edge, i)), r = p.to_b(i), product = cross(e, p.b.edge);
    const Three squared_a(p.a.squared[i]), length = length_squared(product);
    const auto distinct = length > p.b.squared * squared_a * Three(S(T(parallel_sides)));
    const NearestOnLines<Three> on(e, p.b.edge, r, product, Three(S(1)) / select(distinct, length, Three(S(1))));
    const Three missed = length_squared(r + p.b.edge * on.t - e * on.s - for_corners(normal * separation));
    const auto met = distinct & on_edge(on.s, squared_a, allowed) & on_edge(on.t, p.b.squared, allowed);
    const Three counted = select(met, missed, infinite);
    number = select(counted < least_missed, Three(S(T(i))), number);
    least_missed = least(least_missed, counted);
  }
  S missed = least_missed[0], i = number[0], j(0);
  for (int k = 1; k < 3; ++k) {
    const auto better = least_missed[k] < missed;
    missed = select(better, least_missed[k], missed);
    i = select(better, number[k], i);
    j = select(better, S(T(k)), j);
  }
  return at_edges(p, {normal, OneOfThree<S>(i), OneOfThree<S>(j)}, separation, slack);
}

/// What is nearest. Where they are apart by more than `enough` along an axis, that one: with no points, `beyond`.
template <class S, class M>
NearestOfTriangles<S> nearest_of_triangles(const TwoTriangles<S>& p, const S& enough, M& beyond) {
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S slack = p.noise * S(T(triangle_slack));
  const SeenFromFace<S> from_a(
      p.a, [&](int i) { return p.to_b(i); }, slack),
      from_b(
          p.b, [&](int j) { return p.to_a(j); }, slack);
  const Vec3<S> normal_a = p.a.normal * from_a.toward, normal_b = p.b.normal * -from_b.toward;
  const Mask by_b = from_b.separation > from_a.separation;
  Vec3<S> normal = select(by_b, normal_b, normal_a);
  S best = greatest(from_a.separation, from_b.separation);
  beyond = best > enough;
  NearestOfTriangles<S> nearest{{best, normal, {}, {}}, beyond};
  if (all(beyond)) return nearest;

  const EdgeAxis<S> edges = best_edge_axis(p);
  const S edge = p.gap_along(edges.normal);
  const Mask by_edge = edge > best;
  normal = select(by_edge, edges.normal, normal);
  best = greatest(best, edge);
  const Mask now = (edge > enough) & (!beyond);
  nearest.otherwise({{edge, edges.normal, {}, {}}, now});
  beyond = beyond | now;
  if (all(beyond)) return nearest;

  // In the plane of either: what keeps triangles of one plane apart.
  best = greatest(best, greatest(from_a.beside, from_b.beside));
  const S about = best - p.noise;
  const Vec3<S> over_a = picked(from_a.nearest_corner(), p.b.point),
                over_b = picked(from_b.nearest_corner(), p.a.point);
  const Mask on_a = (from_a.separation >= about) & (from_a.lowest() <= from_a.separation + slack),
             on_b = (from_b.separation >= about) & (from_b.lowest() <= from_b.separation + slack);
  nearest.otherwise({{best, normal_a, over_a - normal_a * best, over_a}, on_a});
  nearest.otherwise({{best, normal_b, over_b, over_b + normal_b * best}, on_b});
  NearestOfTriangles<S> of_edges = at_edges(p, edges, best, slack);
  of_edges.proven = of_edges.proven & (edge >= about);
  nearest.otherwise(of_edges);
  if (all(nearest.proven)) return nearest;
  nearest.otherwise(at_corners(p, slack));
  if (all(nearest.proven)) return nearest;
  nearest.otherwise(at_crossing(p, normal, best, slack));
  return nearest;
}

}  // namespace detail

/// Further apart than `enough` along an axis they need not be measured: `beyond`. Of infinitely far all are.
template <class S>
GRAZE_FLATTEN TriangleDistance<S> triangle_distance(const PlacedTriangle<S>& a, const PlacedTriangle<S>& b,
                                                    const S& enough) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Three = Several<S, 3>;
  const auto corners = [](const TriangleCore<S>& t) -> OfCorners<S> {
    const Vec3<S>* p = t.point;
    return {Three(p[0].x, p[1].x, p[2].x), Three(p[0].y, p[1].y, p[2].y), Three(p[0].z, p[1].z, p[2].z)};
  };
  // Differences of corners keep their digits wherever a triangle lies in its own frame.
  const auto edges = [](const TriangleCore<S>& t) -> OfCorners<S> {
    const Vec3<S> u = t.point[1] - t.point[0], v = t.point[2] - t.point[1], w = t.point[0] - t.point[2];
    return {Three(u.x, v.x, w.x), Three(u.y, v.y, w.y), Three(u.z, v.z, w.z)};
  };
  const Mat3<S> turn = rotation_of(a.pose.rotation);
  const RelativeFrame<S> b_in_a = relative_frame(a.pose, turn, b.pose);
  const Vec3<S>* row = b_in_a.rotation.row;
  const Mat3<Three> rotation{{for_corners(row[0]), for_corners(row[1]), for_corners(row[2])}};
  const OfCorners<S> points_a = corners(a.core), points_b = corners(b.core);
  const S extent_a = sqrt(greatest_of(length_squared(points_a))),
          extent_b = sqrt(greatest_of(length_squared(points_b))),
          size = greatest(extent_a + a.radius, extent_b + b.radius) + max_abs(b_in_a.translation),
          radii = a.radius + b.radius;
  const detail::TwoTriangles<S> pair{
      detail::FlatTriangle<S>(points_a, edges(a.core)),
      detail::FlatTriangle<S>(rotation * points_b + for_corners(b_in_a.translation), rotation * edges(b.core)),
      S(box_rounding<T>) * size};
  TriangleDistance<S> found;
  const detail::NearestOfTriangles<S> nearest =
      detail::nearest_of_triangles(pair, enough + radii + pair.noise, found.beyond);
  const CoreDistance<S>& core = nearest.core;
  const auto regular = pair.a.regular & pair.b.regular & (size < S(T(detail::largest_triangle)));
  found.proven = nearest.proven & regular;
  found.beyond = found.beyond & regular;
  // What rounding cannot tell from touching touches. Half of the answer on each side of the middle of the two points,
  // so that b - a = distance * normal to the last bits.
  const S distance = select(abs(core.distance - radii) <= pair.noise, radii, core.distance),
          half = distance * S(T(0.5));
  const Vec3<S> middle = (core.a + core.b) * S(T(0.5));
  found.at.distance = distance - radii;
  found.at.normal = turn * core.normal;
  found.at.a = a.pose.translation + turn * (middle + core.normal * (a.radius - half));
  found.at.b = a.pose.translation + turn * (middle + core.normal * (half - b.radius));
  return found;
}

}  // namespace graze
