// The polytope that EPA expands inside the difference of two small hulls, its facets in blocks of eight. Only for
// `*.kernel.cpp`.
//
// Guarantee: a closed surface, as that of `Polytope`, until an expansion that would break it, which returns false.
// Facets have equal numbers and equal bits at every level. A block holds the facets around one point; removed ones stay
// in it, since there are few.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

#include "narrow/core/support_point.hpp"
#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

/// The smallest of all lanes, by halves.
template <class T, int N>
[[gnu::always_inline]] inline T least_lane(const Wide<T, N>& a) {
  if constexpr (N == 2) {
    return least(a[0], a[1]);
  } else {
    using Half = Wide<T, N / 2>;
    Half low, high;
    if constexpr (N == 8) {
      low = Half::of(__builtin_shufflevector(a.v, a.v, 0, 1, 2, 3));
      high = Half::of(__builtin_shufflevector(a.v, a.v, 4, 5, 6, 7));
    } else {
      static_assert(N == 4);
      low = Half::of(__builtin_shufflevector(a.v, a.v, 0, 1));
      high = Half::of(__builtin_shufflevector(a.v, a.v, 2, 3));
    }
    return least_lane(least(low, high));
  }
}

/// The numbers of a table at the indices given by bytes, the lowest first. The table must have room for `picked_near`;
/// no index is beyond that unless `far`.
inline constexpr std::size_t picked_near = 16;
[[gnu::always_inline]] inline Lanes<double> picked(const double* table, std::uint64_t places,
                                                   [[maybe_unused]] bool far) {
#if defined(__AVX512F__)
  const __m512i at = _mm512_maskz_cvtepu8_epi64(0xff, _mm_cvtsi64_si128(static_cast<long long>(places)));
  // By permutation: lanes set one by one would wait for the memory.
  const __m512d found =
      far ? _mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xff, at, table, 8)
          : _mm512_maskz_permutex2var_pd(0xff, _mm512_loadu_pd(table), at, _mm512_loadu_pd(table + 8));
  return Lanes<double>::of(reinterpret_cast<Lanes<double>::Vector>(found));
#else
  Lanes<double> found;
  for (int k = 0; k < lanes_of<double>; ++k) found.set(k, table[places >> (8 * k) & 0xff]);
  return found;
#endif
}

namespace {

class LanePolytope {
 public:
  explicit LanePolytope(double noise) : noise_(noise) {}
  LanePolytope(const LanePolytope&) = delete;
  LanePolytope& operator=(const LanePolytope&) = delete;

  void begin(const SupportPoint* tetrahedron);
  bool has_room() const { return count_ < most_points && facets_ + most_horizon <= most_facets; }
  /// The nearest open facet; if all are closed, one of those.
  std::size_t nearest_open() const;
  bool open(std::size_t facet) const { return rank_[facet] != gone; }
  /// The offset of a facet's plane along its normal.
  double offset(std::size_t facet) const { return offset_[facet]; }
  Vec3d normal(std::size_t facet) const { return {x_[facet], y_[facet], z_[facet]}; }
  /// The outward normal, not of unit length: available earlier than the unit normal, for the support query that all
  /// else depends on.
  Vec3d outward(std::size_t facet) const { return {along_x_[facet], along_y_[facet], along_z_[facet]}; }
  /// Closes a facet, which is never expanded from then on.
  void close(std::size_t facet);
  /// The storage of the point that `expand` takes.
  SupportPoint& next_point() { return point_[count_]; }
  /// Replaces all facets that see the new point, of which there are some, by a fan from their silhouette. False when
  /// that is impossible: the rest is then no polytope.
  bool expand();
  /// The two shapes' points where the ray from the origin along `direction` leaves. False when rounding lets the ray
  /// miss every facet. `likely` is tested first.
  bool witness(const Vec3d& direction, std::size_t likely, Vec3d& a, Vec3d& b) const;

 private:
  using Doubles = Lanes<double>;
  static constexpr std::size_t block = 8, lanes = static_cast<std::size_t>(Doubles::lanes);
  static constexpr std::size_t word = 64, most_facets = 4 * word, most_points = 40;
  static constexpr std::size_t most_horizon = 2 * block;  // larger ones are rare for hulls
  /// Squared area below which a facet has none: a hundred digits less than for hulls of some size.
  static constexpr double least_area = 1e-200;
  static constexpr double gone = std::numeric_limits<double>::infinity();

