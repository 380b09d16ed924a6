// Pairs of cores as the kernel `mpr_overlaps` takes them: a column for each number.
//
// Guarantee: numbers are those of the shapes and poses, and the offset between two the difference of these, each
// rounded to float. Nothing is allocated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "graze/shape.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// Kinds of cores for the kernel.
enum class MprShape : std::uint8_t {
  sum,     ///< the Minkowski sum of a box and an ellipsoid, about one centre
  points,  ///< the hull of three points, which may be the same
  hull,    ///< the hull of up to `most_mpr_points` points
  none
};
/// Whether two sides stand in the order in which the kernel takes them: sums first, hulls last.
constexpr bool in_mpr_order(MprShape first, MprShape second) { return first <= second; }

/// Number of pairs passed in at a time, a multiple of all numbers of lanes.
inline constexpr std::size_t mpr_chunk = 64;

/// Hulls of more vertices take as long alone, where a scan has a register full of them.
inline constexpr std::size_t most_mpr_points = 16;
static_assert(most_mpr_points <= VertexBlock::size, "of a hull one block is read");

struct MprPairs {
  using Column = float[mpr_chunk];

  /// The columns of a side: for a sum the half extents, the radii, and the greatest radius of the ellipsoid at the
  /// box's bottom and at its top, of which one may be smaller than that of the radii; for points and hulls their
  /// coordinates.
  static constexpr std::size_t of_a = 0, of_b = 3 * most_mpr_points;
  /// The quaternions; the offset from A's origin to B's, in the world; the distance that counts as touching.
  static constexpr std::size_t turn_a = 2 * of_b, turn_b = turn_a + 4, way = turn_b + 4, reach = way + 3;

  Column column[reach + 1];
  /// The numbers of vertices of a side's hulls; the most of all, to which fewer are filled up with copies of the first.
  struct Vertices {
    std::uint8_t count[mpr_chunk];
    std::size_t most = 0;
  } vertices_a, vertices_b;

  /// Fills unused lanes up with the last of `count` pairs, and hulls up to as many vertices as the largest has.
  void fill_up(std::size_t count, MprShape a, MprShape b) {
    constexpr std::size_t most_lanes = 16, most_columns = 9;
    const std::size_t end = (count + most_lanes - 1) / most_lanes * most_lanes;
    const auto fill_lanes = [&](std::size_t begin, std::size_t columns) {
      for (std::size_t c = begin; c < begin + columns; ++c)
        std::fill(column[c] + count, column[c] + end, column[c][count - 1]);
    };
    const auto fill_side = [&](std::size_t begin, MprShape side, Vertices& vertices) {
      if (side != MprShape::hull) return fill_lanes(begin, most_columns);
      vertices.most = *std::max_element(vertices.count, vertices.count + count);
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t c = 3u * vertices.count[k]; c < 3 * vertices.most; ++c)
          column[begin + c][k] = column[begin + c % 3][k];
      fill_lanes(begin, 3 * vertices.most);
    };
    fill_side(of_a, a, vertices_a);
    fill_side(of_b, b, vertices_b);
    fill_lanes(turn_a, reach + 1 - turn_a);
  }
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Tests up to `mpr_chunk` pairs, filled up, for overlap: 1 or 0, or 2 where that is not proven.
    template <MprShape A, MprShape B> void mpr_overlaps(const MprPairs& pairs, std::size_t count,
                                                               std::uint8_t* touch);)
// clang-format on

/// The entry of a pair in the columns from a first one on.
struct MprPlace {
  MprPairs::Column* columns;
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
void put_core(const Capsule<T>& capsule, const MprPlace& to) {
  const T r = capsule.core_radius();
  to.put_axis(capsule.half_height(), capsule.radius_bottom() - r, capsule.radius_top() - r, false);
}
template <class T>
void put_core(const Cylinder<T>& cylinder, const MprPlace& to) {
  to.put_axis(cylinder.half_height(), cylinder.radius_bottom(), cylinder.radius_top(), true);
}
template <class T>
void put_core(const Box<T>& box, const MprPlace& to) {
  to.put(0, box.half_extents());
  to.put(3, Vec3<T>{});
  to.put(6, T(0)), to.put(7, T(0));
}
template <class T>
void put_core(const Rectangle<T>& rectangle, const MprPlace& to) {
  put_core(rectangle.as_box(), to);
}
template <class T>
void put_core(const Ellipsoid<T>& ellipsoid, const MprPlace& to) {
  const T widest = max_abs(ellipsoid.radii());
  to.put(0, Vec3<T>{});
  to.put(3, ellipsoid.radii());
  to.put(6, widest), to.put(7, widest);
}
template <class T>
void put_core(const Sphere<T>& sphere, const MprPlace& to) {
  for (const std::size_t first : {0, 3, 6}) to.put(first, sphere.center());
}
template <class T>
void put_core(const LineSegment<T>& segment, const MprPlace& to) {
  to.put(0, segment.point(0)), to.put(3, segment.point(1)), to.put(6, segment.point(1));
}
template <class T>
void put_core(const Triangle<T>& triangle, const MprPlace& to) {
  for (const std::size_t i : {0, 1, 2}) to.put(3 * i, triangle.point(i));
}

template <class T>
void put_core(const ConvexHull<T>& hull, const MprPlace& to) {
  const VertexBlock& block = hull.data().blocks.front();
  float* column = to.columns[0] + to.place;
  for (std::size_t k = 0; k < hull.data().vertices.size(); ++k)
    for (const float* row : {block.x, block.y, block.z}) *column = row[k], column += mpr_chunk;
}

template <class C>
inline constexpr MprShape mpr_shape = MprShape::none;
template <class T>
inline constexpr MprShape mpr_shape<Capsule<T>> = MprShape::sum;
template <class T>
inline constexpr MprShape mpr_shape<Cylinder<T>> = MprShape::sum;
template <class T>
inline constexpr MprShape mpr_shape<Box<T>> = MprShape::sum;
template <class T>
inline constexpr MprShape mpr_shape<Rectangle<T>> = MprShape::sum;
template <class T>
inline constexpr MprShape mpr_shape<Ellipsoid<T>> = MprShape::sum;
template <class T>
inline constexpr MprShape mpr_shape<Sphere<T>> = MprShape::points;
template <class T>
inline constexpr MprShape mpr_shape<LineSegment<T>> = MprShape::points;
template <class T>
inline constexpr MprShape mpr_shape<Triangle<T>> = MprShape::points;
template <class T>
inline constexpr MprShape mpr_shape<ConvexHull<T>> = MprShape::hull;

}  // namespace graze
