#include "narrow/simplex.hpp"

namespace graze {

namespace {

Nearest vertex(const Simplex& s, std::size_t i) { return {s.w(i), false, 1, {i}, {1.0}}; }

Nearest edge(const Simplex& s, std::size_t i, std::size_t j) {
  const Vec3d &p = s.w(i), &q = s.w(j);
  const Vec3d d = q - p;
  const double along = -dot(p, d), whole = dot(d, d);
  if (!(along > 0)) return vertex(s, i);
  if (along >= whole) return vertex(s, j);
  const double t = along / whole;
  // From the end that is nearer: the error of t then is multiplied by the shorter piece.
  const Vec3d near = t < 0.5 ? p + d * t : q - d * (1 - t);
  // What rounding left along the edge is large beside a point near the origin. Taken off once more, the direction of
  // the point is at right angles to the edge in all its digits.
  const Vec3d point = near - d * (dot(near, d) / whole);
  return {point, false, 2, {i, j}, {1 - t, t}};
}

const Nearest& nearer(const Nearest& a, const Nearest& b) {
  return length_squared(b.point) < length_squared(a.point) ? b : a;
}

Nearest nearest_edge(const Simplex& s, std::size_t i, std::size_t j, std::size_t k) {
  return nearer(nearer(edge(s, i, j), edge(s, j, k)), edge(s, i, k));
}

/// The vertices in ascending order.
Nearest triangle(const Simplex& s, std::size_t i, std::size_t j, std::size_t k) {
  const Vec3d &a = s.w(i), &b = s.w(j), &c = s.w(k);
  const Vec3d normal = cross(b - a, c - a);
  const double area = dot(normal, normal);
  if (!(area > 0)) return nearest_edge(s, i, j, k);
  const double u = dot(normal, cross(b, c)), v = dot(normal, cross(c, a)), w = dot(normal, cross(a, b));
  if (!(u > 0 && v > 0 && w > 0)) return nearest_edge(s, i, j, k);
  const double sum = u + v + w;
  return {normal * (dot(normal, a) / area), false, 3, {i, j, k}, {u / sum, v / sum, w / sum}};
}

Nearest tetrahedron(const Simplex& s) {
  static constexpr std::size_t faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 1, 3, 2}, {1, 2, 3, 0}};
  bool outside = false;
  Nearest best;
  for (const auto& f : faces) {
    const Vec3d& p = s.w(f[0]);
    const Vec3d normal = cross(s.w(f[1]) - p, s.w(f[2]) - p);
    const double origin_side = -dot(normal, p), inner_side = dot(normal, s.w(f[3]) - p);
    if (origin_side * inner_side > 0) continue;  // the origin lies on the inner side of this face
    if (origin_side == 0 && inner_side != 0) continue;
    const Nearest found = triangle(s, f[0], f[1], f[2]);
    best = outside ? nearer(best, found) : found;
    outside = true;
  }
  if (!outside) best.enclosed = true;
  return best;
}

}  // namespace

Nearest nearest_to_origin(const Simplex& s) {
  switch (s.size()) {
  case 1: return vertex(s, 0);
  case 2: return edge(s, 0, 1);
  case 3: return triangle(s, 0, 1, 2);
  default: return tetrahedron(s);
  }
}

void reduce(Simplex& s, const Nearest& nearest) {
  if (nearest.enclosed) return;
  for (std::size_t i = 0; i < nearest.size; ++i) {
    if (nearest.index[i] != i) s.points[i] = s.points[nearest.index[i]];
    s.points[i].weight = nearest.weight[i];
  }
  while (s.size() > nearest.size) s.points.pop_back();
}

}  // namespace graze
