// Double-word arithmetic: a number as the sum of a large and a small one, twice the digits, for computations that
// cancel.
//
// Guarantee: IEEE-exact operations in the order written, so that a scalar and each lane of a `Wide` give the same bits.
// Relative errors of an operation are some units of the square of the scalar's, as long as nothing under- or overflows.
// Sources: Dekker 1971, "A floating-point technique for extending the available precision"; Knuth 1969, "The art of
// computer programming", volume 2, section 4.2.2.
#pragma once

#include "graze/vec3.hpp"

namespace graze {

/// A double-word number. `S` is `float`, `double` or a lane type.
template <class S>
struct Extended {
  using Mask = decltype(S() < S());  ///< the result of a comparison

  S high{}, low{};  ///< the rounded number, and its rounding error

  constexpr Extended() = default;
  /// An ordinary number, exactly.
  constexpr explicit(false) Extended(const S& number) : high(number), low(0) {}
  /// The sum of two parts, the second less than a unit in the last place of the first.
  constexpr Extended(const S& high_part, const S& low_part) : high(high_part), low(low_part) {}

  /// The number rounded to `S`.
  explicit constexpr operator S() const { return high; }

  /// a + b without rounding.
  static constexpr Extended sum(const S& a, const S& b) {
    const S s = a + b, of_b = s - a;
    return {s, (a - (s - of_b)) + (b - of_b)};
  }
  /// a * b without rounding.
  static constexpr Extended product(const S& a, const S& b) {
    // Split into halves of the digits, whose products are exact (Veltkamp; Dekker 1971).
    using Number = typename Lane<S>::type;
    const S split(static_cast<Number>(sizeof(Number) == 4 ? 0x1p12 + 1 : 0x1p27 + 1));
    const S wide_a = split * a, wide_b = split * b;
    const S a1 = wide_a - (wide_a - a), b1 = wide_b - (wide_b - b), a2 = a - a1, b2 = b - b1, p = a * b;
    return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
  }

  friend constexpr Extended operator+(const Extended& a, const Extended& b) {
    const Extended s = sum(a.high, b.high), t = sum(a.low, b.low);
    const Extended u = ordered_sum(s.high, s.low + t.high);
    return ordered_sum(u.high, u.low + t.low);
  }
  friend constexpr Extended operator-(const Extended& a) { return {-a.high, -a.low}; }
  friend constexpr Extended operator-(const Extended& a, const Extended& b) { return a + -b; }
  friend constexpr Extended operator*(const Extended& a, const Extended& b) {
    const Extended p = product(a.high, b.high);
    return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  friend constexpr Extended operator/(const Extended& a, const Extended& b) {
    const S first = a.high / b.high;
    const Extended left = a - b * Extended(first);
    const S second = left.high / b.high;
    const Extended rest = left - b * Extended(second);
    return ordered_sum(first, second) + Extended(rest.high / b.high);
  }
  friend constexpr Mask operator==(const Extended& a, const Extended& b) {
    return (a.high == b.high) & (a.low == b.low);
  }
  friend constexpr Mask operator<(const Extended& a, const Extended& b) {
    return (a.high < b.high) | ((a.high == b.high) & (a.low < b.low));
  }
  friend constexpr Mask operator>(const Extended& a, const Extended& b) { return b < a; }
  friend constexpr Mask operator<=(const Extended& a, const Extended& b) { return !(b < a); }
  friend constexpr Mask operator>=(const Extended& a, const Extended& b) { return !(a < b); }

  /// `yes` where the condition holds, else `no`, lane by lane.
  friend constexpr Extended select(const Mask& condition, const Extended& yes, const Extended& no) {
    return {select(condition, yes.high, no.high), select(condition, yes.low, no.low)};
  }
  friend constexpr Extended least(const Extended& a, const Extended& b) { return select(b < a, b, a); }
  friend constexpr Extended greatest(const Extended& a, const Extended& b) { return select(a < b, b, a); }

 private:
  template <class L>
  struct Lane {
    using type = L;
  };
  template <class L>
  requires requires { typename L::Lane; }
  struct Lane<L> {
    using type = typename L::Lane;
  };

  /// a + b without rounding, if |a| >= |b| or a is zero.
  static constexpr Extended ordered_sum(const S& a, const S& b) {
    const S s = a + b;
    return {s, b - (s - a)};
  }
};

/// A vector in double-word numbers, exactly.
template <class S>
constexpr Vec3<Extended<S>> extended(const Vec3<S>& v) {
  return {v.x, v.y, v.z};
}

}  // namespace graze
