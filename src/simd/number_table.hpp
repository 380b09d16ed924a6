// A small table of numbers that lanes look up each at its own place. Only for `*.kernel.cpp`.
//
// Guarantee: every level reads the same numbers. AVX-512 keeps the table in registers; the others read it number by
// number, which costs less than their gathers.
#pragma once

#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

/// A table of 32 floats, which stay where they are; lanes take the numbers at their places, which are bytes, as many as
/// lanes.
class NumberTable {
 public:
  static constexpr std::size_t size = 32;

#if defined(__AVX512F__)
  [[gnu::always_inline]] explicit NumberTable(const float* numbers)
      : low_(_mm512_loadu_ps(numbers)), high_(_mm512_loadu_ps(numbers + 16)) {}
  [[gnu::always_inline]] Lanes<float> at(const std::uint8_t* places) const {
    const __m512i at = _mm512_maskz_cvtepu8_epi32(0xffff, _mm_loadu_si128(reinterpret_cast<const __m128i*>(places)));
    return Lanes<float>::of(
        reinterpret_cast<Lanes<float>::Vector>(_mm512_maskz_permutex2var_ps(0xffff, low_, at, high_)));
  }

 private:
  __m512 low_, high_;
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
