// Triangle against triangle: the signed distance with its two witness points, across lanes.
//
// Guarantee: where `proven` is set, the distance is right up to rounding, whether the triangles meet or not: no
// direction separates them by more, and the two points, which lie on the triangles, are no further apart. In every lane
// the bits that the pair gives alone. Slivers are never proven.
//
// For triangles that meet, the depth is given by the facet of their Minkowski difference nearest to the origin: a
// corner in front of a face, or two edges that cross (for coplanar triangles their plane, along which they are zero
// deep). For disjoint ones, the separation along such a facet's normal may be the whole distance; else a corner and an
// edge, or two corners, are nearest (Ericson 2005, "Real-time collision detection", section 5.1.10). Each answer proves
// itself: its points are as far apart as the triangles are along its normal.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/core/power_of_two.hpp"
#include "narrow/pairs/triangle_triangle/sat.hpp"

namespace graze {

/// A triangle in place, rounded or not.
template <class S>
struct PlacedTriangle {
  TriangleCore<S> core;
  S radius;
  Pose<S> pose;
};

/// The signed distance of two triangles in place, and whether it is proven.
template <class S>
struct TriangleDistance {
  using Mask = decltype(S() < S());

  Distance<S> at;
  Mask proven;
  Mask beyond;  ///< further apart than the given bound: the distance is a lower bound, and the points are meaningless
};

namespace detail {

/// Roundings of a coordinate by which a witness point may miss the feature that it lies on.
inline constexpr double triangle_slack = 16;

/// The witness points of two triangles and their signed distance.
template <class S>
struct NearestOfTriangles {
  using Mask = decltype(S() < S());
  CoreDistance<S> core;
  Mask proven;

