// The choice of one of three axes, in each lane another: by its place for a single pair, by masks across lanes.
//
// Guarantee: choosing computes nothing: numbers are only moved.
#pragma once

#include "graze/mat3.hpp"
#include "graze/wide.hpp"

namespace graze {

/// The result of `yes()` where the condition holds, else that of `no()`. A single pair calls only one of them.
template <class M, class Yes, class No>
auto either(const M& condition, const Yes& yes, const No& no) {
  if constexpr (std::is_integral_v<M>)
    return condition ? yes() : no();
  else
    return select(condition, yes(), no());
}

/// 1 where the condition holds, else 0. For a single pair without a branch, which would be mispredicted often.
template <class S, class M>
S one_where(const M& condition) {
  if constexpr (std::is_integral_v<M>)
    return static_cast<S>(static_cast<int>(condition));
  else
    return select(condition, S(1), S(0));
}

/// The choice across lanes.
template <class S>
class AxisPermutation {
  using Mask = decltype(S() < S());

 public:
  using Number = S;
  /// Chooses the axis of that number: 0, 1 or 2.
  explicit AxisPermutation(const S& number) : first_(number == S(0)), second_(number == S(1)) {}
  /// Chooses the first axis, the second, or the last; at most one of the masks is set.
  static AxisPermutation of(const Mask& first, const Mask& second) { return {first, second}; }
  /// The axis along which a vector is longest, the first of those.
  static AxisPermutation longest(const Vec3<S>& v) {
    const Vec3<S> a = abs(v);
    const Mask first = (a.x >= a.y) & (a.x >= a.z);
    return {first, (!first) & (a.y >= a.z)};
  }

  template <class V>
  V pick(const V& x, const V& y, const V& z) const {
    return select(first_, x, select(second_, y, z));
  }
  S pick(const Vec3<S>& v) const { return pick(v.x, v.y, v.z); }
  /// The column of this axis.
  Vec3<S> pick(const Mat3<S>& m) const { return {pick(m.row[0]), pick(m.row[1]), pick(m.row[2])}; }
  /// The vector's component along this axis last, the ones along those that follow it before.
  Vec3<S> turned(const Vec3<S>& v) const { return {pick(v.y, v.z, v.x), pick(v.z, v.x, v.y), pick(v)}; }
  /// A matrix with its rows in that order.
  Mat3<S> turned(const Mat3<S>& m) const {
    const Vec3<S>* row = m.row;
    return {{pick(row[1], row[2], row[0]), pick(row[2], row[0], row[1]), pick(row[0], row[1], row[2])}};
  }
  /// A vector without its component along this axis.
  Vec3<S> without(const Vec3<S>& v) const {
    return {select(first_, S(0), v.x), select(second_, S(0), v.y), select(first_ | second_, v.z, S(0))};
  }
  /// The unit vector along this axis.
  Vec3<S> unit() const {
    return {select(first_, S(1), S(0)), select(second_, S(1), S(0)), select(first_ | second_, S(0), S(1))};
  }

 private:
  AxisPermutation(const Mask& first, const Mask& second) : first_(first), second_(second) {}

  Mask first_, second_;
};

/// The choice of a single pair.
template <class S>
requires std::is_arithmetic_v<S>
class AxisPermutation<S> {
 public:
  using Number = S;
  explicit AxisPermutation(S number) : place_(static_cast<std::size_t>(static_cast<int>(number))) {}
  static AxisPermutation of(bool first, bool second) {
    return AxisPermutation(std::size_t{!first} * (std::size_t{2} - std::size_t{second}));  // without a branch
  }
  static AxisPermutation longest(const Vec3<S>& v) {
    const Vec3<S> a = abs(v);
    const bool first = (a.x >= a.y) & (a.x >= a.z), second = a.y >= a.z;
    return of(first, second);
  }

  S pick(S x, S y, S z) const {
    const S all[3] = {x, y, z};
    return all[place_];
  }
  Vec3<S> pick(const Vec3<S>& x, const Vec3<S>& y, const Vec3<S>& z) const {
    return {pick(x.x, y.x, z.x), pick(x.y, y.y, z.y), pick(x.z, y.z, z.z)};
  }
  S pick(const Vec3<S>& v) const { return pick(v.x, v.y, v.z); }
  Vec3<S> pick(const Mat3<S>& m) const { return {pick(m.row[0]), pick(m.row[1]), pick(m.row[2])}; }
  Vec3<S> turned(const Vec3<S>& v) const {
    const S ring[5] = {v.x, v.y, v.z, v.x, v.y};
    return {ring[place_ + 1], ring[place_ + 2], ring[place_]};
  }
  Mat3<S> turned(const Mat3<S>& m) const {
    return transposed(Mat3<S>{{turned(m.column(0)), turned(m.column(1)), turned(m.column(2))}});
  }
  Vec3<S> without(const Vec3<S>& v) const {
    return {place_ == 0 ? S(0) : v.x, place_ == 1 ? S(0) : v.y, place_ == 2 ? S(0) : v.z};
  }
  Vec3<S> unit() const { return {S(place_ == 0), S(place_ == 1), S(place_ == 2)}; }

 private:
  explicit AxisPermutation(std::size_t place) : place_(place) {}

  std::size_t place_;
};

/// The cross product of the chosen axis with a vector, of which one component is zero.
template <class S>
Vec3<S> cross(const AxisPermutation<S>& axis, const Vec3<S>& v) {
  const S zero(0);
  return axis.pick(Vec3<S>{zero, -v.z, v.y}, Vec3<S>{v.z, zero, -v.x}, Vec3<S>{-v.y, v.x, zero});
}

}  // namespace graze
