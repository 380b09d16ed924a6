// Box against box: the overlap test.
//
// Guarantee: in every lane the answer that the pair gives alone; the axes are those from which contacts choose.
#pragma once

#include "narrow/pairs/box_box/reference_axis.hpp"

namespace graze {

namespace detail {

/// Whether any of a pair's three truth values is set, for each pair.
template <class S>
auto any_of_pair(const typename Packed<S, 3>::Mask& three) {
  if constexpr (Packed<S, 3>::joined)
    return any(three);
  else
    return three[0] | three[1] | three[2];
}

}  // namespace detail

/// Two boxes in place, computed without a division: all numbers but B's half extents are multiplied by `scale`, the
/// product of the squared lengths of their quaternions.
template <class S>
struct ScaledBoxes {
  using Row = Packed<S, 3>;
  S scale;
  BoxRows<S> rows;

  ScaledBoxes(const Row& of_a, const PoseRows<S>& a, const Row& of_b, const PoseRows<S>& b)
      : ScaledBoxes(of_a, a, of_b, b, a.length_squared(), b.length_squared()) {}

 private:
  ScaledBoxes(const Row& of_a, const PoseRows<S>& a, const Row& of_b, const PoseRows<S>& b, const S& squared_a,
              const S& squared_b)
      : scale(squared_a * squared_b),
        rows(of_a * Row(scale), of_b,
             transposed_times(rotation_rows(a.vector, a.w, S(2), squared_a), b.translation - a.translation) *
                 Row(squared_b),
             relative_rotation(a, b, S(2), scale)) {}
};

/// Rounding of the separation of two boxes along an axis, times the scale.
template <class S>
S box_noise(const ScaledBoxes<S>& p) {
  return box_noise(p.rows, length(p.rows.half_a), length(p.rows.half_b) * p.scale);
}

/// Whether some axis shows a gap of more than `enough` >= 0, which is multiplied by the scale as well. The products of
/// edges, which need neither root nor division for it, are tested only while faces leave some lane undecided. With
/// `faces_only` they are left out: some disjoint boxes then go undetected, but none that touch are reported as apart.
template <class S>
auto boxes_apart(const ScaledBoxes<S>& boxes, const S& enough, bool faces_only = false) {
  using Row = Packed<S, 3>;
  const BoxRows<S>& p = boxes.rows;
  // Along B's axes and those of edges everything is a product of two numbers multiplied by the scale.
  const S squared = boxes.scale * boxes.scale;
  const Row gap(enough), gap_squared(enough * enough), parallel(S(parallel_edges<S>) * squared), none(S(0)),
      half_b = p.half_b * Row(squared), gap_b(enough * boxes.scale);
  // For a single pair the deciding axis is unpredictable: axes that a branch would separate are tested together.
  auto by_faces = box_faces_of_a(p) > gap;
  if constexpr (!Row::joined)
    if (const auto apart = detail::any_of_pair<S>(by_faces); all(apart)) return apart;
  by_faces = by_faces | (box_faces_of_b(p, half_b) > gap_b);
  auto apart = detail::any_of_pair<S>(by_faces);
  if (faces_only || all(apart)) return apart;
  auto gaps_found = none > none;  // for a single pair
  any_of_three([&](auto i) {
    const BoxEdgeAxes<S> edges = box_edges<i>(p);
    const Row gaps = edges.gap(), squares = edges.length_squared();
    const auto found = (squares > parallel) & (gaps > none) & (gaps * gaps > gap_squared * squares);
    if constexpr (Row::joined)
      gaps_found = gaps_found | found;
    else
      apart = apart | detail::any_of_pair<S>(found);
    return !Row::joined && all(apart);
  });
  if constexpr (Row::joined) apart = any(gaps_found);
  return apart;
}

}  // namespace graze