  void otherwise(const CoreDistance<S>& next, const Mask& next_proven) {
    const Mask take = next_proven & (!proven);
    core = select(take, next, core);
    proven = proven | take;
  }
  void otherwise(const NearestOfTriangles& next) { otherwise(next.core, next.proven); }
};

/// Whether a parameter of an edge is between its ends, but for the squared distance `slack_squared`.
template <class V>
auto on_edge(const V& place, const V& squared, const V& slack_squared) {
  using std::abs;
  const V half(0.5), beyond = greatest(abs(place - half) - half, V(0.0));
  return beyond * beyond * squared <= slack_squared;
}

/// The parameters of the nearest points of two lines, along `e` and `f`, the second starting at offset `r` from the
/// first.
template <class V>
struct NearestOnLines {
  V s, t;
  NearestOnLines(const Vec3<V>& e, const Vec3<V>& f, const Vec3<V>& r, const Vec3<V>& product, const V& per)
      : s(dot(cross(r, f), product) * per), t(dot(cross(r, e), product) * per) {}
};

/// The distance by two edges that cross as seen along an axis.
template <class Row, class S>
NearestOfTriangles<S> at_edges(const TwoTriangles<Row>& p, const EdgeNumbers<S>& numbers, const Vec3<S>& normal,
                               const S& separation, const S& slack_squared) {
  using T = typename LaneOf<S>::type;
  const AxisPermutation<S> i(numbers.a), j(numbers.b);
  const Vec3<S> e = picked(i, p.a.edge), f = picked(j, p.b.edge), from = picked(i, p.a.point),
                to = picked(j, p.b.point), product = cross(e, f);
  const NearestOnLines<S> on(e, f, to - from, product,
                             S(1) / greatest(length_squared(product), S(std::numeric_limits<T>::min())));
  const Vec3<S> a = from + e * on.s, b = to + f * on.t;
  const decltype(S() < S()) met = on_edge(on.s, picked(i, p.a.squared), slack_squared) &
                                  on_edge(on.t, picked(j, p.b.squared), slack_squared) &
                                  (length_squared(b - a - normal * separation) <= slack_squared);
  return {{separation, normal, a, b}, met};
}

/// Any two edges that cross as seen along an axis: these decide where the two planes are parallel and no corner of
/// either lies over the other.
template <class Row, class S>
EdgeNumbers<S> crossing_edges(const TwoTriangles<Row>& p, const Vec3<S>& normal, const S& separation,
                              const S& slack_squared) {
  using T = typename LaneOf<S>::type;
  const Row one{S(1)}, infinity{S(std::numeric_limits<T>::infinity())}, allowed{slack_squared};
  Row least_missed = infinity, number{S(0)};
  for (int i = 0; i < 3; ++i) {
    const CornerRows<Row> e = to_all<Row>(corner_of(p.a.edge, i)), r = p.to_b(i), product = cross(e, p.b.edge);
    const Row squared_a(p.a.squared[i]), length = length_squared(product);
    const auto distinct = length > p.b.squared * squared_a * Row(S(T(parallel_sides)));
    const NearestOnLines<Row> on(e, p.b.edge, r, product, one / select(distinct, length, one));
    const auto met = distinct & on_edge(on.s, squared_a, allowed) & on_edge(on.t, p.b.squared, allowed);
    const Row missed =
        select(met, length_squared(r + p.b.edge * on.t - e * on.s - to_all<Row>(normal * separation)), infinity);
    number = select(missed < least_missed, Row(S(T(i))), number);
    least_missed = least(least_missed, missed);
  }
  S missed = least_missed[0], i = number[0], j(0);
  for (int k = 1; k < 3; ++k) {
    const auto better = least_missed[k] < missed;
    missed = select(better, least_missed[k], missed);
    i = select(better, number[k], i);
    j = select(better, S(T(k)), j);
  }
  return {i, j};
}

/// The distance by a corner of either and an edge, or a corner, of the other, for disjoint triangles.
template <class Row, class S>
NearestOfTriangles<S> at_corners(const TwoTriangles<Row>& p, const S& slack) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  const Row zero{S(0)}, one{S(1)}, per_a = p.a.per(), per_b = p.b.per();
  Row least_squared{S(std::numeric_limits<T>::infinity())}, number{S(0)};
  for (int i = 0; i < 3; ++i) {
    const CornerRows<Row> r = p.to_b(i);
    const Row whole = length_squared(r), along_a = dot(to_all<Row>(corner_of(p.a.edge, i)), r),
              along_b = -dot(p.b.edge, r);
    const auto from_edge = [&](const Row& along, const Row& squared, const Row& per) {
      const Row place = least(greatest(along * per, zero), one);
      return whole + place * (place * squared - (along + along));
    };
    const Row of_a = from_edge(along_a, Row(p.a.squared[i]), Row(per_a[i])),
              of_b = from_edge(along_b, p.b.squared, per_b), nearer = least(of_a, of_b);
    number = select(nearer < least_squared, select(of_b < of_a, Row(S(T(i + 3))), Row(S(T(i)))), number);
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
  const AxisPermutation<S> of_a(which - select(edge_of_b, S(3), S(0))), of_b(j);
  const Vec3<S> corner_a = picked(of_a, p.a.point), corner_b = picked(of_b, p.b.point),
                edge = select(edge_of_b, picked(of_b, p.b.edge), picked(of_a, p.a.edge)),
                from = select(edge_of_b, corner_b, corner_a), corner = select(edge_of_b, corner_a, corner_b);
  const S per = select(edge_of_b, picked(of_b, per_b), picked(of_a, per_a)), place = dot(corner - from, edge) * per;
  const auto within = (place > S(0)) & (place < S(1));
  const Vec3<S> on = from + edge * least(greatest(place, S(0)), S(1));
  Vec3<S> off = corner - on;
  // Perpendicular to the edge to all digits, however near the corner is.
  off = off - edge * select(within, dot(off, edge) * per, S(0));
  const S distance = sqrt(length_squared(off)), scale = S(1) / select(distance > S(0), distance, S(1));
  const Vec3<S> normal = off * select(edge_of_b, -scale, scale);
  const decltype(S() < S()) proven =
      (distance > p.noise * S(T(roundings_off_edge))) & (p.gap_along(normal) >= distance - slack);
  return {{distance, normal, select(edge_of_b, corner, on), select(edge_of_b, on, corner)}, proven};
}

/// The separation along the line from the middle of A to that of B, where it exceeds `enough`, which is not negative.
template <class Row, class S>
NearestOfTriangles<S> beyond_middles(const TwoTriangles<Row>& p, const S& enough) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  const auto sum = [](const Row& r) { return r[0] + r[1] + r[2]; };
  const CornerRows<Row> r = p.b.point - p.a.point;
  const Vec3<S> along{sum(r.x), sum(r.y), sum(r.z)};
  const S gap = p.gap_along(along), squared = length_squared(along);
  const decltype(S() < S()) beyond = (gap > S(0)) & (gap * gap > enough * enough * squared);
  if (!any(beyond)) return {{gap, along, {}, {}}, beyond};
  const S scale = S(1) / sqrt(greatest(squared, S(std::numeric_limits<T>::min())));
  return {{gap * scale, along * scale, {}, {}}, beyond};
}

/// The distance by whichever features prove it. Where an axis separates the triangles by more than `enough`, the
/// separation along it without points, with `beyond` set.
template <class Row, class S, class M>
NearestOfTriangles<S> nearest_of_triangles(const TwoTriangles<Row>& p, const S& enough, M& beyond) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  NearestOfTriangles<S> nearest{};
  if (any(enough < S(std::numeric_limits<T>::infinity()))) {
    nearest = beyond_middles(p, enough);
    beyond = nearest.proven;
    if (all(beyond)) return nearest;
  }
  const S slack = p.noise * S(T(triangle_slack)), slack_squared = slack * slack;
  const auto to_b = [&](int i) { return p.to_b(i); };
  const auto to_a = [&](int j) { return p.to_a(j); };
  const SeenFromPlane<Row> plane_a(p.a, to_b), plane_b(p.b, to_a);
  const Vec3<S> normal_a = p.a.normal * plane_a.toward, normal_b = p.b.normal * -plane_b.toward;
  const M by_b = plane_b.separation > plane_a.separation;
  Vec3<S> normal = select(by_b, normal_b, normal_a);
  S best = greatest(plane_a.separation, plane_b.separation);
  const auto look_beyond = [&](const S& separation, const Vec3<S>& along) {
    const M further = (separation > enough) & (!nearest.proven);
    nearest.otherwise({separation, along, {}, {}}, further);
    beyond = beyond | further;
  };
  look_beyond(best, normal);
  if (all(beyond)) return nearest;

