// Additions to `Wide` for kernels: the width of their level, the lanes a comparison holds in as bits, and a store of
// chosen lanes. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level, so that no code for one instruction set is
// left where another's is called.
#pragma once

#include <cstdint>
#include <utility>

#include "graze/wide.hpp"
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#ifndef GRAZE_ISA
#error "for kernels, which cmake/GrazeKernels.cmake compiles"
#endif

#if defined(__x86_64__)
namespace graze {

/// The lanes of a mask that are set, as bits: for `any` and `all`, where one instruction gives them.
template <class M>
requires(sizeof(M) == 16 && M::lanes >= 2) [[gnu::always_inline]] inline std::uint32_t set_lanes(const M& mask) {
  if constexpr (M::lanes == 4)
    return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask.bits)));
  else
    return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask.bits)));
}
#if defined(__AVX2__)
template <class M>
requires(sizeof(M) == 32 && M::lanes >= 4) [[gnu::always_inline]] inline std::uint32_t set_lanes(const M& mask) {
  if constexpr (M::lanes == 8)
    return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask.bits)));
  else
    return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask.bits)));
}
#endif
#if defined(__AVX512F__)
template <class M>
requires(sizeof(M) == 64 && M::lanes >= 8) [[gnu::always_inline]] inline std::uint32_t set_lanes(const M& mask) {
  if constexpr (M::lanes == 16)
    return _mm512_movepi32_mask(reinterpret_cast<__m512i>(mask.bits));
  else
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask.bits));
}
#endif

}  // namespace graze
#endif

namespace graze::GRAZE_ISA {

/// Bytes of the level's registers: wider vectors than the hardware's are slow in g++.
#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX2__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif

template <class T>
inline constexpr int lanes_of = register_bytes / static_cast<int>(sizeof(T));

/// Lanes of T, as many as a register holds.
template <class T>
using Lanes = Wide<T, lanes_of<T>>;

/// The lanes of a mask that are set, as bits: lane i is bit i.
template <class M>
[[gnu::always_inline]] inline std::uint32_t bits_of(const M& mask) {
  if constexpr (requires { set_lanes(mask); }) {
    return set_lanes(mask);
  } else {
    std::uint32_t bits = 0;
    for (int i = 0; i < M::lanes; ++i) bits |= static_cast<std::uint32_t>(mask[i]) << i;
    return bits;
  }
}

/// The lanes in double: the `part`-th of the registers that they fill.
template <std::size_t part, std::size_t... I>
[[gnu::always_inline]] inline Lanes<double> lanes_in_double(const Lanes<float>& x, std::index_sequence<I...>) {
  return Lanes<double>::of(__builtin_convertvector(__builtin_shufflevector(x.v, x.v, (part * sizeof...(I) + I)...),
                                                   typename Lanes<double>::Vector));
}
template <std::size_t part>
[[gnu::always_inline]] inline Lanes<double> lanes_in_double(const Lanes<float>& x) {
  return lanes_in_double<part>(x, std::make_index_sequence<lanes_of<double>>());
}
template <std::size_t part>
[[gnu::always_inline]] inline Lanes<double> lanes_in_double(const Lanes<double>& x) {
  static_assert(part == 0);
  return x;
}

/// The lanes in which comparisons hold, joined by &. AVX-512 compares into registers of bits; elsewhere whole lanes are
/// joined, since turning them into bits is the expensive part.
template <class T>
class Chosen {
 public:
  static constexpr std::uint32_t all = (std::uint32_t{1} << lanes_of<T>)-1;

  /// The lanes in which a <= b.
  [[gnu::always_inline]] static Chosen at_most(const Lanes<T>& a, const Lanes<T>& b) {
    Chosen c;
#if defined(__AVX512F__)
    if constexpr (sizeof(T) == 4)
      c.mask_ = _mm512_cmp_ps_mask(reinterpret_cast<__m512>(a.v), reinterpret_cast<__m512>(b.v), _CMP_LE_OQ);
    else
      c.mask_ = _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a.v), reinterpret_cast<__m512d>(b.v), _CMP_LE_OQ);
#else
    c.mask_ = a <= b;
#endif
    return c;
  }
  /// The lanes in which a is not less than b, also where either is no number.
  [[gnu::always_inline]] static Chosen not_less(const Lanes<T>& a, const Lanes<T>& b) {
    Chosen c;
#if defined(__AVX512F__)
    if constexpr (sizeof(T) == 4)
      c.mask_ = _mm512_cmp_ps_mask(reinterpret_cast<__m512>(a.v), reinterpret_cast<__m512>(b.v), _CMP_NLT_UQ);
    else
      c.mask_ = _mm512_cmp_pd_mask(reinterpret_cast<__m512d>(a.v), reinterpret_cast<__m512d>(b.v), _CMP_NLT_UQ);
#else
    c.mask_ = !(a < b);
#endif
    return c;
  }
  /// The lanes in which the numbers from `at` on have no bit in common with `bits`.
  [[gnu::always_inline]] static Chosen disjoint(const typename Lanes<T>::Bits* at, typename Lanes<T>::Bits bits) {
    Chosen c;
#if defined(__AVX512F__)
    if constexpr (sizeof(T) == 4)
      c.mask_ = _mm512_testn_epi32_mask(_mm512_loadu_si512(at), _mm512_set1_epi32(bits));
    else
      c.mask_ = _mm512_testn_epi64_mask(_mm512_loadu_si512(at), _mm512_set1_epi64(bits));
#else
    typename Lanes<T>::BitVector v;
    std::memcpy(&v, at, sizeof v);
    c.mask_.bits = (v & bits) == 0;
#endif
    return c;
  }
  [[gnu::always_inline]] friend Chosen operator&(const Chosen& a, const Chosen& b) {
    Chosen c;
#if defined(__AVX512F__)
    c.mask_ = static_cast<Mask>(a.mask_ & b.mask_);
#else
    c.mask_ = a.mask_ & b.mask_;
#endif
    return c;
  }
  /// The chosen lanes: lane i is bit i.
  [[gnu::always_inline]] std::uint32_t bits() const {
#if defined(__AVX512F__)
    return mask_;
#elif defined(__AVX2__)
    if constexpr (sizeof(T) == 4)
      return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask_.bits)));
    else
      return static_cast<std::uint32_t>(_mm256_movemask_pd(reinterpret_cast<__m256d>(mask_.bits)));
