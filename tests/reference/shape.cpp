#include "shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::reference {

Real length(const Vector& a) {
  // Scaled, so that neither tiny nor huge coordinates lose their square.
  const Real m = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
  if (m == 0 || !std::isfinite(m)) return m;
  const Vector s{a.x / m, a.y / m, a.z / m};
  return m * std::sqrt(dot(s, s));
}

Vector normalized(const Vector& a) {
  const Real l = length(a);
  return l > 0 ? Vector{a.x / l, a.y / l, a.z / l} : a;
}

std::pair<Vector, Vector> tangents(const Vector& n) {
  const Real x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  const Vector away = x <= y && x <= z ? Vector{1, 0, 0} : y <= z ? Vector{0, 1, 0} : Vector{0, 0, 1};
  const Vector u = normalized(cross(n, away));
  return {u, cross(n, u)};
}

namespace {

bool parallel_to_any(const std::vector<Vector>& units, const Vector& u, Real tolerance) {
  return std::any_of(units.begin(), units.end(), [&](const Vector& v) {
    const Vector c = cross(u, v);
    return dot(c, c) <= tolerance * tolerance;
  });
}

// Faces and edges of the hull by enumeration: a triple of vertices spans a face
// plane when no vertex lies beyond it. The test is lenient, and the diagonals
// of faces pass as edges: the axes they add are separating-axis candidates, each
// of which yields a valid lower bound, so too many is harmless and too few is
// not. Merging directions 1e-17 apart moves a support value by less than
// rounding does.
void hull_features(Shape& s) {
  const auto& p = s.vertices;
  const std::size_t n = p.size();
  Real extent = 0;
  Edge farthest{0, 0};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (const Real d = length(p[j] - p[i]); d > extent) {
        extent = d;
        farthest = {i, j};
      }
  if (extent == 0) return;
  const Real beyond = 1e-12L * extent, same = 1e-17L;

  std::vector<char> is_edge(n * n, 0);
  is_edge[farthest.first * n + farthest.second] = 1;  // all there is of a segment
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        const Vector a = p[j] - p[i], b = p[k] - p[i], c = cross(a, b);
        const Real area = length(c);
        if (area <= 1e-15L * length(a) * length(b)) continue;
        const Vector normal = c * (1 / area);
        bool above = false, below = false;
        for (std::size_t m = 0; m < n && !(above && below); ++m) {
          const Real h = dot(normal, p[m] - p[i]);
          above = above || h > beyond;
          below = below || h < -beyond;
        }
        if (above && below) continue;
        if (!parallel_to_any(s.face_normals, normal, same)) s.face_normals.push_back(normal);
        is_edge[i * n + j] = is_edge[j * n + k] = is_edge[i * n + k] = 1;
      }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      if (!is_edge[i * n + j]) continue;
      const Vector direction = normalized(p[j] - p[i]);
      if (dot(direction, direction) == 0) continue;
      s.edges.push_back({i, j});
      if (!parallel_to_any(s.edge_directions, direction, same)) s.edge_directions.push_back(direction);
    }
}

// Support of a cone frustum's or capsule's bottom and top part, chosen by value.
Vector higher(const Vector& a, const Vector& b, const Vector& n) { return dot(a, n) >= dot(b, n) ? a : b; }

Vector core_support(const Shape& s, const Vector& n) {
  const Real half = s.height / 2;
  switch (s.kind) {
  case Kind::Polytope:
    return *std::max_element(s.vertices.begin(), s.vertices.end(),
                             [&](const Vector& a, const Vector& b) { return dot(a, n) < dot(b, n); });
  case Kind::Capsule:
    return higher(Vector{0, -half, 0} + s.radius_bottom * n, Vector{0, half, 0} + s.radius_top * n, n);
  case Kind::Cylinder: {
    const Vector radial = normalized({n.x, 0, n.z});
    return higher(Vector{0, -half, 0} + s.radius_bottom * radial, Vector{0, half, 0} + s.radius_top * radial, n);
  }
  case Kind::Ellipsoid: {
    // Image of the unit ball's support point under x -> radii * x.
    const Vector m = normalized({s.radii.x * n.x, s.radii.y * n.y, s.radii.z * n.z});
    return {s.radii.x * m.x, s.radii.y * m.y, s.radii.z * m.z};
  }
  case Kind::Halfspace: break;
  }
  return {};
}

}  // namespace

