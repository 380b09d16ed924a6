// Vectors of N numbers, the storage of the lane type.
//
// Guarantee: g++ and clang compute with their vector extensions; for other compilers the vector is a struct with the
// operations written out, which give the same bits. No other public header uses vector extensions. GRAZE_PLAIN_LANES
// selects the struct with every compiler: in all files of a program, or in none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "graze/detail/standard.hpp"

namespace graze::detail {

#if defined(__GNUC__) && !defined(GRAZE_PLAIN_LANES)

template <class T, int N>
struct LaneVectorOf {
  typedef T type __attribute__((vector_size(N * sizeof(T))));
};
template <class T, int N>
using LaneVector = typename LaneVectorOf<T, N>::type;

/// The bits of a vector as a vector of another type.
template <class To, class From>
[[gnu::always_inline]] inline To bits_as(const From& v) {
  return reinterpret_cast<To>(v);
}
/// Lane by lane, `yes` where the condition holds, else `no`.
template <class Whole, class V>
[[gnu::always_inline]] inline V either_of(const Whole& condition, const V& yes, const V& no) {
  return condition ? yes : no;
}
/// Consecutive lanes from `first` on, one for each of the indices `I`.
template <std::size_t first, class V, std::size_t... I>
[[gnu::always_inline]] inline auto lanes_from(const V& v, std::index_sequence<I...>) {
  return __builtin_shufflevector(v, v, (first + I)...);
}

#else

template <class T, int N>
struct alignas(N * sizeof(T)) LaneVector {
  using Lane = T;
  /// Result of comparisons: all bits of a lane, or none.
  using Truth = LaneVector<std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>, N>;

  T lane[N];

  T operator[](int i) const { return lane[i]; }
  T& operator[](int i) { return lane[i]; }

  friend LaneVector operator+(const LaneVector& a, const LaneVector& b) {
    return of([&](int i) { return a[i] + b[i]; });
  }
  friend LaneVector operator+(const LaneVector& a, T b) {
    return of([&](int i) { return a[i] + b; });
  }
  friend LaneVector operator-(const LaneVector& a, const LaneVector& b) {
    return of([&](int i) { return a[i] - b[i]; });
  }
  friend LaneVector operator-(T a, const LaneVector& b) {
    return of([&](int i) { return a - b[i]; });
  }
  friend LaneVector operator*(const LaneVector& a, const LaneVector& b) {
    return of([&](int i) { return a[i] * b[i]; });
  }
  friend LaneVector operator/(const LaneVector& a, const LaneVector& b) {
    return of([&](int i) { return a[i] / b[i]; });
  }
  friend LaneVector operator-(const LaneVector& a) {
    return of([&](int i) { return -a[i]; });
  }
  friend LaneVector operator&(const LaneVector& a, const LaneVector& b) {
    return of([&](int i) { return a[i] & b[i]; });
  }
  friend LaneVector operator|(const LaneVector& a, const LaneVector& b) {
    return of([&](int i) { return a[i] | b[i]; });
  }
  friend LaneVector operator~(const LaneVector& a) {
    return of([&](int i) { return ~a[i]; });
  }
  LaneVector& operator|=(const LaneVector& b) { return *this = *this | b; }

  friend Truth operator<(const LaneVector& a, const LaneVector& b) {
    return Truth::of([&](int i) { return a[i] < b[i] ? -1 : 0; });
  }
  friend Truth operator<=(const LaneVector& a, const LaneVector& b) {
    return Truth::of([&](int i) { return a[i] <= b[i] ? -1 : 0; });
  }
  friend Truth operator>(const LaneVector& a, const LaneVector& b) { return b < a; }
  friend Truth operator>=(const LaneVector& a, const LaneVector& b) { return b <= a; }
  friend Truth operator==(const LaneVector& a, const LaneVector& b) {
    return Truth::of([&](int i) { return a[i] == b[i] ? -1 : 0; });
  }
  friend Truth operator!=(const LaneVector& a, const LaneVector& b) { return ~(a == b); }

  /// The vector whose lane i is `f(i)`.
  template <class F>
  static LaneVector of(const F& f) {
    LaneVector r;
    for (int i = 0; i < N; ++i) r.lane[i] = static_cast<T>(f(i));
    return r;
  }
};

/// The bits of a vector as a vector of another type.
template <class To, class From>
inline To bits_as(const From& v) {
  static_assert(sizeof(To) == sizeof(From));
  To r;
  std::memcpy(&r, &v, sizeof r);
  return r;
}
/// Lane by lane, `yes` where the condition holds, else `no`.
template <class Whole, class V>
inline V either_of(const Whole& condition, const V& yes, const V& no) {
  return V::of([&](int i) { return condition[i] != 0 ? yes[i] : no[i]; });
}
/// Consecutive lanes from `first` on, one for each of the indices `I`.
template <std::size_t first, class V, std::size_t... I>
inline auto lanes_from(const V& v, std::index_sequence<I...>) {
  return LaneVector<typename V::Lane, static_cast<int>(sizeof...(I))>{{v.lane[first + I]...}};
}

#endif

/// A number that is to fill all lanes. For WebAssembly it is read where it stands in the program: clang 14 turns a read
/// and the filling into one instruction that it does not take for a read, and moves it behind later writes to that
/// place.
template <class T>
[[gnu::always_inline]] inline T read_here(T value) {
#if defined(__wasm__)
  asm volatile("" : "+r"(value));
#endif
  return value;
}

}  // namespace graze::detail