  // Triangles separated by a face: a corner over it, if that is nearest, or nearest points away from all faces.
  const SeenFromFace<Row> face_a(p.a, plane_a, to_b, slack_squared), face_b(p.b, plane_b, to_a, slack_squared);
  const Vec3<S> over_a = picked(face_a.corner, p.b.point), over_b = picked(face_b.corner, p.a.point);
  const M low_a = least_of(face_a.height) <= plane_a.separation + slack,
          low_b = least_of(face_b.height) <= plane_b.separation + slack, apart = best > p.noise;
  const auto at_faces = [&](const S& separation, const M& by_face_a, const M& by_face_b) {
    nearest.otherwise({separation, normal_a, over_a - normal_a * separation, over_a}, by_face_a & low_a);
    nearest.otherwise({separation, normal_b, over_b, over_b + normal_b * separation}, by_face_b & low_b);
  };
  at_faces(best, apart & (!by_b), apart & by_b);
  if (all(nearest.proven)) return nearest;
  nearest.otherwise(at_corners(p, slack));
  if (all(nearest.proven)) return nearest;

  const EdgeAxis<S> edges = best_edge_axis(p);
  S edge = edges.axis.separation;
  normal = select(edge > best, edges.axis.normal, normal);
  best = greatest(best, edge);
  look_beyond(edge, edges.axis.normal);
  // Axes in the plane of either triangle, which separate coplanar triangles.
  const S beside = greatest(face_a.beside, face_b.beside), beside_by = sqrt(abs(beside));
  best = greatest(best, select(beside < S(0), -beside_by, beside_by));
  const S about = best - p.noise;
  at_faces(best, plane_a.separation >= about, plane_b.separation >= about);
  if (all(nearest.proven)) return nearest;
  // The edges of the best product; then any that cross.
  Vec3<S> along = edges.axis.normal;
  EdgeNumbers<S> numbers = edges.numbers;
  for (int round = 0; round < 2; ++round) {
    const NearestOfTriangles<S> crossing = at_edges(p, numbers, along, best, slack_squared);
    const M proven = edge >= about;
    nearest.otherwise(crossing.core, crossing.proven & proven);
    if (round == 1 || all(nearest.proven)) break;
    numbers = crossing_edges(p, normal, best, slack_squared);
    along = normal;
    edge = best;
  }
  return nearest;
}

}  // namespace detail

