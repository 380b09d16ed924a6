// The capsule: the convex hull of two balls, of equal radius or not (tapered).
//
// Guarantee: the core of an untapered capsule is its segment; that of a tapered one is the capsule less a ball of the
// smaller radius (the hull of a ball and a point). One ball may hold the other: then the capsule is that ball.
#pragma once

#include "graze/aabb.hpp"
#include "graze/detail/validate.hpp"
#include "graze/pose.hpp"
#include "graze/shape/face.hpp"

namespace graze {

/// The convex hull of two balls on the Y axis.
template <class T>
class Capsule {
 public:
  static constexpr const char* name = "capsule";

  /// A capsule with `height` between the centres of the balls, which lie on the Y axis about the origin; all >= 0.
  Capsule(T height, T radius_bottom, T radius_top)
      : half_height_(validate::size(height, "height") / T(2)),
        radius_bottom_(validate::size(radius_bottom, "radiusBottom")),
        radius_top_(validate::size(radius_top, "radiusTop")) {}
  /// An untapered capsule: both balls have one radius.
  Capsule(T height, T radius) : Capsule(height, radius, radius) {}

  /// Half of the height, along Y.
  T half_height() const { return half_height_; }
  /// The radius at -Y.
  T radius_bottom() const { return radius_bottom_; }
  /// The radius at +Y.
  T radius_top() const { return radius_top_; }
  /// Whether the radii differ.
  bool tapered() const { return radius_bottom_ != radius_top_; }

  T core_radius() const { return least(radius_bottom_, radius_top_); }
  T core_extent() const { return half_height_ + greatest(radius_bottom_, radius_top_) - core_radius(); }

  template <class S>
  Vec3<S> core_support(const Vec3<S>& direction) const {
    const S h(half_height_);
    if (!tapered()) return {S(0), direction.y < S(0) ? -h : h, S(0)};
    const S bottom(radius_bottom_ - core_radius()), top(radius_top_ - core_radius());
    const Vec3<S> n = normalized(direction);
    const bool up = h * n.y + top >= bottom - h * n.y;
    return Vec3<S>{S(0), up ? h : -h, S(0)} + n * (up ? top : bottom);
  }

  /// The generator of the side that faces `direction`, where one does; else a point of an end ball.
  void core_face(const Vec3<T>& direction, Face<T>& face, T lean = face_lean<T>) const {
    face.clear();
    const Vec3<T> n = normalized(direction);
    const T bottom = radius_bottom_ - core_radius(), top = radius_top_ - core_radius();
    const T height = T(2) * half_height_;
    // The side leans from the axis by the angle whose sine is (bottom - top) / height.
    const T rise = n.y * height - (bottom - top);
    if (height > magnitude(bottom - top) && magnitude(rise) <= lean * height) {
      // The generators end where the end balls' normals equal the side's.
      const Vec3<T> across = normalized(Vec3<T>{n.x, T(0), n.z}, {T(1), T(0), T(0)});
      using std::sqrt;
      const T s = (bottom - top) / height, c = sqrt(T(1) - s * s);
      const Vec3<T> side{across.x * c, s, across.z * c};
      face.push(Vec3<T>{T(0), -half_height_, T(0)} + side * bottom, 0);
      face.push(Vec3<T>{T(0), half_height_, T(0)} + side * top, 1);
      return;
    }
    face.push(core_support(direction), rise > T(0) ? 1 : 0);
    face.id = rise > T(0) ? 2 : 1;
  }

  Aabb<T> core_bounds(const Pose<T>& pose) const {
    const T r = core_radius();
    const Vec3<T> axis = rotate(pose.rotation, Vec3<T>{T(0), half_height_, T(0)});
    const Vec3<T> low = pose.translation - axis, high = pose.translation + axis;
    return merged(inflated(Aabb<T>{low, low}, radius_bottom_ - r), inflated(Aabb<T>{high, high}, radius_top_ - r));
  }

 private:
  static T magnitude(T v) { return v < T(0) ? -v : v; }

  T half_height_, radius_bottom_, radius_top_;
};

}  // namespace graze
