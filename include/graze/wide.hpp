// The lane type: N scalars in one SIMD value.
//
// Guarantee: every operation is lane by lane the IEEE operation of the scalar, so that a kernel written once over its
// scalar gives the same bits in every lane as it gives for that lane alone. Built on the vectors of lane_vector.hpp,
// without intrinsics. All of it is inlined even without optimisation (g++ and clang): kernels are compiled for several
// instruction sets, and no copy for one of them may be left where another's is called.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "graze/detail/lane_vector.hpp"
#include "graze/detail/standard.hpp"

namespace graze {

/// N lanes of T (`float` or `double`), N a power of two. Comparisons give a `Mask`; `select` chooses by it.
template <class T, int N>
struct Wide {
  using Lane = T;                                                               ///< type of a lane
  using Bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;  ///< integer of a lane's size
  using Vector = detail::LaneVector<T, N>;                                      ///< vector type of the compiler with
                                                                                ///< all lanes
  using BitVector = detail::LaneVector<Bits, N>;                                ///< vector of the bits of all lanes

  static constexpr int lanes = N;  ///< number of lanes

  /// One truth value a lane: all bits set, or none.
  struct Mask {
    static constexpr int lanes = N;  ///< number of lanes
    BitVector bits;                  ///< all set for true, none for false

    [[gnu::always_inline]] friend Mask operator&(const Mask& a, const Mask& b) { return {a.bits & b.bits}; }
    [[gnu::always_inline]] friend Mask operator|(const Mask& a, const Mask& b) { return {a.bits | b.bits}; }
    [[gnu::always_inline]] friend Mask operator!(const Mask& a) { return {~a.bits}; }
    /// Lane by lane, `yes` where the condition holds, else `no`.
    [[gnu::always_inline]] friend Mask select(const Mask& condition, const Mask& yes, const Mask& no) {
      return (condition & yes) | ((!condition) & no);
    }
    /// Truth value of one lane.
    [[gnu::always_inline]] bool operator[](int i) const { return bits[i] != 0; }
  };

  Vector v;  ///< the lanes

  [[gnu::always_inline]] Wide() : v{} {}
  /// A number in all lanes.
  [[gnu::always_inline]] explicit(false) Wide(T value) : v(detail::read_here(value) - Vector{}) {}
  /// The value of a compiler's vector.
  [[gnu::always_inline]] static Wide of(const Vector& vector) {
    Wide w;
    w.v = vector;
    return w;
  }
  /// Loads N contiguous numbers.
  [[gnu::always_inline]] static Wide load(const T* from) {
    Wide w;
    std::memcpy(&w.v, from, sizeof w.v);
    return w;
  }
  /// Stores the lanes as N contiguous numbers.
  [[gnu::always_inline]] void store(T* to) const { std::memcpy(to, &v, sizeof v); }
  /// Value of one lane.
  [[gnu::always_inline]] T operator[](int i) const { return v[i]; }
  /// Sets one lane.
  [[gnu::always_inline]] void set(int i, T value) { v[i] = value; }

  [[gnu::always_inline]] friend Wide operator+(const Wide& a, const Wide& b) { return of(a.v + b.v); }
  [[gnu::always_inline]] friend Wide operator-(const Wide& a, const Wide& b) { return of(a.v - b.v); }
  [[gnu::always_inline]] friend Wide operator*(const Wide& a, const Wide& b) { return of(a.v * b.v); }
  [[gnu::always_inline]] friend Wide operator/(const Wide& a, const Wide& b) { return of(a.v / b.v); }
  [[gnu::always_inline]] friend Wide operator-(const Wide& a) { return of(-a.v); }
  [[gnu::always_inline]] Wide& operator+=(const Wide& b) { return *this = *this + b; }
  [[gnu::always_inline]] Wide& operator-=(const Wide& b) { return *this = *this - b; }
  [[gnu::always_inline]] Wide& operator*=(const Wide& b) { return *this = *this * b; }

