// Box against triangle, the points of contact: the face of the box that meets it, and the triangle, its edge or its
// vertex laid over each other along a normal, across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone. The points are the corners of the area that the two
// share, as `lay_over` gives them, up to rounding; of a vertex it is the vertex. Where what is nearest lies nearer than
// these by more than `face_preference`, `known` says so.
#pragma once

#include "narrow/pairs/box_manifold.hpp"
#include "narrow/pairs/box_triangle.hpp"
#include "narrow/pairs/triangle_outline.hpp"
#include "narrow/pairs/triangle_parts.hpp"

namespace graze {

namespace detail {

/// What of the triangle meets the box along a normal, laid over the box's face.
template <class S>
struct TriangleFace {
  using Mask = decltype(S() < S());

  FlatVertex<S> vertex[3];  ///< the triangle, counter-clockwise; an edge is from the first to the second; or the first
  FlatSide<S> side[3];
  Mask whole, edge, front;
  FlatPoint<S> slope;  ///< how `apart` changes

  /// `n` and the triangle's `normal` and points are in the frame of the box's face, which lies across z at `height`.
  /// `fall` is the cosine between n and each edge.
  TriangleFace(const Vec3<S> (&point)[3], const Vec3<S>& normal, const Vec3<S>& n, const S& height, const Vec3<S>& fall,
               const S& rounding) {
    using std::abs;
    using T = typename LaneOf<S>::type;
    const S facing = -dot(normal, n), steep = S(1) / n.z;
    whole = abs(facing) >= S(T(furthest_lean));
    front = facing > S(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const S apart = (point[i].z - height) * steep;
      vertex[i] = {{point[i].x - n.x * apart, point[i].y - n.y * apart}, apart, S(static_cast<T>(i))};
    }
    edge = whole & (!whole);
    if (any(whole)) put_sides_in_order();
    if (!all(whole)) choose_edge({dot(point[0], n), dot(point[1], n), dot(point[2], n)}, fall);
    for (std::size_t i = 0; i < 3; ++i) side[i] = {vertex[i].at, vertex[i == 2 ? 0 : i + 1].at, rounding};

    const S per_facing = S(1) / select(whole, facing, S(1)), squared = side[0].length_squared(),
            rise = (vertex[1].apart - vertex[0].apart) / select(squared > S(0), squared, S(1));
    slope = {select(whole, normal.x * per_facing, side[0].along.x * rise),
             select(whole, normal.y * per_facing, side[0].along.y * rise)};
  }

  S apart_at(const FlatPoint<S>& p) const {
    return vertex[0].apart + (p.x - vertex[0].at.x) * slope.x + (p.y - vertex[0].at.y) * slope.y;
  }
  /// The outline of what it shares with the rectangle that it is laid over.
  Ring<S> over(const RectangleAndTriangle<S>& faces, const S& together) const {
    Corner<S> corners[most_box_points];
    faces.corners(corners, together);
    typename Ring<S>::All x, y, apart;
    Mask are[most_box_points];
    for (std::size_t i = 0; i < most_box_points; ++i) {
      x[i] = corners[i].at.x;
      y[i] = corners[i].at.y;
      apart[i] = apart_at(corners[i].at);
      are[i] = corners[i].is;
    }
    return {x, y, apart, are};
  }
  /// The square of the shortest side; infinite of a vertex.
  S shortest_squared() const {
    const S infinity(std::numeric_limits<typename LaneOf<S>::type>::infinity()),
        first = side[0].length_squared(), others = least(side[1].length_squared(), side[2].length_squared());
    return select(whole, least(first, others), select(edge, first, infinity));
  }
  /// What of the triangle a point on it lies on, within `near`, which is given squared.
  S part(const FlatPoint<S>& p, const S& near_squared) const {
    const auto edge_across = [&](std::size_t i) { return vertex[i].number + S(edge_part); };
    const auto on_end = [&](std::size_t i) { return distance_squared(p, vertex[i].at) <= near_squared; };
    const Mask first_end = (!edge) | on_end(0);
    const S of_edge = select(first_end, vertex[0].number, select(on_end(1), vertex[1].number, edge_across(2)));
    if (!any(whole)) return of_edge;
    const auto on_side = [&](std::size_t i) {
      const S inside = side[i].left_of(p);
      return (inside <= S(0)) | (inside * inside <= near_squared * side[i].length_squared());
    };
    const Mask on0 = on_side(0), on1 = on_side(1), on2 = on_side(2);
    const S face = select(front, S(front_part), S(back_part)),
            beside_0 = select(on1, vertex[1].number, select(on2, vertex[0].number, edge_across(2))),
            beside_1 = select(on2, vertex[2].number, edge_across(0));
    const S of_triangle = select(on0, beside_0, select(on1, beside_1, select(on2, edge_across(1), face)));
    return select(whole, of_triangle, of_edge);
  }