/// Two triangles in a frame at A's origin along the world's axes, from which an answer is only translated.
template <class Row, class S>
TwoTriangles<Row> two_triangles(const PlacedTriangle<S>& a, const PlacedTriangle<S>& b) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  const auto turned = [](const PlacedTriangle<S>& t) -> CornerRows<Row> {
    const Mat3<S> turn = rotation_of(t.pose.rotation);
    const Mat3<Row> rotation{{to_all<Row>(turn.row[0]), to_all<Row>(turn.row[1]), to_all<Row>(turn.row[2])}};
    return rotation * corner_rows<Row>(t.core.point[0], t.core.point[1], t.core.point[2]);
  };
  const auto size = [](const CornerRows<Row>& points, const S& radius) {
    return sqrt(greatest_of(length_squared(points))) + radius;
  };
  const Vec3<S> between = b.pose.translation - a.pose.translation;
  const CornerRows<Row> points_a = turned(a), points_b = turned(b);
  TwoTriangles<Row> pair{FlatTriangle<Row>(points_a),
                         FlatTriangle<Row>(points_b + to_all<Row>(between)),
                         size(points_a, a.radius),
                         size(points_b, b.radius),
                         S(0),
                         {}};
  const S largest = greatest(pair.size_a, pair.size_b) + max_abs(between);
  pair.noise = S(box_rounding<T>) * largest;
  pair.regular = pair.a.regular & pair.b.regular;
  return pair;
}

/// The distance of rounded triangles. Those further apart than `enough`, which is not negative, need not be measured;
/// infinity measures all. `origin`: the frame's, in the world.
template <class Row, class S>
TriangleDistance<S> triangle_distance(const TwoTriangles<Row>& pair, const S& radius_a, const S& radius_b,
                                      const Vec3<S>& origin, const S& enough) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  const S radii = radius_a + radius_b;
  TriangleDistance<S> found{};
  const detail::NearestOfTriangles<S> nearest =
      detail::nearest_of_triangles(pair, enough + radii + pair.noise, found.beyond);
  const CoreDistance<S>& core = nearest.core;
  found.proven = nearest.proven & pair.regular;
  found.beyond = found.beyond & pair.regular;
  // A gap within rounding counts as touching. Half of the distance goes to each side of the middle of the two points,
  // so that b - a = distance * normal to the last bits.
  const S distance = select(abs(core.distance - radii) <= pair.noise, radii, core.distance),
          half = distance * S(T(0.5));
  const Vec3<S> middle = origin + (core.a + core.b) * S(T(0.5));
  found.at.distance = distance - radii;
  found.at.normal = core.normal;
  found.at.a = middle + core.normal * (radius_a - half);
  found.at.b = middle + core.normal * (half - radius_b);
  return found;
}

/// Two triangles in a unit of their own, a power of two about as large as they and their distance: products of ten
/// lengths stay within range, and answers are the same for any size of the world.
template <class S>
struct TrianglesInUnits {
  S unit;
  PlacedTriangle<S> a, b;

