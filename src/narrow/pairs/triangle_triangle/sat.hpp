// Two triangles in one frame: their planes, corners over their faces, and the products of their edges; across lanes, or
// for a single pair with the numbers of three corners in one register.
//
// Guarantee: in every lane the bits that the pair gives alone. A separation along an axis is that of the two intervals,
// so that the largest of all is a lower bound of the distance, and for overlapping triangles exactly minus the depth,
// up to rounding: the Minkowski difference of two triangles has no other facets. For slivers the results are
// meaningless.
#pragma once

#include "narrow/pairs/box_triangle/sat.hpp"
#include "narrow/pairs/triangle_closest_feature.hpp"
#include "simd/axis_permutation.hpp"

namespace graze {

/// A number for each of three corners, or of three edges, which begin at them. `Packed` serves every lane type; a
/// register of four, where the machine has it, is faster for a single pair.
template <class S>
using FourWide = Wide<S, 4>;

template <class Row>
struct RowOf {
  using Number = std::decay_t<decltype(std::declval<Row>()[0])>;
};
template <class S>
Packed<S, 3> row_of(const S& x, const S& y, const S& z, Packed<S, 3>*) {
  return {x, y, z};
}
template <class S>
FourWide<S> row_of(const S& x, const S& y, const S& z, FourWide<S>*) {
  return FourWide<S>::of(typename FourWide<S>::Vector{x, y, z, z});
}
template <class S>
FourWide<S> following(const FourWide<S>& a) {
  return FourWide<S>::of(__builtin_shufflevector(a.v, a.v, 1, 2, 0, 0));
}
template <class S>
S greatest_of(const FourWide<S>& a) {
  return greatest(greatest(a[0], a[1]), a[2]);
}
template <class S>
S least_of(const FourWide<S>& a) {
  return least(least(a[0], a[1]), a[2]);
}

/// Three points, with a row for each coordinate.
template <class Row>
using CornerRows = Vec3<Row>;
template <class Row, class S>
CornerRows<Row> corner_rows(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c) {
  Row* const kind = nullptr;
  return {row_of(a.x, b.x, c.x, kind), row_of(a.y, b.y, c.y, kind), row_of(a.z, b.z, c.z, kind)};
}
template <class Row>
auto corner_of(const CornerRows<Row>& rows, int i) {
  return Vec3<typename RowOf<Row>::Number>{rows.x[i], rows.y[i], rows.z[i]};
}
/// One vector for all three corners.
template <class Row, class S>
CornerRows<Row> to_all(const Vec3<S>& v) {
  return {Row(v.x), Row(v.y), Row(v.z)};
}
/// The number that the permutation puts last.
template <class S, class Row>
S picked(const AxisPermutation<S>& which, const Row& row) {
  return which.pick(row[0], row[1], row[2]);
}
template <class S, class Row>
Vec3<S> picked(const AxisPermutation<S>& which, const CornerRows<Row>& rows) {
  return {picked(which, rows.x), picked(which, rows.y), picked(which, rows.z)};
}

/// Least length of an edge, in units of the two triangles, whose tenth power is a normal number: products of two edges
/// and squares of gaps along them have that order.
inline constexpr double least_triangle = 1e-25;
/// Squared sine below which two edges count as parallel, since the direction of their product is mere rounding.
inline constexpr double parallel_sides =
    4096 * std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();

/// A triangle with its edges and its normal.
template <class Row>
struct FlatTriangle {
  using S = typename RowOf<Row>::Number;

  CornerRows<Row> point, edge;  ///< an edge leads from its corner to the next
  Row squared;                  ///< squared lengths of the edges
  Vec3<S> across, normal;       ///< `across`: as long as twice the area; `normal`: unit
  decltype(S() < S()) regular;  ///< not a sliver, and at least `least_triangle` long

  explicit FlatTriangle(const CornerRows<Row>& points)
      : point(points), edge(CornerRows<Row>{following(points.x), following(points.y), following(points.z)} - points) {
    using std::sqrt;
    using T = typename LaneOf<S>::type;
    constexpr T thin = static_cast<T>(thinnest_triangle * thinnest_triangle);
    squared = length_squared(edge);
    across = cross(corner_of(edge, 0), corner_of(edge, 1));
    const S longest = greatest_of(squared), area = length_squared(across);
    regular = (area > longest * longest * S(thin)) & (longest > S(T(least_triangle * least_triangle)));
    normal = across * (S(1) / sqrt(greatest(area, S(std::numeric_limits<T>::min()))));
  }
  /// One over the squared lengths of the edges.
  Row per() const {
    using T = typename LaneOf<S>::type;
    return Row(S(1)) / greatest(squared, Row(S(std::numeric_limits<T>::min())));
  }
};

/// Two triangles in one frame.
template <class Row>
struct TwoTriangles {
  using S = typename RowOf<Row>::Number;
  using Mask = decltype(S() < S());

  FlatTriangle<Row> a, b;
  S size_a, size_b;  ///< radii about their own origins, with their rounding
  S noise;           ///< rounding of a distance
  Mask regular;

