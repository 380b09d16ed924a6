// Contacts of many pairs of boxes, or of boxes and triangles, by the kernels for them.
//
// Guarantee: for each pair the answer of `convex_contacts`, bit for bit.
#pragma once

#include <algorithm>
#include <bit>
#include <utility>

#include "narrow/batch/pair_kernels.hpp"
#include "narrow/manifold/features.hpp"
#include "narrow/pairs/box_triangle/clip_over_box.hpp"

namespace graze {

/// Whether a contact point is deeper than another.
struct IsDeeper {
  template <class T>
  bool operator()(const ContactPoint<T>& point, const ContactPoint<T>& than) const {
    return point.distance < than.distance;
  }
};

/// Appends the points in the slots of one pair, at most eight, to `points` (of contact points or of types that begin
/// with one), and returns their number. Of two points with the same features the deeper one is kept. `slot(i)` returns
/// the i-th slot; `features_a` and `features_b` are the features of the parts of A and B.
template <class T, class Slot, class Points, class Deeper = IsDeeper>
std::size_t take_points(unsigned filled, const Slot& slot, const std::uint32_t* features_a,
                        const std::uint32_t* features_b, Points& points, const Deeper& deeper = {}) {
  using Point = std::remove_cvref_t<decltype(points[0])>;
  const std::size_t first = points.size();
  // All points lie on one face of either shape, where features are equal exactly where parts are. A pair of parts whose
  // bit is not set is new; few different ones share a bit.
  std::uint64_t seen = 0;
  for (; filled != 0; filled &= filled - 1) {
    const ContactSlot<T> from = slot(static_cast<std::size_t>(std::countr_zero(filled)));
    const auto part_a = static_cast<std::uint32_t>(static_cast<int>(from.part_a)),
               part_b = static_cast<std::uint32_t>(static_cast<int>(from.part_b));
    const std::uint32_t feature = feature_id(features_a[part_a], features_b[part_b]);
    const std::uint64_t bit = std::uint64_t{1} << ((9 * part_a + part_b) % 64);
    const ContactPoint<T> point{from.a, from.b, from.distance, feature};
    if ((seen & bit) != 0) [[unlikely]] {
      std::size_t place = first;
      while (place < points.size() && points[place].feature != feature) ++place;
      if (place < points.size()) {
        if (deeper(point, points[place])) points[place] = Point{point};
        continue;
      }
    }
    seen |= bit;
    // Written in place: a copy would load more bytes at a time than were just stored, and wait for the stores.
    points.emplace_back() = Point{point};
  }
  return points.size() - first;
}

/// Keeps of two points of a pair in a block that have the same features the deeper one, in the place of the first.
template <class T>
void drop_twice(PointBlock<T>& block) {
  const ContactPoint<T>* from = block.points;
  ContactPoint<T>* to = block.points;
  for (std::size_t k = 0; k < block.manifold_count; ++k) {
    auto& manifold = block.manifolds[k];
    ContactPoint<T>* const first = to;
    for (const ContactPoint<T>* const end = from + manifold.point_count; from < end; ++from) {
      ContactPoint<T>* const same =
          std::find_if(first, to, [&](const ContactPoint<T>& p) { return p.feature == from->feature; });
      if (same == to)
        *to++ = *from;
      else if (from->distance < same->distance)
        *same = *from;
    }
    manifold.first_point = block.first_point + static_cast<std::uint32_t>(first - block.points);
    manifold.point_count = static_cast<std::uint32_t>(to - first);
  }
  block.point_count = static_cast<std::uint32_t>(to - block.points);
  block.any_twice = false;
}

/// Touching pairs whose contacts are known, consecutive in a block.
template <class T>
struct MetPairs {
  const typename BatchContacts<T>::Group* manifolds;  ///< one for each pair
  const ContactPoint<T>* points;                      ///< points of all pairs, pair after pair
  std::size_t count, point_count;
  const std::uint32_t* places;  ///< indices among the pairs that were passed in
  const T* distances;

