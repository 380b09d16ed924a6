// The one loader: a kind's shapes in lanes, as cores, and poses, from wherever their numbers stand. Only for
// `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include <iterator>

#include "narrow/batch/layouts.hpp"
#include "narrow/core/core.hpp"
#include "narrow/pairs/box_box/reference_axis.hpp"
#include "simd/rows.hpp"

namespace graze::GRAZE_ISA {

/// Numbers that stand one behind the other, those of a lane behind those of the one before.
template <class T>
struct NumberRows {
  /// Whether lanes take all of the shapes, so that this need not be found out.
  static constexpr bool taken = false;
  const void* from;

  /// Loads numbers from the `first`-th on of each lane's, of which there are `width`.
  template <std::size_t width, std::size_t first, std::size_t count>
  [[gnu::always_inline]] void load(Lanes<T> (&out)[count]) const {
    load_rows<width, first, T>(from, out);
  }
};

/// Numbers that stand anywhere: `row(lane)` is the address of a lane's first.
template <class T, class Row>
struct ScatteredNumbers {
  static constexpr bool taken = true;
  Row row;

  template <std::size_t width, std::size_t first, std::size_t count>
  [[gnu::always_inline]] void load(Lanes<T> (&out)[count]) const {
    static_assert(first + count <= width);
    gather<T>(row, first * sizeof(T), out);
  }
};
template <class T, class Row>
[[gnu::always_inline]] inline ScatteredNumbers<T, Row> scattered(const Row& row) {
  return {row};
}

/// The lanes' shapes, and the lanes in which they are regular, so that kernels take them.
template <class Core, class S>
struct ShapesInLanes {
  Rounded<Core, S> shapes;
  typename S::Mask regular;
};

/// The mask with all lanes set.
template <class S>
[[gnu::always_inline]] inline typename S::Mask everywhere() {
  return {~typename S::BitVector{}};
}

/// The lanes of which `regular()` says that kernels take their shapes: all, if that is known.
template <class From, class S, class Regular>
[[gnu::always_inline]] inline typename S::Mask taken_lanes(const Regular& regular) {
  if constexpr (From::taken)
    return everywhere<S>();
  else
    return regular();
}

// The shapes of a kind, given by a null pointer, from the numbers that its class holds.
template <class From, class T>
[[gnu::always_inline]] inline auto load(const From& from, const Sphere<T>*) {
  using S = Lanes<T>;
  S n[4];
  from.template load<4, 0>(n);
  return ShapesInLanes<PointCore<S>, S>{{{{n[0], n[1], n[2]}}, n[3]}, everywhere<S>()};
}
template <class From, class T>
[[gnu::always_inline]] inline auto load(const From& from, const Capsule<T>*) {
  using S = Lanes<T>;
  S n[From::taken ? 2 : 3];
  from.template load<3, 0>(n);
  return ShapesInLanes<AxisCore<S>, S>{{{n[0]}, n[1]}, taken_lanes<From, S>([&]() __attribute__((always_inline)) {
                                         return (n[0] > S(0)) & (n[1] == n[std::size(n) - 1]);
                                       })};
}
template <class From, class T>
[[gnu::always_inline]] inline auto load(const From& from, const Box<T>*) {
  using S = Lanes<T>;
  S n[3];
  from.template load<3, 0>(n);
  const Vec3<S> half{n[0], n[1], n[2]};
  return ShapesInLanes<BoxCore<S>, S>{
      {{half}, S(0)}, taken_lanes<From, S>([&]() __attribute__((always_inline)) { return regular_box(half); })};
}
template <class From, class T>
[[gnu::always_inline]] inline auto load(const From& from, const Rectangle<T>*) {
  using S = Lanes<T>;
  S n[3];
  from.template load<3, 0>(n);
  return ShapesInLanes<BoxCore<S>, S>{
      {{{n[0], n[1], n[2]}}, S(0)},
      taken_lanes<From, S>([&]() __attribute__((always_inline)) { return regular_rectangle(n[0], n[2]); })};
}
template <class From, class T>
[[gnu::always_inline]] inline auto load(const From& from, const Triangle<T>*) {
  using S = Lanes<T>;
  S n[4], m[4], last[1];
  from.template load<9, 0>(n);
  from.template load<9, 4>(m);
  from.template load<9, 8>(last);
  return ShapesInLanes<TriangleCore<S>, S>{{{{{n[0], n[1], n[2]}, {n[3], m[0], m[1]}, {m[2], m[3], last[0]}}}, S(0)},
                                           everywhere<S>()};
}
template <class From, class T>
[[gnu::always_inline]] inline auto load(const From&, const HalfSpace<T>*) {
  using S = Lanes<T>;
  return ShapesInLanes<PlaneCore, S>{{{}, S(0)}, everywhere<S>()};
}

/// The lanes' poses, without rotations where these have no influence.
template <class From, class T>
[[gnu::always_inline]] inline Pose<Lanes<T>> load(const From& from, const Pose<T>*, bool unturned = false) {
  Lanes<T> t[From::taken ? 4 : 3], q[4];  // scattered, four numbers are loaded at once, but not three
  from.template load<7, 0>(t);
  Pose<Lanes<T>> poses;
  poses.translation = {t[0], t[1], t[2]};
  if (unturned) return poses;
  from.template load<7, 3>(q);
  poses.rotation = {q[0], q[1], q[2], q[3]};
  return poses;
}

/// The type of a kind's shapes in lanes.
template <class C, class T>
using LoadedShapes = decltype(load(NumberRows<T>{}, static_cast<const C*>(nullptr)));

}  // namespace graze::GRAZE_ISA
