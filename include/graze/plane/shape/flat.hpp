// The shapes of the plane with straight sides: box, segment, convex polygon, half-plane.
//
// Guarantee: vertices run counter-clockwise and keep their numbers; edge i leads from vertex i to the next.
// Constructors throw `InvalidValue` for numbers that are not finite, or larger than `largest_magnitude`.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "graze/detail/validate.hpp"
#include "graze/plane/vec2.hpp"

namespace graze::plane {

namespace detail {

/// A point with coordinates up to `largest_magnitude`, returned unchanged. Throws `InvalidValue` with `path`.
template <class T>
Vec2<T> checked_point(const Vec2<T>& v, const std::string& path) {
  if (const char* expectation = validate::fault_of_coordinate(v.x))
    validate::fail(path + "[0]", expectation, static_cast<double>(v.x));
  if (const char* expectation = validate::fault_of_coordinate(v.y))
    validate::fail(path + "[1]", expectation, static_cast<double>(v.y));
  return v;
}

}  // namespace detail

/// A solid rectangle about the origin, its edges along the axes. A zero size makes a segment or a point.
template <class T>
class Box {
 public:
  static constexpr const char* name = "box";

  /// A box of `size`: the full edge lengths, each >= 0.
  explicit Box(const Vec2<T>& size)
      : half_{validate::extent(size.x, "size[0]") / T(2), validate::extent(size.y, "size[1]") / T(2)} {}

  /// Half of the edge lengths.
  const Vec2<T>& half_extents() const { return half_; }
  T core_extent() const { return length(half_); }

 private:
  Vec2<T> half_;
};

/// The segment between two points, both included; a point when they are equal.
template <class T>
class Segment {
 public:
  static constexpr const char* name = "segment";

  /// The segment from `a` to `b`.
  Segment(const Vec2<T>& a, const Vec2<T>& b)
      : a_(detail::checked_point(a, "points[0]")), b_(detail::checked_point(b, "points[1]")) {}

  /// The first end.
  const Vec2<T>& a() const { return a_; }
  /// The second end.
  const Vec2<T>& b() const { return b_; }
  T core_extent() const { return greatest(length(a_), length(b_)); }

 private:
  Vec2<T> a_, b_;
};

/// A convex polygon of any number of vertices; a segment or a point where all its vertices coincide or are collinear.
/// Up to eight vertices are stored in place, more are shared between copies.
template <class T>
class GRAZE_API ConvexPolygon {
 public:
  static constexpr const char* name = "convex";
  /// Number of vertices stored in the shape itself; more are shared by its copies.
  static constexpr std::size_t in_place = 8;

  /// The convex hull of at least one point, in any order; points inside, on edges and duplicates are left out. Exact:
  /// the side of a line that a point lies on is decided without rounding. Cost n log n.
  explicit ConvexPolygon(std::span<const Vec2<T>> points);

  /// The vertices of the hull, counter-clockwise from the lowest (of two, the one on the left).
  std::span<const Vec2<T>> vertices() const {
    return count_ <= in_place ? std::span<const Vec2<T>>(inside_.data(), count_) : std::span<const Vec2<T>>(*outside_);
  }
  T core_extent() const { return extent_; }

 private:
  std::array<Vec2<T>, in_place> inside_{};
  std::shared_ptr<const std::vector<Vec2<T>>> outside_;
  std::size_t count_ = 0;
  T extent_{};
};

/// All points with y <= 0, its surface normal +Y; a rounding moves the surface up.
template <class T>
class HalfPlane {
 public:
  static constexpr const char* name = "plane";

  T core_extent() const { return T(0); }
};

extern template class ConvexPolygon<float>;
extern template class ConvexPolygon<double>;

}  // namespace graze::plane
