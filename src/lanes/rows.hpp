// Rows of a few numbers that stand one behind the other in memory: into lanes, a row each, and lanes back to rows, also
// only those that are chosen. Only for `*.kernel.cpp`.
//
// Guarantee: reads the rows of the lanes and nothing behind them; the same bits at every level.
#pragma once

#include "lanes/gather.hpp"

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

/// Of four rows of `width` numbers, four each from the `first`-th on, side by side.
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
  const typename Lanes<float>::Vector rows[3] = {as_threes<0>(x.v, y.v, z.v, all), as_threes<1>(x.v, y.v, z.v, all),
                                                 as_threes<2>(x.v, y.v, z.v, all)};
  std::memcpy(to, rows, sizeof rows);
}

/// Writes four numbers of each lane whose bit is set, the rows `stride` bytes apart and in the order of the lanes. May
/// write as many rows as there are lanes, of no matter what behind those.
[[gnu::always_inline]] inline void scatter_chosen(const Lanes<float>& x, const Lanes<float>& y, const Lanes<float>& z,
                                                  const Lanes<float>& w, std::uint32_t bits, void* to,
                                                  std::size_t stride) {
#if defined(__AVX512F__)
  const auto chosen = [bits](const Lanes<float>& v) __attribute__((always_inline)) {
    return Lanes<float>::of(reinterpret_cast<Lanes<float>::Vector>(
        _mm512_maskz_compress_ps(static_cast<__mmask16>(bits), reinterpret_cast<__m512>(v.v))));
  };
  scatter(chosen(x), chosen(y), chosen(z), chosen(w), to, stride);
#else
  using namespace gathering;
  constexpr std::size_t lanes = lanes_of<float>;
  typename FloatVector<lanes>::type rows[4];
  transpose(x.v, y.v, z.v, w.v, rows, std::make_index_sequence<lanes>());
  char* at = static_cast<char*>(to);
  for (std::size_t i = 0; i < lanes; ++i) {
    std::memcpy(at, reinterpret_cast<const float*>(&rows[i % 4]) + i / 4 * 4, 16);
    at += bits >> i & 1 ? stride : 0;
  }
#endif
}

/// The lanes whose bits are set hold -1, the others 0.
template <class T, std::size_t... I>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector lanes_with(std::uint32_t bits, std::index_sequence<I...>) {
  using Whole = typename Lanes<T>::BitVector;
  return ((Whole{} + static_cast<typename Lanes<T>::Bits>(bits)) & Whole{(1 << I)...}) != Whole{};
}
template <class T>
[[gnu::always_inline]] inline typename Lanes<T>::BitVector lanes_with(std::uint32_t bits) {
  return lanes_with<T>(bits, std::make_index_sequence<lanes_of<T>>());
}
/// For each lane how many of the lanes before it hold a one; the others hold zeros.
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
  const __m512i at = reinterpret_cast<__m512i>(places);
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
