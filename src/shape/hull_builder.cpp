#include "shape/hull_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace graze {

namespace {

__extension__ using Wide128 = __int128;

constexpr int grid_bits = 40;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

GridPoint minus(const GridPoint& a, const GridPoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

using GridNormal = std::array<Wide128, 3>;

/// Differences have 41 bits, so a component of the product has 83 and the determinant below at most 126.
GridNormal product(const GridPoint& u, const GridPoint& v) {
  const auto part = [&](std::size_t i, std::size_t j) {
    return static_cast<Wide128>(u[i]) * v[j] - static_cast<Wide128>(u[j]) * v[i];
  };
  return {part(1, 2), part(2, 0), part(0, 1)};
}
Wide128 dot(const GridNormal& n, const GridPoint& p) { return n[0] * p[0] + n[1] * p[1] + n[2] * p[2]; }

struct Triangle3 {
  std::array<std::uint32_t, 3> vertex;
  std::array<std::uint32_t, 3> neighbor;  ///< across the edge from vertex i to i + 1
  GridNormal normal;
  std::vector<std::uint32_t> outside;  ///< points that see this triangle and are assigned to no other
  bool live = true;
};

class Quickhull {
 public:
  Quickhull(std::span<const GridPoint> points, const std::array<std::uint32_t, 4>& simplex) : points_(points) {
    const auto [a, b, c, d] = simplex;
    add(a, b, c);
    add(a, d, b);
    add(b, d, c);
    add(c, d, a);
    faces_[0].neighbor = {1, 2, 3};
    faces_[1].neighbor = {3, 2, 0};
    faces_[2].neighbor = {1, 3, 0};
    faces_[3].neighbor = {2, 1, 0};
    std::vector<std::uint32_t> rest(points.size());
    std::iota(rest.begin(), rest.end(), 0u);
    std::erase_if(rest, [&](std::uint32_t p) { return std::find(simplex.begin(), simplex.end(), p) != simplex.end(); });
    assign(rest, {0, 1, 2, 3});
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    // Faces are only ever appended, so going through them in order visits every one that has points left.
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      if (faces_[f].live && !faces_[f].outside.empty()) add_point(f, furthest(f));
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Triangle3& t : faces_)
      if (t.live) triangles.push_back(t.vertex);
    return triangles;
  }

 private:
  struct HorizonEdge {
    std::uint32_t from, to, beyond;
  };

  std::uint32_t add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Triangle3 t;
    t.vertex = {a, b, c};
    t.neighbor = {none, none, none};
    t.normal = product(minus(points_[b], points_[a]), minus(points_[c], points_[a]));
    faces_.push_back(std::move(t));
    return static_cast<std::uint32_t>(faces_.size() - 1);
  }

  Wide128 height(std::uint32_t face, std::uint32_t point) const {
    return dot(faces_[face].normal, minus(points_[point], points_[faces_[face].vertex[0]]));
  }

  std::uint32_t furthest(std::uint32_t face) const {
    std::uint32_t best = none;
    Wide128 most = 0;
    for (const std::uint32_t p : faces_[face].outside)
      if (const Wide128 h = height(face, p); h > most) {
        most = h;
        best = p;
      }
    return best;
  }

  void assign(const std::vector<std::uint32_t>& points, const std::vector<std::uint32_t>& faces) {
    for (const std::uint32_t p : points)
      for (const std::uint32_t f : faces)
        if (height(f, p) > 0) {
          faces_[f].outside.push_back(p);
          break;
        }
  }

  /// Replaces all triangles that see `apex` by a fan over their horizon.
  void add_point(std::uint32_t seed, std::uint32_t apex) {
    seen_.assign(1, seed);
    faces_[seed].live = false;
    horizon_.clear();
    for (std::size_t i = 0; i < seen_.size(); ++i)
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t f = seen_[i], n = faces_[f].neighbor[e];
        if (!faces_[n].live) continue;
        // A triangle whose plane holds the apex goes too: its vertices then are on the horizon or no longer extreme,
        // and no triangle of the fan is without area.
        if (height(n, apex) >= 0) {
          faces_[n].live = false;
          seen_.push_back(n);
        } else {
          horizon_.push_back({faces_[f].vertex[e], faces_[f].vertex[(e + 1) % 3], n});
        }
      }
    link_fan(apex);
    std::vector<std::uint32_t> orphans;
    for (const std::uint32_t f : seen_) {
      for (const std::uint32_t p : faces_[f].outside)
        if (p != apex) orphans.push_back(p);
      faces_[f].outside = {};
    }
    assign(orphans, fan_);
  }

  void link_fan(std::uint32_t apex) {
    fan_.clear();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_start;
    for (const HorizonEdge& e : horizon_) {
      const std::uint32_t t = add(e.from, e.to, apex);
      faces_[t].neighbor[0] = e.beyond;
      Triangle3& beyond = faces_[e.beyond];
      for (std::size_t k = 0; k < 3; ++k)
        if (beyond.vertex[k] == e.to && beyond.vertex[(k + 1) % 3] == e.from) beyond.neighbor[k] = t;
      fan_.push_back(t);
      by_start.emplace_back(e.from, t);
    }
    std::sort(by_start.begin(), by_start.end());
    for (const std::uint32_t t : fan_) {
      const std::uint32_t to = faces_[t].vertex[1];
      const auto next = std::lower_bound(by_start.begin(), by_start.end(), std::pair{to, 0u});
      faces_[t].neighbor[1] = next->second;
      faces_[next->second].neighbor[2] = t;
    }
  }

  std::span<const GridPoint> points_;
  std::vector<Triangle3> faces_;
  std::vector<std::uint32_t> seen_, fan_;
  std::vector<HorizonEdge> horizon_;
};

