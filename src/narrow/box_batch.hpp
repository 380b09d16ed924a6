// Contacts of many pairs of boxes, or of boxes and triangles, by the kernels for them.
//
// Guarantee: for each pair what `convex_contacts` answers, bit for bit.
#pragma once

#include <algorithm>
#include <bit>
#include <utility>

#include "narrow/features.hpp"
#include "narrow/pair_kernels.hpp"
#include "narrow/pairs/box_triangle_manifold.hpp"

namespace graze {

/// Appends the points in the slots of one pair, of which there are at most eight, to `points` (of contact points or of
/// what begins with one), and returns how many. Of two of the same features the deeper one is kept. `slot(i)` gives the
/// i-th slot of the pair, `features_b` what the parts of B name; those of A are a box's.
template <class T, class Slot, class Points>
std::size_t take_points(unsigned filled, const Slot& slot, const std::uint32_t* features_b, Points& points) {
  using Point = std::remove_cvref_t<decltype(points[0])>;
  const std::size_t first = points.size();
  // All lie on one face of either, where features are the same just where parts are. Two parts on each that have no bit
  // in common with those before have not come yet; few others share a bit.
  std::uint64_t seen = 0;
  for (; filled != 0; filled &= filled - 1) {
    const BoxSlot<T> from = slot(static_cast<std::size_t>(std::countr_zero(filled)));
    const auto part_a = static_cast<std::uint32_t>(static_cast<int>(from.part_a)),
               part_b = static_cast<std::uint32_t>(static_cast<int>(from.part_b));
    const std::uint32_t feature = feature_id(box_features.of[part_a], features_b[part_b]);
    const std::uint64_t bit = std::uint64_t{1} << ((9 * part_a + part_b) % 64);
    const ContactPoint<T> point{from.a, from.b, from.distance, feature};
    if ((seen & bit) != 0) [[unlikely]] {
      std::size_t place = first;
      while (place < points.size() && points[place].feature != feature) ++place;
      if (place < points.size()) {
        if (from.distance < points[place].distance) points[place] = Point{point};
        continue;
      }
    }
    seen |= bit;
    // Written where it stays: one that is made elsewhere would be read back by more bytes than it was just written by.
    points.emplace_back() = Point{point};
  }
  return points.size() - first;
}

/// Of two points of a pair in a block that have the same features keeps the deeper one, in the place of the first.
template <class T>
void drop_twice(PointBlock<T>& block, std::size_t pairs) {
  ContactPoint<T>*from = block.points.row, *to = from;
  for (std::size_t k = 0; k < pairs; ++k) {
    ContactPoint<T>*const first = to, *const end = from + static_cast<int>(block.count[k]);
    for (; from < end; ++from) {
      ContactPoint<T>* const same =
          std::find_if(first, to, [&](const ContactPoint<T>& p) { return p.feature == from->feature; });
      if (same == to)
        *to++ = *from;
      else if (from->distance < same->distance)
        *same = *from;
    }
    block.count[k] = static_cast<T>(to - first);
  }
  block.point_count = static_cast<std::uint32_t>(to - block.points.row);
  block.any_twice = false;
}

/// Pairs that meet, some of a block one behind the other, all of them known.
template <class T>
struct MetPairs {
  const PointBlock<T>& block;
  std::size_t first, count;       ///< of the block
  const std::uint8_t* places;     ///< of the block's pairs, among those that were asked about
  const T* distances;             ///< of the block's pairs
  const ContactPoint<T>* points;  ///< of all, pair after pair
  std::size_t point_count;

