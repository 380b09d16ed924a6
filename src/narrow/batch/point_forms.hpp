// Manifolds and points from lanes to rows, in each form of a batch's answer: full contacts and compact ones. Only for
// `*.kernel.cpp`.
//
// Guarantee: the bits of a row are the same in each form and at every level. Everything is inlined or lives in the
// namespace of the level.
#pragma once

#include "narrow/batch/layouts.hpp"
#include "narrow/batch/pair_kernels.hpp"
#include "narrow/manifold/features.hpp"
#include "simd/rows.hpp"

namespace graze::GRAZE_ISA {

#if defined(__AVX512F__)
namespace gathering {

/// From each of two registers the lanes 2 k + {0, 1, 8, 9}, for k = 2 `half` and the next, in turn from both.
template <std::size_t half, class V, std::size_t... I>
[[gnu::always_inline]] inline V every_other_two(const V& a, const V& b, std::index_sequence<I...>) {
  return __builtin_shufflevector(a, b, (I % 2 * 16 + 2 * (2 * half + I % 4 / 2) + I / 4 % 2 + I / 8 * 8)...);
}
template <class V>
[[gnu::always_inline]] inline void rows_of_four(const V* columns, V (&out)[4]) {
  const V low01 = every_other_two<0>(columns[0], columns[1], Sixteen()),
          low23 = every_other_two<0>(columns[2], columns[3], Sixteen()),
          high01 = every_other_two<1>(columns[0], columns[1], Sixteen()),
          high23 = every_other_two<1>(columns[2], columns[3], Sixteen());
  out[0] = paired<0>(low01, low23, Sixteen());
  out[1] = paired<1>(low01, low23, Sixteen());
  out[2] = paired<0>(high01, high23, Sixteen());
  out[3] = paired<1>(high01, high23, Sixteen());
}
/// Transposes eight columns to rows in order, two in each register.
template <class V>
[[gnu::always_inline]] inline void rows_of_eight(const V (&columns)[8], V (&rows)[8]) {
  V low[4], high[4];
  rows_of_four(columns, low);
  rows_of_four(columns + 4, high);
  for (std::size_t k = 0; k < 4; ++k) {
    rows[k] = eights<0>(low[k], high[k], Sixteen());
    rows[k + 4] = eights<1>(low[k], high[k], Sixteen());
  }
}

}  // namespace gathering
#endif

/// Integer lanes reinterpreted as a register of numbers.
[[gnu::always_inline]] inline Lanes<float> as_lanes(const Lanes<float>::BitVector& whole) {
  return Lanes<float>::of(reinterpret_cast<Lanes<float>::Vector>(whole));
}
[[gnu::always_inline]] inline Lanes<float> as_lanes(std::uint32_t whole) {
  return as_lanes(Lanes<float>::BitVector{} + static_cast<std::int32_t>(whole));
}

/// The feature numbers of points, from the numbers of their parts.
template <class T>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector
feature_ids(const std::uint32_t (&features_a)[most_parts], const typename Lanes<T>::BitVector& part_a,
            const std::uint32_t (&features_b)[most_parts], const typename Lanes<T>::BitVector& part_b) {
  if constexpr (gathering::sixteen<T>) {
    return looked_up(features_a, part_a) << 16 | looked_up(features_b, part_b);
  } else {
    typename Lanes<T>::BitVector found{};
    for (int i = 0; i < lanes_of<T>; ++i)
      found[i] = static_cast<typename Lanes<T>::Bits>(feature_id(features_a[part_a[i]], features_b[part_b[i]]));
    return found;
  }
}

/// Points in lanes: positions on A and on B, and their distance.
template <class T>
struct LanePoints {
  Lanes<T> a[3], b[3], distance;
};

/// Writes a row for each of the lanes; `features()` returns the feature numbers.
template <class T, class Features>
[[gnu::always_inline]] inline void put_rows(const LanePoints<T>& points, const Features& features,
                                            ContactPoint<T>* to) {
  const typename Lanes<T>::BitVector feature = features();
  if constexpr (sizeof(T) == 4) {
    using V = Lanes<float>::Vector;
    const Lanes<float> names = Lanes<float>::of(reinterpret_cast<V>(feature)), half(0.5f);
#if defined(__AVX512F__)
    const V columns[8] = {points.a[0].v, points.a[1].v, points.a[2].v,     points.b[0].v,
                          points.b[1].v, points.b[2].v, points.distance.v, names.v};
    V rows[8];
    gathering::rows_of_eight(columns, rows);
    gathering::store_packed<9>(rows, half.v, reinterpret_cast<char*>(to), std::make_index_sequence<9>());
#else
    const Lanes<float> columns[9] = {points.a[0], points.a[1],     points.a[2], points.b[0], points.b[1],
                                     points.b[2], points.distance, names,       half};
    store_chosen_rows(columns, Chosen<float>::all, to);
#endif
  } else {
    for (int i = 0; i < lanes_of<T>; ++i) {
      const auto vector = [i](const Lanes<T>(&v)[3]) { return Vec3<T>{v[0][i], v[1][i], v[2][i]}; };
      to[i] = {vector(points.a), vector(points.b), points.distance[i], static_cast<std::uint32_t>(feature[i])};
    }
  }
}

/// Writes compact points. The position is the middle of the two (`ContactPoint::weight`) for all pairs but balls.
template <class T, class Features>
[[gnu::always_inline]] inline void put_rows(const LanePoints<T>& points, const Features&,
                                            typename CompactContacts<T>::Point* to) {
  const Lanes<T> middle(ContactPoint<T>().weight);
  Lanes<T> at[3];
  for (int k = 0; k < 3; ++k) at[k] = points.a[k] + (points.b[k] - points.a[k]) * middle;
  if constexpr (sizeof(T) == 4) {
    scatter(at[0], at[1], at[2], points.distance, to, sizeof *to);
  } else {
    for (int i = 0; i < lanes_of<T>; ++i) to[i] = {{at[0][i], at[1][i], at[2][i]}, points.distance[i]};
  }
}

/// Manifolds in lanes: the normal, the number of the first point, and the number of points.
template <class T>
struct LaneManifolds {
  Vec3<Lanes<T>> normal;
  typename Lanes<T>::BitVector first_point, point_count;
};

/// Writes a row for each lane of `chosen`, behind those of a block; the first lane is its `first`-th pair.
template <class T>
[[gnu::always_inline]] inline void put_manifolds(const LaneManifolds<T>& m, std::uint32_t chosen, std::size_t,
                                                 PointBlock<T>& block) {
  using Group = typename PointBlock<T>::Group;
  Group* to = block.manifolds + block.manifold_count;
  if constexpr (sizeof(T) == 4) {
    const Lanes<float> none = as_lanes(0u);
    const Lanes<float> rows[7] = {
        m.normal.x, m.normal.y, m.normal.z, none, none, as_lanes(m.first_point), as_lanes(m.point_count)};
    store_chosen_rows(rows, chosen, to);
  } else {
    for (int i = 0; i < lanes_of<T>; ++i)
      if ((chosen >> i & 1) != 0)
        *to++ = {{m.normal.x[i], m.normal.y[i], m.normal.z[i]},
                 0,
                 0,
                 static_cast<std::uint32_t>(m.first_point[i]),
                 static_cast<std::uint32_t>(m.point_count[i])};
  }
}
/// Writes compact manifolds; the pairs have the numbers `block.pairs`.
template <class T>
[[gnu::always_inline]] inline void put_manifolds(const LaneManifolds<T>& m, std::uint32_t chosen, std::size_t first,
                                                 CompactBlock<T>& block) {
  using Group = typename CompactBlock<T>::Group;
  Group* to = block.manifolds + block.manifold_count;
  const std::uint32_t* const pairs = block.pairs + first;
  if constexpr (sizeof(T) == 4) {
    Lanes<float>::BitVector numbers;
    std::memcpy(&numbers, pairs, sizeof numbers);
    const Lanes<float> rows[6] = {
        m.normal.x, m.normal.y, m.normal.z, as_lanes(numbers), as_lanes(m.first_point), as_lanes(m.point_count)};
    store_chosen_rows(rows, chosen, to);
  } else {
    for (int i = 0; i < lanes_of<T>; ++i)
      if ((chosen >> i & 1) != 0)
        *to++ = {{m.normal.x[i], m.normal.y[i], m.normal.z[i]},
                 pairs[i],
                 static_cast<std::uint32_t>(m.first_point[i]),
                 static_cast<std::uint32_t>(m.point_count[i])};
  }
}

}  // namespace graze::GRAZE_ISA
