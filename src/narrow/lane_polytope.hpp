// The polytope that EPA expands inside the difference of two small hulls, its facets in blocks of eight. Only for
// `*.kernel.cpp`.
//
// Guarantee: a closed surface, as of `Polytope`, until an expansion that would break it, which says so. Facets are
// numbered alike at every level, and have the same bits. A block holds the facets around one point, and those that are
// gone stay in it: there are few.
#pragma once

#include <cstdint>
#include <limits>

#include "lanes/lanes.hpp"
#include "narrow/support_point.hpp"

namespace graze::GRAZE_ISA {

/// The least of all lanes, by halves.
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

namespace {

class LanePolytope {
 public:
  explicit LanePolytope(double noise) : noise_(noise) {}
  LanePolytope(const LanePolytope&) = delete;
  LanePolytope& operator=(const LanePolytope&) = delete;

  void begin(const SupportPoint* tetrahedron);
  bool has_room() const { return count_ < most_points && blocks_ + most_horizon / block <= most_blocks; }
  /// The nearest facet that is not closed; when all are, one of those.
  std::size_t nearest_open() const;
  /// Where a facet's plane stands along its normal; infinite if it is closed.
  double open(std::size_t facet) const { return open_[facet]; }
  double offset(std::size_t facet) const { return offset_[facet]; }
  Vec3d normal(std::size_t facet) const { return {x_[facet], y_[facet], z_[facet]}; }
  /// Never expanded from here on.
  void close(std::size_t facet) { open_[facet] = gone; }
  /// Where the point is to be written that `expand` takes.
  SupportPoint& next_point() { return point_[count_]; }
  /// Replaces all facets that see the new point, of which there are some, by a fan from their silhouette. False when
  /// that cannot be done: what is left is no polytope.
  bool expand();
  /// The two shapes' points where the ray from the origin along `direction` leaves. False when rounding lets the ray miss
  /// every facet. `likely` is looked at first.
  bool witness(const Vec3d& direction, std::size_t likely, Vec3d& a, Vec3d& b) const;

 private:
  using Doubles = Lanes<double>;
  static constexpr std::size_t block = 8, lanes = static_cast<std::size_t>(Doubles::lanes);
  static constexpr std::size_t word = 64, most_blocks = 32, most_facets = block * most_blocks, most_points = 40;
  static constexpr std::size_t most_horizon = 2 * block;  // of hulls' points more are rare
  /// Facets of no more than this, squared, have no area: a hundred digits less than those of hulls of some size.
  static constexpr double least_area = 1e-200;
  static constexpr double gone = std::numeric_limits<double>::infinity();

  /// Facets to be: the triangles of two points that follow each other in a ring, and an apex.
  struct Ring {
    alignas(64) double x[most_horizon + block], y[most_horizon + block], z[most_horizon + block],
        squared[most_horizon + block];
  };

  void put(Ring& ring, std::size_t at, std::size_t point) const {
    const Vec3d& w = point_[point].w;
    ring.x[at] = w.x, ring.y[at] = w.y, ring.z[at] = w.z;
    ring.squared[at] = squared_[point];
  }
  void take_point() {
    squared_[count_] = length_squared(point_[count_].w);
    ++count_;
  }
  void link(std::size_t one, std::size_t other) {
    across_[one] = static_cast<std::uint16_t>(other);
    across_[other] = static_cast<std::uint16_t>(one);
  }
  static constexpr std::size_t edge_of(std::size_t facet, std::size_t edge) { return 4 * facet + edge; }
  bool seen(std::size_t facet) const { return seen_[facet / word] >> facet % word & 1; }

  void set_planes(const Ring& ring, std::size_t at, std::size_t to, const Vec3<Doubles>& apex,
                  const Doubles& apex_squared);
  void remove_seen(const Vec3d& w);
  std::size_t find_horizon();
  double pierce(std::size_t facet, const Vec3d& direction, Vec3d& a, Vec3d& b, double best) const;

