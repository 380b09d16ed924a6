#include "narrow/gjk/simplex.hpp"

#include "graze/detail/extended.hpp"
#include "narrow/core/power_of_two.hpp"

namespace graze {

namespace {

/// Length of a triangle's normal, relative to the square of its vertices' distance from the origin, below which it
/// decides with fewer than eight digits beyond which of its edges the origin lies: then all three are tried.
constexpr double slender = 1e-8;

/// The vertices of a simplex, unchanged.
struct Vertices {
  const Simplex& simplex;
  const Vec3d& w(std::size_t i) const { return simplex.w(i); }
};

/// The vertices of a simplex in twice the digits, in a unit near their size.
struct ExactVertices {
  Vec3<Extended<double>> at[4];
  const Vec3<Extended<double>>& w(std::size_t i) const { return at[i]; }
};

/// The nearest of the features tried so far. `Points` has vertices of the scalar S.
template <class S, class Points>
class Search {
 public:
  using Vec = Vec3<S>;

  /// Writes into `best`, which must be empty: a copy would wait for the last stores.
  Search(const Points& s, NearestOf<S>& best) : s_(s), best_(best) {}

  void vertex(std::size_t i) {
    const Vec& p = s_.w(i);
    if (!nearer(p)) return;
    best_.size = 1;
    best_.index = {narrow(i)};
    best_.weight = {S(1)};
  }

  void edge(std::size_t i, std::size_t j) {
    const Vec &p = s_.w(i), &q = s_.w(j);
    const Vec d = q - p;
    const S along = -dot(p, d), whole = dot(d, d);
    if (!(along > S(0))) return vertex(i);
    if (along >= whole) return vertex(j);
    const S t = along / whole;
    // From the nearer end: the error of t then is multiplied by the shorter part.
    const Vec near = t < S(0.5) ? p + d * t : q - d * (S(1) - t);
    // The rounding error along the edge is large relative to a point near the origin. With it subtracted once more, the
    // direction of the point is perpendicular to the edge in all its digits.
    if (!nearer(near - d * (dot(near, d) / whole))) return;
    best_.size = 2;
    best_.index = {narrow(i), narrow(j)};
    best_.weight = {whole - along, along};
  }

  void triangle() {
    const Vec u = s_.w(0) - s_.w(2), v = s_.w(1) - s_.w(2);
    if (!inside(0, 1, 2, u, v, cross(u, v))) edges();
  }

  void tetrahedron() {
    const Vec& p = s_.w(3);  // in GJK the newest vertex, next to which the nearest of the other features lies
    const Vec a = s_.w(0) - p, b = s_.w(1) - p, c = s_.w(2) - p;
    const Vec ab = cross(a, b), bc = cross(b, c), ac = cross(a, c);
    const S volume = dot(ab, c);
    if (outside(-dot(ab, p), volume) && inside(0, 1, 3, a, b, ab)) return;
    if (outside(-dot(bc, p), volume) && inside(1, 2, 3, b, c, bc)) return;
    if (outside(dot(ac, p), volume) && inside(0, 2, 3, a, c, ac)) return;
    const Vec u = s_.w(0) - s_.w(2), v = s_.w(1) - s_.w(2), far = cross(u, v);
    if (outside(dot(far, s_.w(2)), volume) && inside(0, 1, 2, u, v, far)) return;
    if (beyond_ != 0) return edges();
    best_.enclosed = true;
    best_.weight = {S(1)};
  }

 private:
  static std::uint8_t narrow(std::size_t i) { return static_cast<std::uint8_t>(i); }

  /// Whether the origin may lie on the other side of a tetrahedron's side than the fourth vertex, given the volume of
  /// the tetrahedron with the origin, times its own.
  static bool outside(const S& origin, const S& inner) {
    return !(origin * inner > S(0)) && (!(origin == S(0)) || inner == S(0));
  }

  /// A bit for each pair of vertices.
  static unsigned edge_bit(std::size_t i, std::size_t j) { return 1u << (i + j - (i == 0 || j == 0)); }