  std::size_t place(std::size_t k) const { return places[first + k]; }
  T distance(std::size_t k) const { return distances[first + k]; }
  Vec3<T> normal(std::size_t k) const {
    const auto& n = block.normal;
    return {n[0][first + k], n[1][first + k], n[2][first + k]};
  }
  std::uint32_t points_of(std::size_t k) const {
    return static_cast<std::uint32_t>(static_cast<int>(block.count[first + k]));
  }
};

/// Calls `met` with the pairs of a block that follow each other and are known, and `unknown(place)` for each other one,
/// in their order.
template <class T, class Met, class Unknown>
void visit_block(const PointBlock<T>& block, const std::uint8_t* places, const T* distances, std::size_t count,
                 const Met& met, const Unknown& unknown) {
  MetPairs<T> some{block, 0, 0, places, distances, block.points.row, 0};
  for (std::size_t k = 0; k <= count; ++k) {
    if (k < count && block.known[k] != T(0)) {
      ++some.count;
      some.point_count += some.points_of(k - some.first);
      continue;
    }
    if (some.count > 0) met(some);
    if (k < count) unknown(places[k]);
    some.first = k + 1;
    some.count = 0;
    some.points += std::exchange(some.point_count, 0);
  }
}

/// Has the lines of so many records brought near, which may be behind the end of an array: to be read, or to be written
/// when a kernel is done with the next pairs, which are likely to have as many. Neither waits for a line then: of batches
/// that are larger than the cache a quarter of the time.
template <bool to_write, class Record>
void fetch_lines(const Record* first, std::size_t count) {
  constexpr std::size_t line = 64;
  const auto begin = reinterpret_cast<std::uintptr_t>(first), end = begin + count * sizeof(Record);
  for (std::uintptr_t at = begin; at < end; at += line) __builtin_prefetch(reinterpret_cast<const void*>(at), to_write);
}
template <class Record>
void fetch_rows(const Record* first, std::size_t count) {
  fetch_lines<false>(first, count);
}
template <class Record>
void fetch_for_writing(const Record* first, std::size_t count) {
  fetch_lines<true>(first, count);
}

/// The pairs that a chunk is made of: what is loaded for the axes is still near when the points are found, and those
/// that touch fill several blocks.
inline constexpr std::size_t box_chunk = 128;
/// The most that are asked about at a time. Where most pairs wait for one kernel, as in a world, twice a chunk leaves
/// half as many lanes of the last blocks empty.
inline constexpr std::size_t most_chunk = 2 * box_chunk;

/// A kernel for the points of contact of pairs whose axes are known.
template <class T, class Choice>
using PointKernel = void (*)(const PairRef<T>*, const Choice*, std::size_t, PointBlock<T>&);

/// Asks a kernel about up to `most_chunk` pairs, whose axes are known; `pair(i)` gives the `PairRef` of the i-th. Calls
/// `apart(i)` for those further apart than their margins; and then, in the order of the pairs, `met(pairs)`, the
/// `MetPairs`, for some at a time, or, where their faces do not tell, `unknown(i)`.
template <class T, class Choice, class Pair, class Apart, class Met, class Unknown>
void visit_contacts(PointKernel<T, Choice> points, const Pair& pair, const Choice* axes, std::size_t count,
                    const Apart& apart, const Met& met, const Unknown& unknown) {
  // No branch that nobody foresees: places are written either way and kept or written over.
  std::uint8_t place[most_chunk], apart_place[most_chunk];
  std::size_t met_count = 0, apart_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool meets = !(axes[i].distance > pair(i).margin);
    place[met_count] = apart_place[apart_count] = static_cast<std::uint8_t>(i);
    met_count += meets;
    apart_count += !meets;
  }
  for (std::size_t k = 0; k < apart_count; ++k) apart(apart_place[k]);
  PairRef<T> some[block_pairs];
  Choice some_axes[block_pairs];
  T distances[block_pairs];
  PointBlock<T> block;
  for (std::size_t first = 0; first < met_count; first += block_pairs) {
    const std::size_t size = std::min(block_pairs, met_count - first);
    for (std::size_t k = 0; k < size; ++k) {
      some[k] = pair(place[first + k]);
      some_axes[k] = axes[place[first + k]];
      distances[k] = some_axes[k].distance;
    }
    points(some, some_axes, size, block);
    if (block.any_twice) drop_twice(block, size);
    visit_block(block, place + first, distances, size, met, unknown);
  }
}

/// The same of plain boxes (`plain_box`).
template <class T, class Apart, class Met, class Unknown>
void visit_box_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Met& met,
                        const Unknown& unknown) {
  const Isa level = chosen_isa();
  BoxChoice<T> axes[most_chunk];
  GRAZE_KERNEL(level, box_axes<T>)(pairs, count, axes);
  visit_contacts<T, BoxChoice<T>>(
      GRAZE_KERNEL(level, box_points<T>), [&](std::size_t i) -> const PairRef<T>& { return pairs[i]; }, axes, count,
      apart, met, unknown);
}
/// And of plain boxes in rows.
template <class T, class Apart, class Met, class Unknown>
void visit_box_contacts(const PairRows<T>& rows, std::size_t count, T margin, const Apart& apart, const Met& met,
                        const Unknown& unknown) {
  const Isa level = chosen_isa();
  BoxChoice<T> axes[most_chunk];
  GRAZE_KERNEL(level, box_row_axes<T>)(rows, count, margin, axes);
  const auto pair = [&](std::size_t i) {
    return PairRef<T>{static_cast<const Box<T>*>(rows.a) + i, static_cast<const Box<T>*>(rows.b) + i, rows.pose_a + i,
                      rows.pose_b + i, margin};
  };
  visit_contacts<T, BoxChoice<T>>(GRAZE_KERNEL(level, box_points<T>), pair, axes, count, apart, met, unknown);
}
/// And of plain boxes and triangles without a margin; slivers are `unknown`.
template <class T, class Apart, class Met, class Unknown>
void visit_triangle_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Met& met,
                             const Unknown& unknown) {
  const Isa level = chosen_isa();
  TriangleChoice<T> axes[most_chunk];
  GRAZE_KERNEL(level, triangle_axes<T>)(pairs, count, axes);
  visit_contacts<T, TriangleChoice<T>>(
      GRAZE_KERNEL(level, triangle_points<T>), [&](std::size_t i) -> const PairRef<T>& { return pairs[i]; }, axes,
      count, apart, met, unknown);
}

}  // namespace graze
