// What lanes find of pairs with several points of contact each, as rows of points, pair after pair. Only for
// `*.kernel.cpp`.
//
// Guarantee: the points of a pair in the order of their slots; the same bits at every level. Everything is inlined or
// lives in the namespace of the level.
//
// Pairs have points in different slots, and most slots are empty. So what a point is made of is put together first,
// those of all pairs of a bundle one behind the other, and what is left to do is done to points, a full register of
// them at a time, whoever's they are.
#pragma once

#include "narrow/batch/pair_kernels.hpp"
#include "narrow/manifold/features.hpp"
#include "simd/rows.hpp"

namespace graze::GRAZE_ISA {

/// Some numbers of each point of a bundle, a column each, pair after pair; up to the end of the last register, zeros.
template <class T, std::size_t width>
struct PointColumns {
  using Bits = typename Lanes<T>::Bits;
  static constexpr std::size_t lanes = lanes_of<T>, most = lanes * most_block_points;

  T numbers[width][most + lanes];
  Bits lane[most + lanes];  ///< whose point it is
  std::size_t count;

  [[gnu::always_inline]] Lanes<T> operator()(std::size_t column, std::size_t first) const {
    return Lanes<T>::load(numbers[column] + first);
  }
  [[gnu::always_inline]] typename Lanes<T>::BitVector lanes_from(std::size_t first) const {
    typename Lanes<T>::BitVector v;
    std::memcpy(&v, lane + first, sizeof v);
    return v;
  }
};

#if defined(__AVX512F__)
namespace gathering {

/// Of two registers, of every four lanes 2 k + {0, 1, 8, 9}, for k = 2 `half` and the next, those of both by turns.
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
/// Of eight columns the rows, two in each register, in their order.
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

/// Puts columns of slots together, of the slots that are filled: bit i of a lane of `filled` is its slot i.
template <class T, std::size_t width>
[[gnu::always_inline]] inline void put_together(const Lanes<T>* const (&slots)[width], const Lanes<T>& filled,
                                                PointColumns<T, width>& to) {
  constexpr std::size_t lanes = lanes_of<T>;
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 4) {
    using namespace gathering;
    using V = typename Lanes<T>::Vector;
    std::uint16_t two[8];
    const __m128i bytes =
        _mm512_maskz_cvtepi32_epi8(0xffff, _mm512_maskz_cvttps_epi32(0xffff, reinterpret_cast<__m512>(filled.v)));
    std::memcpy(two, &bytes, sizeof two);
    std::size_t first[9];
    first[0] = 0;
    for (std::size_t k = 0; k < 8; ++k) first[k + 1] = first[k] + static_cast<std::size_t>(count_bits(two[k]));
    to.count = first[8];
    for (std::size_t column = 0; column < width; ++column) {
      V columns[8], rows[8];
      for (std::size_t i = 0; i < 8; ++i) columns[i] = slots[column][i].v;
      rows_of_eight(columns, rows);
      for (std::size_t k = 0; k < 8; ++k)
        _mm512_storeu_ps(to.numbers[column] + first[k],
                         _mm512_maskz_compress_ps(two[k], reinterpret_cast<__m512>(rows[k])));
      _mm512_storeu_ps(to.numbers[column] + first[8], _mm512_setzero_ps());
    }
    for (std::size_t k = 0; k < 8; ++k) {
      const int lane = static_cast<int>(2 * k);
      _mm512_storeu_si512(
          to.lane + first[k],
          _mm512_maskz_compress_epi32(two[k], _mm512_mask_set1_epi32(_mm512_set1_epi32(lane), 0xff00, lane + 1)));
    }
    _mm512_storeu_si512(to.lane + first[8], _mm512_setzero_si512());
    return;
  }
#endif
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    auto bits = static_cast<unsigned>(static_cast<int>(filled[static_cast<int>(lane)]));
    for (; bits != 0; bits &= bits - 1, ++count) {
      const Lanes<T>* const* slot = slots;
      const auto i = static_cast<std::size_t>(__builtin_ctz(bits));
      for (std::size_t column = 0; column < width; ++column)
        std::memcpy(&to.numbers[column][count], reinterpret_cast<const T*>(slot[column] + i) + lane, sizeof(T));
      to.lane[count] = static_cast<typename Lanes<T>::Bits>(lane);
    }
  }
  to.count = count;
  for (std::size_t k = count; k < count + lanes; ++k) {
    for (std::size_t column = 0; column < width; ++column) to.numbers[column][k] = T(0);
    to.lane[k] = 0;
  }
}