  std::size_t place(std::size_t k) const { return places[k]; }
  T distance(std::size_t k) const { return distances[k]; }
  const Vec3<T>& normal(std::size_t k) const { return manifolds[k].normal; }
  std::uint32_t points_of(std::size_t k) const { return manifolds[k].point_count; }
};

/// Calls `met` with runs of consecutive pairs of a block that are known, and `unknown(place)` for each other pair, in
/// order.
template <class T, class Met, class Unknown>
void visit_block(const PointBlock<T>& block, const std::uint32_t* places, const T* distances, std::size_t count,
                 const Met& met, const Unknown& unknown) {
  MetPairs<T> some{block.manifolds, block.points, 0, 0, nullptr, nullptr};
  for (std::size_t k = 0; k < count; ++k) {
    some.count = static_cast<std::size_t>(std::countr_one(block.known >> k));
    if (some.count > 0) {
      const auto& last = some.manifolds[some.count - 1];
      some.point_count = last.first_point + last.point_count - some.manifolds->first_point;
      some.places = places + k;
      some.distances = distances + k;
      met(some);
      some.manifolds += some.count;
      some.points += some.point_count;
      k += some.count;
    }
    if (k < count) unknown(places[k]);
  }
}

/// Uninitialised storage for the records that a kernel writes.
template <class Record, std::size_t size>
union RoomFor {
  RoomFor() {}  // NOLINT(modernize-use-equals-default): it would initialise them
  Record records[size];
};

/// Default destination of blocks, for callers without storage of their own.
template <class T>
class BlockRoom {
 public:
  void offer(PointBlock<T>& block) {
    block.manifolds = manifolds_.records;
    block.points = points_.records;
    block.first_point = 0;
  }
  /// Called before the pairs of a block of `count` are visited.
  void settle(PointBlock<T>&, std::size_t) {}

 private:
  RoomFor<typename BatchContacts<T>::Group, block_pairs> manifolds_;
  RoomFor<ContactPoint<T>, PointBlock<T>::room> points_;
};

/// Prefetches the cache lines of records that the kernel is about to write for the next pairs, of which there are
/// likely to be as many as before: they may be behind the end of an array.
template <class Record>
void fetch_for_writing(const Record* first, std::size_t count) {
  fetch_lines<true>(first, count);
}

/// Pairs per chunk: few enough that shapes loaded for the axes are still in the cache when the points are found, and
/// enough that those that touch fill several blocks.
inline constexpr std::size_t batch_chunk = 128;
/// Largest number of pairs passed in at a time. Where most pairs wait for one kernel, as in a world, twice a chunk
/// leaves half as many lanes of the last blocks empty.
inline constexpr std::size_t most_chunk = 2 * batch_chunk;

/// Calls `points(block)` to find the contacts of `count` pairs, and visits them.
template <class T, class Points, class Room, class Met, class Unknown>
void visit_points(const Points& points, const std::uint32_t* places, const T* distances, std::size_t count, Room& room,
                  const Met& met, const Unknown& unknown) {
  PointBlock<T> block;
  room.offer(block);
  points(block);
  if (block.any_twice) drop_twice(block);
  room.settle(block, count);
  visit_block(block, places, distances, count, met, unknown);
}

/// A writer that leaves every block to `visit_points`.
struct WritesNone {
  template <class Boxes>
  bool operator()(const Boxes&, std::size_t) const {
    return false;
  }
};

/// Calls the kernel for the waiting boxes, as long as there is a full block of them, or for `all`; except for blocks
/// that `write(boxes, size)` handles itself, as its result shows.
template <class T, class Room, class Met, class Unknown, class Write = WritesNone>
void visit_met_boxes(MetBoxes<T>& boxes, bool all, Room& room, const Met& met, const Unknown& unknown,
                     const Write& write = {}) {
  const auto kernel = GRAZE_KERNEL(chosen_isa(), box_points<T>);
  for (std::size_t waiting; waiting = boxes.count - boxes.first, waiting >= block_pairs || (all && waiting > 0);) {
    const std::size_t size = std::min(waiting, block_pairs), end = boxes.first + size;
    // Lanes without a pair repeat the last one.
    for (std::size_t column = 0; size < block_pairs && column < MetBoxes<T>::columns; ++column)
      std::fill(boxes.number[column] + end, boxes.number[column] + boxes.first + block_pairs,
                boxes.number[column][end - 1]);
    if (!write(boxes, size))
      visit_points<T>([&](PointBlock<T>& block) { kernel(boxes, size, block); }, boxes.place + boxes.first,
                      boxes.number[MetBoxes<T>::distance] + boxes.first, size, room, met, unknown);
    boxes.first = end;
  }
}

/// Finds the contacts of plain boxes (`plain_box`), up to `most_chunk` pairs. Calls `apart(i)` for those further apart
/// than their margins; and, in the order of the pairs, `met(pairs)` with `MetPairs` for some at a time, or `unknown(i)`
/// where their faces do not determine the contacts.
template <class T, class Apart, class Met, class Unknown, class Room = BlockRoom<T>>
void visit_box_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Met& met,
                        const Unknown& unknown, Room&& room = {}) {
  const auto axes = GRAZE_KERNEL(chosen_isa(), box_axes<T>);
  MetBoxes<T> boxes;
  std::uint32_t places[MetBoxes<T>::most + block_pairs];
  for (std::size_t first = 0; first < count; first += MetBoxes<T>::most) {
    const std::size_t apart_count = axes(pairs + first, std::min(MetBoxes<T>::most, count - first),
                                         static_cast<std::uint32_t>(first), boxes, places);
    for (std::size_t k = 0; k < apart_count; ++k) apart(places[k]);
    visit_met_boxes(boxes, false, room, met, unknown);
  }
  visit_met_boxes(boxes, true, room, met, unknown);
}
/// Finds the axes of plain boxes in rows, at most `MetBoxes::most` at a time, of which the first is pair number
/// `number`. Pairs within the margin wait in `boxes` for `visit_met_boxes`.
template <class T, class Apart>
void visit_box_axes(const PairRows<T>& rows, std::size_t count, T margin, std::uint32_t number, MetBoxes<T>& boxes,
                    const Apart& apart) {
  static_assert(batch_chunk <= MetBoxes<T>::most);
  std::uint32_t places[MetBoxes<T>::most + block_pairs];
  const std::size_t apart_count =
      GRAZE_KERNEL(chosen_isa(), box_row_axes<T>)(rows, count, margin, number, boxes, places);
  for (std::size_t k = 0; k < apart_count; ++k) apart(places[k]);
}

