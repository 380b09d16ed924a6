// Box against box: the signed distance with its two witness points, across lanes.
//
// Guarantee: where `proven` is set, the distance is right up to rounding, whether the boxes overlap or not: no
// direction separates them by more, and the two points, which lie on the boxes, are no further apart. In every lane the
// bits that the pair gives alone.
//
// The nearest points of two disjoint convex polyhedra are a vertex and the point nearest to it, or lie within two edges
// that cross (Mirtich 1998, "V-Clip: fast and robust polyhedral collision detection", section 2). In the second case
// the separation along the edges' common normal is the whole distance, which no other axis exceeds. So the best of the
// fifteen axes and the sixteen corners suffice. Each answer proves itself: its points are as far apart as the boxes are
// along its normal. For overlapping boxes the best axis gives the depth. Moved apart along it they have the same
// nearest points.
#pragma once

#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "narrow/pairs/box_box/reference_axis.hpp"
#include "simd/axis_permutation.hpp"
#include "simd/flatten.hpp"

namespace graze {

/// The witness points of two boxes and their signed distance, in the frame of A.
template <class S>
struct BoxNearest {
  using Mask = decltype(S() < S());
  CoreDistance<S> core;
  Mask proven;

  /// Takes the answer of `next` where it is proven and this one is not.
  void otherwise(const BoxNearest& next) {
    const Mask take = next.proven & (!proven);
    core = select(take, next.core, core);
    proven = proven | take;
  }
};

/// Roundings of a coordinate by which a witness point may miss the box that it lies on: fewer than `laid_slack`.
inline constexpr double witness_slack = 16;

namespace detail {

/// Two boxes as they meet along an axis, seen from the reference box: the one whose face is a rectangle then.
template <class S>
struct MeetingBoxes {
  using Mask = decltype(S() < S());

  Mask by_b;         ///< the reference box is B
  Vec3<S> normal;    ///< from the reference box to the other; for a face exactly one of its axes
  BoxPair<S> boxes;  ///< the pair with the reference box as A

  MeetingBoxes(const BoxPair<S>& p, const S& axis) {
    const S zero(0), one(1);
    const Mask of_edges = axis >= S(6);
    by_b = (axis >= S(3)) & (!of_edges);
    const AxisPermutation<S> face(select(of_edges, zero, axis - select(by_b, S(3), zero)));
    const Vec3<S> unit = face.unit();
    const S side = dot(p.translation, either(
                                          by_b, [&] { return face.pick(p.rotation); }, [&] { return unit; })),
            toward = select(side < zero, S(-1), one);
    normal = unit * select(by_b, -toward, toward);
    if (any(of_edges)) normal = select(of_edges, of_product(p, axis - S(6)), normal);
    boxes = either(
        by_b, [&] { return seen_from_b(p); }, [&] { return p; });
  }