  /// Coordinates of the points, a column each, and their squared distances from the origin.
  struct Columns {
    static constexpr std::size_t room = 48;
    static_assert(room > most_points && room >= picked_near);
    alignas(64) double x[room], y[room], z[room], squared[room];
  };
  struct Corner {
    Vec3<Doubles> w;
    Doubles squared;
  };

  Corner corners(std::uint64_t points) const {
    const bool far = count_ > picked_near;
    return {{picked(column_.x, points, far), picked(column_.y, points, far), picked(column_.z, points, far)},
            picked(column_.squared, points, far)};
  }
  void take_point() {
    const Vec3d& w = point_[count_].w;
    column_.x[count_] = w.x, column_.y[count_] = w.y, column_.z[count_] = w.z;
    column_.squared[count_] = length_squared(w);
    ++count_;
  }
  void link(std::size_t one, std::size_t other) {
    across_[one] = static_cast<std::uint16_t>(other);
    across_[other] = static_cast<std::uint16_t>(one);
  }
  static constexpr std::size_t edge_of(std::size_t facet, std::size_t edge) { return 4 * facet + edge; }
  bool seen(std::size_t facet) const { return seen_[facet / word] >> facet % word & 1; }

  void set_planes(std::size_t to, const Corner& p, const Corner& q, const Corner& apex);
  void remove_seen(const Vec3d& w);
  bool find_horizon();
  bool join_fan(std::size_t first, std::size_t apex);
  double pierce(std::size_t facet, const Vec3d& direction, Vec3d& a, Vec3d& b, double best) const;