#elif defined(__x86_64__)
    if constexpr (sizeof(T) == 4)
      return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask_.bits)));
    else
      return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask_.bits)));
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < lanes_of<T>; ++i) bits |= static_cast<std::uint32_t>(mask_.bits[i] & 1) << i;
    return bits;
#endif
  }

 private:
#if defined(__AVX512F__)
  using Mask = std::conditional_t<sizeof(T) == 4, __mmask16, __mmask8>;
#else
  using Mask = typename Lanes<T>::Mask;
#endif
  Mask mask_;
};

/// The bits of the lanes that hold a pair where `left` pairs are left.
template <class T>
[[gnu::always_inline]] inline std::uint32_t filled_lanes(std::size_t left) {
  return left < static_cast<std::size_t>(lanes_of<T>) ? (std::uint32_t{1} << left) - 1 : Chosen<T>::all;
}

[[gnu::always_inline]] inline int count_bits(std::uint32_t bits) {
#if defined(__POPCNT__) || !defined(__x86_64__)
  return __builtin_popcount(bits);
#else
  // Only for four lanes and fewer; the general function would be a call.
  return static_cast<int>((bits & 1) + (bits >> 1 & 1) + (bits >> 2 & 1) + (bits >> 3 & 1));
#endif
}

#if defined(__AVX2__) && !defined(__AVX512F__)
/// The places of the bits that are set, for each eight bits, a byte each.
struct ChosenPlaces {
  std::uint64_t bytes[256]{};
  constexpr ChosenPlaces() {
    for (unsigned bits = 0; bits < 256; ++bits)
      for (unsigned lane = 0, to = 0; lane < 8; ++lane)
        if (bits >> lane & 1) bytes[bits] |= std::uint64_t{lane} << (8 * to++);
  }
};
inline constexpr ChosenPlaces chosen_places{};
#endif

/// The numbers that `store_chosen` may read and write, however few are chosen.
inline constexpr int chosen_room = register_bytes / 4;

/// Writes those of the lanes at `from` whose bits are set, one after the other; the numbers behind them are overwritten
/// too.
[[gnu::always_inline]] inline void store_chosen(std::uint32_t* to, const std::uint32_t* from, std::uint32_t bits) {
#if defined(__AVX512F__)
  // Not straight to memory: that is microcode on some processors.
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), _mm512_loadu_si512(from)));
#elif defined(__AVX2__)
  const __m256i places = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(chosen_places.bytes[bits])));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                      _mm256_permutevar8x32_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)), places));
#else
  std::uint32_t at = 0;
  for (int i = 0; i < chosen_room; ++i) {
    to[at] = from[i];
    at += bits >> i & 1;
  }
#endif
}

/// `store_chosen` for lanes of numbers, of which there are as many in a register.
template <class T>
[[gnu::always_inline]] inline void store_chosen(const Lanes<T>& v, std::uint32_t bits, T* to) {
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 4)
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps(static_cast<__mmask16>(bits), reinterpret_cast<__m512>(v.v)));
  else
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd(static_cast<__mmask8>(bits), reinterpret_cast<__m512d>(v.v)));
  return;
#endif
#if defined(__AVX2__) && !defined(__AVX512F__)
  if constexpr (sizeof(T) == 4) {
    const __m256i places = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(chosen_places.bytes[bits])));
    _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(reinterpret_cast<__m256>(v.v), places));
    return;
  }
#endif
  T from[lanes_of<T>];
  v.store(from);
  std::size_t at = 0;
  for (int i = 0; i < lanes_of<T>; ++i) {
    to[at] = from[i];
    at += bits >> i & 1;
  }
}

/// `store_chosen` for pairs: `first` and each of the chosen lanes.
[[gnu::always_inline]] inline void store_chosen_pairs(std::uint32_t* to, std::uint32_t first, const std::uint32_t* from,
                                                      std::uint32_t bits) {
#if defined(__AVX512F__)
  const __m512i chosen = _mm512_maskz_compress_epi32(static_cast<__mmask16>(bits), _mm512_loadu_si512(from));
  const __m512i firsts = _mm512_set1_epi32(static_cast<int>(first));
  // Lanes from 16 on are those of `firsts`.
  const __m512i low = _mm512_setr_epi32(16, 0, 16, 1, 16, 2, 16, 3, 16, 4, 16, 5, 16, 6, 16, 7);
  const __m512i high = _mm512_setr_epi32(16, 8, 16, 9, 16, 10, 16, 11, 16, 12, 16, 13, 16, 14, 16, 15);
  _mm512_storeu_si512(to, _mm512_permutex2var_epi32(chosen, low, firsts));
  _mm512_storeu_si512(to + 16, _mm512_permutex2var_epi32(chosen, high, firsts));
#else
  std::uint32_t chosen[chosen_room];
  store_chosen(chosen, from, bits);
  for (int i = 0; i < chosen_room; ++i) to[2 * i] = first, to[2 * i + 1] = chosen[i];
#endif
}

}  // namespace graze::GRAZE_ISA