  double noise_;
  std::size_t count_ = 0, blocks_ = 0;
  alignas(64) double x_[most_facets], y_[most_facets], z_[most_facets], offset_[most_facets], open_[most_facets];
  std::uint8_t
      vertex_[4 * most_facets];  ///< of edge 4 f + e the vertex that it begins at; counter-clockwise from outside
  std::uint16_t across_[4 * most_facets];  ///< the same edge as the neighbour has it
  union {
    SupportPoint point_[most_points + 1];  ///< in a union no zeros are written that nobody reads
  };
  double squared_[most_points + 1];
  std::uint64_t seen_[most_facets / word];  ///< a bit a facet
  // The horizon's edges as the facets in front have them, and as those behind; which of them begins at a vertex, and a
  // bit for each vertex that one begins at.
  std::uint64_t begun_ = 0;
  std::uint8_t from_[3 * most_facets], to_[3 * most_facets], begins_[most_points + 1];
  std::uint16_t outside_[3 * most_facets];
};

void LanePolytope::begin(const SupportPoint* t) {
  const Vec3d& p = t[0].w;
  const bool turned = dot(t[3].w - p, cross(t[1].w - p, t[2].w - p)) > 0;  // so that 0, 1, 2 is counter-clockwise
  for (const unsigned i : {0u, turned ? 2u : 1u, turned ? 1u : 2u, 3u}) {
    point_[count_] = by_parts(t[i]);
    take_point();
  }
  static constexpr std::uint8_t corners[16] = {1, 0, 3, 0, 0, 2, 3, 0, 2, 1, 3, 0, 1, 2, 0, 0};
  static constexpr std::uint16_t across[16] = {14, 6, 9, 0, 13, 10, 1, 0, 12, 2, 5, 0, 8, 4, 0, 0};
  for (std::size_t e = 0; e < 16; ++e) {
    vertex_[e] = corners[e];
    across_[e] = across[e];
  }
  Ring ring;
  for (std::size_t f = 0; f <= block; ++f) put(ring, f, f < 4 ? corners[4 * f] : 2);
  blocks_ = 1;
  // The first three about the last point, the fourth about the first.
  const Vec3d &last = point_[3].w, &first = point_[0].w;
  for (std::size_t k = 0; k < block; k += lanes) {
    Vec3<Doubles> apex{Doubles(last.x), Doubles(last.y), Doubles(last.z)};
    Doubles squared(squared_[3]);
    if (k <= 3 && 3 < k + lanes) {
      const int at = static_cast<int>(3 - k);
      apex.x.set(at, first.x), apex.y.set(at, first.y), apex.z.set(at, first.z);
      squared.set(at, squared_[0]);
    }
    set_planes(ring, k, k, apex, squared);
  }
}

/// Of as many facets as there are lanes. Of a ring that ends before, the rest has no area, and is never seen.
void LanePolytope::set_planes(const Ring& ring, std::size_t at, std::size_t to, const Vec3<Doubles>& apex,
                              const Doubles& apex_squared) {
  const Vec3<Doubles> p{Doubles::load(ring.x + at), Doubles::load(ring.y + at), Doubles::load(ring.z + at)},
      q{Doubles::load(ring.x + at + 1), Doubles::load(ring.y + at + 1), Doubles::load(ring.z + at + 1)};
  const Doubles squared_p = Doubles::load(ring.squared + at), squared_q = Doubles::load(ring.squared + at + 1);
  const Vec3<Doubles> product = cross(p - apex, q - apex);
  const Doubles area = dot(product, product);
  const auto flat = area <= Doubles(least_area);
  const Doubles scale = select(flat, Doubles(0), Doubles(1) / sqrt(area));
  const Vec3<Doubles> normal = product * scale;
  // The vertex nearest to the origin has the smallest coordinates, and so the smallest rounding error.
  const auto second = squared_q < squared_p;
  Vec3<Doubles> nearest = select(second, q, p);
  nearest = select(apex_squared < select(second, squared_q, squared_p), apex, nearest);
  const Doubles offset = dot(normal, nearest);
  normal.x.store(x_ + to);
  normal.y.store(y_ + to);
  normal.z.store(z_ + to);
  offset.store(offset_ + to);
  // A facet without area has no plane of its own; its neighbours bound the polytope there.
  select(flat, Doubles(gone), offset).store(open_ + to);
}

std::size_t LanePolytope::nearest_open() const {
  const std::size_t count = blocks_ * block;
  Doubles all_least = Doubles::load(open_);
  for (std::size_t i = lanes; i < count; i += lanes) all_least = least(all_least, Doubles::load(open_ + i));
  const Doubles nearest(least_lane(all_least));
  // Where it stands is looked for in a whole word's facets: no processor foresees in which of them.
  for (std::size_t first = 0; first < count; first += word) {
    std::uint64_t bits = 0;
    for (std::size_t i = first; i < count && i < first + word; i += lanes)
      bits |= static_cast<std::uint64_t>(Chosen<double>::at_most(Doubles::load(open_ + i), nearest).bits())
              << (i - first);
    if (bits != 0) return first + static_cast<std::size_t>(__builtin_ctzll(bits));
  }
  return 0;
}

/// Notes which facets see a point, and drops them.
void LanePolytope::remove_seen(const Vec3d& w) {
  const Vec3<Doubles> point{Doubles(w.x), Doubles(w.y), Doubles(w.z)};
  const Doubles noise(noise_);
  const std::size_t count = blocks_ * block;
  for (std::size_t first = 0; first < count; first += word) {
    std::uint64_t bits = 0;
    for (std::size_t i = first; i < count && i < first + word; i += lanes) {
      const Vec3<Doubles> n{Doubles::load(x_ + i), Doubles::load(y_ + i), Doubles::load(z_ + i)};
      const Doubles offset = Doubles::load(offset_ + i), height = dot(n, point) - offset;
      bits |= static_cast<std::uint64_t>(~Chosen<double>::at_most(height, noise).bits() & Chosen<double>::all)
              << (i - first);
      const auto dropped = height > noise;
      select(dropped, Doubles(gone), offset).store(offset_ + i);
      select(dropped, Doubles(gone), Doubles::load(open_ + i)).store(open_ + i);
    }
    seen_[first / word] = bits;
  }
}

/// The edges between what has been seen and what has not. Returns how many, or 0 where two begin at one vertex.
std::size_t LanePolytope::find_horizon() {
  std::size_t n = 0;
  bool twice = false;
  begun_ = 0;
  for (std::size_t first = 0; first < blocks_ * block; first += word)
    for (std::uint64_t bits = seen_[first / word]; bits != 0; bits &= bits - 1) {
      const std::size_t f = edge_of(first + static_cast<std::size_t>(__builtin_ctzll(bits)), 0);
      for (std::size_t e = 0; e < 3; ++e) {
        const std::size_t beyond = across_[f + e], from = vertex_[f + e];
        const std::uint64_t edge = !seen(beyond / 4);
        outside_[n] = static_cast<std::uint16_t>(beyond);
        from_[n] = static_cast<std::uint8_t>(from);
        to_[n] = vertex_[f + (e == 2 ? 0 : e + 1)];
        begins_[from] = edge ? static_cast<std::uint8_t>(n) : begins_[from];
        twice |= (begun_ & edge << from) != 0;
        begun_ |= edge << from;
        n += edge;
      }
    }
  return twice ? 0 : n;
}

bool LanePolytope::expand() {
  const std::size_t apex = count_;
  const Vec3d& w = point_[apex].w;
  remove_seen(w);
  const std::size_t n = find_horizon();
  if (n < 3 || n > most_horizon) return false;
  take_point();

  Ring ring;
  const Doubles x(w.x), y(w.y), z(w.z), squared(squared_[apex]);
  for (std::size_t i = 0; i < sizeof ring.x / sizeof ring.x[0]; i += lanes) {
    x.store(ring.x + i), y.store(ring.y + i), z.store(ring.z + i);
    squared.store(ring.squared + i);
  }
  // Each edge begins where the one before ends, or there are several loops.
  const std::size_t first = blocks_ * block;
  std::size_t at = 0, before = first + n - 1;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t fan = first + i;
    put(ring, i, from_[at]);
    vertex_[edge_of(fan, 0)] = from_[at];
    vertex_[edge_of(fan, 1)] = to_[at];
    vertex_[edge_of(fan, 2)] = static_cast<std::uint8_t>(apex);
    link(edge_of(fan, 0), outside_[at]);
    link(edge_of(before, 1), edge_of(fan, 2));
    before = fan;
    if (!(begun_ >> to_[at] & 1)) return false;
    at = begins_[to_[at]];
    if ((at == 0) != (i + 1 == n)) return false;
  }
  put(ring, n, from_[0]);
  const Vec3<Doubles> point{x, y, z};
  for (std::size_t b = 0; b < n; b += block) {
    ++blocks_;
    for (std::size_t k = 0; k < block; k += lanes) set_planes(ring, b + k, first + b + k, point, squared);
  }
  return true;
}

/// Where the ray meets a facet, if that is better than the best so far by its smallest barycentric coordinate there.
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
  // Facets seen edge-on say nothing where the origin lies in their plane.
  for (std::size_t f = 0; f < blocks_ * block; ++f)
    if (offset_[f] != gone && dot(normal(f), direction) > 0.9) best = pierce(f, direction, a, b, best);
  return best >= 0;
}

}  // namespace

}  // namespace graze::GRAZE_ISA