/// In each lane that one of `v` whose place it holds.
template <class T>
[[gnu::always_inline]] inline Lanes<T> lanes_at(const Lanes<T>& v, const typename Lanes<T>::BitVector& places) {
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 4)
    return Lanes<T>::of(reinterpret_cast<typename Lanes<T>::Vector>(
        _mm512_maskz_permutexvar_ps(0xffff, reinterpret_cast<__m512i>(places), reinterpret_cast<__m512>(v.v))));
  else
    return Lanes<T>::of(reinterpret_cast<typename Lanes<T>::Vector>(
        _mm512_maskz_permutexvar_pd(0xff, reinterpret_cast<__m512i>(places), reinterpret_cast<__m512d>(v.v))));
#else
#if defined(__AVX2__)
  if constexpr (sizeof(T) == 4)
    return Lanes<T>::of(reinterpret_cast<typename Lanes<T>::Vector>(
        _mm256_permutevar8x32_ps(reinterpret_cast<__m256>(v.v), reinterpret_cast<__m256i>(places))));
#endif
  T from[lanes_of<T>];
  v.store(from);
  Lanes<T> found;
  for (int i = 0; i < lanes_of<T>; ++i) found.set(i, from[places[i]]);
  return found;
#endif
}

/// The numbers of features of points, by the numbers of their parts.
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

/// Points in lanes: where on A and on B, and how far apart.
template <class T>
struct LanePoints {
  Lanes<T> a[3], b[3], distance;
};

