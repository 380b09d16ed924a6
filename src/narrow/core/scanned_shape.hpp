// Cores with few corners as hulls that are scanned: a ball's centre, a segment, a triangle, a box, a small hull.
//
// Guarantee: the corners are those of `ShapeCore`, ordered so that the first of several equally far along a direction
// is the one that it returns.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "narrow/core/core.hpp"
#include "shape/furthest_vertex.hpp"

namespace graze {

template <class T>
bool is_hull(const Shape<T>& shape) {
  return shape.template as<ConvexHull<T>>() != nullptr;
}

/// Whether a shape's core has few corners and no other points.
template <class C>
bool is_scannable(const C& concrete) {
  return has_core(concrete);
}
template <class T>
bool is_scannable(const Triangle<T>&) {
  return true;
}
template <class T>
bool is_scannable(const ConvexHull<T>& hull) {
  return !hull.data().blocks.empty();
}
template <class T>
bool is_scannable(const Shape<T>& shape) {
  return shape.visit([](const auto& concrete) { return is_scannable(concrete); });
}

template <class T>
class ScannedShape {
 public:
  /// Takes a scannable shape, which must outlive this object.
  explicit ScannedShape(const Shape<T>& shape) {
    // `this->`: clang 14 does not take `take` alone for a use of `this`.
    shape.visit([this](const auto& concrete) { this->take(concrete); });
  }
  ScannedShape(const ScannedShape&) = delete;
  ScannedShape& operator=(const ScannedShape&) = delete;

  const ScannedHull<T>& view() const { return view_; }
  /// The greatest distance of a corner from the frame's origin.
  T extent() const { return extent_; }

 private:
  void take(const ConvexHull<T>& hull) {
    view_ = scanned(hull.data());
    extent_ = hull.data().extent;
  }
  void take(const Triangle<T>& triangle) { take({triangle.point(0), triangle.point(1), triangle.point(2)}); }
  void take(const LineSegment<T>& segment) { take({segment.point(0), segment.point(1)}); }
  void take(const Capsule<T>& capsule) {
    take({{T(0), capsule.half_height(), T(0)}, {T(0), -capsule.half_height(), T(0)}});
  }
  template <class C>
  void take(const C& concrete) {
    take_core(core_of(concrete));
  }

  void take_core(const PointCore<T>& core) { take({core.point}); }
  void take_core(const BoxCore<T>& core) {
    const auto& [x, y, z] = core.half;
    take({{x, y, z}, {-x, y, z}, {x, -y, z}, {-x, -y, z}, {x, y, -z}, {-x, y, -z}, {x, -y, -z}, {-x, -y, -z}});
  }
  template <class Other>
  void take_core(const Other&) {}  // no scannable shape has another core
  void take(std::initializer_list<Vec3<T>> corners) {
    std::copy(corners.begin(), corners.end(), corners_);
    extent_ = T(0);
    for (const Vec3<T>& corner : corners) extent_ = greatest(extent_, length(corner));
    view_ = {&block_, corners_, static_cast<std::uint32_t>(corners.size()), static_cast<float>(extent_)};
    fill_block(corners_, corners.size(), block_);
  }

  ScannedHull<T> view_;
  T extent_;
  // Storage for shapes other than hulls.
  VertexBlock block_;
  Vec3<T> corners_[8];
};

}  // namespace graze
