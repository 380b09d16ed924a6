#include "narrow/gjk/polytope.hpp"

#include <algorithm>

namespace graze {

const Facet* Polytope::nearest_open() const {
  double least_offset = closed;
  const Facet* best = nullptr;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (!(open_[i] < least_offset)) continue;
    least_offset = open_[i];
    best = &facets_[i];
  }
  return best;
}

void Polytope::add_vertex(const SupportPoint& p) {
  vertices_.push_back(p);
  squared_.push_back(length_squared(p.w));
}

void Polytope::build_tetrahedron(const Simplex& s) {
  const Vec3d& p = s.w(0);
  const double volume = dot(s.w(3) - p, cross(s.w(1) - p, s.w(2) - p));
  const bool turned = volume > 0;  // so that 0, 1, 2 is counter-clockwise seen from outside
  for (const std::size_t i : {0, turned ? 2 : 1, turned ? 1 : 2, 3}) add_vertex(s.points[i]);
  add_facet(0, 1, 2);
  add_facet(0, 3, 1);
  add_facet(0, 2, 3);
  add_facet(1, 3, 2);
  facets_[0].neighbor = {1, 3, 2};
  facets_[1].neighbor = {2, 3, 0};
  facets_[2].neighbor = {0, 3, 1};
  facets_[3].neighbor = {1, 2, 0};
}

std::uint16_t Polytope::add_facet(std::uint16_t i, std::uint16_t j, std::uint16_t k) {
  const bool fresh = free_.empty();
  const std::size_t slot = fresh ? facets_.size() : free_.back();
  if (fresh) {
    facets_.emplace_back();
    open_.emplace_back();
  } else {
    free_.pop_back();
  }
  Facet& f = facets_[slot];
  const Vec3d &a = vertices_[i].w, &b = vertices_[j].w, &c = vertices_[k].w;
  f.normal = unit(cross(b - a, c - a), Vec3d{});
  // The vertex nearest to the origin has the smallest coordinates, and so the smallest rounding error. It is
  // unpredictable which one: numbers are chosen without a branch.
  const double la = squared_[i], lb = squared_[j], lc = squared_[k];
  std::size_t nearest = lb < la ? j : i;
  nearest = lc < least(la, lb) ? k : nearest;
  f.offset = dot(f.normal, vertices_[nearest].w);
  f.vertex = {i, j, k};
  f.live = true;
  // A facet without area has no plane of its own; its neighbours bound the polytope there.
  open_[slot] = f.normal == Vec3d{} ? closed : f.offset;
  return static_cast<std::uint16_t>(slot);
}

bool Polytope::find_horizon(std::uint16_t seed, const Vec3d& w) {
  // Depth first around each facet in order, so that the horizon's edges come out as a counter-clockwise loop.
  struct Visit {
    std::uint16_t facet;
    std::uint8_t edge, left;
  };
  FixedVector<Visit, max_facets> stack;
  horizon_.clear();
  seen_.clear();
  facets_[seed].live = false;
  seen_.push_back(seed);
  stack.push_back({seed, 0, 3});
  while (!stack.empty()) {
    Visit& top = stack.back();
    if (top.left == 0) {
      stack.pop_back();
      continue;
    }
    const Facet& f = facets_[top.facet];
    const std::uint8_t e = top.edge;
    top.edge = static_cast<std::uint8_t>((e + 1) % 3);
    --top.left;
    const std::uint16_t n = f.neighbor[e];
    Facet& next = facets_[n];
    const auto entry = static_cast<std::uint8_t>(std::find(next.neighbor.begin(), next.neighbor.end(), top.facet) -
                                                 next.neighbor.begin());
    if (entry == 3) return false;
    if (next.live && sees(next, w)) {
      next.live = false;
      seen_.push_back(n);
      stack.push_back({n, static_cast<std::uint8_t>((entry + 1) % 3), 2});
    } else if (next.live) {
      if (horizon_.full()) return false;
      horizon_.push_back({f.vertex[e], f.vertex[(e + 1u) % 3], n, entry});
    }
  }
  return horizon_is_loop();
}

bool Polytope::horizon_is_loop() const {
  if (horizon_.size() < 3) return false;
  for (std::size_t i = 0; i < horizon_.size(); ++i)
    if (horizon_[i].to != horizon_[(i + 1) % horizon_.size()].from) return false;
  return true;
}

