// The polytope that EPA expands: a triangulated convex polyhedron inside the Minkowski difference.
//
// Guarantee: a closed surface of live facets at all times; an expansion that would break it (rounding can fold a
// silhouette on itself) is refused and leaves everything as it was. All memory is in place.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "narrow/gjk/simplex.hpp"

namespace graze {

/// A triangle of the polytope: dot(normal, w) = offset, outward.
struct Facet {
  Vec3d normal;
  double offset;
  std::array<std::uint16_t, 3> vertex;    ///< counter-clockwise seen from outside
  std::array<std::uint16_t, 3> neighbor;  ///< across the edge from vertex i to vertex i + 1
  bool live;
};

/// The result for a flat difference, which has no tetrahedron: its normal separates the cores at zero depth.
struct Flat {
  bool is = false;
  Vec3d normal, a, b;
  double depth = 0;
};

class Polytope {
 public:
  /// `noise`: distance of a point from a plane by rounding alone.
  explicit Polytope(double noise) : noise_(noise) {}

  /// Grows `start` (one to four points) to a tetrahedron by support queries of the difference.
  template <class Difference>
  Flat begin(const Difference& difference, const Simplex& start);

  /// Replaces all facets that see the new point by a fan from their silhouette. False when that cannot be done.
  bool expand(const Facet& seen_first, const SupportPoint& point);

  /// The nearest open facet, or none. Costs a comparison a facet.
  const Facet* nearest_open() const;
  /// Closes a facet, which is never expanded from then on: it is known to lie on the boundary of the difference, or
  /// nearly.
  void close(const Facet& facet) { open_[static_cast<std::size_t>(&facet - facets_.begin())] = closed; }
  std::size_t live_count() const;

  /// The two shapes' points where the ray from the origin along `direction` leaves the polytope. False when rounding
  /// lets the ray miss every facet: the points are then those of the facet that it misses least. `likely` is tested
  /// first.
  bool witness(const Vec3d& direction, const Facet* likely, Vec3d& a, Vec3d& b) const;
  /// The two shapes' points nearest to a point of the difference's boundary that no facet's ray determines well: a
  /// sliver's barycentric coordinates are mere rounding. Costs a comparison a facet, and a nearest point for the few
  /// that are near.
  void nearest_witness(const Vec3d& target, Vec3d& a, Vec3d& b) const;
  /// The radius of a ball about the origin inside the polytope, or `enough` if that is smaller. Holds whatever rounding
  /// did to the planes: no point of a triangle is nearer to the origin than the least of its vertices along any unit
  /// vector.
  double inner_radius(double enough) const;

  std::span<const SupportPoint> vertices() const { return {vertices_.begin(), vertices_.end()}; }
  /// All facets ever made; those that are not `live` have been replaced.
  std::span<const Facet> facets() const { return {facets_.begin(), facets_.end()}; }

 private:
  static constexpr std::size_t max_vertices = 256;
  static constexpr std::size_t max_facets = 2 * max_vertices;  // Euler: 2 V - 4 live at most
  static constexpr double closed = std::numeric_limits<double>::infinity();

  struct HorizonEdge {
    std::uint16_t from, to, outside;  ///< the edge reversed, as in the facet behind it, `outside`
    std::uint8_t outside_edge;
  };

  void build_tetrahedron(const Simplex& s);
  std::uint16_t add_facet(std::uint16_t i, std::uint16_t j, std::uint16_t k);
  bool sees(const Facet& f, const Vec3d& w) const { return dot(f.normal, w) - f.offset > noise_; }
  bool find_horizon(std::uint16_t seed, const Vec3d& w);
  bool horizon_is_loop() const;
  void add_vertex(const SupportPoint& p);
  double least_along(const Facet& facet, const Vec3d& direction) const;
  double pierce(const Vec3d& direction, double facing, Vec3d& a, Vec3d& b) const;
  bool pierce(const Facet& facet, const Vec3d& direction, double& best, Vec3d& a, Vec3d& b) const;

  double noise_;
  FixedVector<SupportPoint, max_vertices> vertices_;
  FixedVector<double, max_vertices> squared_;  ///< squared distances of the vertices
  FixedVector<Facet, max_facets> facets_;
  FixedVector<double, max_facets> open_;  ///< offsets of the facets, or `closed`
  FixedVector<HorizonEdge, max_facets> horizon_;
  FixedVector<std::uint16_t, max_facets> seen_, free_;
};

namespace detail {

/// The support point, among those of the given directions, of largest distance from the span of the simplex.
template <class Difference, class Measure>
SupportPoint furthest_support(const Difference& difference, std::span<const Vec3d> directions, const Measure& measure) {
  SupportPoint best{};
  double most = -1;
  for (const Vec3d& d : directions) {
    const SupportPoint p = difference.support(d);
    if (const double m = measure(p.w); m > most) {
      most = m;
      best = p;
    }
  }
  return best;
}

}  // namespace detail

template <class Difference>
Flat Polytope::begin(const Difference& difference, const Simplex& start) {
  using detail::furthest_support;
  if (start.size() == 4) {
    build_tetrahedron(start);
    return {};
  }
  Simplex s = start;
  // The direction, `n` or `-n`, whose support point separates most: a flat difference has about no extent there. The
  // witnesses come from GJK's simplex, which lies at the origin within rounding.
  const auto flat = [&](const Vec3d& n) {
    const double above = dot(difference.support(n).w, n), below = -dot(difference.support(-n).w, n);
    return Flat{true, above >= below ? n : -n, start.point_a(), start.point_b(), -greatest(above, below)};
  };

  if (s.size() == 1) {
    static constexpr Vec3d axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Vec3d p = s.w(0);
    s.push(furthest_support(difference, axes, [&](const Vec3d& w) { return length(w - p); }));
    if (length(s.w(1) - p) <= noise_) return flat({0, 1, 0});
  }
  if (s.size() == 2) {
    const Vec3d p = s.w(0), along = unit(s.w(1) - p);
    const Vec3d u = any_perpendicular(along), v = cross(along, u);
    const Vec3d around[] = {u, -u, v, -v};
    s.push(furthest_support(difference, around, [&](const Vec3d& w) { return length(cross(w - p, along)); }));
    if (length(cross(s.w(2) - p, along)) <= noise_) return flat(u);
  }
  if (s.size() == 3) {
    const Vec3d p = s.w(0);
    const Vec3d n = unit(cross(s.w(1) - p, s.w(2) - p));
    const Vec3d sides[] = {n, -n};
    s.push(furthest_support(difference, sides, [&](const Vec3d& w) { return std::abs(dot(w - p, n)); }));
    if (std::abs(dot(s.w(3) - p, n)) <= noise_) return flat(n);
  }
  build_tetrahedron(s);
  return {};
}

}  // namespace graze