/// A kernel for the contact points of pairs whose distances, and further results in a `Choice`, are known.
template <class T, class Choice>
using PointKernel = void (*)(const PairRef<T>*, const Choice*, std::size_t, PointBlock<T>&);

/// Finds the contact points of up to `most_chunk` pairs; calls back as `visit_box_contacts` does.
template <class T, class Choice, class Apart, class Met, class Unknown>
void visit_contacts(PointKernel<T, Choice> points, const PairRef<T>* pairs, const Choice* choices, std::size_t count,
                    const Apart& apart, const Met& met, const Unknown& unknown) {
  // Without unpredictable branches: indices are written either way and kept or overwritten.
  std::uint32_t place[most_chunk], apart_place[most_chunk];
  std::size_t met_count = 0, apart_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool meets = !(choices[i].distance > pairs[i].margin);
    place[met_count] = apart_place[apart_count] = static_cast<std::uint32_t>(i);
    met_count += meets;
    apart_count += !meets;
  }
  for (std::size_t k = 0; k < apart_count; ++k) apart(apart_place[k]);
  PairRef<T> some[block_pairs];
  Choice some_choices[block_pairs];
  T distances[block_pairs];
  BlockRoom<T> room;
  for (std::size_t first = 0; first < met_count; first += block_pairs) {
    const std::size_t size = std::min(block_pairs, met_count - first);
    for (std::size_t k = 0; k < size; ++k) {
      some[k] = pairs[place[first + k]];
      some_choices[k] = choices[place[first + k]];
      distances[k] = some_choices[k].distance;
    }
    visit_points<T>([&](PointBlock<T>& block) { points(some, some_choices, size, block); }, place + first, distances,
                    size, room, met, unknown);
  }
}

/// Finds the contacts of plain boxes and triangles without rounding, as `visit_box_contacts` does; slivers are
/// `unknown`.
template <class T, class Apart, class Met, class Unknown>
void visit_triangle_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Met& met,
                             const Unknown& unknown) {
  const Isa level = chosen_isa();
  TriangleReferenceAxis<T> axes[most_chunk];
  GRAZE_KERNEL(level, triangle_axes<T>)(pairs, count, axes);
  visit_contacts<T, TriangleReferenceAxis<T>>(GRAZE_KERNEL(level, triangle_points<T>), pairs, axes, count, apart, met,
                                              unknown);
}

}  // namespace graze
