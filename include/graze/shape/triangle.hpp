// The triangle and the line segment, alone, as shapes without thickness.
//
// Guarantee: any vertices up to `largest_magnitude`, degenerate ones included (a triangle may be a sliver, a segment or
// a point).
#pragma once

#include "graze/aabb.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

namespace detail {

/// The index of the vertex furthest along `direction`; the first of equal ones.
template <class S, class T>
std::size_t furthest(const Vec3<T>* vertices, std::size_t count, const Vec3<S>& direction) {
  std::size_t best = 0;
  S most = dot(converted<S>(vertices[0]), direction);
  for (std::size_t i = 1; i < count; ++i) {
    const S along = dot(converted<S>(vertices[i]), direction);
    if (along > most) {
      most = along;
      best = i;
    }
  }
  return best;
}

/// The bounds of points under a pose.
template <class T>
Aabb<T> bounds_of(const Vec3<T>* vertices, std::size_t count, const Pose<T>& pose) {
  Aabb<T> bounds = Aabb<T>::empty();
  for (std::size_t i = 0; i < count; ++i) bounds = merged(bounds, transform(pose, vertices[i]));
  return bounds;
}

}  // namespace detail

/// A triangle without thickness.
template <class T>
class Triangle {
 public:
  static constexpr const char* name = "triangle";

  /// A triangle, counter-clockwise seen from its front. Throws `InvalidValue`.
  Triangle(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c)
      : points_{validate::vertex(a, "points[0]"), validate::vertex(b, "points[1]"), validate::vertex(c, "points[2]")} {}

  /// The i-th vertex.
  const Vec3<T>& point(std::size_t i) const { return points_[i]; }

  T core_radius() const { return T(0); }
  T core_extent() const { return greatest(length(points_[0]), greatest(length(points_[1]), length(points_[2]))); }
  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    return converted<S>(points_[detail::furthest(points_, 3, direction)]);
  }
  /// The whole triangle (from either side), an edge or a vertex.
  void core_face(const Vec3<T>& direction, Face<T>& face, T lean = face_lean<T>) const {
    face.clear();
    const Vec3<T> n = normalized(direction);
    const Vec3<T> m = normalized(cross(points_[1] - points_[0], points_[2] - points_[0]), Vec3<T>{});
    const T sine = length(cross(n, m));
    const T facing = dot(n, m);
    if (m != Vec3<T>{} && sine <= lean) {
      const bool front = facing > T(0);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = front ? i : 2 - i;
        face.push(points_[k], k);
      }
      face.id = front ? 0 : 1;
      return;
    }
    const std::size_t top = detail::furthest(points_, 3, n);
    // The flatter of the two edges that leave the top vertex: seen along the triangle, the other may lie below it.
    const std::size_t next = (top + 1) % 3, last = (top + 2) % 3;
    const auto fall = [&](std::size_t v) { return dot(normalized(points_[top] - points_[v], Vec3<T>{}), n); };
    const std::size_t other = fall(last) < fall(next) ? last : next;
    if (fall(other) <= lean) {
      face.push(points_[least(top, other)], least(top, other));
      face.push(points_[greatest(top, other)], greatest(top, other));
      face.id = static_cast<std::uint32_t>(2 + top + other);
      return;
    }
    face.push(points_[top], top);
    face.id = 6;
  }
  Aabb<T> core_bounds(const Pose<T>& pose) const { return detail::bounds_of(points_, 3, pose); }

 private:
  Vec3<T> points_[3];
};

/// The segment between two points, as a shape (with a margin, a capsule in any place).
template <class T>
class LineSegment {
 public:
  static constexpr const char* name = "segment";

  /// The segment from `a` to `b`. Throws `InvalidValue`.
  LineSegment(const Vec3<T>& a, const Vec3<T>& b)
      : points_{validate::vertex(a, "points[0]"), validate::vertex(b, "points[1]")} {}

  /// The i-th end.
  const Vec3<T>& point(std::size_t i) const { return points_[i]; }

  T core_radius() const { return T(0); }
  T core_extent() const { return greatest(length(points_[0]), length(points_[1])); }
  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    return converted<S>(points_[detail::furthest(points_, 2, direction)]);
  }
  void core_face(const Vec3<T>& direction, Face<T>& face, T lean = face_lean<T>) const {
    face.clear();
    const Vec3<T> edge = points_[1] - points_[0];
    const T along = dot(normalized(direction), edge);
    const T limit = lean * length(edge);
    if (along <= limit) face.push(points_[0], 0);
    if (-along <= limit) face.push(points_[1], 1);
  }
  Aabb<T> core_bounds(const Pose<T>& pose) const { return detail::bounds_of(points_, 2, pose); }

 private:
  Vec3<T> points_[2];
};

}  // namespace graze