  /// Takes the point inside a triangle that is nearest to the origin. Where there is none, marks the edges beyond which
  /// the origin lies: an edge or one of its ends can be nearest only then. For the vertices i, j and k, u and v are the
  /// vectors from k to i and j, and `normal` is their cross product.
  bool inside(std::size_t i, std::size_t j, std::size_t k, const Vec& u, const Vec& v, const Vec& normal) {
    const Vec& p = s_.w(k);
    const S area = dot(normal, normal);
    const Vec turned = cross(p, normal);
    const S x = dot(v, turned), y = -dot(u, turned), z = area - x - y;
    if (area > S(0) && x > S(0) && y > S(0) && z > S(0)) {
      nearer(normal * (dot(normal, p) / area));
      best_.size = 3;
      best_.index = {narrow(i), narrow(j), narrow(k)};
      best_.weight = {x, y, z};
      return true;
    }
    const S reach = greatest(length_squared(p), greatest(length_squared(s_.w(i)), length_squared(s_.w(j))));
    const bool all = !(area > S(slender * slender) * reach * reach);
    if (all || !(x > S(0))) beyond_ |= edge_bit(j, k);
    if (all || !(y > S(0))) beyond_ |= edge_bit(i, k);
    if (all || !(z > S(0))) beyond_ |= edge_bit(i, j);
    return false;
  }

  /// Tries the marked edges.
  void edges() {
    static constexpr std::uint8_t ends[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    for (; beyond_ != 0; beyond_ &= beyond_ - 1) {
      const auto& e = ends[__builtin_ctz(beyond_)];
      edge(e[0], e[1]);
    }
  }

  bool nearer(const Vec& point) {
    const S squared = length_squared(point);
    if (best_.size > 0 && !(squared < best_.squared)) return false;
    best_.squared = squared;
    best_.point = {point.x, point.y, point.z};
    return true;
  }

  const Points& s_;
  NearestOf<S>& best_;
  unsigned beyond_ = 0;  ///< the marked edges
};

template <class S, class Points>
void search(const Points& points, std::size_t size, NearestOf<S>& best) {
  Search<S, Points> search(points, best);
  switch (size) {
  case 1: search.vertex(0); break;
  case 2: search.edge(0, 1); break;
  case 3: search.triangle(); break;
  default: search.tetrahedron();
  }
}

}  // namespace

Nearest nearest_to_origin(const Simplex& s) {
  Nearest best;
  search<double>(Vertices{s}, s.size(), best);
  return best;
}

ExactNearest exactly_nearest_to_origin(const Simplex& s) {
  double size = 0;
  for (std::size_t i = 0; i < s.size(); ++i) size = greatest(size, max_abs(s.w(i)));
  const double unit = power_of_two_below(size);
  ExactNearest found;
  if (!(unit > 0)) {
    found.nearest.size = 1;
    found.nearest.weight = {1};
    return found;
  }
  const double scale = 1 / unit;
  ExactVertices vertices;
  for (std::size_t i = 0; i < s.size(); ++i) vertices.at[i] = extended(s.w(i) * scale);
  NearestOf<Extended<double>> best;
  search<Extended<double>>(vertices, s.size(), best);
  Nearest& n = found.nearest;
  n.enclosed = best.enclosed;
  n.size = best.size;
  n.index = best.index;
  Extended<double> whole;
  for (std::size_t i = 0; i < best.size; ++i) whole = whole + best.weight[i];
  for (std::size_t i = 0; i < best.size; ++i) n.weight[i] = static_cast<double>(best.weight[i] / whole);
  const Vec3d point = converted<double>(best.point);
  found.direction = normalized(point);
  found.distance = dot(point, found.direction) * unit;
  n.point = found.direction * found.distance;
  return found;
}

void reduce(Simplex& s, const Nearest& nearest) {
  if (nearest.enclosed) return;
  for (std::size_t i = 0; i < nearest.size; ++i) {
    if (nearest.index[i] != i) s.points[i] = by_parts(s.points[nearest.index[i]]);
    s.weight[i] = nearest.weight[i];
  }
  s.points.truncate(nearest.size);
}

}  // namespace graze
