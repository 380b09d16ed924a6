#include "distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace graze::reference {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

// A shape without margin, turned into world axes and reduced to the simplest
// kind of the same extent. Translation is kept apart, so that only the offset
// between the two shapes is ever added to their own coordinates.
struct Core {
  Placed placed;
  Real slope = 0;  // capsule, cylinder: n.axis where support changes ends

  Core(const Placed& original, const Vector& origin) : placed(original) {
    Shape& s = placed.shape;
    const Real half = s.height / 2, taper = s.radius_bottom - s.radius_top;
    if (s.kind == Kind::Capsule && std::fabs(taper) >= s.height) {
      s = polytope({{0, taper > 0 ? -half : half, 0}}, s.margin + std::max(s.radius_bottom, s.radius_top));
    } else if (s.kind == Kind::Capsule && taper == 0) {
      s = polytope({{0, -half, 0}, {0, half, 0}}, s.margin + s.radius_top);
    } else if (s.kind == Kind::Cylinder && s.radius_bottom == 0 && s.radius_top == 0) {
      s = polytope({{0, -half, 0}, {0, half, 0}}, s.margin);
    } else if (s.kind == Kind::Ellipsoid) {
      const Vector r = s.radii;
      if (r.x == r.y && r.y == r.z)
        s = point(s.margin + r.x);
      else if ((r.x == 0) + (r.y == 0) + (r.z == 0) == 2)
        s = polytope({-r, r}, s.margin);
    }
    if (s.kind == Kind::Capsule) slope = taper / s.height;
    if (s.kind == Kind::Cylinder) slope = s.height > 0 || taper != 0 ? taper / std::hypot(s.height, taper) : 0;
    placed.translation = placed.translation - origin;
    for (Vector& v : s.vertices) v = placed.to_world_direction(v);
    for (Vector& v : s.face_normals) v = placed.to_world_direction(v);
    for (Vector& v : s.edge_directions) v = placed.to_world_direction(v);
  }

  const Shape& shape() const { return placed.shape; }
  bool is_polytope() const { return shape().kind == Kind::Polytope; }

  // Support value about the shape's own origin, for unit n in world axes.
  // Closed forms, apart from the support points of shape.cpp.
  Real value(const Vector& n) const {
    const Shape& s = shape();
    switch (s.kind) {
    case Kind::Polytope: {
      Real best = -infinity;
      for (const Vector& v : s.vertices) best = std::max(best, dot(v, n));
      return best;
    }
    case Kind::Capsule: {
      const Real rise = dot(placed.axis_y, n) * s.height / 2;
      return std::max(s.radius_bottom - rise, s.radius_top + rise);
    }
    case Kind::Cylinder: {
      const Real x = dot(placed.axis_x, n), z = dot(placed.axis_z, n), radial = std::sqrt(x * x + z * z);
      const Real rise = dot(placed.axis_y, n) * s.height / 2;
      return std::max(s.radius_bottom * radial - rise, s.radius_top * radial + rise);
    }
    case Kind::Ellipsoid: {
      const Vector l = placed.to_local_direction(n);
      const Real x = l.x * s.radii.x, y = l.y * s.radii.y, z = l.z * s.radii.z;
      return std::sqrt(x * x + y * y + z * z);
    }
    case Kind::Halfspace: break;
    }
    return infinity;
  }
};

struct Pair {
  Core a, b;
  Vector offset;  // from A's origin to B's
  Real margins;   // subtract from every s(n) alike, so they never matter to the search
  Real scale;     // what rounding errors are proportional to

  Pair(const Placed& pa, const Placed& pb)
      : a(pa, pa.translation), b(pb, pa.translation), offset(b.placed.translation) {
    margins = a.shape().margin + b.shape().margin;
    scale = bounding_radius(pa.shape) + bounding_radius(pb.shape) + length(offset);
  }
  Real operator()(const Vector& n) const { return dot(n, offset) - a.value(n) - b.value(-n); }
};

// ---------------------------------------------------------------- polytopes

// The best direction among those tried; s(n) of two vertex sets is abandoned as
// soon as it falls to the best so far.
struct Best {
  const std::vector<Vector>& a;
  const std::vector<Vector>& b;
  Vector offset;
  Signed best{-infinity, {0, 1, 0}};