/// The point that maximises `measure`, the first of equals; `none` when no measure is positive.
template <class Measure>
std::uint32_t extreme(std::span<const GridPoint> points, const Measure& measure) {
  std::uint32_t best = none;
  double most = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (const double m = measure(points[i]); m > most) {
      most = m;
      best = i;
    }
  return best;
}

double magnitude(const GridNormal& n) {
  double sum = 0;
  for (const Wide128 c : n) sum += static_cast<double>(c) * static_cast<double>(c);
  return sum;
}

/// The hull of coplanar points by Andrew's monotone chain (1979), in the plane of the two axes across the largest
/// component of the normal.
std::vector<std::uint32_t> flat_hull(std::span<const GridPoint> points, const GridNormal& normal) {
  const auto size = [&](std::size_t i) { return normal[i] < 0 ? -normal[i] : normal[i]; };
  const std::size_t major = size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
  const std::size_t u = (major + 1) % 3, v = (major + 2) % 3;
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(points[a][u], points[a][v], a) < std::tie(points[b][u], points[b][v], b);
  });
  const auto left = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const GridPoint p = minus(points[b], points[a]), q = minus(points[c], points[a]);
    return static_cast<Wide128>(p[u]) * q[v] - static_cast<Wide128>(p[v]) * q[u] > 0;
  };
  std::vector<std::uint32_t> chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = chain.size();
    for (const std::uint32_t p : order) {
      while (chain.size() >= base + 2 && !left(chain[chain.size() - 2], chain.back(), p)) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return chain;
}

}  // namespace

Grid to_grid(std::span<const Vec3d> points) {
  Vec3d lower = points[0], upper = points[0];
  for (const Vec3d& p : points) {
    lower = least(lower, p);
    upper = greatest(upper, p);
  }
  // Halves, so that the extent of huge sets does not overflow.
  const double half_extent = max_abs(upper * 0.5 - lower * 0.5);
  int exponent = 0;
  std::frexp(half_extent, &exponent);  // half_extent <= 2^exponent
  Grid grid;
  grid.step = half_extent > 0 ? std::ldexp(1.0, exponent + 1 - grid_bits) : 0;
  grid.points.reserve(points.size());
  for (const Vec3d& p : points) {
    GridPoint g{};
    for (std::size_t i = 0; i < 3 && half_extent > 0; ++i)
      g[i] = std::llround(std::ldexp(p[i] * 0.5 - lower[i] * 0.5, grid_bits - exponent));
    grid.points.push_back(g);
  }
  return grid;
}

Vec3d grid_normal(std::span<const GridPoint> points, std::span<const std::uint32_t> loop) {
  GridNormal sum{};
  const GridPoint& origin = points[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const GridNormal n = product(minus(points[loop[i]], origin), minus(points[loop[i + 1]], origin));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
  }
  return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

HullSurface hull_surface(std::span<const GridPoint> points) {
  HullSurface surface;
  const auto length_from = [&](const GridPoint& o) {
    return [o](const GridPoint& p) {
      const GridPoint d = minus(p, o);
      return static_cast<double>(d[0]) * static_cast<double>(d[0]) +
             static_cast<double>(d[1]) * static_cast<double>(d[1]) +
             static_cast<double>(d[2]) * static_cast<double>(d[2]);
    };
  };
  const std::uint32_t first = [&] {
    const std::uint32_t far = extreme(points, length_from(points[0]));
    return far == none ? 0 : far;
  }();
  const std::uint32_t second = extreme(points, length_from(points[first]));
  if (second == none) {
    surface.polygon = {first};
    return surface;
  }
  const GridPoint along = minus(points[second], points[first]);
  const std::uint32_t third =
      extreme(points, [&](const GridPoint& p) { return magnitude(product(along, minus(p, points[first]))); });
  if (third == none) {
    surface.dimension = 1;
    surface.polygon = {first, second};
    return surface;
  }
  const GridNormal normal = product(along, minus(points[third], points[first]));
  const auto height = [&](const GridPoint& p) { return dot(normal, minus(p, points[first])); };
  const std::uint32_t fourth = extreme(points, [&](const GridPoint& p) {
    const Wide128 h = height(p);
    return static_cast<double>(h < 0 ? -h : h);
  });
  if (fourth == none) {
    surface.dimension = 2;
    surface.polygon = flat_hull(points, normal);
    return surface;
  }
  surface.dimension = 3;
  // The first triangle must not see the fourth point.
  const bool above = height(points[fourth]) > 0;
  surface.triangles = Quickhull(points, {first, above ? third : second, above ? second : third, fourth}).run();
  return surface;
}

}  // namespace graze
