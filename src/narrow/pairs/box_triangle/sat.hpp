// Box against triangle: the reference axis of contacts, among the three axes of the box, the triangle's normal and
// those of its sides in its plane, and the nine products of their edges (Akenine-Möller 2001, "Fast 3D triangle-box
// overlap testing", Journal of Graphics Tools); across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The separation along an axis is that of the two
// intervals, so that the largest of all is a lower bound of the distance, and for overlapping shapes exactly minus the
// depth, up to rounding. For triangles as slender as `regular` excludes the results are meaningless.
#pragma once

#include "narrow/pairs/box_box/reference_axis.hpp"
#include "simd/axis_permutation.hpp"
#include "simd/packed.hpp"

namespace graze {

/// Least height of a triangle, relative to its longest side; a lower one is left to the general path, since rounding
/// turns its normal by more than some tens of roundings.
inline constexpr double lowest_triangle = 1.0 / 32;

/// A vector for each of the triangle's corners, or of its edges, which begin at them.
template <class S>
using OfCorners = Vec3<Packed<S, 3>>;
template <class S>
Vec3<S> of_corner(const OfCorners<S>& v, int i) {
  return {v.x[i], v.y[i], v.z[i]};
}
/// One vector for all three corners.
template <class S>
OfCorners<S> for_corners(const Vec3<S>& v) {
  using Three = Packed<S, 3>;
  return {Three(v.x), Three(v.y), Three(v.z)};
}

/// A box and a triangle in the frame of the box.
template <class S>
struct BoxAndTriangle {
  using Three = Packed<S, 3>;

  Mat3<S> turn;  ///< rotation of the box in the world
  Vec3<S> half;
  OfCorners<S> point, before, edge;  ///< each corner, the preceding corner, and the edge to the next one
  S size_a, size_b;                  ///< radii about their own origins
  S noise;                           ///< rounding of the separation along an axis

  BoxAndTriangle(const BoxCore<S>& box, const Pose<S>& pose_a, const TriangleCore<S>& triangle, const Pose<S>& pose_b)
      : turn(rotation_of(pose_a.rotation)), half(box.half) {
    using std::sqrt;
    const RelativeFrame<S> b_in_a = relative_frame(pose_a, turn, pose_b);
    const Vec3<S>&a = triangle.point[0], &b = triangle.point[1], &c = triangle.point[2];
    const OfCorners<S> corner{Three(a.x, b.x, c.x), Three(a.y, b.y, c.y), Three(a.z, b.z, c.z)};
    const Mat3<Three> rotation{{for_corners(b_in_a.rotation.row[0]), for_corners(b_in_a.rotation.row[1]),
                                for_corners(b_in_a.rotation.row[2])}};
    // Differences of corners keep their digits wherever the triangle lies in its own frame.
    edge = rotation * OfCorners<S>{Three(b.x - a.x, c.x - b.x, a.x - c.x), Three(b.y - a.y, c.y - b.y, a.y - c.y),
                                   Three(b.z - a.z, c.z - b.z, a.z - c.z)};
    point = rotation * corner + for_corners(b_in_a.translation);
    const auto last_first = [](const Three& v) { return Three(v[2], v[0], v[1]); };
    before = {last_first(point.x), last_first(point.y), last_first(point.z)};
    size_a = length(half);
    size_b = sqrt(largest(length_squared(corner)));
    noise = S(box_rounding<typename LaneOf<S>::type>) * (greatest(size_a, size_b) + max_abs(b_in_a.translation));
  }
  static S largest(const Three& v) { return greatest(v[0], greatest(v[1], v[2])); }
};

/// The directions of a triangle.
template <class S>
struct TriangleDirections {
  OfCorners<S> along;             ///< unit vectors along its edges
  Vec3<S> normal;                 ///< unit, on the front side
  decltype(S() < S()) regular{};  ///< not a sliver, and of lengths within the bounds of `regular_box`

  TriangleDirections() = default;
  explicit TriangleDirections(const BoxAndTriangle<S>& p) {
    using T = typename LaneOf<S>::type;
    using Three = Packed<S, 3>;
    using std::sqrt;
    constexpr T lowest = static_cast<T>(lowest_triangle * lowest_triangle);
    const S least_square(std::numeric_limits<T>::min());
    const Three squared = length_squared(p.edge);
    const Vec3<S> area = cross(of_corner(p.edge, 0), of_corner(p.edge, 1));
    const S longest = p.largest(squared), area_squared = length_squared(area);
    regular = regular_box(Vec3<S>{sqrt(longest), p.size_b, p.size_b}) & (area_squared > longest * longest * S(lowest));
    along = p.edge * (Three(S(1)) / sqrt(greatest(squared, Three(least_square))));
    normal = area * (S(1) / sqrt(greatest(area_squared, least_square)));
  }
};

/// The axis along which contacts are found.
template <class S>
struct TriangleReferenceAxis {
  S distance;      ///< signed distance; a lower bound where it exceeds the margin; minus infinity for a sliver
  Vec3<S> normal;  ///< unit, from the box to the triangle, in the frame of the box
};

namespace detail {

/// The best of the axes tested so far.
template <class S>
struct BestAxis {
  S separation;
  Vec3<S> normal;  ///< unit, from the box to the triangle