  double noise_;
  std::size_t count_ = 0, facets_ = 0;
  Doubles least_;  ///< smallest ranks, by lane
  alignas(64) double x_[most_facets], y_[most_facets], z_[most_facets], offset_[most_facets];
  alignas(64) double along_x_[most_facets], along_y_[most_facets], along_z_[most_facets];
  /// The signed square of the offset, by which facets are ordered, and available earlier. Infinite if closed.
  alignas(64) double rank_[most_facets];
  std::uint8_t vertex_[4 * most_facets];   ///< starting vertex of edge 4 f + e; counter-clockwise from outside
  std::uint16_t across_[4 * most_facets];  ///< number of the same edge in the neighbour
  union {
    SupportPoint point_[most_points + 1];  ///< in a union, so that no unread zeros are written
  };
  union {
    Columns column_;
  };
  std::uint64_t seen_[most_facets / word];  ///< a bit for each facet
  // The horizon's edges: start and end as in the facets in front, and each edge as in the facet behind; the edge that
  // begins at a vertex, and a bit for each vertex at which one begins.
  std::size_t horizon_ = 0;
  std::uint64_t begun_ = 0, from_first_ = 0, to_first_ = 0;  ///< for the first block's edges also a byte each
  std::uint8_t from_[3 * most_facets], to_[3 * most_facets], begins_[most_points + 1];
  std::uint16_t outside_[3 * most_facets];
};

void LanePolytope::begin(const SupportPoint* t) {
  for (double* row : {column_.x, column_.y, column_.z, column_.squared})
    for (std::size_t i = 0; i < picked_near; i += lanes) Doubles(0).store(row + i);
  const Vec3d& p = t[0].w;
  const bool turned = dot(t[3].w - p, cross(t[1].w - p, t[2].w - p)) > 0;  // so that 0, 1, 2 is counter-clockwise
  for (const unsigned i : {0u, turned ? 2u : 1u, turned ? 1u : 2u, 3u}) {
    point_[count_] = by_parts(t[i]);
    take_point();
  }
  static constexpr std::uint8_t vertices[16] = {1, 0, 3, 0, 0, 2, 3, 0, 2, 1, 3, 0, 1, 2, 0, 0};
  static constexpr std::uint16_t across[16] = {14, 6, 9, 0, 13, 10, 1, 0, 12, 2, 5, 0, 8, 4, 0, 0};
  for (std::size_t e = 0; e < 16; ++e) {
    vertex_[e] = vertices[e];
    across_[e] = across[e];
  }
  facets_ = block;
  least_ = Doubles(gone);
  // Vertices of these facets, a byte each.
  constexpr std::uint64_t from = 0x01020001, to = 0x02010200, last = 0x00030303;
  for (std::size_t k = 0; k < block; k += lanes)
    set_planes(k, corners(from >> 8 * k), corners(to >> 8 * k), corners(last >> 8 * k));
}

/// Computes the planes of as many facets as there are lanes. Facets whose corners are one point have no area, and are
/// never seen.
void LanePolytope::set_planes(std::size_t to, const Corner& p, const Corner& q, const Corner& apex) {
  const Vec3<Doubles> product = cross(p.w - apex.w, q.w - apex.w);
  const Doubles area = dot(product, product);
  // The vertex nearest to the origin has the smallest coordinates, and so the smallest rounding error.
  const auto second = q.squared < p.squared;
  Vec3<Doubles> nearest = select(second, q.w, p.w);
  nearest = select(apex.squared < select(second, q.squared, p.squared), apex.w, nearest);
  const Doubles volume = dot(product, nearest);
  // A facet without area has no plane of its own; its neighbours bound the polytope there.
  const auto flat = area <= Doubles(least_area);
  const Doubles rank = select(flat, Doubles(gone), volume * (abs(volume) / area));
  least_ = least(least_, rank);
  rank.store(rank_ + to);
  product.x.store(along_x_ + to);
  product.y.store(along_y_ + to);
  product.z.store(along_z_ + to);
  const Doubles scale = select(flat, Doubles(0), Doubles(1) / sqrt(area));
  const Vec3<Doubles> normal = product * scale;
  normal.x.store(x_ + to);
  normal.y.store(y_ + to);
  normal.z.store(z_ + to);
  dot(normal, nearest).store(offset_ + to);
}

std::size_t LanePolytope::nearest_open() const {
  const Doubles nearest(least_lane(least_));
  // Its index is searched in a whole word's facets: a branch would be unpredictable.
  for (std::size_t first = 0; first < facets_; first += word) {
    std::uint64_t bits = 0;
    for (std::size_t i = first; i < facets_ && i < first + word; i += lanes)
      bits |= static_cast<std::uint64_t>(Chosen<double>::at_most(Doubles::load(rank_ + i), nearest).bits())
              << (i - first);
    if (bits != 0) return first + static_cast<std::size_t>(__builtin_ctzll(bits));
  }
  return 0;
}

void LanePolytope::close(std::size_t facet) {
  rank_[facet] = gone;
  least_ = Doubles(gone);
  for (std::size_t i = 0; i < facets_; i += lanes) least_ = least(least_, Doubles::load(rank_ + i));
}

/// Marks the facets that see a point, and drops them.
void LanePolytope::remove_seen(const Vec3d& w) {
  const Vec3<Doubles> point{Doubles(w.x), Doubles(w.y), Doubles(w.z)};
  const Doubles noise(noise_);
  Doubles all_least(gone);
  for (std::size_t first = 0; first < facets_; first += word) {
    std::uint64_t bits = 0;
    for (std::size_t i = first; i < facets_ && i < first + word; i += lanes) {
      const Vec3<Doubles> n{Doubles::load(x_ + i), Doubles::load(y_ + i), Doubles::load(z_ + i)};
      const Doubles offset = Doubles::load(offset_ + i), height = dot(n, point) - offset;
      bits |= static_cast<std::uint64_t>(~Chosen<double>::at_most(height, noise).bits() & Chosen<double>::all)
              << (i - first);
      const auto dropped = height > noise;
      const Doubles rank = select(dropped, Doubles(gone), Doubles::load(rank_ + i));
      all_least = least(all_least, rank);
      rank.store(rank_ + i);
      select(dropped, Doubles(gone), offset).store(offset_ + i);
    }
    seen_[first / word] = bits;
  }
  least_ = all_least;
}

/// Finds the edges between seen and unseen facets. False where two begin at one vertex, and where there are more than
/// the storage holds.
bool LanePolytope::find_horizon() {
  std::size_t n = 0;
  std::uint64_t begun = 0, twice = 0, from_first = 0, to_first = 0;
  for (std::size_t first = 0; first < facets_; first += word)
    for (std::uint64_t bits = seen_[first / word]; bits != 0; bits &= bits - 1) {
      const std::size_t f = edge_of(first + static_cast<std::size_t>(__builtin_ctzll(bits)), 0);
      for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t beyond = across_[f + e], from = vertex_[f + e], to = vertex_[f + (e == 2 ? 0 : e + 1)];
        const std::uint64_t edge = !seen(beyond / 4);
        outside_[n] = static_cast<std::uint16_t>(beyond);
        from_[n] = static_cast<std::uint8_t>(from);
        to_[n] = static_cast<std::uint8_t>(to);
        begins_[edge ? from : most_points] = static_cast<std::uint8_t>(n);
        from_first |= (from & -edge) << (8 * n & 63);
        to_first |= (to & -edge) << (8 * n & 63);
        twice |= begun & edge << from;
        begun |= edge << from;
        n += edge;
      }
    }
  horizon_ = n;
  begun_ = begun;
  from_first_ = from_first;
  to_first_ = to_first;
  return n >= 3 && n <= most_horizon && twice == 0;
}

