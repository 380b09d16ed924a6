// Contacts of many pairs of boxes, or of boxes and triangles, by the kernels for them.
//
// Guarantee: for each pair what `convex_contacts` answers, bit for bit.
#pragma once

#include <algorithm>
#include <bit>

#include "narrow/features.hpp"
#include "narrow/pair_kernels.hpp"
#include "narrow/pairs/box_triangle_manifold.hpp"

namespace graze {

/// Appends the points in the slots of one pair, of which there are at most eight, to `points` (of contact points or of
/// what begins with one), and returns how many. Of two of the same features the deeper one is kept. `slot(i)` gives the
/// i-th slot of the pair, `features_b` what the parts of B name; those of A are a box's.
template <class T, class Slot, class Points>
std::size_t take_points(unsigned filled, const Slot& slot, const std::uint16_t* features_b, Points& points) {
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

/// The points of one of the pairs of a block.
template <class T>
struct BoxPoints {
  const BoxPointBlock<T>& block;
  std::size_t pair;
  const std::uint16_t* features_b;

  /// As `take_points`.
  template <class Points>
  std::size_t append(Points& points) const {
    return take_points<T>(
        static_cast<unsigned>(block.filled[pair]),
        [&](std::size_t i) {
          const auto& slot = block.slots[i];
          return BoxSlot<T>{{slot.a[0][pair], slot.a[1][pair], slot.a[2][pair]},
                            {slot.b[0][pair], slot.b[1][pair], slot.b[2][pair]},
                            slot.distance[pair],
                            slot.part_a[pair],
                            slot.part_b[pair]};
        },
        features_b, points);
  }
};

/// The same with the two in each other's place, where they are `turned`.
template <class T>
struct TurnedPoints {
  const BoxPoints<T>& points;
  bool turned;

  template <class Points>
  std::size_t append(Points& to) const {
    const std::size_t first = to.size(), count = points.append(to);
    for (std::size_t i = first; turned && i < first + count; ++i) {
      ContactPoint<T>& point = to[i];
      point = mirrored(point);
    }
    return count;
  }
};

/// The pairs that a chunk is made of: what is loaded for the axes is still near when the points are found, and those
/// that touch fill several blocks.
inline constexpr std::size_t box_chunk = 128;
/// The most that are asked about at a time. Where most pairs wait for one kernel, as in a world, twice a chunk leaves
/// half as many lanes of the last blocks empty.
inline constexpr std::size_t most_chunk = 2 * box_chunk;

/// The kernels for the contacts of one kind of pairs.
template <class T, class Choice>
struct ContactKernels {
  void (*axes)(const PairRef<T>*, std::size_t, Choice*);
  void (*points)(const PairRef<T>*, const Choice*, std::size_t, BoxPointBlock<T>&);
  const std::uint16_t* features_b;
};

/// Asks kernels about up to `most_chunk` pairs, in this order:
/// `apart(i)` for those further apart than their margins; and then, in the order of the pairs,
/// `touching(i, distance, normal, points)`, the last a `BoxPoints`, or, where their faces do not tell, `unknown(i)`.
template <class T, class Choice, class Apart, class Touching, class Unknown>
void visit_contacts(const ContactKernels<T, Choice>& kernels, const PairRef<T>* pairs, std::size_t count,
                    const Apart& apart, const Touching& touching, const Unknown& unknown) {
  Choice axes[most_chunk];
  kernels.axes(pairs, count, axes);
  // No branch that nobody foresees: places are written either way and kept or written over.
  std::uint8_t place[most_chunk], apart_place[most_chunk];
  std::size_t met_count = 0, apart_count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const bool meets = !(axes[i].distance > pairs[i].margin);
    place[met_count] = apart_place[apart_count] = static_cast<std::uint8_t>(i);
    met_count += meets;
    apart_count += !meets;
  }
  for (std::size_t k = 0; k < apart_count; ++k) apart(apart_place[k]);
  PairRef<T> met[block_pairs];
  Choice met_axes[block_pairs];
  BoxPointBlock<T> block;
  for (std::size_t first = 0; first < met_count; first += block_pairs) {
    const std::size_t size = std::min(block_pairs, met_count - first);
    for (std::size_t k = 0; k < size; ++k) {
      met[k] = pairs[place[first + k]];
      met_axes[k] = axes[place[first + k]];
    }
    kernels.points(met, met_axes, size, block);
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t i = place[first + k];
      if (block.known[k] == T(0)) {
        unknown(i);
        continue;
      }
      touching(i, met_axes[k].distance, Vec3<T>{block.normal[0][k], block.normal[1][k], block.normal[2][k]},
               BoxPoints<T>{block, k, kernels.features_b});
    }
  }
}

/// The same of plain boxes (`plain_box`).
template <class T, class Apart, class Touching, class Unknown>
void visit_box_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Touching& touching,
                        const Unknown& unknown) {
  const Isa level = chosen_isa();
  visit_contacts<T, BoxChoice<T>>(
      {GRAZE_KERNEL(level, box_axes<T>), GRAZE_KERNEL(level, box_points<T>), box_features.of}, pairs, count, apart,
      touching, unknown);
}
/// And of plain boxes and triangles without a margin; slivers are `unknown`.
template <class T, class Apart, class Touching, class Unknown>
void visit_triangle_contacts(const PairRef<T>* pairs, std::size_t count, const Apart& apart, const Touching& touching,
                             const Unknown& unknown) {
  const Isa level = chosen_isa();
  visit_contacts<T, TriangleChoice<T>>(
      {GRAZE_KERNEL(level, triangle_axes<T>), GRAZE_KERNEL(level, triangle_points<T>), triangle_features}, pairs, count,
      apart, touching, unknown);
}

}  // namespace graze
