// The feature of a triangle that meets another shape along a normal, projected along it: the triangle, an edge or a
// vertex; across lanes.
//
// Guarantee: in every lane the bits that the pair gives alone.
#pragma once

#include "narrow/pairs/box_triangle/outline.hpp"
#include "narrow/pairs/triangle_parts.hpp"

namespace graze::detail {

/// A triangle as seen along a contact normal.
template <class S>
struct TriangleView {
  S facing;           ///< cosine between its front normal and the direction to the other shape
  FlatPoint<S> rise;  ///< gradient of its height, times `facing`
  Vec3<S> far;        ///< distance of each vertex from the other shape
  Vec3<S> fall;       ///< cosine between the normal and each edge, without its sign
  S most_fall;        ///< an edge with a larger `fall` shows only its upper end; squared if `fall` is
};

template <class S>
struct TriangleFace {
  using Mask = decltype(S() < S());

  FlatVertex<S> vertex[3];  ///< the triangle, counter-clockwise; for an edge, its ends are the first two; for a vertex,
                            ///< the first
  FlatSide<S> side[3];
  Mask whole, edge, front;
  FlatPoint<S> slope;  ///< gradient of the vertices' `apart`

  TriangleFace() = default;
  /// `vertex_at(i)` returns the i-th vertex and is called in place: a copy right after its numbers were stored waits
  /// for them.
  template <class VertexAt>
  TriangleFace(const VertexAt& vertex_at, const TriangleView<S>& view, const S& rounding)
      : vertex{vertex_at(0), vertex_at(1), vertex_at(2)} {
    using std::abs;
    using T = typename LaneOf<S>::type;
    whole = abs(view.facing) >= S(T(furthest_lean));
    front = view.facing > S(0);
    edge = whole & (!whole);
    if (any(whole)) put_sides_in_order();
    if (!all(whole)) choose_edge(view);
    for (std::size_t i = 0; i < 3; ++i) side[i] = {vertex[i].at, vertex[i == 2 ? 0 : i + 1].at, rounding};

    const S per_facing = S(1) / select(whole, view.facing, S(1)), squared = side[0].length_squared(),
            rise = (vertex[1].apart - vertex[0].apart) / select(squared > S(0), squared, S(1));
    slope = {select(whole, view.rise.x * per_facing, side[0].along.x * rise),
             select(whole, view.rise.y * per_facing, side[0].along.y * rise)};
  }

  S apart_at(const FlatPoint<S>& p) const {
    return vertex[0].apart + (p.x - vertex[0].at.x) * slope.x + (p.y - vertex[0].at.y) * slope.y;
  }
  /// The squared length of the shortest side; infinite for a vertex.
  S shortest_squared() const {
    const S infinity(std::numeric_limits<typename LaneOf<S>::type>::infinity()),
        first = side[0].length_squared(), others = least(side[1].length_squared(), side[2].length_squared());
    return select(whole, least(first, others), select(edge, first, infinity));
  }
  /// The part of the triangle that a point on it lies on; ends and edges count within the squared distance
  /// `near_squared`.
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
  /// Makes the vertices counter-clockwise, and the side of the smallest angle first: the one in the first half turn
  /// that follows one in the second.
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

  /// Chooses the feature of a triangle seen edge-on: of the two edges at the vertex nearest to the other shape the one
  /// with the smaller `fall`; the vertex, if both exceed `most_fall`.
  void choose_edge(const TriangleView<S>& view) {
    const Vec3<S>& far = view.far;
    const Mask seen = !whole, top0 = (far.x <= far.y) & (far.x <= far.z), top1 = (!top0) & (far.y <= far.z),
               top2 = !(top0 | top1);
    const auto top = AxisPermutation<S>::of(top0, top1);
    const S after = top.pick(view.fall), before = top.pick(view.fall.z, view.fall.x, view.fall.y);
    edge = seen & (least(after, before) <= view.most_fall);
    const Mask ahead = (!edge) | (after < before), back = !ahead;
    begin_with(seen & ((top1 & ahead) | (top2 & back)), seen & ((top2 & ahead) | (top0 & back)), vertex);
    const Mask alone = seen & (!edge);
    vertex[1] = select(alone, vertex[0], vertex[1]);
  }
};

}  // namespace graze::detail
