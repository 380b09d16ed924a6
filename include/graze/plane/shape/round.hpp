// The round shapes of the plane: circle, capsule, ellipse.
//
// Guarantee: any sizes >= 0; a zero one degenerates the shape (a capsule of zero height to a circle, an ellipse with a
// zero radius to a segment). Constructors throw `InvalidValue` for other numbers.
#pragma once

#include "graze/detail/validate.hpp"
#include "graze/plane/vec2.hpp"

namespace graze::plane {

/// A disc about the origin.
template <class T>
class Circle {
 public:
  static constexpr const char* name = "circle";

  /// A disc of `radius`. Throws `InvalidValue` if it is negative, not finite or too large.
  explicit Circle(T radius) : radius_(validate::extent(radius, "radius")) {}

  /// The radius.
  T radius() const { return radius_; }
  T core_extent() const { return radius_; }

 private:
  T radius_;
};

/// The convex hull of two discs on the Y axis, of equal radius or not (tapered). One disc may hold the other: then the
/// capsule is that disc.
template <class T>
class Capsule {
 public:
  static constexpr const char* name = "capsule";

  /// A capsule with `height` between the centres of the discs, which lie on the Y axis about the origin.
  Capsule(T height, T radius_bottom, T radius_top)
      : half_height_(validate::extent(height, "height") / T(2)),
        radius_bottom_(validate::extent(radius_bottom, "radiusBottom")),
        radius_top_(validate::extent(radius_top, "radiusTop")) {}
  /// An untapered capsule: both discs have one radius.
  Capsule(T height, T radius) : Capsule(height, radius, radius) {}

  /// Half of the height, along Y.
  T half_height() const { return half_height_; }
  /// The radius at -Y.
  T radius_bottom() const { return radius_bottom_; }
  /// The radius at +Y.
  T radius_top() const { return radius_top_; }
  /// Whether the radii differ.
  bool tapered() const { return radius_bottom_ != radius_top_; }
  T core_extent() const { return half_height_ + greatest(radius_bottom_, radius_top_); }

 private:
  T half_height_, radius_bottom_, radius_top_;
};

/// An ellipse about the origin.
template <class T>
class Ellipse {
 public:
  static constexpr const char* name = "ellipse";

  /// An ellipse with `radii` along the axes.
  explicit Ellipse(const Vec2<T>& radii)
      : radii_{validate::extent(radii.x, "radii[0]"), validate::extent(radii.y, "radii[1]")} {}

  /// The radii along X and Y.
  const Vec2<T>& radii() const { return radii_; }
  T core_extent() const { return max_abs(radii_); }

 private:
  Vec2<T> radii_;
};

}  // namespace graze::plane
