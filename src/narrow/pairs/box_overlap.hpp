// Box against box: whether they touch.
//
// Guarantee: in every lane what the pair gives alone; the axes are those that contacts are chosen from.
#pragma once

#include "narrow/pairs/box_choice.hpp"

namespace graze {

namespace detail {

/// Of each pair, whether any of its three is set.
template <class S>
auto any_of_pair(const typename Several<S, 3>::Mask& three) {
  if constexpr (Several<S, 3>::joined)
    return any(three);
  else
    return three[0] | three[1] | three[2];
}

}  // namespace detail

/// Whether some axis shows a gap of more than `enough` >= 0. The products of edges, which need neither root nor division
/// for it, are tried only while faces leave some lane to know. With `faces_only` they are left out: of some boxes that
/// are apart it is then not known, of none that touch is it said.
template <class S>
auto boxes_apart(const BoxRows<S>& p, const S& enough, bool faces_only = false) {
  using Row = Several<S, 3>;
  const Row gap(enough), gap_squared(enough * enough), parallel(S(parallel_edges<S>)), none(S(0));
  // Of a single pair nobody foresees which axis tells: those that a jump would part are tried together.
  auto by_faces = box_faces_of_a(p) > gap;
  if constexpr (!Row::joined)
    if (const auto apart = detail::any_of_pair<S>(by_faces); all(apart)) return apart;
  by_faces = by_faces | (box_faces_of_b(p) > gap);
  auto apart = detail::any_of_pair<S>(by_faces);
  if (faces_only || all(apart)) return apart;
  auto gaps_found = none > none;  // of a single pair
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
