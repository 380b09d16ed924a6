#include "separating_axes.hpp"

#include <algorithm>
#include <limits>

namespace graze::reference {
namespace {

// Unit vectors closer than this are one axis. Taking one for the other moves a depth by less than this times the size,
// which is below the rounding of double precision; the opposite faces of a moved box differ by less.
constexpr Real same_axis = 1e-16L;
// Sine of the angle below which two edges count as parallel: their cross product is mostly rounding error.
constexpr Real parallel_edges = 1e-12L;

void add_axis(std::vector<Vector>& axes, const Vector& direction) {
  const Vector unit = normalized(direction);
  if (dot(unit, unit) == 0) return;
  for (const Vector& axis : axes) {
    const Vector c = cross(axis, unit);
    if (dot(c, c) <= same_axis * same_axis) return;
  }
  axes.push_back(unit);
}

// Axes are up to sign.
struct Features {
  std::vector<Vector> vertices, normals, edges;
};

// Vertices are seen from `origin`, so that depths of bodies far away keep their digits.
Features features(const Polyhedron& p, const Vector& origin) {
  Features f;
  for (const Vector& v : p.vertices) f.vertices.push_back(v - origin);
  for (const std::vector<int>& face : p.faces) {
    const auto at = [&](std::size_t i) { return f.vertices[static_cast<std::size_t>(face[i % face.size()])]; };
    Vector area;
    for (std::size_t i = 0; i < face.size(); ++i) {
      area = area + cross(at(i) - at(0), at(i + 1) - at(0));
      add_axis(f.edges, at(i + 1) - at(i));
    }
    add_axis(f.normals, area);
  }
  // The faces of a flat polyhedron have no neighbour but each other. Two of them in one plane are told apart only by
  // the lines of their edges, to which no cross product of edges is perpendicular within the plane.
  if (f.normals.size() == 1) {
    const Vector n = f.normals.front();
    for (const Vector& edge : f.edges) add_axis(f.normals, cross(n, edge));
  }
  return f;
}

struct Interval {
  Real low, high;
};

Interval project(const std::vector<Vector>& points, const Vector& axis) {
  Interval i{std::numeric_limits<Real>::infinity(), -std::numeric_limits<Real>::infinity()};
  for (const Vector& p : points) {
    const Real h = dot(axis, p);
    i.low = h < i.low ? h : i.low;
    i.high = h > i.high ? h : i.high;
  }
  return i;
}

struct WayOut {
  Vector normal;
  Real depth;
};

}  // namespace

AxisResult separating_axes(const Polyhedron& a, const Polyhedron& b) {
  const Vector origin = a.vertices.empty() ? Vector{} : (a.vertices.front());
  const Features fa = features(a, origin), fb = features(b, origin);

  std::vector<WayOut> ways;
  ways.reserve(2 * (fa.normals.size() + fb.normals.size() + fa.edges.size() * fb.edges.size()));
  const auto attempt = [&](const Vector& axis) {
    const Interval ia = project(fa.vertices, axis), ib = project(fb.vertices, axis);
    ways.push_back({axis, ia.high - ib.low});
    ways.push_back({-axis, ib.high - ia.low});
  };
  for (const Vector& n : fa.normals) attempt(n);
  for (const Vector& n : fb.normals) attempt(n);
  for (const Vector& ea : fa.edges)
    for (const Vector& eb : fb.edges) {
      const Vector c = cross(ea, eb);
      if (dot(c, c) > parallel_edges * parallel_edges) attempt(normalized(c));
    }

  WayOut best{{0, 1, 0}, std::numeric_limits<Real>::infinity()};
  for (const WayOut& way : ways)
    if (way.depth < best.depth) best = way;
  Real runner_up = std::numeric_limits<Real>::infinity();
  for (const WayOut& way : ways) {
    const Vector d = way.normal - best.normal;
    if (way.depth < runner_up && dot(d, d) > same_direction * same_direction) runner_up = way.depth;
  }
  const bool overlap = best.depth >= 0;
  return {best.depth, best.normal, overlap, overlap ? 0 : -best.depth, runner_up};
}

Polyhedron polyhedron_of_box(const Vector& edge_lengths) {
  // Bits 0, 1, 2 of a corner's number say on which side in x, y, z it is.
  Polyhedron p;
  for (int i = 0; i < 8; ++i) {
    const auto side = [&](int bit, Real length) { return (i >> bit & 1) ? length / 2 : -length / 2; };
    p.vertices.push_back({side(0, edge_lengths.x), side(1, edge_lengths.y), side(2, edge_lengths.z)});
  }
  p.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return p;
}

Polyhedron polyhedron_of_hull(const std::vector<Vector>& points) {
  Polyhedron p{points, {}};
  const int n = static_cast<int>(points.size());
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  Real extent = 0;
  for (int i = 1; i < n; ++i) extent = std::max(extent, length(at(i) - at(0)));
  // Points meant to be coplanar are so only to the rounding of single or double precision. Lenient, as a face too many
  // is harmless.
  const Real beyond = 1e-12L * extent;
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        const Vector u = at(j) - at(i), v = at(k) - at(i), c = cross(u, v);
        if (length(c) <= 1e-15L * length(u) * length(v)) continue;
        const Vector normal = normalized(c);
        bool above = false, below = false;
        for (int m = 0; m < n && !(above && below); ++m) {
          const Real h = dot(normal, at(m) - at(i));
          above = above || h > beyond;
          below = below || h < -beyond;
        }
        if (!above) p.faces.push_back({i, j, k});
        if (!below) p.faces.push_back({i, k, j});
      }
  return p;
}

Polyhedron polyhedron_of_polygon(const std::vector<Vector>& corners) {
  Polyhedron p{corners, {{}, {}}};
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) p.faces[0].push_back(i);
  p.faces[1].assign(p.faces[0].rbegin(), p.faces[0].rend());
  return p;
}

Polyhedron moved(const Polyhedron& polyhedron, const Vector& translation, const Quaternion& rotation) {
  const Placed placed = place({}, translation, rotation);
  Polyhedron p = polyhedron;
  for (Vector& v : p.vertices) v = placed.to_world(v);
  return p;
}

}  // namespace graze::reference
