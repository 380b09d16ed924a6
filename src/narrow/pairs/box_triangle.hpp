// Box against triangle: the axis that contacts stand on, of three of the box, the triangle's normal and those of its sides
// in its plane, and the nine products of their edges (Akenine-Möller 2001, "Fast 3D triangle-box overlap testing",
// Journal of Graphics Tools); across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The separation along an axis is that of the two's
// intervals, so that the largest of all is a lower bound of the distance, and of those that overlap exactly minus the
// depth, up to rounding. What a triangle as slender as `regular` excludes gives means nothing.
#pragma once

#include "narrow/pairs/box_choice.hpp"

namespace graze {

/// A triangle lower than this part of its longest side is left to the general path: of a lower one rounding turns the
/// normal by more than some tens of roundings.
inline constexpr double lowest_triangle = 1.0 / 32;

/// A box and a triangle in the frame of the box.
template <class S>
struct BoxAndTriangle {
  Mat3<S> turn;  ///< of the box in the world
  Vec3<S> half;
  Vec3<S> point[3], edge[3];  ///< from each point to the next
  S size_a, size_b;           ///< about their own origins
  S noise;                    ///< what rounding may do to the separation along an axis

  BoxAndTriangle(const BoxCore<S>& box, const Pose<S>& pose_a, const TriangleCore<S>& triangle, const Pose<S>& pose_b)
      : turn(rotation_of(pose_a.rotation)), half(box.half) {
    const RelativeFrame<S> b_in_a = relative_frame(pose_a, turn, pose_b);
    const auto& corner = triangle.point;
    // Differences of corners keep their digits wherever the triangle lies in its own frame.
    for (std::size_t i = 0; i < 3; ++i) edge[i] = b_in_a.rotation * (corner[i == 2 ? 0 : i + 1] - corner[i]);
    point[0] = b_in_a.rotation * corner[0] + b_in_a.translation;
    point[1] = point[0] + edge[0];
    point[2] = point[0] - edge[2];
    using std::sqrt;
    size_a = length(half);
    size_b = sqrt(greatest(length_squared(corner[0]), greatest(length_squared(corner[1]), length_squared(corner[2]))));
    noise = S(box_rounding<typename LaneOf<S>::type>) * (greatest(size_a, size_b) + max_abs(b_in_a.translation));
  }
};

/// The directions of a triangle.
template <class S>
struct TriangleDirections {
  Vec3<S> along[3], normal;       ///< unit, of its edges and out of its front
  decltype(S() < S()) regular{};  ///< of no sliver, and of lengths as those of `regular_box`

