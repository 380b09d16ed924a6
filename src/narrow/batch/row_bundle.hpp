// A bundle of pairs in lanes, from rows of shapes and poses. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/layouts.hpp"
#include "narrow/batch/pair_kernels.hpp"
#include "narrow/core/core.hpp"
#include "narrow/pairs/box_box/reference_axis.hpp"
#include "simd/rows.hpp"

namespace graze::GRAZE_ISA {

/// The lanes' shapes, and the lanes in which they are regular, so that kernels take them.
template <class Core, class S>
struct RowShapes {
  Rounded<Core, S> shapes;
  typename S::Mask regular;
};

/// The mask with all lanes set.
template <class S>
[[gnu::always_inline]] inline typename S::Mask everywhere() {
  return {~typename S::BitVector{}};
}

template <class T>
[[gnu::always_inline]] inline auto load_rows(const void* from, const Sphere<T>*) {
  using S = Lanes<T>;
  S n[4];
  load_rows<4, 0, T>(from, n);
  return RowShapes<PointCore<S>, S>{{{{n[0], n[1], n[2]}}, n[3]}, everywhere<S>()};
}
template <class T>
[[gnu::always_inline]] inline auto load_rows(const void* from, const Capsule<T>*) {
  using S = Lanes<T>;
  S n[3];
  load_rows<3, 0, T>(from, n);
  return RowShapes<AxisCore<S>, S>{{{n[0]}, n[1]}, (n[0] > S(0)) & (n[1] == n[2])};
}
template <class T>
[[gnu::always_inline]] inline auto load_rows(const void* from, const Box<T>*) {
  using S = Lanes<T>;
  S n[3];
  load_rows<3, 0, T>(from, n);
  const Vec3<S> half{n[0], n[1], n[2]};
  return RowShapes<BoxCore<S>, S>{{{half}, S(0)}, regular_box(half)};
}

template <class T>
[[gnu::always_inline]] inline auto load_rows(const void* from, const Rectangle<T>*) {
  using S = Lanes<T>;
  S n[3];
  load_rows<3, 0, T>(from, n);
  return RowShapes<BoxCore<S>, S>{{{{n[0], n[1], n[2]}}, S(0)}, regular_rectangle(n[0], n[2])};
}
template <class T>
[[gnu::always_inline]] inline auto load_rows(const void* from, const Triangle<T>*) {
  using S = Lanes<T>;
  S n[4], m[4], last[1];
  load_rows<9, 0, T>(from, n);
  load_rows<9, 4, T>(from, m);
  load_rows<9, 8, T>(from, last);
  return RowShapes<TriangleCore<S>, S>{{{{{n[0], n[1], n[2]}, {n[3], m[0], m[1]}, {m[2], m[3], last[0]}}}, S(0)},
                                       everywhere<S>()};
}
template <class T>
[[gnu::always_inline]] inline auto load_rows(const void*, const HalfSpace<T>*) {
  using S = Lanes<T>;
  return RowShapes<PlaneCore, S>{{{}, S(0)}, everywhere<S>()};
}

/// Whether the rotations of the lanes' shapes have no influence.
template <class Core, class S>
[[gnu::always_inline]] inline bool centred(const Rounded<Core, S>&) {
  return false;
}
template <class S>
[[gnu::always_inline]] inline bool centred(const Rounded<PointCore<S>, S>& balls) {
  return is_origin(balls.core.point);
}

/// The lanes' poses, without rotations where these have no influence.
template <class T>
[[gnu::always_inline]] inline Pose<Lanes<T>> load_rows(const Pose<T>* from, bool unturned) {
  Lanes<T> t[3], q[4];
  load_rows<7, 0, T>(from, t);
  Pose<Lanes<T>> poses;
  poses.translation = {t[0], t[1], t[2]};
  if (unturned) return poses;
  load_rows<7, 3, T>(from, q);
  poses.rotation = {q[0], q[1], q[2], q[3]};
  return poses;
}

/// The pairs of A and B from the `first`-th row on, one a lane.
template <class A, class B, class T>
struct RowBundle {
  using S = Lanes<T>;
  static constexpr std::size_t lanes = lanes_of<T>;

  decltype(load_rows(nullptr, static_cast<const A*>(nullptr))) a;
  decltype(load_rows(nullptr, static_cast<const B*>(nullptr))) b;
  Pose<S> pose_a, pose_b;

  [[gnu::always_inline]] RowBundle(const PairRows<T>& rows, std::size_t first)
      : a(load_rows(static_cast<const A*>(rows.a) + first, static_cast<const A*>(nullptr))),
        b(load_rows(static_cast<const B*>(rows.b) + first, static_cast<const B*>(nullptr))),
        pose_a(load_rows(rows.pose_a + first, centred(a.shapes))),
        pose_b(load_rows(rows.pose_b + first, centred(b.shapes))) {}

  /// The lanes in which both shapes are regular.
  [[gnu::always_inline]] typename S::Mask regular() const { return a.regular & b.regular; }
};

/// Number of pairs ahead of a kernel's present one whose rows are prefetched. A bundle at a time: a processor fetches a
/// few dozen lines at once and delays more. Those of a whole chunk at once took a fifth of the time of contacts of
/// boxes.
inline constexpr std::size_t rows_ahead = 64;

/// Prefetches the rows of a bundle that begins with the `first`-th, which may be behind the end.
template <class A, class B, class T>
[[gnu::always_inline]] inline void fetch_rows(const PairRows<T>& rows, std::size_t first) {
  fetch_lines<false>(static_cast<const A*>(rows.a) + first, lanes_of<T>);
  fetch_lines<false>(static_cast<const B*>(rows.b) + first, lanes_of<T>);
  fetch_lines<false>(rows.pose_a + first, lanes_of<T>);
  fetch_lines<false>(rows.pose_b + first, lanes_of<T>);
}

/// Writes the indices of the lanes whose bits are set, the first lane's being `first`.
[[gnu::always_inline]] inline void append_places(std::uint32_t bits, std::size_t first, std::uint8_t* places,
                                                 std::uint32_t& count) {
  for (; bits != 0; ++first, bits >>= 1)
    if ((bits & 1) != 0) places[count++] = static_cast<std::uint8_t>(first);
}

template <std::size_t N>
struct ByteVector {
  typedef std::uint8_t type __attribute__((vector_size(N)));
};

/// Writes the first `count` lanes of integers, a byte each.
template <class T>
[[gnu::always_inline]] inline void put_bytes(const typename Lanes<T>::BitVector& whole, std::size_t count,
                                             std::uint8_t* to) {
  using Bytes = typename ByteVector<lanes_of<T>>::type;
  const Bytes bytes = __builtin_convertvector(whole, Bytes);
  if (count == static_cast<std::size_t>(lanes_of<T>)) {
    std::memcpy(to, &bytes, sizeof bytes);
  } else {
    for (std::size_t i = 0; i < count; ++i) to[i] = bytes[i];
  }
}

}  // namespace graze::GRAZE_ISA