  TrianglesInUnits(const PlacedTriangle<S>& of_a, const PlacedTriangle<S>& of_b) : a(of_a), b(of_b) {
    const auto extent = [](const PlacedTriangle<S>& t) {
      const Vec3<S>* const p = t.core.point;
      return greatest(t.radius, greatest(max_abs(p[0]), greatest(max_abs(p[1]), max_abs(p[2]))));
    };
    const S below =
        power_of_two_below(greatest(max_abs(b.pose.translation - a.pose.translation), greatest(extent(a), extent(b))));
    unit = select(below > S(0), below, S(1));
    const S per = S(1) / unit;
    for (PlacedTriangle<S>* const t : {&a, &b}) {
      for (Vec3<S>& point : t->core.point) point = point * per;
      t->radius = t->radius * per;
      t->pose.translation = t->pose.translation * per;
    }
  }

  /// A result in the caller's unit.
  TriangleDistance<S> restored(TriangleDistance<S> found) const {
    found.at.distance = found.at.distance * unit;
    found.at.a = found.at.a * unit;
    found.at.b = found.at.b * unit;
    return found;
  }
};

template <class Row, class S>
TriangleDistance<S> triangle_distance(const PlacedTriangle<S>& of_a, const PlacedTriangle<S>& of_b, const S& enough) {
  const TrianglesInUnits<S> in(of_a, of_b);
  return in.restored(triangle_distance(two_triangles<Row>(in.a, in.b), in.a.radius, in.b.radius, in.a.pose.translation,
                                       enough / in.unit));
}

/// The axes from which contacts are found: the best axis of a face, a triangle's normal or the perpendicular of one of
/// its edges in its plane, and the best product of edges; along the world's axes.
template <class S>
struct TriangleAxes {
  TriangleAxis<S> face, edge;
  S smaller;  ///< size of the smaller triangle: see `most_edges_of_size`
  S noise;    ///< rounding of a separation

  TriangleAxes times(const S& unit) const {
    return {{face.separation * unit, face.normal}, {edge.separation * unit, edge.normal}, smaller * unit, noise * unit};
  }
};

namespace detail {

template <class Row, class To>
auto best_face_axis(const FlatTriangle<Row>& face, const To& to) {
  using std::sqrt;
  using S = typename RowOf<Row>::Number;
  const SeenFromPlane<Row> plane(face, to);
  TriangleAxis<S> best{plane.separation, face.normal * plane.toward};
  const CornerRows<Row> outward = cross(face.edge, to_all<Row>(face.normal)) * sqrt(face.per());
  for (int i = 0; i < 3; ++i) {
    const Vec3<S> across = corner_of(outward, i);
    const S separation = least_of(dot(to_all<Row>(across), to(i)));
    best = select(separation > best.separation, TriangleAxis<S>{separation, across}, best);
  }
  return best;
}

/// The size of a triangle, by which faces are preferred to edges, is at most so many times its longest edge. Triangles
/// of a mesh count as large as their distance from the mesh's origin, about which the body is; where all of them lie
/// far beside it, that is no size of theirs. A body of a few triangles about its origin reaches no further than this.
inline constexpr double most_edges_of_size = 4;

template <class Row>
auto size_of_smaller(const TwoTriangles<Row>& p) {
  using std::sqrt;
  using S = typename RowOf<Row>::Number;
  using T = typename LaneOf<S>::type;
  const S longest = sqrt(least(greatest_of(p.a.squared), greatest_of(p.b.squared)));
  return least(least(p.size_a, p.size_b), S(T(most_edges_of_size)) * longest);
}

}  // namespace detail

template <class Row>
auto triangle_axes(const TwoTriangles<Row>& p) {
  using S = typename RowOf<Row>::Number;
  const TriangleAxis<S> a = detail::best_face_axis(p.a, [&](int i) { return p.to_b(i); }),
                        b = detail::best_face_axis(p.b, [&](int j) { return p.to_a(j); });
  return TriangleAxes<S>{select(b.separation > a.separation, TriangleAxis<S>{b.separation, -b.normal}, a),
                         best_edge_axis(p).axis, detail::size_of_smaller(p), p.noise};
}

}  // namespace graze
