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

/// Whether some axis shows a gap of more than `enough` >= 0. Three axes are tried at a time, only while not all lanes
/// know; the products of edges need neither root nor division for it. With `faces_only` they are left out: of some
/// boxes that are apart it is then not known, of none that touch is it said.
template <class S>
auto boxes_apart(const BoxRows<S>& p, const S& enough, bool faces_only = false) {
  using Row = Several<S, 3>;
  const Row gap(enough), gap_squared(enough * enough), parallel(S(parallel_edges<S>)), none(S(0));
  auto apart = detail::any_of_pair<S>(box_faces_of_a(p) > gap);
  if (all(apart)) return apart;
  apart = apart | detail::any_of_pair<S>(box_faces_of_b(p) > gap);
  if (faces_only) return apart;
  any_of_three([&](auto i) {
    if (all(apart)) return true;
    const BoxEdgeAxes<S> edges = box_edges<i>(p);
    const Row gaps = edges.gap(), squares = edges.length_squared();
    const auto distinct = (squares > parallel) & (gaps > none);
    apart = apart | detail::any_of_pair<S>(distinct & (gaps * gaps > gap_squared * squares));
    return false;
  });
  return apart;
}

}  // namespace graze
