// The side of a line on which a point lies.
//
// Guarantee: exact for doubles, as long as no product of two coordinates under- or overflows. Most answers come from
// one rounded determinant with its error bound; the rest from an exact sum (Shewchuk 1997, "Adaptive precision
// floating-point arithmetic and fast robust geometric predicates").
#pragma once

#include "graze/plane/vec2.hpp"

namespace graze::plane {

namespace detail {

/// A sum of doubles held without error, smallest first.
class ExactSum {
 public:
  void add_product(double a, double b) {
    const double product = a * b;
    const auto [a_high, a_low] = halves(a);
    const auto [b_high, b_low] = halves(b);
    add(a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low));
    add(product);
  }
  /// The sum rounded, of the right sign.
  double value() const {
    double sum = 0;
    for (int i = 0; i < size_; ++i) sum += terms_[i];
    return sum;
  }

 private:
  struct Halves {
    double high, low;
  };
  /// Two halves of 26 bits (Dekker 1971).
  static Halves halves(double v) {
    const double c = 134217729.0 * v, high = c - (c - v);
    return {high, v - high};
  }
  void add(double v) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const double sum = v + terms_[i], part = sum - v;
      const double rest = (v - (sum - part)) + (terms_[i] - part);
      if (rest != 0) terms_[kept++] = rest;
      v = sum;
    }
    terms_[kept++] = v;
    size_ = kept;
  }

  double terms_[12] = {};
  int size_ = 0;
};

}  // namespace detail

/// Positive where a, b, c turn to the left, negative where to the right, zero where they lie on a line.
inline double orientation(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const double l = (b.x - a.x) * (c.y - a.y), r = (b.y - a.y) * (c.x - a.x), det = l - r;
  // Shewchuk's bound A for this determinant: (3 + 16 u) u with u = 2^-53.
  constexpr double bound = 3.3306690738754716e-16;
  const double magnitude = (l < 0 ? -l : l) + (r < 0 ? -r : r);
  if (det > bound * magnitude || -det > bound * magnitude) return det;
  detail::ExactSum sum;
  sum.add_product(b.x, c.y);
  sum.add_product(-b.x, a.y);
  sum.add_product(-a.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(b.y, a.x);
  sum.add_product(a.y, c.x);
  return sum.value();
}

}  // namespace graze::plane