/// Writes a row for each of the lanes.
template <class T>
[[gnu::always_inline]] inline void put_rows(const LanePoints<T>& points, const typename Lanes<T>::BitVector& feature,
                                            ContactPoint<T>* to) {
  if constexpr (sizeof(T) == 4) {
    static_assert(sizeof(ContactPoint<T>) == 36 && offsetof(ContactPoint<T>, feature) == 28);
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

/// Numbers of points, of which two are the same where both are of one pair and have the same parts.
template <class T>
class PointKeys {
  using S = Lanes<T>;
  static constexpr std::size_t lanes = lanes_of<T>, most = lanes * most_block_points;
  static constexpr T none = T(-1);

 public:
  [[gnu::always_inline]] PointKeys() {
    for (std::size_t k = 0; k < most_block_points; ++k) keys_[k] = none;
  }
  [[gnu::always_inline]] void put(std::size_t first, const S& lane, const S& part_a, const S& part_b) {
    ((lane * S(T(most_parts)) + part_a) * S(T(most_parts)) + part_b).store(keys_ + (most_block_points + first));
  }
  /// Whether any of the first so many comes twice.
  [[gnu::always_inline]] bool any_twice(std::size_t count) {
    for (std::size_t k = 0; k < lanes; ++k) keys_[most_block_points + count + k] = none - T(1 + k);
    typename S::Mask twice = S(none) < S(none);
    for (std::size_t first = 0; first < count; first += lanes) {
      const S here = S::load(keys_ + (most_block_points + first));
      // A pair has no more points than that.
      for (std::size_t back = 1; back < most_block_points; ++back)
        twice = twice | (here == S::load(keys_ + (most_block_points + first - back)));
    }
    return any(twice);
  }

 private:
  T keys_[most_block_points + most + lanes];
};

/// Points ahead of those that are written, whose lines are fetched: those of the next pairs are likely to come there.
inline constexpr std::size_t points_ahead = 64;

/// Before the first bundle.
template <class T>
[[gnu::always_inline]] inline void clear(PointBlock<T>& block) {
  block.known = block.manifold_count = block.point_count = 0;
  block.any_twice = false;
}

/// Appends the points of a bundle to those of a block, as `make(columns, first)` makes them of the columns from the
/// `first`-th point on: `LanePoints` and the numbers of their parts.
template <class T, std::size_t width, class Make>
[[gnu::always_inline]] inline void
append_points(const PointColumns<T, width>& columns, const std::uint32_t (&features_a)[most_parts],
              const std::uint32_t (&features_b)[most_parts], const Make& make, PointBlock<T>& block) {
  using BitVector = typename Lanes<T>::BitVector;
  PointKeys<T> keys;
  ContactPoint<T>* const to = block.points + block.point_count;
  for (std::size_t first = 0; first < columns.count; first += lanes_of<T>) {
    LanePoints<T> points;
    Lanes<T> part_a, part_b;
    make(first, points, part_a, part_b);
    const BitVector a = __builtin_convertvector(part_a.v, BitVector), b = __builtin_convertvector(part_b.v, BitVector);
    keys.put(first, Lanes<T>::of(__builtin_convertvector(columns.lanes_from(first), typename Lanes<T>::Vector)), part_a,
             part_b);
    fetch_lines<true>(to + first + points_ahead, lanes_of<T>);
    put_rows<T>(points, feature_ids<T>(features_a, a, features_b, b), to + first);
  }
  block.point_count += static_cast<std::uint32_t>(columns.count);
  if (keys.any_twice(columns.count)) block.any_twice = true;
}

/// Writes the manifolds of a bundle of which `count` lanes are filled, the first with the block's `first`-th pair.
/// Those that are not `known` have none and no points, nor have lanes without a pair: of these slots `filled` becomes
/// empty.
template <class T>
[[gnu::always_inline]] inline void put_pairs(const Vec3<Lanes<T>>& normal, const Lanes<T>& known, std::size_t first,
                                             std::size_t count, Lanes<T>& filled, PointBlock<T>& block) {
  using S = Lanes<T>;
  using Whole = typename S::BitVector;
  using Group = typename BatchContacts<T>::Group;
  const std::uint32_t here = Chosen<T>::not_less(known, S(1)).bits() & filled_lanes<T>(count);
  const Whole chosen = lanes_with<T>(here);
  // The bits of all lanes are counted at once, by twos, by fours and by eights.
  const Whole bits = __builtin_convertvector(filled.v, Whole) & chosen, twos = bits - (bits >> 1 & 0x55),
              fours = (twos & 0x33) + (twos >> 2 & 0x33), counts = (fours + (fours >> 4)) & 0xf;
  filled = S::of(__builtin_convertvector(bits, typename S::Vector));
  Group* to = block.manifolds + block.manifold_count;
  std::uint32_t point = block.first_point + block.point_count;
  if constexpr (sizeof(T) == 4) {
    static_assert(sizeof(Group) == 28 && offsetof(Group, piece_a) == 12 && offsetof(Group, first_point) == 20);
    const auto as_lanes = [](const Whole& whole) __attribute__((always_inline)) {
      return S::of(reinterpret_cast<typename S::Vector>(whole));
    };
    const S none = as_lanes(Whole{});
    const S group[7] = {normal.x,
                        normal.y,
                        normal.z,
                        none,
                        none,
                        as_lanes(ones_before<T>(counts) + static_cast<std::int32_t>(point)),
                        as_lanes(counts)};
    store_chosen_rows(group, here, to);
  } else {
    for (int i = 0; i < lanes_of<T>; ++i) {
      if ((here >> i & 1) == 0) continue;
      const auto size = static_cast<std::uint32_t>(counts[i]);
      *to++ = {{normal.x[i], normal.y[i], normal.z[i]}, 0, 0, point, size};
      point += size;
    }
  }
  block.known |= here << first;
  block.manifold_count += static_cast<std::uint32_t>(count_bits(here));
}

}  // namespace graze::GRAZE_ISA