 private:
  /// The unit vector of the product of A's i-th axis with B's j-th, from A to B, by the number 3 i + j.
  static Vec3<S> of_product(const BoxPair<S>& p, const S& number) {
    using std::sqrt;
    const S zero(0), first = select(number < S(3), zero, select(number < S(6), S(1), S(2)));
    const Vec3<S> along = AxisPermutation<S>(number - first * S(3)).pick(p.rotation);
    const Vec3<S> product = cross(AxisPermutation<S>(first), along);
    const S scale = S(1) / sqrt(length_squared(product));
    return product * (scale * select(dot(p.translation, product) < zero, S(-1), S(1)));
  }
};

/// The corner of a box that lies furthest along a direction, both in the box's frame.
template <class S>
Vec3<S> corner_along(const Vec3<S>& half, const Vec3<S>& direction) {
  const auto side = [](const S& h, const S& d) { return select(d < S(0), -h, h); };
  return {side(half.x, direction.x), side(half.y, direction.y), side(half.z, direction.z)};
}

template <class S>
auto inside_box(const Vec3<S>& half, const Vec3<S>& p, const S& slack) {
  const Vec3<S> a = abs(p);
  return (a.x <= half.x + slack) & (a.y <= half.y + slack) & (a.z <= half.z + slack);
}

/// An answer in the frame of B, from B to A, as one in the frame of A, from A to B.
template <class S>
CoreDistance<S> seen_from_a(const BoxPair<S>& p, const CoreDistance<S>& d) {
  return {d.distance, -(p.rotation * d.normal), p.rotation * d.b + p.translation, p.rotation * d.a + p.translation};
}

}  // namespace detail

/// The points in which the boxes meet along one axis of known separation: a corner over a face, or two edges.
template <class S>
BoxNearest<S> along_axis(const BoxPair<S>& p, const S& axis, const S& separation, const S& slack) {
  using namespace detail;
  using std::abs;
  using Mask = decltype(S() < S());
  const MeetingBoxes<S> m(p, axis);
  const Vec3<S>& n = m.normal;
  const Mask of_edges = axis >= S(6);
  const S first = select(axis < S(9), S(0), select(axis < S(12), S(1), S(2)));
  // Meaningless for an axis of a face.
  const AxisPermutation<S> i(first), j(select(of_edges, axis - S(6) - first * S(3), S(0)));
  Vec3<S> reach = corner_along(m.boxes.half_b, -transposed_times(m.boxes.rotation, n));
  if (any(of_edges)) reach = select(of_edges, j.without(reach), reach);
  Vec3<S> other = m.boxes.translation + m.boxes.rotation * reach, on = other - n * separation;
  Mask met = separation == separation;
  if (any(of_edges)) {
    // The nearest points of the two lines; the squared sine from the product, which keeps its digits.
    const Vec3<S> middle = i.without(corner_along(m.boxes.half_a, n)), between = other - middle,
                  along = j.pick(m.boxes.rotation), across = i.without(along);
    const S cosine = i.pick(along), by_i = i.pick(between), by_j = dot(between, along),
            scale = S(1) / select(of_edges, length_squared(across), S(1));
    const S s = (by_i - cosine * by_j) * scale, t = (cosine * by_i - by_j) * scale;
    const Vec3<S> a = middle + i.unit() * s, b = other + along * t;
    const Mask meets =
        (abs(t) <= j.pick(m.boxes.half_b) + slack) & (length_squared(b - a - n * separation) <= slack * slack);
    met = meets | (!of_edges);
    on = select(of_edges, a, on);
    other = select(of_edges, b, other);
  }
  met = met & inside_box(m.boxes.half_a, on, slack);
  const CoreDistance<S> core{separation, n, on, other};
  return {select(m.by_b, seen_from_a(p, core), core), met};
}

namespace detail {

/// The offset of a point beyond the faces of a box, by axis: zero along axes between whose two faces it lies.
template <class S>
Vec3<S> beyond(const Vec3<S>& half, const Vec3<S>& point) {
  const auto past = [](const S& h, const S& x) { return greatest(x - h, S(0)) + least(x + h, S(0)); };
  return {past(half.x, point.x), past(half.y, point.y), past(half.z, point.z)};
}

/// The distance by the corner of B that is nearest to A, for disjoint boxes.
template <class S>
BoxNearest<S> at_corner_of_b(const BoxPair<S>& p, const S& slack) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  const Vec3<S> x = p.rotation.column(0) * p.half_b.x, y = p.rotation.column(1) * p.half_b.y,
                z = p.rotation.column(2) * p.half_b.z;
  S squared(std::numeric_limits<T>::infinity()), number(0);
  for (int k = 0; k < 8; ++k) {
    const Vec3<S> at_x = k & 1 ? p.translation + x : p.translation - x, at_xy = k & 2 ? at_x + y : at_x - y;
    // Twice the offset beyond the faces, without a comparison, which for a single pair would be an unpredictable
    // branch.
    const Vec3<S> past = abs(k & 4 ? at_xy + z : at_xy - z) - p.half_a;
    const S s = length_squared(past + abs(past));
    number = select(s < squared, S(T(k)), number);
    squared = least(squared, s);
  }
  squared = squared * S(T(0.25));
  const auto at_z = number >= S(4);
  const S rest = number - select(at_z, S(4), S(0));
  const auto at_y = rest >= S(2), at_x = rest - select(at_y, S(2), S(0)) >= S(1);
  const Vec3<S> corner = p.translation + select(at_x, x, -x) + select(at_y, y, -y) + select(at_z, z, -z),
                gap = beyond(p.half_a, corner);
  const S distance = sqrt(squared), scale = S(1) / select(squared > S(0), distance, S(1));
  // Along the gap no point of A is further out than the one it begins at. Other corners of B that reach further in are
  // what the proof lacks.
  const S missing = dot(corner - p.translation, gap) + dot(abs(transposed_times(p.rotation, gap)), p.half_b);
  const decltype(S() < S()) proven = (squared > S(0)) & (missing <= slack * distance);
  return {{distance, gap * scale, corner - gap, corner}, proven};
}

/// The distance by the corner of either box that is nearest to the other one. Of two corners that are equally near up
/// to rounding, one may prove the distance and the other not.
template <class S>
BoxNearest<S> at_corner(const BoxPair<S>& p, const S& slack) {
  BoxNearest<S> nearest = at_corner_of_b(p, slack);
  if (all(nearest.proven)) return nearest;
  BoxNearest<S> of_a = at_corner_of_b(seen_from_b(p), slack);
  of_a.core = seen_from_a(p, of_a.core);
  nearest.otherwise(of_a);
  return nearest;
}

/// The distance at a point where the rim of a face crosses that of the face it meets along a face's axis: decides where
/// the two are parallel and no corner of either lies over the other. `separation` is that along the axis.
template <class S>
BoxNearest<S> at_crossing(const BoxPair<S>& p, const S& axis, const S& separation, const S& slack) {
  using T = typename LaneOf<S>::type;
  const MeetingBoxes<S> m(p, axis);
  const Vec3<S>&n = m.normal,
        c[3] = {m.boxes.rotation.column(0), m.boxes.rotation.column(1), m.boxes.rotation.column(2)};
  const Vec3<S> lean{dot(n, c[0]), dot(n, c[1]), dot(n, c[2])};
  const auto face = AxisPermutation<S>::longest(lean);
  const Vec3<S> half = face.turned(m.boxes.half_b), u = face.pick(c[1], c[2], c[0]) * half.x,
                v = face.pick(c[2], c[0], c[1]) * half.y,
                middle =
                    m.boxes.translation - face.pick(c[0], c[1], c[2]) * select(face.pick(lean) < S(0), -half.z, half.z);
  // Across the reference face the region has no end.
  const S infinity(std::numeric_limits<T>::infinity()), vanishing = slack * S(epsilon<S>);
  Vec3<S> reach;
  for (std::size_t k = 0; k < 3; ++k) reach[k] = select(n[k] == S(0), m.boxes.half_a[k], infinity);
  const S height = dot(abs(n), m.boxes.half_a);
  S nearest = infinity;
  Vec3<S> other = middle;
  const auto clip = [&](const Vec3<S>& along, const Vec3<S>& across) {
    using std::abs;
    Vec3<S> inverse;
    for (std::size_t k = 0; k < 3; ++k) inverse[k] = S(1) / select(abs(along[k]) > vanishing, along[k], vanishing);
    const auto rising = dot(n, along) > S(0);
    const auto side = [&](const Vec3<S>& from) {
      S low(-1), high(1);
      for (std::size_t k = 0; k < 3; ++k) {
        const S at = -(from[k] * inverse[k]), wide = reach[k] * abs(inverse[k]);
        low = greatest(low, at - wide);
        high = least(high, at + wide);
      }
      const Vec3<S> deepest = from + along * select(rising, low, high);
      const S apart = dot(n, deepest) - height;
      const auto nearer = (low <= high) & (apart < nearest);
      nearest = select(nearer, apart, nearest);
      other = select(nearer, deepest, other);
    };
    side(middle - across);
    side(middle + across);
  };
  clip(u, v);
  clip(v, u);
  const decltype(S() < S()) proven = (axis < S(6)) & (nearest <= separation + slack);
  const CoreDistance<S> core{separation, n, other - n * nearest, other};
  return {select(m.by_b, seen_from_a(p, core), core), proven};
}

}  // namespace detail

