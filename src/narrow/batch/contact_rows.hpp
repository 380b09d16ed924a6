// Results of lanes for pairs with one point of contact at most, as rows of a batch's answer. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/point_forms.hpp"
#include "narrow/batch/row_bundle.hpp"
#include "narrow/manifold/features.hpp"
#include "narrow/pairs/segment_lanes.hpp"
#include "simd/rows.hpp"

namespace graze::GRAZE_ISA {

/// The contacts of a bundle.
template <class T>
struct LaneContacts {
  using Names = typename Lanes<T>::BitVector;

  CoreDistance<Lanes<T>> at;
  Names feature;
  Lanes<T> weight;

  [[gnu::always_inline]] LaneContacts mirrored() const {
    using Bits = typename Lanes<T>::Bits;
    constexpr Bits low = static_cast<Bits>(0xffffu), high = static_cast<Bits>(0xffff0000u);
    return {graze::mirrored(at), (feature << 16 & high) | (feature >> 16 & low), Lanes<T>(1) - weight};
  }
};

/// Writes the entries of the pairs of a bundle of which `count` lanes are filled; the lanes of `touching` have a
/// manifold, the first of them number `first`.
template <class T>
[[gnu::always_inline]] inline void put_pairs(const Lanes<T>& distance, std::uint32_t touching, std::size_t count,
                                             std::uint32_t first, typename BatchContacts<T>::Pair* to) {
  using Entry = typename BatchContacts<T>::Pair;
  if constexpr (sizeof(T) == 4) {
    using Whole = Lanes<float>::BitVector;
    const Whole ones = lanes_with<float>(touching) & 1;
    const Whole overlapping = reinterpret_cast<Whole>(distance.v <= typename Lanes<T>::Vector{}) & ones;
    const Whole numbers = ones_before<float>(ones) + static_cast<std::int32_t>(first);
    const auto store = [&](Entry * place) __attribute__((always_inline)) {
      store_threes(as_lanes(overlapping), as_lanes(numbers), as_lanes(ones), place);
    };
    if (count == static_cast<std::size_t>(lanes_of<T>)) return store(to);
    Entry some[lanes_of<float>];
    store(some);
    for (std::size_t i = 0; i < count; ++i) to[i] = some[i];
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t touches = touching >> i & 1;
      to[i] = {touches != 0 && distance[static_cast<int>(i)] <= T(0), first, touches};
      first += touches;
    }
  }
}

/// Writes a manifold with its point for each touching lane; points are numbered from `first_point` on.
template <class T>
[[gnu::always_inline]] inline void put_points(const LaneContacts<T>& found, std::uint32_t touching,
                                              std::uint32_t first_point, typename BatchContacts<T>::Group* manifolds,
                                              ContactPoint<T>* points) {
  const CoreDistance<Lanes<T>>& at = found.at;
  if constexpr (sizeof(T) == 4) {
    const Lanes<float> zero = as_lanes(0u), one = as_lanes(1u), feature = as_lanes(found.feature);
    const Lanes<float> number =
        as_lanes(ones_before<float>(lanes_with<float>(touching) & 1) + static_cast<std::int32_t>(first_point));
    const Lanes<float> group[7] = {at.normal.x, at.normal.y, at.normal.z, zero, zero, number, one};
    const Lanes<float> point[9] = {at.a.x, at.a.y, at.a.z, at.b.x, at.b.y, at.b.z, at.distance, feature, found.weight};
    store_chosen_rows(group, touching, manifolds);
    store_chosen_rows(point, touching, points);
  } else {
    const auto vector = [](const Vec3<Lanes<T>>& v, int i) { return Vec3<T>{v.x[i], v.y[i], v.z[i]}; };
    for (int i = 0; i < lanes_of<T>; ++i) {
      if ((touching >> i & 1) == 0) continue;
      *manifolds++ = {vector(at.normal, i), 0, 0, first_point++, 1};
      *points++ = {vector(at.a, i), vector(at.b, i), at.distance[i], static_cast<std::uint32_t>(found.feature[i]),
                   found.weight[i]};
    }
  }
}

/// Writes the results of a bundle whose first pair is the `first`-th, and adds to the counts. The lanes of `unknown`
/// must not be in `touching`.
template <class T>
[[gnu::always_inline]] inline void put(const LaneContacts<T>& found, std::uint32_t touching, std::uint32_t unknown,
                                       std::size_t first, std::size_t count, const ContactRows<T>& to,
                                       RowCounts& counts) {
  put_pairs<T>(found.at.distance, touching, count, to.first_manifold + counts.touching, to.pairs + first);
  put_points<T>(found, touching, to.first_point + counts.touching, to.manifolds + counts.touching,
                to.points + counts.touching);
  counts.touching += static_cast<std::uint32_t>(count_bits(touching));
  append_places(unknown, first, to.unknown, counts.unknown);
}

}  // namespace graze::GRAZE_ISA