  void try_one(const Vector& n) {
    const Real shift = dot(n, offset);
    Real top = dot(n, a[0]), bottom = infinity;
    for (const Vector& v : b) {
      bottom = std::min(bottom, dot(n, v));
      if (shift + bottom - top <= best.distance) return;
    }
    for (const Vector& v : a) {
      top = std::max(top, dot(n, v));
      if (shift + bottom - top <= best.distance) return;
    }
    best = {shift + bottom - top, n};
  }
  void try_both(const Vector& n) {
    try_one(n);
    try_one(-n);
  }
};

// s is the support function of the Minkowski difference of the vertex sets, so
// overlap is decided by the difference's facets, whose normals are face normals
// of either shape or cross products of an edge of each (Ericson, Real-Time
// Collision Detection, 5.2.1). When separated, the closest features may also be
// vertex-edge or vertex-vertex, whose direction is tried as well.
Signed polytope_distance(const Pair& pair) {
  const Shape &sa = pair.a.shape(), &sb = pair.b.shape();
  Best search{sa.vertices, sb.vertices, pair.offset};
  // A flat or shorter difference has normals that no face or edge pair spans.
  for (const Vector& n : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) search.try_both(n);
  for (const Shape* s : {&sa, &sb}) {
    if (!s->edge_directions.empty()) search.try_both(tangents(s->edge_directions[0]).first);
    for (const Vector& n : s->face_normals) search.try_both(n);
  }
  for (const Vector& e : sa.edge_directions)
    for (const Vector& f : sb.edge_directions) {
      const Vector n = cross(e, f);
      const Real sine = std::sqrt(dot(n, n));
      // Closer to parallel than this, the facet is a sliver narrower than rounding.
      if (sine > 1e-17L) search.try_both(n * (1 / sine));
    }
  if (search.best.distance < -1e-16L * pair.scale) return search.best;

  // Feet are not clamped to their edge: at the end of an edge, either of the
  // vertex-edge and vertex-vertex directions is the accurate one.
  const auto vertices_to_edges = [&](const Shape& from, const Shape& to, Real side) {
    for (const Vector& v : from.vertices)
      for (const Edge& e : to.edges) {
        const Vector start = to.vertices[e.first], u = normalized(to.vertices[e.second] - start);
        Vector d = side * pair.offset + start - v;
        for (int i = 0; i < 2; ++i) {  // twice: the first leaves rounding along the edge when d is short
          d = d - dot(d, u) * u;
          d = normalized(d);
        }
        if (dot(d, d) > 0.5L) search.try_one(side * d);
      }
  };
  vertices_to_edges(sa, sb, 1);
  vertices_to_edges(sb, sa, -1);
  for (const Vector& v : sa.vertices)
    for (const Vector& w : sb.vertices)
      if (const Vector d = normalized(pair.offset + w - v); dot(d, d) > 0) search.try_one(d);
  return search.best;
}

// ------------------------------------------------------------------- search

// A support function has creases along circles n.axis = level: across an edge
// of a polytope, and across the side of a cone. Maxima of s like to lie on
// creases and where two of them cross, and sampling there finds them.
struct Crease {
  Vector axis;
  Real level;
};

void add_creases(const Core& core, Real side, std::vector<Crease>& out) {
  if (core.is_polytope())
    for (const Vector& e : core.shape().edge_directions) out.push_back({e, 0});
  else if (core.shape().kind != Kind::Ellipsoid)
    out.push_back({core.placed.axis_y, side * core.slope});
}