/// The distance by all fifteen axes, and by the corners where these do not prove it. `noise`: rounding of a coordinate.
template <class S>
BoxNearest<S> nearest_of_boxes(const BoxPair<S>& p, const S& noise) {
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S slack = noise * S(T(witness_slack));
  const BoxRows<S> rows(p);
  const auto [face, face_number] = best_face(rows);
  const Mask apart = face > noise;
  BoxNearest<S> nearest{};
  if (any(apart)) {
    nearest = detail::at_corner(p, slack);
    nearest.proven = nearest.proven & apart;
    if (all(nearest.proven)) return nearest;
  }
  S edge_number(6);
  const S edge = best_edges(rows, face + noise, edge_number);
  const Mask by_edge = edge > face + noise;
  const S axis = select(by_edge, edge_number, face_number), separation = select(by_edge, edge, face);
  const BoxNearest<S> along = along_axis(p, axis, separation, slack);
  nearest.otherwise(along);
  if (all(nearest.proven)) return nearest;
  // Overlapping boxes with parallel features are moved apart, far enough that the gap has all its digits.
  const S moved = select(separation > noise, S(0), max_abs(p.half_a) + max_abs(p.half_b) - separation);
  const Vec3<S> away = along.core.normal * moved;
  BoxPair<S> moved_apart = p;
  moved_apart.translation += away;
  BoxNearest<S> corner = detail::at_corner(moved_apart, slack);
  corner.core.distance -= moved;
  corner.core.b -= away;
  // After the move, a corner that hangs over a rim by less than the square root of a rounding is as near as the face.
  // Moved back, it lies off the normal by as much.
  const CoreDistance<S>& core = corner.core;
  const Vec3<S> beside = core.b - core.a - core.normal * core.distance;
  corner.proven = corner.proven & (length_squared(beside) <= slack * slack);
  nearest.otherwise(corner);
  if (all(nearest.proven)) return nearest;
  nearest.otherwise(detail::at_crossing(p, axis, separation, slack));
  return nearest;
}

