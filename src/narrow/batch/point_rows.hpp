// Results of lanes for pairs with several points of contact each, as rows of points, pair after pair. Only for
// `*.kernel.cpp`.
//
// Guarantee: the points of a pair in the order of their slots; the same bits at every level. Everything is inlined or
// lives in the namespace of the level.
//
// Pairs have points in different slots, and most slots are empty. So the numbers of points are first compacted, those
// of all pairs of a bundle one behind the other, and all further work is done on points, a full register of them at a
// time, regardless of their pairs.
#pragma once

#include "narrow/batch/point_forms.hpp"

namespace graze::GRAZE_ISA {

/// Some numbers of each point of a bundle, a column each, pair after pair; up to the end of the last register, zeros.
template <class T, std::size_t width>
struct PointColumns {
  using Bits = typename Lanes<T>::Bits;
  static constexpr std::size_t lanes = lanes_of<T>, most = lanes * most_block_points;

  T numbers[width][most + lanes];
  Bits lane[most + lanes];  ///< lane of the point's pair
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

/// Compacts columns of slots to those that are filled: bit i of a lane of `filled` is its slot i.
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

/// In each lane the element of `v` at the index in that lane of `places`.
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

/// Keys of points, equal exactly for two points of one pair with the same parts.
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
  /// Whether any of the first `count` keys comes twice.
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

/// Number of points ahead of those being written whose lines are prefetched, since the next pairs' points are likely to
/// come there.
inline constexpr std::size_t points_ahead = 64;

/// Empties a block before the first bundle.
template <class T, class Form>
[[gnu::always_inline]] inline void clear(PointBlock<T, Form>& block) {
  block.known = block.manifold_count = block.point_count = 0;
  block.any_twice = false;
}

/// Appends the points of a bundle to those of a block. `make(first, points, part_a, part_b)` computes them,
/// `LanePoints` and the numbers of their parts, from the columns beginning with the `first`-th point.
template <class T, std::size_t width, class Make, class Form>
[[gnu::always_inline]] inline void
append_points(const PointColumns<T, width>& columns, const std::uint32_t (&features_a)[most_parts],
              const std::uint32_t (&features_b)[most_parts], const Make& make, PointBlock<T, Form>& block) {
  using BitVector = typename Lanes<T>::BitVector;
  PointKeys<T> keys;
  auto* const to = block.points + block.point_count;
  for (std::size_t first = 0; first < columns.count; first += lanes_of<T>) {
    LanePoints<T> points;
    Lanes<T> part_a, part_b;
    make(first, points, part_a, part_b);
    const BitVector a = __builtin_convertvector(part_a.v, BitVector), b = __builtin_convertvector(part_b.v, BitVector);
    keys.put(first, Lanes<T>::of(__builtin_convertvector(columns.lanes_from(first), typename Lanes<T>::Vector)), part_a,
             part_b);
    fetch_lines<true>(to + first + points_ahead, lanes_of<T>);
    const auto features = [&]() __attribute__((always_inline)) { return feature_ids<T>(features_a, a, features_b, b); };
    put_rows<T>(points, features, to + first);
  }
  block.point_count += static_cast<std::uint32_t>(columns.count);
  if (keys.any_twice(columns.count)) block.any_twice = true;
}

/// Writes the manifolds of a bundle of which `count` lanes are filled, beginning with the block's `first`-th pair.
/// Lanes that are not `known` or hold no pair have no manifold and no points: their bits in `filled` are cleared.
template <class T, class Form>
[[gnu::always_inline]] inline void put_pairs(const Vec3<Lanes<T>>& normal, const Lanes<T>& known, std::size_t first,
                                             std::size_t count, Lanes<T>& filled, PointBlock<T, Form>& block) {
  using S = Lanes<T>;
  using Whole = typename S::BitVector;
  const std::uint32_t here = Chosen<T>::not_less(known, S(1)).bits() & filled_lanes<T>(count);
  const Whole chosen = lanes_with<T>(here);
  // The bits of all lanes are counted at once, by twos, by fours and by eights.
  const Whole bits = __builtin_convertvector(filled.v, Whole) & chosen, twos = bits - (bits >> 1 & 0x55),
              fours = (twos & 0x33) + (twos >> 2 & 0x33), counts = (fours + (fours >> 4)) & 0xf;
  filled = S::of(__builtin_convertvector(bits, typename S::Vector));
  const Whole numbers = ones_before<T>(counts) + static_cast<typename S::Bits>(block.first_point + block.point_count);
  put_manifolds<T>(LaneManifolds<T>{normal, numbers, counts}, here, first, block);
  block.known |= here << first;
  block.manifold_count += static_cast<std::uint32_t>(count_bits(here));
}

}  // namespace graze::GRAZE_ISA
