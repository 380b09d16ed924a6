// Two triangles clipped by each other along a normal: the corners of their intersection, across lanes; also with an
// edge in the place of either.
//
// Guarantee: in every lane the bits that the pair gives alone. No corner is lost to rounding; one may come twice.
//
// Each side, clipped by the other triangle's three (Cyrus, Beck 1978, "Generalized two- and three-dimensional
// clipping"), is a side of the intersection or empty, and begins at a corner of it; and the sides of a convex area
// follow each other by their directions, so that those of the two triangles, in order each, have only to be merged.
#pragma once

#include "narrow/pairs/triangle_face.hpp"
#include "narrow/pairs/triangle_triangle/sat.hpp"

namespace graze::detail {

/// The sides of a triangle in rows: a number for each side.
template <class Row>
struct SideRows {
  FlatPoint<Row> from, along;
  Row reach;  ///< sum of the absolute values of `along`'s components

  template <class S>
  explicit SideRows(const TriangleFace<S>& face)
      : from{row(face, [](const FlatSide<S>& s) { return s.from.x; }),
             row(face, [](const FlatSide<S>& s) { return s.from.y; })},
        along{row(face, [](const FlatSide<S>& s) { return s.along.x; }),
              row(face, [](const FlatSide<S>& s) { return s.along.y; })},
        reach(abs(along.x) + abs(along.y)) {}

 private:
  template <class S, class F>
  static Row row(const TriangleFace<S>& face, const F& of) {
    Row* const kind = nullptr;
    return row_of(of(face.side[0]), of(face.side[1]), of(face.side[2]), kind);
  }
};

/// The intervals of each triangle's sides within the other triangle, from `low` to `high` in parameters of the side,
/// empty where these are the other way round; and the cross products of A's sides with B's.
template <class Row>
struct ClippedSides {
  using S = typename RowOf<Row>::Number;
  using Mask = decltype(S() < S());

  S low_a[3], high_a[3];
  Row low_b, high_b, turn[3];

  /// Points no further outside a triangle than `slack` count as inside. For an edge and a triangle, `by_edge`, that
  /// holds for the edge's ends only: where it leaves the triangle it is clipped at the rim.
  ClippedSides(const TriangleFace<S>& a, const TriangleFace<S>& b, const S& slack, const Mask& by_edge)
      : low_b(S(0)), high_b(S(1)) {
    const SideRows<Row> sides(b);
    const bool any_edge = any(by_edge);
    const Row zero(S(0)), one(S(1)), slack_b = sides.reach * Row(slack), edge(one_where<S>(by_edge));
    for (std::size_t i = 0; i < 3; ++i) {
      using std::abs;
      const FlatPoint<S>&from = a.side[i].from, &along = a.side[i].along;
      const FlatPoint<Row> to{sides.from.x - Row(from.x), sides.from.y - Row(from.y)}, d{Row(along.x), Row(along.y)};
      turn[i] = d.x * sides.along.y - d.y * sides.along.x;
      const S reach = abs(along.x) + abs(along.y);
      // For parallel sides any number far beyond their ends serves.
      const Row vanishing = sides.reach * Row(reach * S(epsilon<S> * epsilon<S>)) + Row(S(smallest));
      const auto parallel = abs(turn[i]) <= vanishing;
      const Row per = one / select(parallel, vanishing, turn[i]);
      const auto leaves = (turn[i] > zero) | parallel;  // A's side leaves B's half-plane, and B's enters A's
      const Row left = to.x * sides.along.y - to.y * sides.along.x, slack_a{slack * reach},
                of_a = any_edge ? place(left, left - turn[i], slack_b, per, edge) : (left + slack_b) * per;
      low_a[i] = greatest(S(0), greatest_of(select(leaves, zero, of_a)));
      high_a[i] = least(S(1), least_of(select(leaves, of_a, one)));
      const Row other_left = d.x * to.y - d.y * to.x,
                of_b = any_edge ? place(other_left, other_left + turn[i], slack_a, -per, edge)
                                : (other_left + slack_a) * -per;
      low_b = greatest(low_b, select(leaves, of_b, zero));
      high_b = least(high_b, select(leaves, one, of_b));
    }
  }

 private:
  static constexpr double smallest = std::numeric_limits<double>::min();

