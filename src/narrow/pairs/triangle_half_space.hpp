// A triangle on a half-space: the corners of its support face, each with its own height, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The distance is that of `distance`, bit for bit, and the
// lowest point's; the face is the one that `Triangle::core_face` gives up to `side_lean`, up to rounding of its lean,
// with its vertices in that order. There are points exactly where the distance is within the margin.
#pragma once

#include "narrow/pairs/box_box/reference_axis.hpp"
#include "narrow/pairs/half_space_distance.hpp"
#include "narrow/pairs/half_space_slots.hpp"

namespace graze {

namespace detail {

/// The support face of a triangle, downward, by its corners' numbers: all three, the two of an edge, or one.
template <class S>
struct LowFace {
  using Mask = decltype(S() < S());

  Mask whole, edge;  ///< all three corners, or at least two
  S number[3];

  /// `down`: unit. The first of equally low corners counts.
  LowFace(const TriangleCore<S>& triangle, const Vec3<S>& down) {
    const auto& p = triangle.point;
    const S zero(0), one(1), two(2), lean(side_lean<typename LaneOf<S>::type>);
    const auto direction = [](const Vec3<S>& v) { return direction_of(v, length(v)); };
    const Vec3<S> along[3] = {direction(p[1] - p[0]), direction(p[2] - p[1]), direction(p[0] - p[2])};
    // A product of unit edges: neither the normal nor its length depends on the size of the triangle.
    const Vec3<S> normal = cross(along[0], along[1]);
    const S squared = length_squared(normal);
    whole = (squared > zero) & (length_squared(cross(down, normal)) <= lean * lean * squared);
    const Mask front = dot(down, normal) > zero;

    const S low[3] = {dot(p[0], down), dot(p[1], down), dot(p[2], down)};
    const auto second = low[1] > low[0];
    const auto third = low[2] > select(second, low[1], low[0]);
    const S top = select(third, two, select(second, one, zero));
    const AxisPermutation<S> at(top);
    // Slopes of the edges from there; the flatter one counts, below which the other may lie.
    const S rise[3] = {dot(along[0], down), dot(along[1], down), dot(along[2], down)};
    const S to_next = -at.pick(rise[0], rise[1], rise[2]), to_last = at.pick(rise[2], rise[0], rise[1]);
    const auto last_flatter = to_last < to_next;
    const S other = select(last_flatter, at.pick(two, zero, one), at.pick(one, two, zero));
    edge = whole | (select(last_flatter, to_last, to_next) <= lean);

    number[0] = select(whole, select(front, zero, two), select(edge, least(top, other), top));
    number[1] = select(whole, one, greatest(top, other));
    number[2] = select(front, two, zero);
  }
};

}  // namespace detail

/// The contacts of a triangle without rounding. `plane` is the height of the half-space's surface in its own frame;
/// points are found up to `margin` above it.
template <class S>
Rest<S> rest(const Rounded<TriangleCore<S>, S>& triangle, const Pose<S>& pose, const S& plane,
             const Pose<S>& plane_pose, const S& margin) {
  using T = typename LaneOf<S>::type;
  const auto& p = triangle.core.point;
  const S zero(0), one(1);
  const Vec3<S> plane_up{zero, one, zero};
  const Pose<S> seen = relative(plane_pose, pose);
  const Vec3<S> down = rotate(conjugate(seen.rotation), -plane_up), lowest = furthest_along(triangle.core, down);
  const detail::LowFace<S> face(triangle.core, down);

  Rest<S> found;
  found.distance = transform(seen, lowest).y - plane;
  found.up = rotate(plane_pose.rotation, plane_up);
  // Corners level with the lowest up to rounding are kept with it, so that a face that touches touches whole. No corner
  // is further from the origin than twice its largest coordinate.
  const S size = greatest(max_abs(p[0]), greatest(max_abs(p[1]), max_abs(p[2]))),
          noise = S(T(2) * box_rounding<T>) * (size + max_abs(seen.translation)),
          limit = greatest(margin, found.distance + noise), lowest_along = dot(down, lowest);
  const auto near = found.distance <= margin;
  // NOLINTNEXTLINE(misc-redundant-expression): true in every lane
  const decltype(S() < S()) is[] = {zero == zero, face.edge, face.whole};
  found.filled = zero;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S> corner = AxisPermutation<S>(face.number[i]).pick(p[0], p[1], p[2]);
    auto& slot = found.slots[i];
    slot.distance = found.distance + (lowest_along - dot(down, corner));
    slot.of_body = transform(pose, corner);
    slot.of_plane = slot.of_body - found.up * slot.distance;
    slot.corner = face.number[i];
    found.filled = found.filled + select(near & is[i] & (slot.distance <= limit), S(T(1 << i)), zero);
  }
  return found;
}

}  // namespace graze
