// A ray against the eight boxes of a node of a `WideTree` at once, in the tree's own scalar.
//
// Guarantee: no box that the exact ray crosses is left out: they are widened by more than rounding moves anything here.
// The bounds are taken as the tree keeps them, in eight bits: along an axis the ray passes step q of the node's frame at
// t = a q + b, with a and b the same for all children.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "graze/vec3.hpp"
#include "graze/wide.hpp"
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace graze {

/// As many lanes as every x86-64 has: wider vectors than the hardware's are slow in g++.
template <class T>
using RayLanes = Wide<T, 16 / static_cast<int>(sizeof(T))>;

/// Lane i as bit i.
template <class T>
[[gnu::always_inline]] inline std::uint32_t bits_of(const typename RayLanes<T>::Mask& mask) {
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 4)
    return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask.bits)));
  else
    return static_cast<std::uint32_t>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask.bits)));
#else
  std::uint32_t bits = 0;
  for (int i = 0; i < RayLanes<T>::lanes; ++i) bits |= (mask[i] ? 1u : 0u) << i;
  return bits;
#endif
}

/// `least` and `greatest`, which select by a mask, in one instruction; for numbers.
template <class T>
[[gnu::always_inline]] inline RayLanes<T> lesser(const RayLanes<T>& a, const RayLanes<T>& b) {
#if defined(__SSE2__)
  typedef typename RayLanes<T>::Vector Vector;
  if constexpr (sizeof(T) == 4)
    return RayLanes<T>::of(
        reinterpret_cast<Vector>(_mm_min_ps(reinterpret_cast<__m128>(a.v), reinterpret_cast<__m128>(b.v))));
  else
    return RayLanes<T>::of(
        reinterpret_cast<Vector>(_mm_min_pd(reinterpret_cast<__m128d>(a.v), reinterpret_cast<__m128d>(b.v))));
#else
  return least(a, b);
#endif
}
template <class T>
[[gnu::always_inline]] inline RayLanes<T> larger(const RayLanes<T>& a, const RayLanes<T>& b) {
#if defined(__SSE2__)
  typedef typename RayLanes<T>::Vector Vector;
  if constexpr (sizeof(T) == 4)
    return RayLanes<T>::of(
        reinterpret_cast<Vector>(_mm_max_ps(reinterpret_cast<__m128>(a.v), reinterpret_cast<__m128>(b.v))));
  else
    return RayLanes<T>::of(
        reinterpret_cast<Vector>(_mm_max_pd(reinterpret_cast<__m128d>(a.v), reinterpret_cast<__m128d>(b.v))));
#else
  return greatest(a, b);
#endif
}

/// Eight bytes as numbers.
template <class T>
struct EightNumbers {
  static constexpr int parts = 8 / RayLanes<T>::lanes;
  RayLanes<T> part[parts];

  [[gnu::always_inline]] explicit EightNumbers(const std::uint8_t* from) {
#if defined(__SSE2__)
    const __m128i zero = _mm_setzero_si128();
    const __m128i words = _mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(from)), zero);
    const __m128i low = _mm_unpacklo_epi16(words, zero), high = _mm_unpackhi_epi16(words, zero);
    if constexpr (sizeof(T) == 4) {
      part[0].v = reinterpret_cast<decltype(part[0].v)>(_mm_cvtepi32_ps(low));
      part[1].v = reinterpret_cast<decltype(part[0].v)>(_mm_cvtepi32_ps(high));
    } else {
      const auto upper_half = [](const __m128i& v) { return _mm_unpackhi_epi64(v, v); };
      part[0].v = reinterpret_cast<decltype(part[0].v)>(_mm_cvtepi32_pd(low));
      part[1].v = reinterpret_cast<decltype(part[0].v)>(_mm_cvtepi32_pd(upper_half(low)));
      part[2].v = reinterpret_cast<decltype(part[0].v)>(_mm_cvtepi32_pd(high));
      part[3].v = reinterpret_cast<decltype(part[0].v)>(_mm_cvtepi32_pd(upper_half(high)));
    }
