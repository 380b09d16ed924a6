// The shapes that the special pairs of the plane take, and the core of each.
//
// Guarantee: the table of kinds is derived from the list of shapes and the list of pairs: neither is written again.
#pragma once

#include <array>
#include <type_traits>

#include "graze/plane/shape.hpp"
#include "plane/pairs/pair_list.hpp"

namespace graze::plane {

/// The core that represents a kind of shape in the special pairs; none for kinds that no entry takes.
template <class C>
inline constexpr std::optional<LaneCore> lane_core{};
template <class T>
inline constexpr std::optional<LaneCore> lane_core<Circle<T>> = LaneCore::point;
template <class T>
inline constexpr std::optional<LaneCore> lane_core<Capsule<T>> = LaneCore::segment;
template <class T>
inline constexpr std::optional<LaneCore> lane_core<Segment<T>> = LaneCore::segment;
template <class T>
inline constexpr std::optional<LaneCore> lane_core<Box<T>> = LaneCore::box;
template <class T>
inline constexpr std::optional<LaneCore> lane_core<HalfPlane<T>> = LaneCore::half_plane;

/// The numbers of a shape that has a core, for `LaneShape::size`, and its radius aside from `Shape::rounding`.
template <class T>
double size_numbers(const Circle<T>& c, double*) {
  return double(c.radius());
}
template <class T>
double size_numbers(const Capsule<T>& c, double* size) {
  const auto h = double(c.half_height());
  size[0] = size[2] = 0;
  size[1] = -h;
  size[3] = h;
  return double(c.radius_top());
}
template <class T>
double size_numbers(const Segment<T>& s, double* size) {
  size[0] = double(s.a().x), size[1] = double(s.a().y), size[2] = double(s.b().x), size[3] = double(s.b().y);
  return 0;
}
template <class T>
double size_numbers(const Box<T>& b, double* size) {
  size[0] = double(b.half_extents().x), size[1] = double(b.half_extents().y);
  return 0;
}
template <class T>
double size_numbers(const HalfPlane<T>&, double*) {
  return 0;
}

/// Whether the special pairs take a shape of a kind that has a core: all but tapered capsules.
template <class C>
bool accepted(const C&) {
  return true;
}
template <class T>
bool accepted(const Capsule<T>& c) {
  return !c.tapered();
}

/// The entry of the list that takes two kinds of shapes.
template <class T>
class KindTable {
 public:
  static constexpr std::size_t kinds = Shape<T>::count;

  static constexpr std::optional<PairEntry> at(std::size_t a, std::size_t b) { return entries[a * kinds + b]; }

 private:
  template <std::size_t... I>
  static constexpr std::array<std::optional<LaneCore>, kinds> cores(std::index_sequence<I...>) {
    return {lane_core<std::variant_alternative_t<I, ShapeList<T>>>...};
  }
  static constexpr auto made() {
    constexpr auto core = cores(std::make_index_sequence<kinds>());
    std::array<std::optional<PairEntry>, kinds * kinds> table{};
    for (std::size_t a = 0; a < kinds; ++a)
      for (std::size_t b = 0; b < kinds; ++b)
        if (core[a] && core[b]) table[a * kinds + b] = entry_of(*core[a], *core[b]);
    return table;
  }
  static constexpr std::array<std::optional<PairEntry>, kinds* kinds> entries = made();
};

}  // namespace graze::plane