  /// The vectors from a corner of A to B's three, and from a corner of B to A's.
  CornerRows<Row> to_b(int i) const { return b.point - to_all<Row>(corner_of(a.point, i)); }
  CornerRows<Row> to_a(int j) const { return a.point - to_all<Row>(corner_of(b.point, j)); }
  /// The separation along a vector from A to B, times its length.
  S gap_along(const Vec3<S>& n) const {
    const CornerRows<Row> along = to_all<Row>(n), first = to_all<Row>(corner_of(a.point, 0));
    return least_of(dot(along, b.point - first)) - greatest_of(dot(along, a.point - first));
  }
};

/// An axis from A to B and the separation along it.
template <class S>
struct TriangleAxis {
  S separation;
  Vec3<S> normal;  ///< unit
};
template <class M, class S>
TriangleAxis<S> select(const M& condition, const TriangleAxis<S>& yes, const TriangleAxis<S>& no) {
  return {select(condition, yes.separation, no.separation), select(condition, yes.normal, no.normal)};
}

/// The corners of one triangle relative to the plane of the other.
template <class Row>
struct SeenFromPlane {
  using S = typename RowOf<Row>::Number;

  S separation;  ///< separation along the normal
  S toward;      ///< 1 if the corners are on the normal's side, else -1
  Row height;    ///< distance from the plane on that side

  template <class To>
  SeenFromPlane(const FlatTriangle<Row>& face, const To& to) {
    const Row along = dot(to_all<Row>(face.normal), to(0));
    const S above = least_of(along), below = -greatest_of(along);
    separation = greatest(above, below);
    toward = select(above < below, S(-1), S(1));
    height = along * Row(toward);
  }
};

/// The corners of one triangle that lie over the other.
template <class Row>
struct SeenFromFace {
  using S = typename RowOf<Row>::Number;

  Row height;                 ///< infinite for corners that do not
  S beside;                   ///< largest separation across an edge of the triangle, in its plane: its signed square
  AxisPermutation<S> corner;  ///< the lowest corner that does

  template <class To>
  SeenFromFace(const FlatTriangle<Row>& face, const SeenFromPlane<Row>& seen, const To& to, const S& slack_squared)
      : corner(S(0)) {
    using std::abs;
    using T = typename LaneOf<S>::type;
    const S infinity(std::numeric_limits<T>::infinity());
    const Row per = face.per();
    const CornerRows<Row> outward = cross(face.edge, to_all<Row>(face.normal));  // as long as the edges
    Row furthest(-infinity);
    beside = -infinity;
    for (int i = 0; i < 3; ++i) {
      const Row out = dot(to_all<Row>(corner_of(outward, i)), to(i)), squares = out * abs(out) * Row(per[i]);
      furthest = greatest(furthest, squares);
      beside = greatest(beside, least_of(squares));
    }
    height = select(furthest <= Row(slack_squared), seen.height, Row(infinity));
    const auto first = (height[0] <= height[1]) & (height[0] <= height[2]);
    corner = AxisPermutation<S>::of(first, (!first) & (height[1] <= height[2]));
  }
};

/// Numbers of an edge of A and an edge of B.
template <class S>
struct EdgeNumbers {
  S a, b;
};

/// The best product of two edges, and which edges.
template <class S>
struct EdgeAxis {
  TriangleAxis<S> axis;
  EdgeNumbers<S> numbers;
};

template <class Row>
auto best_edge_axis(const TwoTriangles<Row>& p) {
  using std::abs, std::sqrt;
  using S = typename RowOf<Row>::Number;
  using T = typename LaneOf<S>::type;
  // An edge of A projects to one point along its products, 0 here, and A's other corner to another; and so for B,
  // relative to the separation of the two edges. Separations are compared by their signed squares, a product each in
  // place of a root.
  const Row zero{S(0)}, of_a = -dot(to_all<Row>(p.a.across), p.b.edge), of_b = dot(to_all<Row>(p.b.across), p.a.edge),
                        low_a = least(of_a, zero), high_a = greatest(of_a, zero), low_b = least(of_b, zero),
                        high_b = greatest(of_b, zero);
  Row gap{S(-std::numeric_limits<T>::infinity())}, squared{S(1)}, number{S(0)}, toward{S(1)};
  for (int i = 0; i < 3; ++i) {
    const CornerRows<Row> product = cross(to_all<Row>(corner_of(p.a.edge, i)), p.b.edge);
    const Row length = length_squared(product), between = dot(product, p.to_b(i)),
              above = between + Row(low_b[i]) - high_a, below = low_a - (between + Row(high_b[i])),
              apart = greatest(above, below), squares = apart * abs(apart);
    const auto better =
        (length > p.b.squared * Row(p.a.squared[i] * S(T(parallel_sides)))) & (squares * squared > gap * length);
    gap = select(better, squares, gap);
    squared = select(better, length, squared);
    number = select(better, Row(S(T(i))), number);
    toward = select(better, select(above < below, Row(S(-1)), Row(S(1))), toward);
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
  const Vec3<S> normal =
      cross(picked(AxisPermutation<S>(i), p.a.edge), picked(AxisPermutation<S>(j), p.b.edge)) * (side / sqrt(over));
  return EdgeAxis<S>{{p.gap_along(normal), normal}, {i, j}};
}

}  // namespace graze