std::vector<Vector> sample_directions(const Pair& pair, int effort) {
  constexpr Real tau = 2 * std::numbers::pi_v<Real>;
  std::vector<Vector> out;
  const int count = 1000 * effort;  // Fibonacci lattice, about 0.1 apart
  for (int i = 0; i < count; ++i) {
    const Real y = 1 - (2 * static_cast<Real>(i) + 1) / static_cast<Real>(count), r = std::sqrt(1 - y * y);
    const Real turn = tau * std::fmod(static_cast<Real>(i) / std::numbers::phi_v<Real>, 1.0L);
    out.push_back({r * std::cos(turn), y, r * std::sin(turn)});
  }
  const auto both = [&](const Vector& v) {
    const Vector n = normalized(v);
    if (dot(n, n) == 0) return;
    out.push_back(n);
    out.push_back(-n);
  };
  both(pair.offset);
  const Placed &a = pair.a.placed, &b = pair.b.placed;
  for (const Vector& u : {a.axis_x, a.axis_y, a.axis_z}) both(u);
  for (const Vector& v : {b.axis_x, b.axis_y, b.axis_z}) {
    both(v);
    for (const Vector& u : {a.axis_x, a.axis_y, a.axis_z}) both(cross(u, v));
  }
  for (const Core* core : {&pair.a, &pair.b})
    for (const Vector& n : core->shape().face_normals) both(n);

  std::vector<Crease> ca, cb;
  add_creases(pair.a, 1, ca);
  add_creases(pair.b, -1, cb);
  const int creases = static_cast<int>(ca.size() + cb.size());
  const int steps = std::clamp(1200 / std::max(creases, 1), 8, 48) * effort;
  for (const auto* list : {&ca, &cb})
    for (const Crease& c : *list) {
      const auto [u, v] = tangents(c.axis);
      const Real r = std::sqrt(std::max<Real>(0, 1 - c.level * c.level));
      for (int i = 0; i < steps; ++i) {
        const Real turn = tau * static_cast<Real>(i) / static_cast<Real>(steps);
        out.push_back(normalized(c.level * c.axis + r * (std::cos(turn) * u + std::sin(turn) * v)));
      }
    }
  for (const Crease& p : ca)
    for (const Crease& q : cb) {
      const Real c = dot(p.axis, q.axis), det = 1 - c * c;
      if (det < 1e-12L) continue;
      const Vector middle = ((p.level - c * q.level) / det) * p.axis + ((q.level - c * p.level) / det) * q.axis;
      const Real rest = 1 - dot(middle, middle);
      if (rest < 0) continue;
      const Vector across = std::sqrt(rest / det) * cross(p.axis, q.axis);
      out.push_back(normalized(middle + across));
      out.push_back(normalized(middle - across));
    }
  return out;
}

struct Maximum {
  Real x, value;
};

// Golden section (Kiefer 1953) for a unimodal function; it needs no derivative,
// so creases do not disturb it. Stops at `width`, or when nothing but rounding
// (`flat`) is left of the differences.
template <class F>
Maximum golden_section(F f, Real lo, Real hi, Real width, Real flat) {
  constexpr Real ratio = 1 / std::numbers::phi_v<Real>;
  Real x1 = hi - ratio * (hi - lo), x2 = lo + ratio * (hi - lo);
  Real at_lo = -infinity, at_hi = -infinity, f1 = f(x1), f2 = f(x2);
  while (hi - lo > width && std::max(f1, f2) - std::min({f1, f2, at_lo, at_hi}) > flat) {
    if (f1 >= f2) {
      hi = x2, at_hi = f2;
      x2 = x1, f2 = f1;
      f1 = f(x1 = hi - ratio * (hi - lo));
    } else {
      lo = x1, at_lo = f1;
      x1 = x2, f1 = f2;
      f2 = f(x2 = lo + ratio * (hi - lo));
    }
  }
  return f1 >= f2 ? Maximum{x1, f1} : Maximum{x2, f2};
}

struct Precision {
  Real window, outer, inner, flat;
};

// Maximum of s near `start`, by golden section over one tangent coordinate of
// the golden-section maximum over the other. Unlike pattern search this cannot
// stall on a crease: the inner maximum is exact, so the outer function is a
// plain function of one variable. It needs superlevel sets that are connected
// with interval slices, which holds for separated pairs (convex sets in this
// chart) and near a maximum for overlapping ones. A maximum at the border of
// the window moves the window, and widens it: beside a rim at a small distance
// the way along the crease is long and almost level.
Signed climb(const Pair& pair, Vector start, Precision p) {
  Signed best{pair(start), start};
  for (int moves = 0; moves < 40; ++moves) {
    const Vector n0 = start;
    const auto [e1, e2] = tangents(n0);
    const auto direction = [&, u = e1, w = e2](Real x, Real y) { return normalized(n0 + x * u + y * w); };
    const auto over_y = [&](Real x) {
      return golden_section([&](Real y) { return pair(direction(x, y)); }, -p.window, p.window, p.inner, p.flat);
    };
    const Maximum mx = golden_section([&](Real x) { return over_y(x).value; }, -p.window, p.window, p.outer, p.flat);
    const Real y = over_y(mx.x).x;
    const Vector n = direction(mx.x, y);
    const Real value = pair(n);
    const bool gained = value > best.distance + p.flat;
    if (value > best.distance) best = {value, n};
    if (!gained || std::max(std::fabs(mx.x), std::fabs(y)) < 0.8L * p.window) break;
    start = n;
    p.window = std::min(2 * p.window, 0.5L);
  }
  return best;
}