Shape polytope(std::vector<Vector> vertices, Real margin) {
  Shape s;
  s.kind = Kind::Polytope;
  s.vertices = std::move(vertices);
  s.margin = margin;
  if (s.vertices.empty()) s.vertices.push_back({});
  hull_features(s);
  return s;
}

Shape point(Real margin) { return polytope({{0, 0, 0}}, margin); }

Shape box(const Vector& full_size, Real margin) {
  std::vector<Vector> corners;
  for (const Real x : {-1, 1})
    for (const Real y : {-1, 1})
      for (const Real z : {-1, 1}) corners.push_back({x * full_size.x / 2, y * full_size.y / 2, z * full_size.z / 2});
  return polytope(std::move(corners), margin);
}

Shape sphere(Real radius) { return point(radius); }

Shape capsule(Real height, Real radius_bottom, Real radius_top, Real margin) {
  Shape s;
  s.kind = Kind::Capsule;
  s.height = height;
  s.radius_bottom = radius_bottom;
  s.radius_top = radius_top;
  s.margin = margin;
  return s;
}

Shape cylinder(Real height, Real radius_bottom, Real radius_top, Real margin) {
  Shape s = capsule(height, radius_bottom, radius_top, margin);
  s.kind = Kind::Cylinder;
  return s;
}

Shape ellipsoid(const Vector& radii, Real margin) {
  Shape s;
  s.kind = Kind::Ellipsoid;
  s.radii = radii;
  s.margin = margin;
  return s;
}

Shape halfspace(Real margin) {
  Shape s;
  s.kind = Kind::Halfspace;
  s.margin = margin;
  return s;
}

Placed place(Shape shape, const Vector& translation, const Quaternion& rotation) {
  const Real norm =
      std::sqrt(rotation.x * rotation.x + rotation.y * rotation.y + rotation.z * rotation.z + rotation.w * rotation.w);
  const Quaternion q =
      norm > 0 ? Quaternion{rotation.x / norm, rotation.y / norm, rotation.z / norm, rotation.w / norm} : Quaternion{};
  Placed placed;
  placed.shape = std::move(shape);
  placed.translation = translation;
  placed.axis_x = {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)};
  placed.axis_y = {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)};
  placed.axis_z = {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)};
  return placed;
}

bool is_halfspace_normal(const Placed& halfspace, const Vector& unit) {
  return length(unit - halfspace.axis_y) <= halfspace_alignment;
}

Vector support(const Placed& placed, const Vector& n) {
  const Shape& s = placed.shape;
  if (s.kind == Kind::Halfspace) return placed.translation + s.margin * placed.axis_y;
  const Vector unit = normalized(n);
  return placed.to_world(core_support(s, placed.to_local_direction(unit))) + s.margin * unit;
}

Real support_value(const Placed& placed, const Vector& n) {
  const Vector unit = normalized(n);
  if (placed.shape.kind == Kind::Halfspace) {
    if (!is_halfspace_normal(placed, unit)) return std::numeric_limits<Real>::infinity();
    return dot(placed.axis_y, placed.translation) + placed.shape.margin;
  }
  return dot(unit, support(placed, unit));
}

Real bounding_radius(const Shape& s) {
  switch (s.kind) {
  case Kind::Polytope: {
    Real r = 0;
    for (const Vector& v : s.vertices) r = std::max(r, length(v));
    return r + s.margin;
  }
  case Kind::Capsule: return s.height / 2 + std::max(s.radius_bottom, s.radius_top) + s.margin;
  case Kind::Cylinder: return std::hypot(s.height / 2, std::max(s.radius_bottom, s.radius_top)) + s.margin;
  case Kind::Ellipsoid: return std::max({s.radii.x, s.radii.y, s.radii.z}) + s.margin;
  case Kind::Halfspace: break;
  }
  return 0;
}

}  // namespace graze::reference
