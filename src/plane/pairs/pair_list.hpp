// The list of the special pairs of the plane: to add one is to write its struct and to name it here.
//
// A pair is a struct with the two cores `a` and `b` (A gives the frame) and a function `nearest`, from which all of
// overlap, distance and contacts follow. A lane may decline (`LanePair::known`): the walk around the Minkowski
// difference answers for it then.
#pragma once

#include <optional>

#include "plane/pairs/box_box.hpp"
#include "plane/pairs/box_point.hpp"
#include "plane/pairs/half_plane.hpp"
#include "plane/pairs/point_point.hpp"
#include "plane/pairs/segment_point.hpp"
#include "plane/pairs/segment_segment.hpp"

namespace graze::plane {

template <class... P>
struct Pairs {
  static constexpr std::size_t count = sizeof...(P);
};

using PairList = Pairs<PointPoint, SegmentPoint, SegmentSegment, BoxPoint, BoxSegment, BoxBox, HalfPlanePoint,
                       HalfPlaneSegment, HalfPlaneBox>;

/// A place in the list, and whether the shapes are taken the other way round.
struct PairEntry {
  std::uint8_t place;
  bool turned;
};

/// The entry of two cores, if there is one.
template <class... P>
constexpr std::optional<PairEntry> entry_of(LaneCore a, LaneCore b, Pairs<P...>) {
  constexpr LaneCore first[] = {P::a...}, second[] = {P::b...};
  for (std::size_t i = 0; i < sizeof...(P); ++i) {
    const auto number = static_cast<std::uint8_t>(i);
    if (first[i] == a && second[i] == b) return PairEntry{number, false};
    if (first[i] == b && second[i] == a) return PairEntry{number, true};
  }
  return {};
}
constexpr std::optional<PairEntry> entry_of(LaneCore a, LaneCore b) { return entry_of(a, b, PairList()); }

}  // namespace graze::plane
