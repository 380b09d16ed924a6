// The Minkowski difference of two small hulls, whose vertices are scanned.
//
// Guarantee: as `MinkowskiDifference` of their cores, to the last bit. A query is one call of a kernel, in which the
// two scans run beside each other.
#pragma once

#include "narrow/support_point.hpp"
#include "shape/furthest_vertex.hpp"

namespace graze {

/// B - A, B turned and moved into A's frame.
template <class T>
struct HullPair {
  ScannedHull<T> a, b;
  Mat3d rotation;
  Vec3d translation;
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// The point of the difference that lies least far along a direction.
    template <class T> void hull_support(const HullPair<T>& hulls, const Vec3d& direction, SupportPoint& point);)
// clang-format on

template <class T>
class HullDifference {
 public:
  /// Both hulls have blocks.
  HullDifference(const HullData<T>& a, const HullData<T>& b, const Posed& b_in_a)
      : hulls_{scanned(a), scanned(b), rotation_matrix(b_in_a.rotation), b_in_a.translation},
        support_(kernel()),
        size_(static_cast<double>(greatest(a.extent, b.extent))),
        reach_(size_ + max_abs(b_in_a.translation)) {}

  SupportPoint support(const Vec3d& direction) const {
    SupportPoint point;
    support_(hulls_, direction, point);
    return point;
  }
  const Vec3d& center_offset() const { return hulls_.translation; }
  double size() const { return size_; }
  double reach() const { return reach_; }

 private:
  using Support = void (*)(const HullPair<T>&, const Vec3d&, SupportPoint&);
  static Support kernel() {
    static const Support chosen = GRAZE_KERNEL(chosen_isa(), hull_support<T>);
    return chosen;
  }

  HullPair<T> hulls_;
  Support support_;
  double size_, reach_;
};

}  // namespace graze
