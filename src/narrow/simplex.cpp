#include "narrow/simplex.hpp"

namespace graze {

namespace {

/// A candidate for the nearest point: which points of the simplex carry it and with what weights.
struct Candidate {
  Vec3d point;
  int size = 0;
  std::array<std::size_t, 3> index{};
  std::array<double, 3> weight{};
};

Candidate vertex(const Simplex& s, std::size_t i) { return {s.point[i].w, 1, {i}, {1.0}}; }

Candidate edge(const Simplex& s, std::size_t i, std::size_t j) {
  const Vec3d &p = s.point[i].w, &q = s.point[j].w;
  const Vec3d d = q - p;
  const double along = -dot(p, d), whole = dot(d, d);
  if (!(along > 0)) return vertex(s, i);
  if (along >= whole) return vertex(s, j);
  const double t = along / whole;
  // From the end that is nearer: the error of t then is multiplied by the shorter piece.
  const Vec3d point = t < 0.5 ? p + d * t : q - d * (1 - t);
  return {point, 2, {i, j}, {1 - t, t}};
}

const Candidate& nearer(const Candidate& a, const Candidate& b) {
  return length_squared(b.point) < length_squared(a.point) ? b : a;
}

Candidate nearest_edge(const Simplex& s, std::size_t i, std::size_t j, std::size_t k) {
  return nearer(nearer(edge(s, i, j), edge(s, j, k)), edge(s, k, i));
}

Candidate triangle(const Simplex& s, std::size_t i, std::size_t j, std::size_t k) {
  const Vec3d &a = s.point[i].w, &b = s.point[j].w, &c = s.point[k].w;
  const Vec3d normal = cross(b - a, c - a);
  const double area = dot(normal, normal);
  if (!(area > 0)) return nearest_edge(s, i, j, k);
  const double u = dot(normal, cross(b, c)), v = dot(normal, cross(c, a)), w = dot(normal, cross(a, b));
  if (!(u > 0 && v > 0 && w > 0)) return nearest_edge(s, i, j, k);
  const double sum = u + v + w;
  return {normal * (dot(normal, a) / area), 3, {i, j, k}, {u / sum, v / sum, w / sum}};
}

Nearest reduce_to(Simplex& s, const Candidate& c) {
  Simplex reduced;
  for (std::size_t i = 0; i < static_cast<std::size_t>(c.size); ++i) {
    reduced.weight[i] = c.weight[i];
    reduced.push(s.point[c.index[i]]);
  }
  s = reduced;
  return {c.point, false};
}

Nearest reduce_tetrahedron(Simplex& s) {
  static constexpr std::size_t faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
  bool outside = false;
  Candidate best;
  for (const auto& f : faces) {
    const Vec3d& p = s.point[f[0]].w;
    const Vec3d normal = cross(s.point[f[1]].w - p, s.point[f[2]].w - p);
    const double origin_side = -dot(normal, p), inner_side = dot(normal, s.point[f[3]].w - p);
    if (origin_side * inner_side > 0) continue;  // the origin lies on the inner side of this face
    if (origin_side == 0 && inner_side != 0) continue;
    const Candidate c = triangle(s, f[0], f[1], f[2]);
    best = outside ? nearer(best, c) : c;
    outside = true;
  }
  if (!outside) return {{}, true};
  return reduce_to(s, best);
}

}  // namespace

Nearest reduce_to_nearest(Simplex& s) {
  switch (s.size) {
  case 1: return reduce_to(s, vertex(s, 0));
  case 2: return reduce_to(s, edge(s, 0, 1));
  case 3: return reduce_to(s, triangle(s, 0, 1, 2));
  default: return reduce_tetrahedron(s);
  }
}

}  // namespace graze
