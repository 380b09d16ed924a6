// The Minkowski difference of two small hulls, whose vertices are scanned; or of one and a `ScannedShape`.
//
// Guarantee: that of `MinkowskiDifference` of their cores, to the last bit, except that of two corners of a box or a
// segment equally far along a direction up to rounding either may be found. A query is one call of a kernel, in which
// the two scans run in parallel.
#pragma once

#include "narrow/core/support_point.hpp"
#include "shape/furthest_vertex.hpp"

namespace graze {

/// B - A, B rotated and moved into A's frame.
template <class T>
struct HullPair {
  ScannedHull<T> a, b;
  Mat3d rotation;
  Vec3d translation;
};

/// B's vertices in A's frame: queries that read them transform neither a direction nor a point, a latency that would
/// add to each query's.
struct PlacedVertices {
  static constexpr std::size_t room = most_scan_blocks * VertexBlock::size;
  alignas(64) double x[room], y[room], z[room];
  VertexBlock turned[most_scan_blocks];  ///< without the translation, rounded
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// The support point of the difference: the one least far along a direction.
    template <class T> void hull_support(const HullPair<T>& hulls, const Vec3d& direction, SupportPoint& point);
    /// Transforms B's vertices. Costs as much as two or three queries.
    template <class T> void place_vertices(const HullPair<T>& hulls, PlacedVertices& placed);
    /// The point of `hull_support`, to the last bit, from placed vertices.
    template <class T> void placed_support(const HullPair<T>& hulls, const PlacedVertices& placed,
                                           const Vec3d& direction, SupportPoint& point);)
// clang-format on

template <class T>
class HullDifference {
 public:
  /// `size`: the larger of their extents.
  HullDifference(const ScannedHull<T>& a, const ScannedHull<T>& b, T size, const Posed& b_in_a)
      : hulls_{a, b, rotation_matrix(b_in_a.rotation), b_in_a.translation},
        size_(static_cast<double>(size)),
        reach_(size_ + max_abs(b_in_a.translation)) {}

  /// The support point for the first query, which often suffices to separate two hulls; needs no `place()`.
  SupportPoint first_support(const Vec3d& direction) const {
    static const auto kernel = GRAZE_KERNEL(chosen_isa(), hull_support<T>);
    SupportPoint point;
    kernel(hulls_, direction, point);
    return point;
  }
  /// Transforms B's vertices, before all other queries.
  void place() {
    static const auto kernel = GRAZE_KERNEL(chosen_isa(), place_vertices<T>);
    kernel(hulls_, placed_);
  }
  SupportPoint support(const Vec3d& direction) const {
    SupportPoint point;
    support_(hulls_, placed_, direction, point);
    return point;
  }
  const HullPair<T>& hulls() const { return hulls_; }
  const PlacedVertices& placed() const { return placed_; }
  const Vec3d& center_offset() const { return hulls_.translation; }
  double size() const { return size_; }
  double reach() const { return reach_; }

 private:
  using Support = void (*)(const HullPair<T>&, const PlacedVertices&, const Vec3d&, SupportPoint&);
  static Support kernel() {
    static const Support chosen = GRAZE_KERNEL(chosen_isa(), placed_support<T>);
    return chosen;
  }

  HullPair<T> hulls_;
  Support support_ = kernel();
  double size_, reach_;
  PlacedVertices placed_;
};

}  // namespace graze
