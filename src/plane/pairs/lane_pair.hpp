// Two convex shapes in place, one pair a lane, as the special pairs of the plane see them.
//
// Guarantee: everything in this folder is written over S, the lanes of doubles, in + - * / sqrt, comparisons and
// selections; so a pair has the same bits alone and beside others, at every level of the instruction set. The few
// branches skip a part that no lane needs, and change no lane's answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "graze/plane/pose2.hpp"
#include "graze/wide.hpp"
#include "narrow/manifold/features.hpp"

namespace graze::plane {

/// The cores of the special pairs, the later ones giving the frame of a pair.
enum class LaneCore : std::uint8_t {
  point,       ///< at the origin
  segment,     ///< between two points, which may be one
  box,         ///< about the origin
  half_plane,  ///< y <= 0
};

/// The numbers that a shape in place is loaded as: its pose (translation, cosine, sine), its size (the ends of a
/// segment, half the edges of a box) and its rounding radius.
inline constexpr std::size_t pose_columns = 4, size_columns = 4, shape_columns = pose_columns + size_columns + 1;

/// A shape in place.
template <class S>
struct LaneShape {
  Pose2<S> pose;
  S size[size_columns];
  S radius;
};

/// The largest difference from 1 of the square of a rotation's length for a special pair to take it.
inline constexpr double longest_rotation = 1e-4;

/// The rotation at unit length up to the third power of `longest_rotation`: the series of the inverse square root.
template <class S>
[[gnu::always_inline]] inline Rot2<S> at_unit_length(const Rot2<S>& q) {
  const S excess = q.cosine * q.cosine + q.sine * q.sine - S(1), scale = S(1) - excess * (S(0.5) - S(0.375) * excess);
  return {q.cosine * scale, q.sine * scale};
}
template <class S>
[[gnu::always_inline]] inline auto near_unit_length(const Rot2<S>& q) {
  return abs(q.cosine * q.cosine + q.sine * q.sine - S(1)) <= S(longest_rotation);
}

/// A pair seen from A. Two points are seen from an upright frame about A: their rotations do not matter.
template <class S>
struct LanePair {
  LaneShape<S> a, b;
  Rot2<S> rotation_a;  ///< of unit length
  Pose2<S> b_in_a;

  [[gnu::always_inline]] LanePair(const LaneShape<S>& of_a, const LaneShape<S>& of_b, bool upright) : a(of_a), b(of_b) {
    const Vec2<S> between = b.pose.translation - a.pose.translation;
    if (upright) {
      b_in_a.translation = between;
      return;
    }
    rotation_a = at_unit_length(a.pose.rotation);
    b_in_a = {inverse_rotate(rotation_a, between), inverse(rotation_a) * at_unit_length(b.pose.rotation)};
  }
  S radius() const { return a.radius + b.radius; }
};

/// The signed distance of two cores, rounding aside, and the points that realise it, in A's frame.
template <class S>
struct LaneNearest {
  S distance;
  Vec2<S> normal;          ///< unit, from A to B
  Vec2<S> a, b;            ///< on the cores
  S feature_a, feature_b;  ///< as whole numbers
};

/// 1 or -1.
template <class S>
[[gnu::always_inline]] inline S sign_of(const S& x) {
  return select(x < S(0), S(-1), S(1));
}
template <class S>
[[gnu::always_inline]] inline S clamped(const S& x, const S& half) {
  return greatest(-half, least(x, half));
}

template <class S>
[[gnu::always_inline]] inline S vertex_number(const S& number) {
  return number + S(double(vertex_feature(0)));
}
template <class S>
[[gnu::always_inline]] inline S side_number(const S& number) {
  return number + S(double(graze::detail::feature_of_kind(2, 0)));
}

/// Distances of cores up to this, relative to the numbers that they were made of, are rounding and have no direction:
/// some sixteen operations, each half a unit off.
inline constexpr double touching = 16 * std::numeric_limits<double>::epsilon();

}  // namespace graze::plane
