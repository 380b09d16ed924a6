// The scan of a small hull's vertices on the lanes of a level. Only for `*.kernel.cpp`.
//
// Guarantee: that of `furthest_vertex.hpp`.
#pragma once

#include "shape/furthest_vertex.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

/// The rounding of the difference of two vertices' places along a direction, relative to the hull's extent and the
/// direction's largest component: two and a half roundings of each of three products, which sum to no more than the
/// square root of three, of two vertices; twice that.
inline constexpr float scan_slack = 18 * std::numeric_limits<float>::epsilon();

/// The slack where all products are too small for a float to hold: all vertices are looked at then.
inline constexpr float scan_floor = 16 * std::numeric_limits<float>::min();

/// The larger lane by lane; the second where either is no number.
[[gnu::always_inline]] inline Lanes<float> larger(const Lanes<float>& a, const Lanes<float>& b) {
#if defined(__x86_64__)
  using L = Lanes<float>;
#if defined(__AVX512F__)
  return L::of(reinterpret_cast<L::Vector>(
      _mm512_maskz_max_ps(0xffff, reinterpret_cast<__m512>(a.v), reinterpret_cast<__m512>(b.v))));
#elif defined(__AVX2__)
  return L::of(
      reinterpret_cast<L::Vector>(_mm256_max_ps(reinterpret_cast<__m256>(a.v), reinterpret_cast<__m256>(b.v))));
#else
  return L::of(reinterpret_cast<L::Vector>(_mm_max_ps(reinterpret_cast<__m128>(a.v), reinterpret_cast<__m128>(b.v))));
#endif
#else
  return select(a > b, a, b);
#endif
}

/// The largest of all lanes, by halves.
[[gnu::always_inline]] inline float largest(const Lanes<float>& a) {
#if defined(__x86_64__)
#if defined(__AVX512F__)
  const auto v = reinterpret_cast<__m512>(a.v);
  // Masked, if by all: g++ 12 takes what the others leave undefined for a mistake.
  const __m256 eight =
      _mm256_max_ps(_mm512_maskz_extractf32x8_ps(0xff, v, 0), _mm512_maskz_extractf32x8_ps(0xff, v, 1));
#elif defined(__AVX2__)
  const auto eight = reinterpret_cast<__m256>(a.v);
#endif
#if defined(__AVX2__)
  const __m128 four = _mm_max_ps(_mm256_castps256_ps128(eight), _mm256_extractf128_ps(eight, 1));
#else
  const auto four = reinterpret_cast<__m128>(a.v);
#endif
  const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_max_ss(two, _mm_shuffle_ps(two, two, 1)));
#else
  float most = a[0];
  for (int i = 1; i < Lanes<float>::lanes; ++i) most = greatest(most, a[i]);
  return most;
#endif
}

/// The places of the vertices of some blocks along a direction.
template <std::size_t Blocks>
class Places {
 public:
  [[gnu::always_inline]] Places(const VertexBlock* blocks, const Vec3<float>& direction) {
    const L x(direction.x), y(direction.y), z(direction.z);
    for (std::size_t i = 0; i < registers; ++i) {
      const VertexBlock& block = blocks[i / each];
      const std::size_t at = i % each * lanes;
      along_[i] = L::load(block.x + at) * x + L::load(block.y + at) * y + L::load(block.z + at) * z;
    }
  }
  [[gnu::always_inline]] float most() const {
    L all = along_[0];
    for (std::size_t i = 1; i < registers; ++i) all = larger(along_[i], all);
    return largest(all);
  }
  /// Bit i of vertex i where it is not less than `level`.
  [[gnu::always_inline]] VertexBits not_less(float level) const {
    const L low(level);
    VertexBits bits = 0;
    for (std::size_t i = 0; i < registers; ++i)
      bits |= VertexBits{Chosen<float>::not_less(along_[i], low).bits()} << (i * lanes);
    return bits;
  }

 private:
  using L = Lanes<float>;
  static constexpr std::size_t lanes = static_cast<std::size_t>(L::lanes), each = VertexBlock::size / lanes,
                               registers = Blocks * each;
  L along_[registers];
};

/// The bits of a hull's vertices, without what fills its blocks up.
template <class T>
[[gnu::always_inline]] inline VertexBits all_vertices(const ScannedHull<T>& hull) {
  return ~VertexBits{0} >> (64 - hull.count);
}

/// The vertex furthest along `direction` of those whose bits are set in `among`; of equals the first.
template <class T, class S>
[[gnu::noinline]] std::uint32_t furthest_among(const ScannedHull<T>& hull, VertexBits among, const Vec3<S>& direction) {
  const auto first = [&] { return static_cast<std::uint32_t>(__builtin_ctzll(among)); };
  const auto along = [&](std::uint32_t v) { return dot(converted<S>(hull.vertices[v]), direction); };
  std::uint32_t best = first();
  S most = along(best);
  for (among &= among - 1; among != 0; among &= among - 1) {
    const std::uint32_t v = first();
    const S here = along(v);
    // A branch on which of them is further would be mispredicted often.
    best ^= (best ^ v) & (0u - static_cast<std::uint32_t>(here > most));
    most = here > most ? here : most;
  }
  return best;
}

[[gnu::always_inline]] inline bool several(VertexBits bits) { return (bits & (bits - 1)) != 0; }
[[gnu::always_inline]] inline std::uint32_t first_of(VertexBits bits) {
  return static_cast<std::uint32_t>(__builtin_ctzll(bits));
}

template <std::size_t Blocks, class T, class S>
[[gnu::always_inline]] inline VertexBits highest_of(const ScannedHull<T>& hull, const Vec3<S>& direction) {
  const Vec3<float> d = converted<float>(direction);
  const Places<Blocks> places(hull.blocks, d);
  const float slack = scan_slack * hull.extent * max_abs(d) + scan_floor;
  // A vertex that is not known to be lower may be the furthest: also where overflow has left no number.
  return places.not_less(places.most() - slack) & all_vertices(hull);
}
/// The bits of the vertices among which rounding leaves open which lies furthest along a direction; most often one.
template <class T, class S>
[[gnu::always_inline]] inline VertexBits highest(const ScannedHull<T>& hull, const Vec3<S>& direction) {
  if (hull.count > 2 * VertexBlock::size) return highest_of<most_scan_blocks>(hull, direction);
  return hull.count > VertexBlock::size ? highest_of<2>(hull, direction) : highest_of<1>(hull, direction);
}

template <class T, class S>
[[gnu::always_inline]] inline std::uint32_t scan(const ScannedHull<T>& hull, const Vec3<S>& direction) {
  const VertexBits candidates = highest(hull, direction);
  if (!several(candidates)) [[likely]]
    return first_of(candidates);
  return furthest_among(hull, candidates, direction);
}

}  // namespace graze::GRAZE_ISA