/// A box in place, rounded or not. It may have zero length along some axes: a capsule is a box with a length along one.
template <class S>
struct PlacedBox {
  Vec3<S> half;
  S radius;
  Pose<S> pose;
};
template <class S>
PlacedBox<S> placed_box(const Rounded<BoxCore<S>, S>& box, const Pose<S>& pose) {
  return {box.core.half, box.radius, pose};
}
template <class S>
PlacedBox<S> placed_box(const Rounded<AxisCore<S>, S>& capsule, const Pose<S>& pose) {
  return {{S(0), capsule.core.half_height, S(0)}, capsule.radius, pose};
}
template <class S, class T>
PlacedBox<S> converted(const PlacedBox<T>& box) {
  return {converted<S>(box.half), static_cast<S>(box.radius), converted<S>(box.pose)};
}

/// The signed distance of two boxes in place, and whether it is proven.
template <class S>
struct BoxDistance {
  Distance<S> at;
  decltype(S() < S()) proven;
};

/// One function: numbers stay in registers, which saves a sixth of its time.
template <class S>
GRAZE_FLATTEN BoxDistance<S> box_distance(const PlacedBox<S>& a, const PlacedBox<S>& b) {
  using std::abs;
  using T = typename LaneOf<S>::type;
  const BoxPair<S> p = box_pair(a.half, a.pose, b.half, b.pose);
  const S noise = box_noise(p, length(a.half) + a.radius, length(b.half) + b.radius), radii = a.radius + b.radius;
  const BoxNearest<S> nearest = nearest_of_boxes(p, noise);
  const CoreDistance<S>& core = nearest.core;
  // A gap within rounding counts as touching. Half of the distance goes to each side of the middle of the two points,
  // so that b - a = distance * normal to the last bits.
  const S distance = select(abs(core.distance - radii) <= noise, radii, core.distance), half = distance * S(T(0.5));
  const Vec3<S> middle = (core.a + core.b) * S(T(0.5));
  const Mat3<S> turn = rotation_of(a.pose.rotation);
  BoxDistance<S> found;
  found.at.distance = distance - radii;
  found.at.normal = turn * core.normal;
  found.at.a = a.pose.translation + turn * (middle + core.normal * (a.radius - half));
  found.at.b = a.pose.translation + turn * (middle + core.normal * (half - b.radius));
  const S size = greatest(greatest(max_abs(a.half), max_abs(b.half)), max_abs(p.translation));
  found.proven = nearest.proven & (size > S(smallest_length<T>)) & (size < S(largest_length<T>));
  return found;
}

}  // namespace graze
