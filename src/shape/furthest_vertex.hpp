// The vertex of a small hull that lies furthest in a direction: a scan, four vertices at a time.
//
// Guarantee: the vertex that a scan one after the other in the direction's own scalar finds, of equals the first. Lanes of
// float tell which vertices may be that within rounding, most often one; only those are looked at again.
#pragma once

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "graze/shape/convex_hull.hpp"
#include "graze/wide.hpp"
#include "shape/hull_hierarchy.hpp"

namespace graze {

static_assert(scan_limit <= 32, "a bit a vertex");

/// What rounding may make of the difference of two vertices' places along a direction, relative to the hull's extent and
/// the direction's largest component: two and a half roundings of each of three products, which sum to no more than the
/// square root of three, of two vertices; twice that.
inline constexpr float column_slack = 18 * std::numeric_limits<float>::epsilon();

/// Where all products are too small for a float to hold, all vertices are looked at.
inline constexpr float column_floor = 16 * std::numeric_limits<float>::min();

using ColumnLanes = Wide<float, 4>;

/// Writes the vertices' coordinates as three columns of `column_length` numbers each.
template <class T>
void fill_columns(HullData<T>& hull) {
  if (hull.vertices.size() > scan_limit) return;
  hull.column_length = (hull.vertices.size() + ColumnLanes::lanes - 1) / ColumnLanes::lanes * ColumnLanes::lanes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < hull.column_length; ++i)
      hull.columns.push_back(static_cast<float>(hull.vertices[i < hull.vertices.size() ? i : 0][axis]));
}

/// Lane i is bit i.
inline std::uint32_t bits_of(const ColumnLanes::Mask& mask) {
#if defined(__x86_64__)
  return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(mask.bits)));
#else
  std::uint32_t bits = 0;
  for (int i = 0; i < ColumnLanes::lanes; ++i) bits |= static_cast<std::uint32_t>(mask.bits[i] & 1) << i;
  return bits;
#endif
}

/// The index of the vertex of a hull with columns that lies furthest along `direction`.
template <class T, class S>
std::size_t furthest_vertex(const HullData<T>& hull, const Vec3<S>& direction) {
  const Vec3<float> d = cast<float>(direction);
  const std::size_t length = hull.column_length;
  const float *x = hull.columns.data(), *y = x + length, *z = y + length;
  alignas(ColumnLanes) float along[scan_limit];
  const ColumnLanes dx(d.x), dy(d.y), dz(d.z);
  ColumnLanes most(-std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < length; i += ColumnLanes::lanes) {
    const ColumnLanes here =
        ColumnLanes::load(x + i) * dx + ColumnLanes::load(y + i) * dy + ColumnLanes::load(z + i) * dz;
    here.store(along + i);
    most = greatest(most, here);
  }
  const float top = greatest(greatest(most[0], most[1]), greatest(most[2], most[3]));
  const float slack = column_slack * static_cast<float>(hull.extent) * max_abs(d) + column_floor;
  // What is not known to be lower may be the one: also where overflow has left no number.
  const ColumnLanes low(top - slack);
  std::uint32_t candidates = 0;
  for (std::size_t i = 0; i < length; i += ColumnLanes::lanes)
    candidates |= bits_of(!(ColumnLanes::load(along + i) < low)) << i;
  std::size_t best = static_cast<std::size_t>(__builtin_ctz(candidates | 0x80000000u));
  if ((candidates & (candidates - 1)) == 0) return least(best, hull.vertices.size() - 1);
  S highest = dot(cast<S>(hull.vertices[best]), direction);
  for (candidates &= candidates - 1; candidates != 0; candidates &= candidates - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(candidates));
    if (i >= hull.vertices.size()) break;
    const S there = dot(cast<S>(hull.vertices[i]), direction);
    if (!(there > highest)) continue;
    highest = there;
    best = i;
  }
  return best;
}

}  // namespace graze