  void keep(const S& other, const Vec3<S>& other_normal) {
    const auto better = other > separation;
    separation = select(better, other, separation);
    normal = select(better, other_normal, normal);
  }
};

/// The best of the box's own axes.
template <class S>
BestAxis<S> box_side_axes(const BoxAndTriangle<S>& p) {
  BestAxis<S> best{S(-std::numeric_limits<typename LaneOf<S>::type>::infinity()), {S(0), S(0), S(0)}};
  for (std::size_t i = 0; i < 3; ++i) {
    const S a = p.point[i][0], b = p.point[i][1], c = p.point[i][2];
    const S above = least(a, least(b, c)) - p.half[i], below = -greatest(a, greatest(b, c)) - p.half[i];
    Vec3<S> toward{S(0), S(0), S(0)};
    toward[i] = select(above > below, S(1), S(-1));
    best.keep(greatest(above, below), toward);
  }
  return best;
}

/// The best of the triangle's normal, the normals of its sides, and `best`.
template <class S>
BestAxis<S> triangle_side_axes(const BoxAndTriangle<S>& p, const TriangleDirections<S>& d, BestAxis<S> best) {
  using std::abs;
  using Three = Packed<S, 3>;
  const S offset = dot(d.normal, of_corner(p.point, 0));
  best.keep(abs(offset) - dot(graze::abs(d.normal), p.half), select(offset > S(0), d.normal, -d.normal));
  const OfCorners<S> inward = -cross(d.along, for_corners(d.normal));
  const Three separations = dot(inward, p.point) - dot(graze::abs(inward), for_corners(p.half));
  if (!any(separations > Three(best.separation))) return best;
  for (int i = 0; i < 3; ++i) best.keep(separations[i], of_corner(inward, i));
  return best;
}

/// The best product of a box's edge with one of the triangle's, if it is better than `face`; else minus infinity.
template <class S>
BestAxis<S> edge_axes(const BoxAndTriangle<S>& p, const TriangleDirections<S>& d, const S& face) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  using Three = Packed<S, 3>;
  // Separations are compared by their signed squares, a product each in place of a root. Axes are numbered 3 i + j for
  // the box's i-th edge and the triangle's j-th.
  const Three parallel(S(parallel_edges<S>)), least_square(face * abs(face));
  S gap(-std::numeric_limits<T>::infinity()), squared(1), number(0), toward(1);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t u = i == 2 ? 0 : i + 1, v = i == 0 ? 2 : i - 1;
    // The product projects its whole edge to one point, so that the triangle has only two projections.
    const Three n_u = -d.along[v], n_v = d.along[u];
    const Three one = n_u * p.point[u] + n_v * p.point[v], other = n_u * p.before[u] + n_v * p.before[v],
                reach = abs(n_u) * Three(p.half[u]) + abs(n_v) * Three(p.half[v]);
    const Three above = least(one, other) - reach, below = -greatest(one, other) - reach,
                apart = greatest(above, below), lengths = n_u * n_u + n_v * n_v, squares = apart * abs(apart);
    const auto promising = (lengths > parallel) & (squares > least_square * lengths);
    if (!any(promising)) continue;
    const auto upper = above > below;
    for (int j = 0; j < 3; ++j) {
      const auto better = promising[j] & (squares[j] * squared > gap * lengths[j]);
      gap = select(better, squares[j], gap);
      squared = select(better, lengths[j], squared);
      number = select(better, S(static_cast<T>(3 * static_cast<int>(i) + j)), number);
      toward = select(better, select(upper[j], S(1), S(-1)), toward);
    }
  }
  using Mask = decltype(S() < S());
  const Mask first = number < S(3), second = (!first) & (number < S(6));
  const S j = number - select(first, S(0), select(second, S(3), S(6))), scale = toward / sqrt(squared);
  const Vec3<S> f =
      select(j == S(0), of_corner(d.along, 0), select(j == S(1), of_corner(d.along, 1), of_corner(d.along, 2)));
  const Vec3<S> product = cross(AxisPermutation<S>::of(first, second), f);
  const S separation = sqrt(abs(gap) / squared);
  return {select(gap < S(0), -separation, separation), product * scale};
}

}  // namespace detail

/// The reference axis for contacts up to `margin` apart. A face is preferred to an edge that is better by less than
/// `face_preference`. The triangle's directions are found only where the box's own axes do not decide.
template <class S>
TriangleReferenceAxis<S> triangle_reference_axis(const BoxAndTriangle<S>& p, const S& margin,
                                                 TriangleDirections<S>& directions) {
  using T = typename LaneOf<S>::type;
  const S infinity(std::numeric_limits<T>::infinity()), enough = margin + p.noise;
  const detail::BestAxis<S> of_box = detail::box_side_axes(p);
  // No further axis needs a test where a face separates the two by more than the margin.
  const auto by_box = of_box.separation > enough;
  if (all(by_box)) return {of_box.separation, of_box.normal};
  directions = TriangleDirections<S>(p);
  const detail::BestAxis<S> of_both = detail::triangle_side_axes(p, directions, of_box),
                            face{select(by_box, of_box.separation, of_both.separation),
                                 select(by_box, of_box.normal, of_both.normal)};
  const auto by_face = face.separation > enough;
  detail::BestAxis<S> edge{-infinity, face.normal};
  if (!all(by_face)) edge = detail::edge_axes(p, directions, face.separation);
  edge.separation = select(by_face, -infinity, edge.separation);

  const AxisChoice<S> choice = choose_axis(face.separation, edge.separation, p.noise, least(p.size_a, p.size_b));
  const S distance = choice.distance(p.noise);
  const auto by_edge = choice.by_edge(distance > margin);
  return {select(by_box | directions.regular, distance, -infinity), select(by_edge, edge.normal, face.normal)};
}

}  // namespace graze
