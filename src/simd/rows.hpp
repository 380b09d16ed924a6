// Rows of a few numbers that stand one behind the other in memory: loaded into lanes, a row each, and stored back from
// lanes, also only from chosen ones. Only for `*.kernel.cpp`.
//
// Guarantee: reads the rows of the lanes and nothing behind them; the same bits at every level.
#pragma once

#include "simd/gather.hpp"

namespace graze::GRAZE_ISA {

namespace gathering {

/// The sixteen lanes of a lane type whose registers hold that many.
template <class T>
inline constexpr bool sixteen = sizeof(T) == 4 && lanes_of<T> == 16;

using Sixteen = std::make_index_sequence<16>;

template <class V>
[[gnu::always_inline]] inline V loaded(const float* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Four numbers, from the `first`-th on, of each of four rows of `width` numbers, side by side.
template <std::size_t width, std::size_t first, class V, std::size_t... I>
[[gnu::always_inline]] inline V four_rows(const float* from, std::index_sequence<I...>) {
  if constexpr (width == 4) {
    static_assert(first == 0);
    return loaded<V>(from);
  } else {
    // All of the four stands in the first sixteen numbers and the last sixteen.
    constexpr std::size_t behind = 4 * width - 16;
    static_assert(behind <= 16);
    return __builtin_shufflevector(loaded<V>(from), loaded<V>(from + behind),
                                   (I / 4 * width + first + I % 4 < 16
                                        ? I / 4 * width + first + I % 4
                                        : I / 4 * width + first + I % 4 - behind + 16)...);
  }
}
template <class V, std::size_t... I>
[[gnu::always_inline]] inline V every_fourth_lane_first(const V& v, std::index_sequence<I...>) {
  return __builtin_shufflevector(v, v, (I % 4 * 4 + I / 4)...);
}
/// The `k`-th numbers of rows of three that fill three registers.
template <std::size_t k, class V, std::size_t... I>
[[gnu::always_inline]] inline V of_threes(const V& r0, const V& r1, const V& r2, std::index_sequence<I...>) {
  const V low = __builtin_shufflevector(r0, r1, (3 * I + k < 32 ? 3 * I + k : I)...);
  return __builtin_shufflevector(low, r2, (3 * I + k < 32 ? I : 3 * I + k - 16)...);
}
/// The `part`-th of the three registers that rows of three fill.
template <std::size_t part, class V, std::size_t... I>
[[gnu::always_inline]] inline V as_threes(const V& a, const V& b, const V& c, std::index_sequence<I...>) {
  constexpr std::size_t n = sizeof...(I), first = part * n;
  const V two = __builtin_shufflevector(a, b, ((first + I) / 3 + (first + I) % 3 % 2 * n)...);
  return __builtin_shufflevector(two, c, ((first + I) % 3 == 2 ? (first + I) / 3 + n : I)...);
}

/// `numbers`, each `by` lanes further up.
template <std::size_t by, class V, std::size_t... I>
[[gnu::always_inline]] inline V moved_up(const V& numbers, std::index_sequence<I...>) {
  constexpr std::size_t n = sizeof...(I);
  return __builtin_shufflevector(numbers, V{}, (I < by ? n : I - by)...);
}
template <std::size_t by, class V, std::size_t... I>
[[gnu::always_inline]] inline V summed_up(const V& numbers, std::index_sequence<I...> all) {
  if constexpr (by >= sizeof...(I))
    return numbers;
  else
    return summed_up<2 * by>(numbers + moved_up<by>(numbers, all), all);
}

}  // namespace gathering

/// `count` <= 4 numbers from the `first`-th on of each lane's row of `width` numbers, each number in a `Lanes` of its
/// own. The rows stand one behind the other.
template <std::size_t width, std::size_t first, class T, std::size_t count>
[[gnu::always_inline]] inline void load_rows(const void* from, Lanes<T> (&out)[count]) {
  static_assert(first + count <= width);
  using namespace gathering;
  if constexpr (sixteen<T> && width == 3) {
    using V = typename Lanes<T>::Vector;
    const auto* const numbers = static_cast<const float*>(from);
    const V r0 = loaded<V>(numbers), r1 = loaded<V>(numbers + 16), r2 = loaded<V>(numbers + 32);
    out[0] = Lanes<T>::of(of_threes<first>(r0, r1, r2, Sixteen()));
    if constexpr (count > 1) out[1] = Lanes<T>::of(of_threes<first + 1>(r0, r1, r2, Sixteen()));
    if constexpr (count > 2) out[2] = Lanes<T>::of(of_threes<first + 2>(r0, r1, r2, Sixteen()));
  } else if constexpr (sixteen<T> && width <= 8) {
    using V = typename Lanes<T>::Vector;
    static_assert(first + 4 <= width);
    const auto* const numbers = static_cast<const float*>(from);
    V columns[4];
    transpose(four_rows<width, first, V>(numbers, Sixteen()),
              four_rows<width, first, V>(numbers + 4 * width, Sixteen()),
              four_rows<width, first, V>(numbers + 8 * width, Sixteen()),
              four_rows<width, first, V>(numbers + 12 * width, Sixteen()), columns, Sixteen());
    for (std::size_t k = 0; k < count; ++k) out[k] = Lanes<T>::of(every_fourth_lane_first(columns[k], Sixteen()));
  } else {
    const auto row = [from](std::size_t lane) __attribute__((always_inline)) {
      return static_cast<const char*>(from) + lane * width * sizeof(T);
    };
    gather<T>(row, first * sizeof(T), out);
  }
}

/// Writes three numbers of each lane, a row of three for each, one behind the other.
[[gnu::always_inline]] inline void store_threes(const Lanes<float>& x, const Lanes<float>& y, const Lanes<float>& z,
                                                void* to) {
  using namespace gathering;
  constexpr auto all = std::make_index_sequence<lanes_of<float>>();
  const auto store = [to](std::size_t at, const Lanes<float>::Vector& v) __attribute__((always_inline)) {
    std::memcpy(static_cast<char*>(to) + at * sizeof v, &v, sizeof v);
  };
  store(0, as_threes<0>(x.v, y.v, z.v, all));
  store(1, as_threes<1>(x.v, y.v, z.v, all));
  store(2, as_threes<2>(x.v, y.v, z.v, all));
}

#if defined(__AVX512F__)
namespace gathering {

/// The `half`-th two of the fours in `a`, each with that in `b` behind it.
template <std::size_t half, class V, std::size_t... I>
[[gnu::always_inline]] inline V eights(const V& a, const V& b, std::index_sequence<I...>) {
  return __builtin_shufflevector(a, b, (I / 4 % 2 * 16 + (2 * half + I / 8) * 4 + I % 4)...);
}
/// The `part`-th sixteen numbers of rows of `width`. The first eight of each row stand two rows to a register, and the
/// ninth of all rows in `ninth`.
template <std::size_t width, std::size_t part, class V, std::size_t... I>
[[gnu::always_inline]] inline V packed_rows(const V (&pairs)[8], const V& ninth, std::index_sequence<I...>) {
  constexpr std::size_t first = 16 * part / width / 2, second = first < 7 ? first + 1 : 7;
  static_assert((16 * part + 15) / width / 2 <= second);
  const V eight = __builtin_shufflevector(
      pairs[first], pairs[second],
      ((16 * part + I) / width % 2 * 8 + (16 * part + I) % width % 8 + ((16 * part + I) / width / 2 - first) * 16)...);
  if constexpr (width <= 8)
    return eight;
  else
    return __builtin_shufflevector(eight, ninth, ((16 * part + I) % width < 8 ? I : (16 * part + I) / width + 16)...);
}
template <std::size_t width, class V, std::size_t... part>
[[gnu::always_inline]] inline void store_packed(const V (&pairs)[8], const V& ninth, char* to,
                                                std::index_sequence<part...>) {
  const auto store = [to](std::size_t at, const V& v) __attribute__((always_inline)) {
    std::memcpy(to + at * sizeof v, &v, sizeof v);
  };
  (store(part, packed_rows<width, part>(pairs, ninth, Sixteen())), ...);
}

}  // namespace gathering
#endif

/// Writes rows of `width` numbers, 5 to 9, of the lanes whose bits are set, one behind the other in the order of the
/// lanes. As many rows as there are lanes may be written; those behind the chosen ones are of no meaning.
template <std::size_t width>
[[gnu::always_inline]] inline void store_chosen_rows(const Lanes<float> (&columns)[width], std::uint32_t bits,
                                                     void* to) {
  static_assert(width >= 5 && width <= 9);
  using namespace gathering;
#if defined(__AVX512F__)
  using V = Lanes<float>::Vector;
  const __m512i ordered = _mm512_maskz_compress_epi32(
      static_cast<__mmask16>(bits), _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
  // The order by which the rows that come to stand in one register follow each other.
  const __m512i places = _mm512_maskz_permutexvar_epi32(
      0xffff, _mm512_setr_epi32(0, 2, 4, 6, 1, 3, 5, 7, 8, 10, 12, 14, 9, 11, 13, 15), ordered);
  const auto chosen = [](const Lanes<float>& v, const __m512i& from) __attribute__((always_inline)) {
    return reinterpret_cast<V>(_mm512_maskz_permutexvar_ps(0xffff, from, reinterpret_cast<__m512>(v.v)));
  };
  V numbers[8];
  for (std::size_t k = 0; k < 8; ++k) numbers[k] = k < width ? chosen(columns[k], places) : V{};
  V low[4], high[4], pairs[8];
  transpose(numbers[0], numbers[1], numbers[2], numbers[3], low, Sixteen());
  transpose(numbers[4], numbers[5], numbers[6], numbers[7], high, Sixteen());
  for (std::size_t k = 0; k < 4; ++k) {
    pairs[k] = eights<0>(low[k], high[k], Sixteen());
    pairs[k + 4] = eights<1>(low[k], high[k], Sixteen());
  }
  store_packed<width>(pairs, width > 8 ? chosen(columns[width - 1], ordered) : V{}, static_cast<char*>(to),
                      std::make_index_sequence<width>());
#else
  // Rows of lanes that are not chosen are written over by the next one.
  constexpr std::size_t lanes = lanes_of<float>;
  for (std::size_t first = 0; first < width; first += 4) {
    const std::size_t from = first + 4 <= width ? first : width - 4;
    typename Vector<float, lanes>::type rows[4];
    transpose(columns[from].v, columns[from + 1].v, columns[from + 2].v, columns[from + 3].v, rows,
              std::make_index_sequence<lanes>());
    char* at = static_cast<char*>(to) + from * sizeof(float);
    for (std::size_t i = 0; i < lanes; ++i) {
      std::memcpy(at, reinterpret_cast<const float*>(&rows[i % 4]) + i / 4 * 4, 16);
      at += bits >> i & 1 ? width * sizeof(float) : 0;
    }
  }
#endif
}

/// A vector of -1 in the lanes whose bits are set, and 0 in the others.
template <class T, std::size_t... I>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector lanes_with(std::uint32_t bits, std::index_sequence<I...>) {
  using Whole = typename Lanes<T>::BitVector;
  return ((Whole{} + static_cast<typename Lanes<T>::Bits>(bits)) & Whole{(1 << I)...}) != Whole{};
}
template <class T>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector lanes_with(std::uint32_t bits) {
  return lanes_with<T>(bits, std::make_index_sequence<lanes_of<T>>());
}
/// For each lane the number of lanes before it that hold a one; the others hold zeros.
template <class T>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector ones_before(const typename Lanes<T>::BitVector& ones) {
  return gathering::summed_up<1>(ones, std::make_index_sequence<lanes_of<T>>()) - ones;
}

/// The numbers of a table at the places that the lanes hold.
template <std::size_t size>
[[gnu::always_inline]] inline Lanes<float>::BitVector looked_up(const std::uint32_t (&table)[size],
                                                                const Lanes<float>::BitVector& places) {
#if defined(__AVX512F__)
  static_assert(size == 16 || size == 64);
  const auto at = reinterpret_cast<__m512i>(places);
  if constexpr (size == 16) {
    return reinterpret_cast<Lanes<float>::BitVector>(
        _mm512_maskz_permutexvar_epi32(static_cast<__mmask16>(0xffff), at, _mm512_loadu_si512(table)));
  } else {
    const auto half = [&](const std::uint32_t* from) __attribute__((always_inline)) {
      return _mm512_permutex2var_epi32(_mm512_loadu_si512(from), at, _mm512_loadu_si512(from + 16));
    };
    const __mmask16 upper = _mm512_test_epi32_mask(at, _mm512_set1_epi32(32));
    return reinterpret_cast<Lanes<float>::BitVector>(_mm512_mask_blend_epi32(upper, half(table), half(table + 32)));
  }
#else
  Lanes<float>::BitVector found{};
  for (int i = 0; i < lanes_of<float>; ++i) found[i] = static_cast<std::int32_t>(table[places[i]]);
  return found;
#endif
}

}  // namespace graze::GRAZE_ISA