  TriangleDirections() = default;
  explicit TriangleDirections(const BoxAndTriangle<S>& p) {
    using T = typename LaneOf<S>::type;
    using std::sqrt;
    constexpr T lowest = static_cast<T>(lowest_triangle * lowest_triangle);
    S longest(0), squared[3];
    for (std::size_t i = 0; i < 3; ++i) {
      squared[i] = length_squared(p.edge[i]);
      longest = greatest(longest, squared[i]);
    }
    const Vec3<S> area = cross(p.edge[0], p.edge[1]);
    const S area_squared = length_squared(area);
    regular = regular_box(Vec3<S>{sqrt(longest), p.size_b, p.size_b}) & (area_squared > longest * longest * S(lowest));
    const auto inverse = [&](const S& square) { return S(1) / sqrt(select(regular, square, S(1))); };
    for (std::size_t i = 0; i < 3; ++i) along[i] = p.edge[i] * inverse(squared[i]);
    normal = area * inverse(area_squared);
  }
};

/// The axis that contacts stand on.
template <class S>
struct TriangleChoice {
  S distance;      ///< signed; where it is more than the margin, a lower bound; minus infinity of a sliver
  Vec3<S> normal;  ///< unit, from the box to the triangle, in the frame of the box
};

namespace detail {

/// The best axis of those tried so far.
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

/// The box's own axes.
template <class S>
BestAxis<S> box_side_axes(const BoxAndTriangle<S>& p) {
  BestAxis<S> best{S(-std::numeric_limits<typename LaneOf<S>::type>::infinity()), {S(0), S(0), S(0)}};
  for (std::size_t i = 0; i < 3; ++i) {
    const S &a = p.point[0][i], &b = p.point[1][i], &c = p.point[2][i];
    const S above = least(a, least(b, c)) - p.half[i], below = -greatest(a, greatest(b, c)) - p.half[i];
    Vec3<S> toward{S(0), S(0), S(0)};
    toward[i] = select(above > below, S(1), S(-1));
    best.keep(greatest(above, below), toward);
  }
  return best;
}

/// The triangle's normal and those of its sides, where they are better than `best`.
template <class S>
BestAxis<S> triangle_side_axes(const BoxAndTriangle<S>& p, const TriangleDirections<S>& d, BestAxis<S> best) {
  using std::abs;
  const S offset = dot(d.normal, p.point[0]);
  best.keep(abs(offset) - dot(graze::abs(d.normal), p.half), select(offset > S(0), d.normal, -d.normal));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S> outward = cross(d.along[i], d.normal);
    best.keep(-dot(outward, p.point[i]) - dot(graze::abs(outward), p.half), -outward);
  }
  return best;
}

/// The products of the box's edges with the triangle's.
template <class S>
BestAxis<S> edge_axes(const BoxAndTriangle<S>& p, const TriangleDirections<S>& d) {
  using std::abs, std::sqrt;
  using T = typename LaneOf<S>::type;
  // Separations are compared by their squares with their signs, a product each in place of a root. Axes are numbered 3 j + i
  // for the triangle's j-th edge and the box's i-th.
  S gap(-std::numeric_limits<T>::infinity()), squared(1), number(0), toward(1);
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3<S>&f = d.along[j], &on = p.point[j], &off = p.point[j == 0 ? 2 : j - 1];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t u = i == 2 ? 0 : i + 1, v = i == 0 ? 2 : i - 1;
      // The product of the box's i-th edge with f. The whole edge is one place along it: the triangle has but two.
      const S n_u = -f[v], n_v = f[u];
      const S one = n_u * on[u] + n_v * on[v], other = n_u * off[u] + n_v * off[v],
              reach = abs(n_u) * p.half[u] + abs(n_v) * p.half[v];
      const S above = least(one, other) - reach, below = -greatest(one, other) - reach, apart = greatest(above, below),
              length = n_u * n_u + n_v * n_v, signed_square = apart * abs(apart);
      const auto better = (length > S(parallel_edges<S>)) & (signed_square * squared > gap * length);
      gap = select(better, signed_square, gap);
      squared = select(better, length, squared);
      number = select(better, S(static_cast<T>(3 * j + i)), number);
      toward = select(better, select(above > below, S(1), S(-1)), toward);
    }
  }
  const auto first = number < S(3), second = (!first) & (number < S(6));
  const Vec3<S> f = select(first, d.along[0], select(second, d.along[1], d.along[2]));
  const S i = number - select(first, S(0), select(second, S(3), S(6))), scale = toward / sqrt(squared);
  const Vec3<S> product = select(i == S(0), Vec3<S>{S(0), -f.z, f.y},
                                 select(i == S(1), Vec3<S>{f.z, S(0), -f.x}, Vec3<S>{-f.y, f.x, S(0)}));
  const S separation = sqrt(abs(gap) / squared);
  return {select(gap < S(0), -separation, separation), product * scale};
}

}  // namespace detail

/// `margin` is up to where contacts are wanted. A face is taken before an edge that is hardly better. The triangle's
/// directions are found only where the box's own axes do not tell.
template <class S>
TriangleChoice<S> triangle_choice(const BoxAndTriangle<S>& p, const S& margin, TriangleDirections<S>& directions) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  const S infinity(std::numeric_limits<T>::infinity()), enough = margin + p.noise;
  const detail::BestAxis<S> of_box = detail::box_side_axes(p);
  // Where a face tells that they are further apart than anybody asks, no further axis need be tried.
  const auto by_box = of_box.separation > enough;
  if (all(by_box)) return {of_box.separation, of_box.normal};
  directions = TriangleDirections<S>(p);
  const detail::BestAxis<S> of_both = detail::triangle_side_axes(p, directions, of_box),
                            face{select(by_box, of_box.separation, of_both.separation),
                                 select(by_box, of_box.normal, of_both.normal)};
  const auto by_face = face.separation > enough;
  detail::BestAxis<S> edge{-infinity, face.normal};
  if (!all(by_face)) edge = detail::edge_axes(p, directions);
  edge.separation = select(by_face, -infinity, edge.separation);

  const S smaller = least(p.size_a, p.size_b);
  const auto edge_best = edge.separation > face.separation + p.noise,
             edge_chosen = edge.separation > face.separation + S(T(face_preference)) * smaller;
  const S separation = select(edge_best, edge.separation, face.separation);
  const S distance = select(abs(separation) <= p.noise, S(0), separation);
  const auto outside = distance > margin;
  const auto by_edge = (outside & edge_best) | ((!outside) & edge_chosen);
  return {select(by_box | directions.regular, distance, -infinity), select(by_edge, edge.normal, face.normal)};
}

}  // namespace graze