bool LanePolytope::expand() {
  const std::size_t apex = count_, first = facets_;
  const SupportPoint& point = point_[apex];
  remove_seen(point.w);
  if (!find_horizon()) return false;
  const Corner last{{Doubles(point.w.x), Doubles(point.w.y), Doubles(point.w.z)}, Doubles(length_squared(point.w))};
  if (horizon_ <= block) {
    facets_ += block;
    for (std::size_t k = 0; k < block; k += lanes)
      set_planes(first + k, corners(from_first_ >> 8 * k), corners(to_first_ >> 8 * k), last);
  } else {
    facets_ += 2 * block;
    for (std::size_t i = horizon_; i < most_horizon; ++i) from_[i] = to_[i] = 0;
    for (std::size_t k = 0; k < most_horizon; k += lanes) {
      std::uint64_t from, to;
      std::memcpy(&from, from_ + k, sizeof from);
      std::memcpy(&to, to_ + k, sizeof to);
      set_planes(first + k, corners(from), corners(to), last);
    }
  }
  take_point();
  return join_fan(first, apex);
}

/// Joins the facets from `first` on, one for each edge of the horizon. False where the horizon is not one loop.
bool LanePolytope::join_fan(std::size_t first, std::size_t apex) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < horizon_; ++i) {
    const std::size_t fan = first + at, to = to_[at];
    if (!(begun_ >> to & 1)) return false;
    vertex_[edge_of(fan, 0)] = from_[at];
    vertex_[edge_of(fan, 1)] = static_cast<std::uint8_t>(to);
    vertex_[edge_of(fan, 2)] = static_cast<std::uint8_t>(apex);
    link(edge_of(fan, 0), outside_[at]);
    at = begins_[to];
    link(edge_of(fan, 1), edge_of(first + at, 2));
    if ((at == 0) != (i + 1 == horizon_)) return false;
  }
  return true;
}

/// Intersects the ray with a facet, and takes the points if the smallest barycentric coordinate there is larger than
/// `best`.
double LanePolytope::pierce(std::size_t facet, const Vec3d& direction, Vec3d& a, Vec3d& b, double best) const {
  const SupportPoint &p = point_[vertex_[edge_of(facet, 0)]], &q = point_[vertex_[edge_of(facet, 1)]],
                     &r = point_[vertex_[edge_of(facet, 2)]];
  double u = dot(direction, cross(q.w, r.w)), v = dot(direction, cross(r.w, p.w)), w = dot(direction, cross(p.w, q.w));
  const double sum = u + v + w;
  if (!(sum > 0)) return best;
  const double inside = least(u, least(v, w)) / sum;
  if (!(inside > best)) return best;
  u = greatest(u, 0.0), v = greatest(v, 0.0), w = greatest(w, 0.0);
  const double whole = u + v + w;
  a = (p.a * u + q.a * v + r.a * w) / whole;
  b = (p.b * u + q.b * v + r.b * w) / whole;
  return inside;
}

bool LanePolytope::witness(const Vec3d& direction, std::size_t likely, Vec3d& a, Vec3d& b) const {
  double best = -gone;
  if (offset_[likely] != gone) best = pierce(likely, direction, a, b, best);
  if (best > 0) return true;
  // Facets seen edge-on are no hits where the origin lies in their plane.
  for (std::size_t f = 0; f < facets_; ++f)
    if (offset_[f] != gone && dot(normal(f), direction) > 0.9) best = pierce(f, direction, a, b, best);
  return best >= 0;
}

}  // namespace

}  // namespace graze::GRAZE_ISA
