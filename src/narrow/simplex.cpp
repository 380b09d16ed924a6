#include "narrow/simplex.hpp"

namespace graze {

namespace {

/// A triangle whose normal is shorter than this, relative to the square of its vertices' distance from the origin, tells
/// beyond which of its edges the origin lies with fewer than eight digits: then all three are tried.
constexpr double slender = 1e-8;

/// What is nearest of what has been tried.
class Search {
 public:
  /// Writes into `best`, which is empty: a copy would wait for what was written last.
  Search(const Simplex& s, Nearest& best) : s_(s), best_(best) {}

  void finish() {
    const double whole = best_.weight[0] + best_.weight[1] + best_.weight[2];
    for (double& w : best_.weight) w /= whole;
  }
  bool found() const { return best_.size > 0; }

  void vertex(std::size_t i) {
    const Vec3d& p = s_.w(i);
    if (!nearer(p)) return;
    best_.size = 1;
    best_.index = {narrow(i)};
    best_.weight = {1};
  }

  void edge(std::size_t i, std::size_t j) {
    const Vec3d &p = s_.w(i), &q = s_.w(j);
    const Vec3d d = q - p;
    const double along = -dot(p, d), whole = dot(d, d);
    if (!(along > 0)) return vertex(i);
    if (along >= whole) return vertex(j);
    const double t = along / whole;
    // From the end that is nearer: the error of t then is multiplied by the shorter piece.
    const Vec3d near = t < 0.5 ? p + d * t : q - d * (1 - t);
    // What rounding left along the edge is large beside a point near the origin. Taken off once more, the direction of
    // the point is at right angles to the edge in all its digits.
    if (!nearer(near - d * (dot(near, d) / whole))) return;
    best_.size = 2;
    best_.index = {narrow(i), narrow(j)};
    best_.weight = {whole - along, along};
  }

  /// `normal` is that of the vertices in this order, of any length.
  void triangle(std::size_t i, std::size_t j, std::size_t k, const Vec3d& normal) {
    const Vec3d &a = s_.w(i), &b = s_.w(j), &c = s_.w(k);
    const double area = dot(normal, normal);
    const double u = dot(normal, cross(b, c)), v = dot(normal, cross(c, a)), w = dot(normal, cross(a, b));
    if (area > 0 && u > 0 && v > 0 && w > 0) {
      if (!nearer(normal * (dot(normal, a) / area))) return;
      best_.size = 3;
      best_.index = {narrow(i), narrow(j), narrow(k)};
      best_.weight = {u, v, w};
      return;
    }
    // An edge or one of its ends is nearest only to what lies beyond that edge.
    const double reach = greatest(dot(a, a), greatest(dot(b, b), dot(c, c)));
    const bool all = !(area > slender * slender * reach * reach);
    if (all || !(w > 0)) edge(i, j);
    if (all || !(u > 0)) edge(j, k);
    if (all || !(v > 0)) edge(i, k);
  }

  void triangle(std::size_t i, std::size_t j, std::size_t k) {
    triangle(i, j, k, cross(s_.w(j) - s_.w(i), s_.w(k) - s_.w(i)));
  }

  void tetrahedron() {
    const Vec3d &p = s_.w(0), &q = s_.w(1);
    const Vec3d u = q - p, v = s_.w(2) - p, w = s_.w(3) - p;
    const Vec3d uv = cross(u, v), vw = cross(v, w), uw = cross(u, w);
    const double volume = dot(uv, w);
    side(0, 1, 2, uv, -dot(uv, p), volume);
    side(0, 2, 3, vw, -dot(vw, p), volume);
    side(0, 1, 3, uw, -dot(uw, p), -volume);
    const Vec3d far = cross(s_.w(2) - q, s_.w(3) - q);
    side(1, 2, 3, far, -dot(far, q), -volume);
    if (found()) return;
    best_.enclosed = true;
    best_.weight = {1};
  }

 private:
  static std::uint8_t narrow(std::size_t i) { return static_cast<std::uint8_t>(i); }

  /// Tries a side of the tetrahedron unless the origin lies where the fourth vertex does.
  void side(std::size_t i, std::size_t j, std::size_t k, const Vec3d& normal, double origin, double inner) {
    if (origin * inner > 0 || (origin == 0 && inner != 0)) return;
    triangle(i, j, k, normal);
  }

  bool nearer(const Vec3d& point) {
    const double squared = length_squared(point);
    if (found() && !(squared < squared_)) return false;
    squared_ = squared;
    best_.point = point;
    return true;
  }

  const Simplex& s_;
  Nearest& best_;
  double squared_ = 0;
};

}  // namespace

Nearest nearest_to_origin(const Simplex& s) {
  Nearest best;
  Search search(s, best);
  switch (s.size()) {
  case 1: search.vertex(0); break;
  case 2: search.edge(0, 1); break;
  case 3: search.triangle(0, 1, 2); break;
  default: search.tetrahedron();
  }
  search.finish();
  return best;
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