Signed search(const Pair& pair, int effort) {
  std::vector<Signed> samples;
  for (const Vector& n : sample_directions(pair, effort)) samples.push_back({pair(n), n});
  const auto better = [](const Signed& x, const Signed& y) { return x.distance > y.distance; };
  std::sort(samples.begin(), samples.end(), better);

  // Start from the samples that have no better one near them.
  const auto near = [](const Signed& x, const Signed& y, Real angle) {
    const Vector d = x.normal - y.normal;
    return dot(d, d) < angle * angle;
  };
  const std::size_t considered = std::min<std::size_t>(samples.size(), 400 * static_cast<std::size_t>(effort));
  std::vector<Signed> hills;
  for (std::size_t i = 0; i < considered && hills.size() < 10 * static_cast<std::size_t>(effort); ++i) {
    bool top = true;
    for (std::size_t j = 0; j < i && top; ++j) top = !near(samples[i], samples[j], 0.15L);
    if (top) hills.push_back(samples[i]);
  }
  const Real rounding = 2e-19L * pair.scale;
  const bool separated = hills[0].distance > 0;  // then s has one maximum only
  if (separated) hills.resize(1);
  for (Signed& hill : hills) hill = climb(pair, hill.normal, {0.15L, 1e-4L, 1e-6L, 1e-9L * pair.scale});
  std::sort(hills.begin(), hills.end(), better);

  Signed best = hills[0];
  std::vector<Signed> done;
  for (const Signed& hill : hills) {
    if (done.size() == 3 * static_cast<std::size_t>(effort) || hill.distance < hills[0].distance - 1e-3L * pair.scale)
      break;
    if (std::any_of(done.begin(), done.end(), [&](const Signed& d) { return near(hill, d, 0.02L); })) continue;
    done.push_back(hill);
    const Signed refined = climb(pair, hill.normal, {0.02L, 1e-17L, 1e-17L, rounding});
    if (refined.distance > best.distance) best = refined;
  }
  return best;
}

}  // namespace

Real separation(const Placed& a, const Placed& b, const Vector& n) {
  Vector unit = normalized(n);
  if (a.shape.kind == Kind::Halfspace && is_halfspace_normal(a, unit)) unit = a.axis_y;
  if (b.shape.kind == Kind::Halfspace && is_halfspace_normal(b, -unit)) unit = -b.axis_y;
  // About A's origin, so that a common offset costs no digits.
  Placed near = a, far = b;
  far.translation = b.translation - a.translation;
  near.translation = {};
  return -support_value(far, -unit) - support_value(near, unit);
}

Signed search_signed_distance(const Placed& a, const Placed& b, int effort) {
  const Pair pair(a, b);
  Signed result = search(pair, effort);
  result.distance -= pair.margins;
  return result;
}

Signed signed_distance(const Placed& a, const Placed& b) {
  if (a.shape.kind == Kind::Halfspace) return {separation(a, b, a.axis_y), a.axis_y};
  if (b.shape.kind == Kind::Halfspace) return {separation(a, b, -b.axis_y), -b.axis_y};
  const Pair pair(a, b);
  if (!pair.a.is_polytope() || !pair.b.is_polytope()) return search_signed_distance(a, b);
  Signed result = polytope_distance(pair);
  result.distance -= pair.margins;
  return result;
}

Real size(const Placed& a, const Placed& b) { return std::max(bounding_radius(a.shape), bounding_radius(b.shape)); }

}  // namespace graze::reference
