// A small table of numbers that lanes look up each at its own place. Only for `*.kernel.cpp`.
//
// Guarantee: every level reads the same numbers. AVX-512 keeps the table in registers; the others read it number by
// number, which costs less than their gathers.
#pragma once

#include "lanes/lanes.hpp"

namespace graze::GRAZE_ISA {

/// Of `size` floats, which stay where they are; places are bytes, as many as lanes.
template <std::size_t size>
class NumberTable {
 public:
#if defined(__AVX512F__)
  static_assert(size == 64, "four registers");
  [[gnu::always_inline]] explicit NumberTable(const float* numbers) {
    for (int i = 0; i < 4; ++i) quarters_[i] = _mm512_loadu_ps(numbers + 16 * i);
  }
  [[gnu::always_inline]] Lanes<float> at(const std::uint8_t* places) const {
    const __m512i at = _mm512_maskz_cvtepu8_epi32(0xffff, _mm_loadu_si128(reinterpret_cast<const __m128i*>(places)));
    const __m512 low = _mm512_maskz_permutex2var_ps(0xffff, quarters_[0], at, quarters_[1]);
    const __m512 high = _mm512_maskz_permutex2var_ps(0xffff, quarters_[2], at, quarters_[3]);
    const __mmask16 is_high = _mm512_test_epi32_mask(at, _mm512_set1_epi32(32));
    return Lanes<float>::of(reinterpret_cast<Lanes<float>::Vector>(_mm512_mask_blend_ps(is_high, low, high)));
  }

 private:
  __m512 quarters_[4];
#else
  [[gnu::always_inline]] explicit NumberTable(const float* numbers) : numbers_(numbers) {}
  [[gnu::always_inline]] Lanes<float> at(const std::uint8_t* places) const {
    float found[Lanes<float>::lanes];
    for (int i = 0; i < Lanes<float>::lanes; ++i) found[i] = numbers_[places[i]];
    return Lanes<float>::load(found);
  }

 private:
  const float* numbers_;
#endif
};

}  // namespace graze::GRAZE_ISA
