// The vertex of a small hull that lies furthest in a direction: a scan, four vertices at a time.
//
// Guarantee: the vertex that a scan one after the other in the direction's own scalar finds, of equals the first. Lanes of
// float tell which vertices may be that within rounding, most often one; only those are looked at again.
#pragma once

#if defined(__x86_64__)
#include <emmintrin.h>
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

/// Vertices are scanned in blocks of so many times four: their comparisons make sixteen bits.
inline constexpr std::size_t column_block = 4;

/// Of a hull that is to be scanned.
template <class T>
void fill_columns(HullData<T>& hull) {
  const std::size_t count = hull.vertices.size(), together = column_block * ColumnLanes::lanes;
  if (count > scan_limit) return;
  for (std::size_t i = 0; i < (count + together - 1) / together * together; i += ColumnLanes::lanes)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ColumnLanes four;
      for (int k = 0; k < ColumnLanes::lanes; ++k) {
        const std::size_t v = i + static_cast<std::size_t>(k);
        four.set(k, static_cast<float>(hull.vertices[v < count ? v : 0][axis]));
      }
      hull.columns.push_back(four);
    }
}

/// The larger lane by lane; the second where either is no number.
inline ColumnLanes larger(const ColumnLanes& a, const ColumnLanes& b) {
#if defined(__x86_64__)
  return ColumnLanes::of(
      reinterpret_cast<ColumnLanes::Vector>(_mm_max_ps(reinterpret_cast<__m128>(a.v), reinterpret_cast<__m128>(b.v))));
#else
  return select(a > b, a, b);
#endif
}

/// Which lanes of a block are not less than `low`: vertex i is bit i.
inline std::uint32_t not_less(const ColumnLanes::Vector* along, const ColumnLanes& low) {
#if defined(__x86_64__)
  const auto compared = [&](std::size_t i) {
    return _mm_castps_si128(_mm_cmpnlt_ps(reinterpret_cast<__m128>(along[i]), reinterpret_cast<__m128>(low.v)));
  };
  const __m128i first = _mm_packs_epi32(compared(0), compared(1)), last = _mm_packs_epi32(compared(2), compared(3));
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(first, last)));
#else
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < column_block; ++i)
    for (int k = 0; k < ColumnLanes::lanes; ++k)
      bits |= std::uint32_t{!(along[i][k] < low[k])} << (i * ColumnLanes::lanes + static_cast<std::size_t>(k));
  return bits;
#endif
}

/// The vertex furthest along `direction` of those whose bits are set in `among`; of equals the first.
template <class T, class S>
std::size_t furthest_among(const HullData<T>& hull, std::uint32_t among, const Vec3<S>& direction) {
  const auto first = [&] { return static_cast<std::size_t>(__builtin_ctz(among)); };
  std::size_t best = first();
  S most = dot(cast<S>(hull.vertices[best]), direction);
  for (among &= among - 1; among != 0; among &= among - 1) {
    const S along = dot(cast<S>(hull.vertices[first()]), direction);
    if (!(along > most)) continue;
    most = along;
    best = first();
  }
  return best;
}

/// The index of the vertex of a hull with columns that lies furthest along `direction`.
template <class T, class S>
std::size_t furthest_vertex(const HullData<T>& hull, const Vec3<S>& direction) {
  const Vec3<float> d = cast<float>(direction);
  const ColumnLanes x(d.x), y(d.y), z(d.z);
  ColumnLanes most(-std::numeric_limits<float>::infinity());
  ColumnLanes::Vector along[scan_limit / ColumnLanes::lanes];  // not lanes, which would be cleared
  const ColumnLanes* column = hull.columns.data();
  const std::size_t fours = hull.columns.size() / 3;
  for (std::size_t i = 0; i < fours; i += column_block)
    for (std::size_t k = 0; k < column_block; ++k, column += 3) {
      const ColumnLanes here = column[0] * x + column[1] * y + column[2] * z;
      along[i + k] = here.v;
      most = larger(here, most);
    }
  const float top = greatest(greatest(most[0], most[1]), greatest(most[2], most[3]));
  const float slack = column_slack * static_cast<float>(hull.extent) * max_abs(d) + column_floor;
  // What is not known to be lower may be the one: also where overflow has left no number.
  const ColumnLanes low(top - slack);
  std::uint32_t candidates = 0;
  for (std::size_t i = 0; i < fours; i += column_block)
    candidates |= not_less(along + i, low) << (i * ColumnLanes::lanes);
  candidates &= 0xffffffffu >> (32 - hull.vertices.size());
  if ((candidates & (candidates - 1)) == 0) return static_cast<std::size_t>(__builtin_ctz(candidates));
  return furthest_among(hull, candidates, direction);
}

/// Bit i of vertex i where it lies at least `level` along `direction`. Of a hull with columns that are its vertices.
inline std::uint32_t vertices_at_least(const HullData<float>& hull, const Vec3<float>& direction, float level) {
  const ColumnLanes x(direction.x), y(direction.y), z(direction.z), low(level);
  ColumnLanes::Vector along[column_block];
  const ColumnLanes* column = hull.columns.data();
  const std::size_t fours = hull.columns.size() / 3;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < fours; i += column_block) {
    for (std::size_t k = 0; k < column_block; ++k, column += 3)
      along[k] = (column[0] * x + column[1] * y + column[2] * z).v;
    bits |= not_less(along, low) << (i * ColumnLanes::lanes);
  }
  return bits & (0xffffffffu >> (32 - hull.vertices.size()));
}

}  // namespace graze
