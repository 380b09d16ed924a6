// Pairs of cores as the kernel `mpr_overlaps` takes them: a column for each number.
//
// Guarantee: numbers are those of the shapes and poses, and the offset between two the difference of these, each
// rounded to float. Nothing is allocated.
#pragma once

#include <cstddef>
#include <cstdint>

#include "graze/shape.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// Kinds of cores for the kernel.
enum class PortalSide : std::uint8_t {
  sum,     ///< the Minkowski sum of a box and an ellipsoid, about one centre
  points,  ///< the hull of three points, which may be the same
  none
};

/// Number of pairs passed in at a time, a multiple of all numbers of lanes.
inline constexpr std::size_t portal_chunk = 64;

struct PortalPairs {
  using Column = float[portal_chunk];

  /// The columns of a side: for a sum the half extents, the radii, and the greatest radius of the ellipsoid at the
  /// box's bottom and at its top, of which one may be smaller than that of the radii; for points their coordinates.
  static constexpr std::size_t of_a = 0, of_b = 9;
  /// The quaternions; the offset from A's origin to B's, in the world; the distance that counts as touching.
  static constexpr std::size_t turn_a = 18, turn_b = 22, way = 26, reach = 29;

  Column column[30];

  /// Fills unused lanes up with the last of `count` pairs.
  void fill_up(std::size_t count) {
    constexpr std::size_t most_lanes = 16;
    for (Column& numbers : column)
      for (std::size_t k = count; k % most_lanes != 0; ++k) numbers[k] = numbers[count - 1];
  }
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Tests up to `portal_chunk` pairs, filled up, for overlap: 1 or 0, or 2 where that is not proven.
    template <PortalSide A, PortalSide B> void mpr_overlaps(const PortalPairs& pairs, std::size_t count,
                                                               std::uint8_t* touch);)
// clang-format on

/// The entry of a pair in the columns from a first one on.
struct PortalPlace {
  PortalPairs::Column* columns;
  std::size_t place;

  template <class T>
  void put(std::size_t column, T number) const {
    columns[column][place] = static_cast<float>(number);
  }
  template <class T>
  void put(std::size_t first, const Vec3<T>& v) const {
    put(first, v.x), put(first + 1, v.y), put(first + 2, v.z);
  }
  template <class T>
  void put(const Quat<T>& q) const {
    put(0, q.vector()), put(3, q.w);
  }
  /// Puts a core along Y, with a disc or a ball at each end.
  template <class T>
  void put_axis(T half, T bottom, T top, bool disc) const {
    const T wide = greatest(bottom, top);
    put(0, Vec3<T>{T(0), half, T(0)});
    put(3, Vec3<T>{wide, disc ? T(0) : wide, wide});
    put(6, bottom), put(7, top);
  }
};

template <class T>
void put_core(const Capsule<T>& capsule, const PortalPlace& to) {
  const T r = capsule.core_radius();
  to.put_axis(capsule.half_height(), capsule.radius_bottom() - r, capsule.radius_top() - r, false);
}
template <class T>
void put_core(const Cylinder<T>& cylinder, const PortalPlace& to) {
  to.put_axis(cylinder.half_height(), cylinder.radius_bottom(), cylinder.radius_top(), true);
}
template <class T>
void put_core(const Box<T>& box, const PortalPlace& to) {
  to.put(0, box.half_extents());
  to.put(3, Vec3<T>{});
  to.put(6, T(0)), to.put(7, T(0));
}
template <class T>
void put_core(const Rectangle<T>& rectangle, const PortalPlace& to) {
  put_core(rectangle.as_box(), to);
}
template <class T>
void put_core(const Ellipsoid<T>& ellipsoid, const PortalPlace& to) {
  const T widest = max_abs(ellipsoid.radii());
  to.put(0, Vec3<T>{});
  to.put(3, ellipsoid.radii());
  to.put(6, widest), to.put(7, widest);
}
template <class T>
void put_core(const Sphere<T>& sphere, const PortalPlace& to) {
  for (const std::size_t first : {0, 3, 6}) to.put(first, sphere.center());
}
template <class T>
void put_core(const LineSegment<T>& segment, const PortalPlace& to) {
  to.put(0, segment.point(0)), to.put(3, segment.point(1)), to.put(6, segment.point(1));
}
template <class T>
void put_core(const Triangle<T>& triangle, const PortalPlace& to) {
  for (const std::size_t i : {0, 1, 2}) to.put(3 * i, triangle.point(i));
}

template <class C>
inline constexpr PortalSide portal_side = PortalSide::none;
template <class T>
inline constexpr PortalSide portal_side<Capsule<T>> = PortalSide::sum;
template <class T>
inline constexpr PortalSide portal_side<Cylinder<T>> = PortalSide::sum;
template <class T>
inline constexpr PortalSide portal_side<Box<T>> = PortalSide::sum;
template <class T>
inline constexpr PortalSide portal_side<Rectangle<T>> = PortalSide::sum;
template <class T>
inline constexpr PortalSide portal_side<Ellipsoid<T>> = PortalSide::sum;
template <class T>
inline constexpr PortalSide portal_side<Sphere<T>> = PortalSide::points;
template <class T>
inline constexpr PortalSide portal_side<LineSegment<T>> = PortalSide::points;
template <class T>
inline constexpr PortalSide portal_side<Triangle<T>> = PortalSide::points;

}  // namespace graze