bool Polytope::expand(const Facet& seen_first, const SupportPoint& point) {
  if (vertices_.full()) return false;
  const auto seed = static_cast<std::uint16_t>(&seen_first - facets_.begin());
  if (!find_horizon(seed, point.w)) {
    for (const std::uint16_t f : seen_) facets_[f].live = true;
    return false;
  }
  const auto apex = static_cast<std::uint16_t>(vertices_.size());
  add_vertex(point);
  for (const std::uint16_t f : seen_) {
    free_.push_back(f);
    open_[f] = closed;
  }

  std::uint16_t first = 0, previous = 0;
  for (std::size_t i = 0; i < horizon_.size(); ++i) {
    const HorizonEdge& edge = horizon_[i];
    const std::uint16_t fan = add_facet(edge.from, edge.to, apex);
    facets_[fan].neighbor[0] = edge.outside;
    facets_[edge.outside].neighbor[edge.outside_edge] = fan;
    if (i == 0) {
      first = fan;
    } else {
      facets_[previous].neighbor[1] = fan;
      facets_[fan].neighbor[2] = previous;
    }
    previous = fan;
  }
  facets_[previous].neighbor[1] = first;
  facets_[first].neighbor[2] = previous;
  return true;
}

std::size_t Polytope::live_count() const {
  return static_cast<std::size_t>(std::count_if(facets_.begin(), facets_.end(), [](const Facet& f) { return f.live; }));
}

/// Whether the ray hits the facet with a smallest barycentric coordinate larger than the best so far.
bool Polytope::pierce(const Facet& f, const Vec3d& direction, double& best, Vec3d& a, Vec3d& b) const {
  const SupportPoint &p = vertices_[f.vertex[0]], &q = vertices_[f.vertex[1]], &r = vertices_[f.vertex[2]];
  double u = dot(direction, cross(q.w, r.w)), v = dot(direction, cross(r.w, p.w)), w = dot(direction, cross(p.w, q.w));
  const double sum = u + v + w;
  if (!(sum > 0)) return false;
  const double inside = least(u, least(v, w)) / sum;
  if (!(inside > best)) return false;
  best = inside;
  u = greatest(u, 0.0), v = greatest(v, 0.0), w = greatest(w, 0.0);
  const double whole = u + v + w;
  a = (p.a * u + q.a * v + r.a * w) / whole;
  b = (p.b * u + q.b * v + r.b * w) / whole;
  return true;
}

double Polytope::pierce(const Vec3d& direction, double facing, Vec3d& a, Vec3d& b) const {
  // Exactly one facet is hit but for rounding.
  double best = -std::numeric_limits<double>::infinity();
  for (const Facet& f : facets_)
    if (f.live && dot(f.normal, direction) > facing) pierce(f, direction, best, a, b);
  return best;
}

bool Polytope::witness(const Vec3d& direction, const Facet* likely, Vec3d& a, Vec3d& b) const {
  double best = -std::numeric_limits<double>::infinity();
  if (likely && likely->live && likely->normal == direction && pierce(*likely, direction, best, a, b) && best > 0)
    return true;
  // Facets seen edge-on are no hits where the origin lies in their plane: only facets that face the ray count, and the
  // others serve to return some points.
  const double missed = pierce(direction, 0.9, a, b);
  if (missed == -std::numeric_limits<double>::infinity()) pierce(direction, 0.0, a, b);
  return missed >= 0;
}

void Polytope::nearest_witness(const Vec3d& target, Vec3d& a, Vec3d& b) const {
  double best = std::numeric_limits<double>::infinity();
  for (const Facet& f : facets_) {
    if (!f.live || std::abs(dot(f.normal, target) - f.offset) > best) continue;
    Simplex triangle;
    for (const std::uint16_t v : f.vertex) {
      SupportPoint p = vertices_[v];
      p.w -= target;
      triangle.push(p);
    }
    const Nearest nearest = nearest_to_origin(triangle);
    const double distance = std::sqrt(nearest.squared);
    if (!(distance < best)) continue;
    best = distance;
    reduce(triangle, nearest);
    a = triangle.point_a();
    b = triangle.point_b();
  }
}

double Polytope::least_along(const Facet& f, const Vec3d& direction) const {
  const auto along = [&](std::size_t i) { return dot(direction, vertices_[f.vertex[i]].w); };
  return least(along(0), least(along(1), along(2)));
}

double Polytope::inner_radius(double enough) const {
  double radius = enough;
  for (const Facet& f : facets_) {
    if (!f.live) continue;
    double known = least_along(f, f.normal);
    // A sliver's normal is mere rounding; the sliver lies in the planes of its neighbours as well as in its own.
    for (std::size_t i = 0; i < 3 && known < radius; ++i)
      known = greatest(known, least_along(f, facets_[f.neighbor[i]].normal));
    radius = least(radius, known);
  }
  return radius;
}

}  // namespace graze
