// A bundle of pairs in lanes, from rows of shapes and poses. Only for `*.kernel.cpp`.
//
// Guarantee: everything is inlined or lives in the namespace of the level.
#pragma once

#include "narrow/batch/load_shapes.hpp"
#include "narrow/batch/pair_kernels.hpp"

namespace graze::GRAZE_ISA {

/// Whether the rotations of the lanes' shapes have no influence.
template <class Core, class S>
[[gnu::always_inline]] inline bool centred(const Rounded<Core, S>&) {
  return false;
}
template <class S>
[[gnu::always_inline]] inline bool centred(const Rounded<PointCore<S>, S>& balls) {
  return is_origin(balls.core.point);
}

/// The pairs of A and B from the `first`-th row on, one a lane.
template <class A, class B, class T>
struct RowBundle {
  using S = Lanes<T>;
  static constexpr std::size_t lanes = lanes_of<T>;

  LoadedShapes<A, T> a;
  LoadedShapes<B, T> b;
  Pose<S> pose_a, pose_b;

  [[gnu::always_inline]] RowBundle(const PairRows<T>& rows, std::size_t first)
      : a(load(NumberRows<T>{static_cast<const A*>(rows.a) + first}, static_cast<const A*>(nullptr))),
        b(load(NumberRows<T>{static_cast<const B*>(rows.b) + first}, static_cast<const B*>(nullptr))),
        pose_a(load(NumberRows<T>{rows.pose_a + first}, rows.pose_a, centred(a.shapes))),
        pose_b(load(NumberRows<T>{rows.pose_b + first}, rows.pose_b, centred(b.shapes))) {}

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