  /// The parameter at which a side crosses a line, from the distances of its ends to the left of that, and one over
  /// their difference.
  static Row place(const Row& start, const Row& end, const Row& slack, const Row& per, const Row& edge) {
    const Row zero(S(0)), one(S(1)), lowest = -slack, at = (start + slack) * per,
                                     clamped = least(greatest(start * per, zero), one);
    const auto crosses = ((start >= lowest) & (end < lowest)) | ((start < lowest) & (end >= lowest));
    return select(crosses & (edge > zero), clamped, at);
  }
};

/// Merges two times three corners, each at the beginning of a side, by the order of the sides' directions: A's, B's,
/// and which of A's come before which of B's.
template <class S, class M>
void merge_corners(const Corner<S> (&a)[3], const Corner<S> (&b)[3], const M (&before)[3][3],
                   Corner<S> (&slots)[most_contact_slots]) {
  if constexpr (std::is_integral_v<M>) {
    for (int k = 0; k < 3; ++k) {
      const int of_b = 3 - before[k][0] - before[k][1] - before[k][2],
                of_a = before[0][k] + before[1][k] + before[2][k];
      slots[k + of_b] = a[k];
      slots[k + of_a] = b[k];
    }
  } else {
    // The k-th corner of one is in slot s where s - k of the other come before it.
    const auto after = [&](int i, int count) {
      const M past = count == 0   ? before[i][0]
                     : count == 3 ? !before[i][2]
                                  : (!before[i][count - 1]) & before[i][count];
      return past;
    };
    const auto behind = [&](int j, int count) {
      const M past = count == 0   ? !before[0][j]
                     : count == 3 ? before[2][j]
                                  : before[count - 1][j] & (!before[count][j]);
      return past;
    };
    for (int s = 0; s < 6; ++s) {
      const int first = s > 3 ? s - 3 : 0, last = s < 2 ? s : 2;
      Corner<S> corner = b[last];
      for (int j = first; j < last; ++j) corner = select(behind(j, s - j), b[j], corner);
      for (int i = first; i <= last; ++i) corner = select(after(i, s - i), a[i], corner);
      slots[s] = corner;
    }
  }
}

/// The corners of the intersection of two faces, at least one of them whole and neither a vertex; the slots must be
/// empty.
template <class Row, class S>
void shared_corners(const TriangleFace<S>& a, const TriangleFace<S>& b, const S& slack,
                    Corner<S> (&slots)[most_contact_slots]) {
  using Mask = decltype(S() < S());
  const Mask by_edge = a.edge | b.edge;
  const ClippedSides<Row> clipped(a, b, slack, by_edge);
  const auto corner = [](const FlatSide<S>& side, const S& t, const S& low, const S& high) {
    return Corner<S>{{side.from.x + side.along.x * t, side.from.y + side.along.y * t}, low <= high};
  };
  Corner<S> of_a[3], of_b[3];
  Mask before[3][3];
  for (int i = 0; i < 3; ++i) {
    const S &low = clipped.low_a[i], low_b = clipped.low_b[i];
    of_a[i] = corner(a.side[i], low, low, clipped.high_a[i]);
    of_b[i] = corner(b.side[i], low_b, low_b, clipped.high_b[i]);
    const Mask late = in_second_half(a.side[i].along);
    for (int j = 0; j < 3; ++j) {
      const Mask late_b = in_second_half(b.side[j].along);
      before[i][j] = ((!late) & late_b) | (((late & late_b) | (!(late | late_b))) & (clipped.turn[i][j] > S(0)));
    }
  }
  merge_corners(of_a, of_b, before, slots);
  if (!any(by_edge)) return;
  const Corner<S> end_a = corner(a.side[0], clipped.high_a[0], clipped.low_a[0], clipped.high_a[0]),
                  end_b = corner(b.side[0], clipped.high_b[0], clipped.low_b[0], clipped.high_b[0]);
  slots[0] = select(a.edge, of_a[0], select(b.edge, of_b[0], slots[0]));
  slots[1] = select(a.edge, end_a, select(b.edge, end_b, slots[1]));
  for (std::size_t i = 2; i < 6; ++i) slots[i].is = slots[i].is & (!by_edge);
}

}  // namespace graze::detail
