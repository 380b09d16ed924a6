// The pairs of the list that have lanes: the pair that answers for two kinds of shapes.
//
// Guarantee: derived from the list of pairs (`narrow/pair_list.hpp`) and from nothing else.
#pragma once

#include <cstdint>

#include "narrow/batch/lane_shapes.hpp"
#include "narrow/pair_list.hpp"

namespace graze {

namespace detail {

/// Stand-in for a sink, for the concepts below: takes every call of a pair's `visit_contacts`.
template <class T>
struct AnySink {
  using Scalar = T;
  static constexpr std::size_t most = 1;
  void apart(std::size_t) {}
  void unknown(std::size_t) {}
  void one(std::size_t, const PointContact<T>&) {}
  template <class Points>
  void several(std::size_t, T, const Vec3<T>&, const Points&, std::size_t) {}
  void met(const MetPairs<T>&, bool) {}
};

}  // namespace detail

template <class P>
concept HasOverlapRows = requires {
  P::template overlap_rows<float>();
};
template <class P>
concept HasDistanceRows = requires {
  P::template distance_rows<float>();
};
template <class P>
concept HasContactRows = requires {
  P::template contact_rows<float>();
};
/// Pairs with contacts across lanes.
template <class P>
concept HasContactLanes = requires(const PairRef<float>* pairs, detail::AnySink<float>& sink) {
  P::visit_contacts(pairs, std::size_t(), false, sink);
};
template <class P>
concept HasLanes = HasOverlapRows<P> || HasDistanceRows<P> || HasContactLanes<P>;

/// Whether the kernels behind `visit_contacts` reject shapes that they do not take themselves.
template <class P>
constexpr bool takes_all_shapes() {
  return requires { P::takes_all_shapes; };
}

/// A pair with lanes by its index in the list, or none.
using LanePair = std::uint8_t;
inline constexpr LanePair no_lanes = PairList::count;
static_assert(2 * PairList::count < 256, "a queue's number takes eight bits");

/// Calls `f` with the pair, if it has lanes, as its template argument.
template <class F>
void with_lane_pair(LanePair pair, const F& f) {
  PairList::with(pair, [&]<class P>() {
    if constexpr (HasLanes<P>) f.template operator()<P>();
  });
}

/// A property of the pairs with lanes: `holds<P>()` for each.
class LanePairSet {
 public:
  template <class Holds>
  constexpr explicit LanePairSet(const Holds& holds) {
    std::size_t place = 0;
    PairList::each([&]<class P>() {
      if constexpr (HasLanes<P>) has_[place] = holds.template operator()<P>();
      ++place;
    });
  }
  constexpr bool operator()(LanePair pair) const { return has_[pair]; }

 private:
  bool has_[PairList::count + 1]{};
};
inline constexpr LanePairSet with_overlap_rows([]<class P>() { return HasOverlapRows<P>; }),
    with_distance_rows([]<class P>() { return HasDistanceRows<P>; }),
    with_contact_lanes([]<class P>() { return HasContactLanes<P>; }),
    with_all_shapes([]<class P>() { return takes_all_shapes<P>(); });

/// The lanes for two kinds: a pair of the list, and whether the two shapes have to be swapped for it.
struct LanesFor {
  LanePair pair = no_lanes;
  bool turned = false;

  bool exist() const { return pair != no_lanes; }
  friend bool operator==(const LanesFor&, const LanesFor&) = default;
};

template <class T>
class LaneTable {
 public:
  constexpr LaneTable() {
    LanePair place = 0;
    PairList::each([&]<class P>() {
      if constexpr (HasLanes<P>) {
        constexpr std::size_t a = detail::kind_of<typename P::template A<T>, T>(),
                              b = detail::kind_of<typename P::template B<T>, T>();
        at_[b * Shape<T>::count + a] = {place, true};
        at_[a * Shape<T>::count + b] = {place, false};
      }
      ++place;
    });
  }
  constexpr const LanesFor& operator()(std::size_t kind_a, std::size_t kind_b) const {
    return at_[kind_a * Shape<T>::count + kind_b];
  }

 private:
  LanesFor at_[Shape<T>::count * Shape<T>::count];
};
template <class T>
inline constexpr LaneTable<T> lane_table;

/// Whether a kind is in any pair that has lanes.
template <class C, class T>
constexpr bool has_lanes() {
  bool found = false;
  PairList::each([&]<class P>() {
    if constexpr (HasLanes<P>)
      found = found || std::is_same_v<typename P::template A<T>, C> || std::is_same_v<typename P::template B<T>, C>;
  });
  return found;
}

/// The concrete shape if lanes take it, else null.
template <class T>
const void* concrete_for_lanes(const Shape<T>& shape) {
  if (shape.rounding() != T(0)) return nullptr;
  return shape.visit([&](const auto& concrete) -> const void* {
    using C = std::decay_t<decltype(concrete)>;
    if constexpr (has_lanes<C, T>())
      return taken_by_lanes(concrete) ? &concrete : nullptr;
    else
      return nullptr;
  });
}

/// Finds the contacts of up to `Sink::most` pairs of concrete shapes that lanes take, by the pair's kernels, and passes
/// them to the sink (`contact_sink.hpp`), in the caller's order of the shapes.
template <class T, class Sink>
void visit_lane_contacts(const LanesFor& lanes, const PairRef<T>* pairs, std::size_t count, Sink& sink) {
  with_lane_pair(lanes.pair, [&]<class P>() {
    if constexpr (HasContactLanes<P>) P::visit_contacts(pairs, count, lanes.turned, sink);
  });
}

}  // namespace graze
