// The lanes of a bundle in double, a register at a time. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/core/core.hpp"
#include "simd/gather.hpp"

namespace graze::GRAZE_ISA {

template <std::size_t part, class L>
[[gnu::always_inline]] inline Vec3<Lanes<double>> in_double(const Vec3<L>& v) {
  return {lanes_in_double<part>(v.x), lanes_in_double<part>(v.y), lanes_in_double<part>(v.z)};
}
template <std::size_t part, class L>
[[gnu::always_inline]] inline Pose<Lanes<double>> in_double(const Pose<L>& pose) {
  const Quat<L>& q = pose.rotation;
  return {
      in_double<part>(pose.translation),
      {lanes_in_double<part>(q.x), lanes_in_double<part>(q.y), lanes_in_double<part>(q.z), lanes_in_double<part>(q.w)}};
}

template <std::size_t part, class L>
[[gnu::always_inline]] inline PointCore<Lanes<double>> in_double(const PointCore<L>& core) {
  return {in_double<part>(core.point)};
}
template <std::size_t part, class L>
[[gnu::always_inline]] inline AxisCore<Lanes<double>> in_double(const AxisCore<L>& core) {
  return {lanes_in_double<part>(core.half_height)};
}
template <std::size_t part, class L>
[[gnu::always_inline]] inline TriangleCore<Lanes<double>> in_double(const TriangleCore<L>& core) {
  return {{in_double<part>(core.point[0]), in_double<part>(core.point[1]), in_double<part>(core.point[2])}};
}
template <std::size_t part, class Core, class L>
[[gnu::always_inline]] inline auto in_double(const Rounded<Core, L>& shape) {
  using Found = decltype(in_double<part>(shape.core));
  return Rounded<Found, Lanes<double>>{in_double<part>(shape.core), lanes_in_double<part>(shape.radius)};
}

/// Number of registers in double, the parts, that the lanes of T fill.
template <class T>
inline constexpr std::size_t parts_of = sizeof(double) / sizeof(T);

/// Calls `f(part)` with the number of each part, a constant, that holds some of `count` pairs.
template <class T, class F>
void visit_parts(std::size_t count, const F& f) {
  f(std::integral_constant<std::size_t, 0>());
  if constexpr (parts_of<T> == 2)
    if (count > static_cast<std::size_t>(lanes_of<double>)) f(std::integral_constant<std::size_t, 1>());
}

/// Numbers of all parts, rounded to T.
[[gnu::always_inline]] inline Lanes<double> joined(const Lanes<double> (&parts)[1]) { return parts[0]; }
template <std::size_t... I>
[[gnu::always_inline]] inline Lanes<float> joined(const Lanes<double> (&parts)[2], std::index_sequence<I...>) {
  using Half = typename gathering::Vector<float, lanes_of<double>>::type;
  return Lanes<float>::of(__builtin_shufflevector(__builtin_convertvector(parts[0].v, Half),
                                                  __builtin_convertvector(parts[1].v, Half), I...));
}
[[gnu::always_inline]] inline Lanes<float> joined(const Lanes<double> (&parts)[2]) {
  return joined(parts, std::make_index_sequence<lanes_of<float>>());
}

}  // namespace graze::GRAZE_ISA