  [[gnu::always_inline]] friend Mask operator<(const Wide& a, const Wide& b) {
    return {detail::bits_as<BitVector>(a.v < b.v)};
  }
  [[gnu::always_inline]] friend Mask operator<=(const Wide& a, const Wide& b) {
    return {detail::bits_as<BitVector>(a.v <= b.v)};
  }
  [[gnu::always_inline]] friend Mask operator>(const Wide& a, const Wide& b) {
    return {detail::bits_as<BitVector>(a.v > b.v)};
  }
  [[gnu::always_inline]] friend Mask operator>=(const Wide& a, const Wide& b) {
    return {detail::bits_as<BitVector>(a.v >= b.v)};
  }
  [[gnu::always_inline]] friend Mask operator==(const Wide& a, const Wide& b) {
    return {detail::bits_as<BitVector>(a.v == b.v)};
  }
  [[gnu::always_inline]] friend Mask operator!=(const Wide& a, const Wide& b) {
    return {detail::bits_as<BitVector>(a.v != b.v)};
  }

  /// Lane by lane, `yes` where the condition holds, else `no`.
  [[gnu::always_inline]] friend Wide select(const Mask& condition, const Wide& yes, const Wide& no) {
    return of(detail::either_of(condition.bits, yes.v, no.v));
  }
  [[gnu::always_inline]] friend Wide least(const Wide& a, const Wide& b) { return select(b < a, b, a); }
  [[gnu::always_inline]] friend Wide greatest(const Wide& a, const Wide& b) { return select(a < b, b, a); }
  [[gnu::always_inline]] friend Wide abs(const Wide& a) {
    constexpr Bits sign = sizeof(T) == 4 ? Bits(0x80000000u) : Bits(0x8000000000000000u);
    return of(detail::bits_as<Vector>(detail::bits_as<BitVector>(a.v) & ~(BitVector{} + sign)));
  }
  /// Square root lane by lane: both compilers make one vector instruction of the loop.
  [[gnu::always_inline]] friend Wide sqrt(const Wide& a) {
    Wide r;
    for (int i = 0; i < N; ++i) r.v[i] = std::sqrt(a.v[i]);
    return r;
  }
};

namespace detail {

/// The lanes of two vectors combined bit by bit: or, if `either`, else and.
template <bool either, class V>
[[gnu::always_inline]] inline V joined(const V& a, const V& b) {
  if constexpr (either)
    return a | b;
  else
    return a & b;
}
/// The lanes of a vector combined half by half in registers, down to 64 bits: lane by lane takes several times as many
/// instructions.
template <bool either, class V, std::size_t... I>
[[gnu::always_inline]] inline std::uint64_t joined_lanes(const V& v, std::index_sequence<I...>) {
  constexpr std::size_t half = sizeof...(I);
  if constexpr (sizeof(V) > 16) {
    return joined_lanes<either>(
        joined<either>(lanes_from<0>(v, std::index_sequence<I...>()), lanes_from<half>(v, std::index_sequence<I...>())),
        std::make_index_sequence<half / 2>());
  } else {
    static_assert(sizeof(V) == 16);
    std::uint64_t words[2];
    std::memcpy(words, &v, sizeof words);
    return joined<either>(words[0], words[1]);
  }
}

}  // namespace detail

/// Whether any lane is set. Also takes the `bool` of a scalar comparison, and the `int` that joining two of them gives,
/// so that kernels run over scalars too. Uses `set_lanes(mask)` where an instruction makes bits of lanes.
template <class M>
[[gnu::always_inline]] inline bool any(const M& mask) {
  if constexpr (std::is_integral_v<M>) {
    return mask != 0;
  } else if constexpr (requires { set_lanes(mask); }) {
    return set_lanes(mask) != 0;
  } else {
    return detail::joined_lanes<true>(mask.bits, std::make_index_sequence<M::lanes / 2>()) != 0;
  }
}
/// Whether all lanes are set.
template <class M>
[[gnu::always_inline]] inline bool all(const M& mask) {
  if constexpr (std::is_integral_v<M>) {
    return mask != 0;
  } else if constexpr (requires { set_lanes(mask); }) {
    return set_lanes(mask) == (std::uint32_t{1} << M::lanes) - 1;
  } else {
    return detail::joined_lanes<false>(mask.bits, std::make_index_sequence<M::lanes / 2>()) == ~std::uint64_t{0};
  }
}

}  // namespace graze
