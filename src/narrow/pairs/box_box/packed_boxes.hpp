// Two boxes with their numbers packed in rows of three: operations on three numbers at once take a third of the
// instructions for a single pair, and no more across lanes.
//
// Guarantee: the bits of `relative_frame`.
#pragma once

#include "graze/mat3.hpp"
#include "graze/pose.hpp"
#include "narrow/batch/layouts.hpp"
#include "simd/packed.hpp"

namespace graze {

/// Two boxes in the frame of A. The columns of `rotation` are B's axes.
template <class S>
struct BoxPair {
  Vec3<S> half_a, half_b, translation;
  Mat3<S> rotation;
};

/// The two boxes in the frame of B, with B first.
template <class S>
BoxPair<S> seen_from_b(const BoxPair<S>& p) {
  return {p.half_b, p.half_a, -transposed_times(p.rotation, p.translation), transposed(p.rotation)};
}
template <class M, class S>
BoxPair<S> select(const M& condition, const BoxPair<S>& yes, const BoxPair<S>& no) {
  return {select(condition, yes.half_a, no.half_a), select(condition, yes.half_b, no.half_b),
          select(condition, yes.translation, no.translation), select(condition, yes.rotation, no.rotation)};
}

/// A matrix by its rows, packed.
template <class S>
struct Rows {
  Packed<S, 3> row[3];
};
template <class S>
Rows<S> transposed(const Rows<S>& m) {
  const auto& r = m.row;
  return {gathered<0, 0, 0>(r[0], r[1], r[2]), gathered<1, 1, 1>(r[0], r[1], r[2]),
          gathered<2, 2, 2>(r[0], r[1], r[2])};
}
/// The transposed matrix times a vector.
template <class S>
Packed<S, 3> transposed_times(const Rows<S>& m, const Packed<S, 3>& v) {
  return m.row[0] * spread<0>(v) + m.row[1] * spread<1>(v) + m.row[2] * spread<2>(v);
}

/// The rotation matrix of a quaternion, given by its vector part and its real part three times. `per` is two over the
/// squared length of the quaternion and `unit` one; or two and that square, for the matrix times it.
template <class S>
Rows<S> rotation_rows(const Packed<S, 3>& vector, const Packed<S, 3>& w, const S& per, const S& unit) {
  using Row = Packed<S, 3>;
  const Row scaled = vector * Row(per);
  const Row squares = vector * scaled, products = permuted<0, 0, 1>(vector) * permuted<1, 2, 2>(scaled),
            by_w = w * permuted<2, 1, 0>(scaled);
  const Row diagonal = Row(unit) - (permuted<1, 0, 0>(squares) + permuted<2, 2, 1>(squares)), more = products + by_w,
            less = products - by_w;
  return {gathered<0, 0, 1>(diagonal, less, more), gathered<0, 1, 2>(more, diagonal, less),
          gathered<1, 2, 2>(less, more, diagonal)};
}

/// A pose in packed rows.
template <class S>
struct PoseRows {
  using Row = Packed<S, 3>;
  Row translation, vector, w;  ///< `w`: the real part three times

  explicit PoseRows(const Pose<S>& pose) {
    if constexpr (Row::joined) {
      // One load each, which reads beyond its numbers; the last number of the rotation is the pose's last.
      const S* const numbers = reinterpret_cast<const S*>(&pose);
      const Packed<S, 4> rotation = Packed<S, 4>::load(numbers + 3);
      translation = Row::load(numbers);
      vector = first_three(rotation);
      w = spread<3>(rotation);
    } else {
      translation = Row(pose.translation);
      vector = Row(pose.rotation.vector());
      w = Row(pose.rotation.w);
    }
  }
  PoseRows(const Row& at, const Row& of_vector, const Row& real) : translation(at), vector(of_vector), w(real) {}
  /// The squared length of the quaternion.
  S length_squared() const { return sum(vector * vector) + (w * w)[0]; }
  Rows<S> rotation() const { return rotation_rows(vector, w, S(2) / length_squared(), S(1)); }

  friend PoseRows select(const typename Row::Mask& condition, const PoseRows& yes, const PoseRows& no) {
    return {select(condition, yes.translation, no.translation), select(condition, yes.vector, no.vector),
            select(condition, yes.w, no.w)};
  }
};

/// The rotation from the frame of B to the frame of A; `per` and `unit` as for `rotation_rows`.
template <class S>
Rows<S> relative_rotation(const PoseRows<S>& a, const PoseRows<S>& b, const S& per, const S& unit) {
  using Row = Packed<S, 3>;
  const Row back = -a.vector;
  return rotation_rows(b.vector * a.w + back * b.w +
                           (following(back) * preceding(b.vector) - preceding(back) * following(b.vector)),
                       a.w * b.w - Row(sum(back * b.vector)), per, unit);
}

/// A `BoxPair` in packed rows.
template <class S>
struct BoxRows {
  using Row = Packed<S, 3>;
  Row half_a, half_b, translation;
  Rows<S> rotation;

  explicit BoxRows(const BoxPair<S>& p)
      : half_a(p.half_a),
        half_b(p.half_b),
        translation(p.translation),
        rotation{Row(p.rotation.row[0]), Row(p.rotation.row[1]), Row(p.rotation.row[2])} {}
  BoxRows(const Row& of_a, const Row& of_b, const Row& from_a, const Rows<S>& turn)
      : half_a(of_a), half_b(of_b), translation(from_a), rotation(turn) {}
  /// The boxes in place, with B transformed to the frame of A.
  BoxRows(const Row& of_a, const PoseRows<S>& a, const Row& of_b, const PoseRows<S>& b) : half_a(of_a), half_b(of_b) {
    rotation = relative_rotation(a, b, S(2) / (a.length_squared() * b.length_squared()), S(1));
    translation = transposed_times(a.rotation(), b.translation - a.translation);
  }
};

}  // namespace graze
