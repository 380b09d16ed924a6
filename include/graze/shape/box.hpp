// The box, and with zero thickness the rectangle.
//
// Guarantee: held as half extents; every vertex, edge and face has a number that never changes: bit i of a vertex's
// number is set on the positive side of axis i; face 2i is the negative side of axis i and 2i + 1 the positive.
#pragma once

#include "graze/aabb.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

/// A solid box about the origin, its edges along the axes. A rectangle is answered as a box, too.
template <class T>
class Box {
 public:
  static constexpr const char* name = "box";

  /// `size`: the full edge lengths, each >= 0 (zero makes a rectangle, a segment or a point). Throws `InvalidValue`.
  explicit Box(const Vec3<T>& size) : half_(validate::resolved(validate::extents(size, "size")) * T(0.5)) {}

  /// Half of the edge lengths.
  const Vec3<T>& half_extents() const { return half_; }

  T core_radius() const { return T(0); }
  T core_extent() const { return length(half_); }

  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    const Vec3<S> h = converted<S>(half_);
    return {direction.x < S(0) ? -h.x : h.x, direction.y < S(0) ? -h.y : h.y, direction.z < S(0) ? -h.z : h.z};
  }

  /// A face when `direction` leans little from an axis, an edge when it leans little from the plane across one, else
  /// a corner.
  void core_face(const Vec3<T>& direction, Face<T>& face, T lean = face_lean<T>) const {
    face.clear();
    const Vec3<T> n = normalized(direction), a = abs(n);
    const std::size_t major = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    const std::size_t u = (major + 1) % 3, v = (major + 2) % 3;
    const bool positive[3] = {n.x >= T(0), n.y >= T(0), n.z >= T(0)};
    const auto corner = [&](bool positive_u, bool positive_v) {
      Vec3<T> p;
      p[major] = positive[major] ? half_[major] : -half_[major];
      p[u] = positive_u ? half_[u] : -half_[u];
      p[v] = positive_v ? half_[v] : -half_[v];
      // A side of zero length has one corner for its two ends, with one number.
      face.push(p, (std::size_t(positive[major]) << major) | (std::size_t(positive_u && half_[u] > T(0)) << u) |
                       (std::size_t(positive_v && half_[v] > T(0)) << v));
    };
    // A side of zero length has only one end: the face degenerates to an edge or a corner.
    const bool flat_u = a[u] <= lean && half_[u] > T(0), flat_v = a[v] <= lean && half_[v] > T(0);
    if (flat_u && flat_v) {
      face.id = static_cast<std::uint32_t>(2 * major + std::size_t(positive[major]));
      const bool forward = positive[major];  // u, v, major are right-handed
      corner(false, false);
      corner(forward, !forward);
      corner(true, true);
      corner(!forward, forward);
    } else if (flat_u) {
      face.id = edge_id(u);
      corner(false, positive[v]);
      corner(true, positive[v]);
    } else if (flat_v) {
      face.id = edge_id(v);
      corner(positive[u], false);
      corner(positive[u], true);
    } else {
      corner(positive[u], positive[v]);
      face.id = edge_id(3);
    }
  }

  Aabb<T> core_bounds(const Pose<T>& pose) const {
    const Vec3<T> reach = abs(rotation_matrix(pose.rotation)) * half_;
    return {pose.translation - reach, pose.translation + reach};
  }

 private:
  /// Edges are numbered from six, after the faces; two along the same axis differ by their vertices' numbers.
  static constexpr std::uint32_t edge_id(std::size_t axis) { return static_cast<std::uint32_t>(6 + axis); }

  Vec3<T> half_;
};

}  // namespace graze