#else
    for (int i = 0; i < 8; ++i) part[i / RayLanes<T>::lanes].set(i % RayLanes<T>::lanes, static_cast<T>(from[i]));
#endif
  }
};

template <class T>
class TreeRay {
 public:
  /// For a ray through the bounds of a tree that lies within `extent` of the frame's origin, by rounding `slack` more;
  /// `origin` is a point of it that is no further from their centre than their corners, `direction` unit.
  TreeRay(const Vec3d& origin, const Vec3d& direction, double begin, double extent, double slack)
      : origin_(cast<T>(origin)), begin_(static_cast<T>(begin)) {
    // With u half an epsilon and M the sum below, a crossing is off by 4 u M / |direction| for rounding of the bounds
    // themselves, 5 for a, 5 for b (of which one for the origin and one for the inverse) and 2 for their sum: 8 epsilon.
    // What underflows is less than the least normal number.
    constexpr double off = 16 * static_cast<double>(std::numeric_limits<T>::epsilon());
    const double reach = extent + max_abs(origin);
    const double around = slack + off * reach + static_cast<double>(std::numeric_limits<T>::min());
    for (std::size_t i = 0; i < 3; ++i) {
      // Within the bounds t is of the order of M, and what is slower than this crosses less than a rounding of M. Its
      // inverse times any length is finite.
      constexpr double slowest = 0x1p-60;
      const double d = direction[i], inverse = 1 / (d < 0 ? least(d, -slowest) : greatest(d, slowest));
      inverse_[i] = static_cast<T>(inverse);
      widening_[i] = static_cast<T>(around * std::abs(inverse));
    }
    begin_ -= static_cast<T>(around) + off_of(begin_);
  }

  /// What no key of a box exceeds that the ray enters by `end`.
  T limit(double end) const {
    constexpr T most = std::numeric_limits<T>::max();
    if (!(end < static_cast<double>(most))) return most;
    const T t = greatest(static_cast<T>(end), -most);
    return t + off_of(t);
  }

  /// Which of eight children, a bit each, the ray enters by `limit`, and in `keys` where, at the latest. `Node` is that
  /// of a `WideTree`.
  template <class Node>
  [[gnu::always_inline]] std::uint32_t crossed(const Node& node, T limit, T (&keys)[8]) const {
    constexpr int parts = EightNumbers<T>::parts, lanes = RayLanes<T>::lanes;
    RayLanes<T> enter[parts], leave[parts];
    for (int k = 0; k < parts; ++k) enter[k] = begin_, leave[k] = limit;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool forward = inverse_[axis] >= T(0);
      const T a = node.step[axis] * inverse_[axis], b = (node.origin[axis] - origin_[axis]) * inverse_[axis];
      const RayLanes<T> scale(a), first(b - widening_[axis]), last(b + widening_[axis]);
      const EightNumbers<T> low(forward ? node.lower[axis] : node.upper[axis]),
          high(forward ? node.upper[axis] : node.lower[axis]);
      for (int k = 0; k < parts; ++k) {
        enter[k] = larger<T>(low.part[k] * scale + first, enter[k]);
        leave[k] = lesser<T>(high.part[k] * scale + last, leave[k]);
      }
    }
    std::uint32_t bits = 0;
    for (int k = 0; k < parts; ++k) {
      enter[k].store(keys + k * lanes);
      bits |= bits_of<T>(enter[k] <= leave[k]) << (k * lanes);
    }
    return bits & ((1u << node.count) - 1);
  }

 private:
  static T off_of(T t) { return T(2) * std::numeric_limits<T>::epsilon() * (t < T(0) ? -t : t); }

  Vec3<T> origin_, inverse_, widening_;
  T begin_;
};

}  // namespace graze