 private:
  /// Counter-clockwise, and the side of the smallest angle first: the one in the first half turn that follows one in
  /// the second.
  void put_sides_in_order() {
    const Mask clockwise = whole & (cross(vertex[0].at, vertex[1].at, vertex[2].at) < S(0));
    const FlatVertex<S> b = vertex[1], c = vertex[2];
    vertex[1] = select(clockwise, c, b);
    vertex[2] = select(clockwise, b, c);
    Mask second_half[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const FlatPoint<S>&from = vertex[i].at, &to = vertex[i == 2 ? 0 : i + 1].at;
      second_half[i] = in_second_half(FlatPoint<S>{to.x - from.x, to.y - from.y});
    }
    begin_with(whole & second_half[0] & (!second_half[1]), whole & second_half[1] & (!second_half[2]), vertex);
  }

  /// Seen from the side, of the two edges at the vertex nearest to the box the one that falls off least; if both fall
  /// off more than a face may lean, the vertex.
  void choose_edge(const Vec3<S>& far, const Vec3<S>& fall) {
    using T = typename LaneOf<S>::type;
    const Mask seen = !whole, top0 = (far.x <= far.y) & (far.x <= far.z), top1 = (!top0) & (far.y <= far.z),
               top2 = !(top0 | top1);
    const auto top = OneOfThree<S>::of(top0, top1);
    const S after = top.pick(fall), before = top.pick(fall.z, fall.x, fall.y);
    edge = seen & (least(after, before) <= S(T(1 - furthest_lean)));
    const Mask ahead = (!edge) | (after < before), back = !ahead;
    begin_with(seen & ((top1 & ahead) | (top2 & back)), seen & ((top2 & ahead) | (top0 & back)), vertex);
    const Mask alone = seen & (!edge);
    vertex[1] = select(alone, vertex[0], vertex[1]);
  }
};

}  // namespace detail

/// The points along the chosen axis of a box and a triangle that are at most `margin` apart, in the world. Only for
/// those within the margin of each other.
template <class S>
void triangle_manifold(const BoxAndTriangle<S>& p, const TriangleDirections<S>& directions,
                       const TriangleChoice<S>& choice, const S& margin, const Pose<S>& pose_a, BoxManifold<S>& found) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  using Mask = decltype(S() < S());
  const S zero(0), one(1);

  // The axes of the box turned until its face's comes last.
  const auto axes = OneOfThree<S>::longest(choice.normal);
  const Vec3<S> n = axes.turned(choice.normal), half = axes.turned(p.half),
                point[3] = {axes.turned(of_corner(p.point, 0)), axes.turned(of_corner(p.point, 1)),
                            axes.turned(of_corner(p.point, 2))};
  const Mask positive = n.z >= zero;
  const S height = select(positive, half.z, -half.z);
  const Several<S, 3> fall = abs(dot(directions.along, for_corners(choice.normal)));
  const detail::TriangleFace<S> face(point, axes.turned(directions.normal), n, height, {fall[0], fall[1], fall[2]},
                                     p.noise);
  const detail::RectangleAndTriangle<S> faces{
      {half.x, half.y}, {face.side[0], face.side[1], face.side[2]}, face.whole, face.edge, p.noise};
  const S shorter = least(half.x, half.y),
          near = S(T(same_place)) * sqrt(least(S(4) * shorter * shorter, face.shortest_squared())),
          near_squared = near * near;

  detail::Ring<S> corners = face.over(faces, S(same_point<T>) * near_squared);
  const S nearest = corners.find_deepest();
  if (any(face.whole)) detail::drop_idle_corners(corners, near);

  const Vec3<S> wx = axes.turned(p.turn.row[0]), wy = axes.turned(p.turn.row[1]), wz = axes.turned(p.turn.row[2]);
  found.normal = {dot(wx, n), dot(wy, n), dot(wz, n)};
  found.filled = zero;
  const S box_face = face_part(axes, positive), limit = greatest(margin, choice.distance + p.noise);
  const FlatPoint<S> rim{half.x - near, half.y - near};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const S apart = corners.apart_at(i);
    const Mask here = corners.has(i) & (apart <= limit);
    if (!any(here)) continue;
    const FlatPoint<S> at = corners.at(i);
    const Vec3<S> place{at.x, at.y, height},
        on_box = pose_a.translation + Vec3<S>{dot(wx, place), dot(wy, place), dot(wz, place)};
    found.put(i,
              {on_box, on_box + found.normal * apart, apart,
               box_face + part_along<S>(at.x, rim.x) + part_along<S>(at.y, rim.y) * S(3), face.part(at, near_squared)});
    found.filled = found.filled + select(here, S(T(1 << i)), zero);
  }
  const S allowed = S(T(face_preference)) * least(p.size_a, p.size_b);
  const Mask known = directions.regular & (found.filled > zero) & (nearest <= choice.distance + allowed);
  found.known = select(known, one, zero);
}

}  // namespace graze
