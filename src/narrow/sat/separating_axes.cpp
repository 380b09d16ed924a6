#include "narrow/sat/separating_axes.hpp"

#include "narrow/sat/gauss_map.hpp"

namespace graze {

double lowest(std::span<const Vec3d> points, const Vec3d& direction) {
  double low = std::numeric_limits<double>::infinity();
  for (const Vec3d& p : points) low = least(low, dot(p, direction));
  return low;
}

namespace {

/// The separation of B from each face of A, and B's vertex nearest to it.
struct FaceSupports {
  SmallVector<double, 96> separation;
  SmallVector<std::uint32_t, 96> vertex;
};

SeparatingAxis best_face(AxisKind kind, const Polyhedron& a, const Polyhedron& b, FaceSupports& supports) {
  SeparatingAxis best{kind};
  for (std::size_t f = 0; f < a.normals().size(); ++f) {
    const Vec3d& n = a.normals()[f];
    const std::size_t v = b.support_vertex(-n);
    const double separation = dot(b.vertices()[v], n) - a.offset(f);
    supports.separation.push_back(separation);
    supports.vertex.push_back(static_cast<std::uint32_t>(v));
    if (separation > best.separation) best = {kind, separation, n, f, f};
  }
  return best;
}

PlacedEdge placed(const Polyhedron& p, std::size_t edge) {
  const HullEdge& e = p.edges()[edge];
  const Vec3d& point = p.vertices()[e.vertex[0]];
  return {p.normals()[e.face[0]], p.normals()[e.face[1]], p.vertices()[e.vertex[1]] - point, point};
}

/// Whether n . q exceeds `best` for some unit vector n of the arc from `a` to `b`, given x = a . q and y = b . q: at
/// one of its ends, or where q's projection falls inside it, which it never does where both are negative.
bool exceeds_on_arc(double x, double y, const Vec3d& a, const Vec3d& b, double best) {
  if (x > best || y > best) return true;
  if (x <= 0 && y <= 0) return false;
  const double c = dot(a, b);
  if (!(y > c * x && x > c * y)) return false;
  return x * x + y * y - 2 * c * x * y > best * best * (1 - c * c);
}

/// The edges of A on whose arcs some axis may show a larger separation than `best`. The separation of B along an axis
/// is at most that of its vertices nearest to the two faces, which rules most edges out.
SmallVector<std::uint32_t, 128> promising_edges(const Polyhedron& a, const FaceSupports& supports, const Polyhedron& b,
                                                double best) {
  SmallVector<std::uint32_t, 128> promising;
  for (std::size_t i = 0; i < a.edges().size(); ++i) {
    const HullEdge& e = a.edges()[i];
    const std::uint32_t left = e.face[0], right = e.face[1];
    const Vec3d &m = a.normals()[left], &n = a.normals()[right], &on_edge = a.vertices()[e.vertex[0]];
    const Vec3d q = b.vertices()[supports.vertex[left]] - on_edge;
    if (!exceeds_on_arc(supports.separation[left], dot(n, q), m, n, best)) continue;
    const Vec3d r = b.vertices()[supports.vertex[right]] - on_edge;
    if (!exceeds_on_arc(dot(m, r), supports.separation[right], m, n, best)) continue;
    promising.push_back(static_cast<std::uint32_t>(i));
  }
  return promising;
}

SmallVector<std::uint32_t, 128> all_edges(const Polyhedron& p) {
  SmallVector<std::uint32_t, 128> all;
  for (std::size_t i = 0; i < p.edges().size(); ++i) all.push_back(static_cast<std::uint32_t>(i));
  return all;
}

/// Calls `f(axis)` for each pair of these edges that makes a facet of the difference.
template <class Edges, class F>
void visit_crossing_edges(const Polyhedron& a, const Edges& edges_a, const Polyhedron& b, const Edges& edges_b, F&& f) {
  for (const std::uint32_t i : edges_a) {
    const PlacedEdge of_a = placed(a, i);
    for (const std::uint32_t j : edges_b) {
      const PlacedEdge of_b = placed(b, j);
      const Vec3d normal = crossing_normal(of_a, of_b);
      if (normal != Vec3d{}) f(SeparatingAxis{AxisKind::edges, dot(of_b.point - of_a.point, normal), normal, i, j});
    }
  }
}

}  // namespace

std::string numbered(std::string name, std::size_t number) {
  name += std::to_string(number);
  return name;
}

std::string axis_name(const SeparatingAxis& axis) {
  if (axis.kind == AxisKind::edges) return numbered(numbered("A edge ", axis.a) + " × B edge ", axis.b);
  return axis.kind == AxisKind::face_a ? numbered("A face ", axis.a) : numbered("B face ", axis.b);
}

SeparatingAxes separating_axes(const Polyhedron& a, const Polyhedron& b, double enough) {
  SeparatingAxes axes;
  FaceSupports of_a, of_b;
  axes.face_a = best_face(AxisKind::face_a, a, b, of_a);
  if (axes.face_a.separation > enough) return axes;
  axes.face_b = best_face(AxisKind::face_b, b, a, of_b);
  axes.face_b.normal = -axes.face_b.normal;
  const double best = axes.best_face().separation;
  if (best > enough) return axes;
  const auto edges_a = promising_edges(a, of_a, b, best), edges_b = promising_edges(b, of_b, a, best);
  visit_crossing_edges(a, edges_a, b, edges_b, [&](const SeparatingAxis& axis) {
    if (axis.separation > axes.edge.separation) axes.edge = axis;
  });
  return axes;
}

std::vector<SeparatingAxis> all_separating_axes(const Polyhedron& a, const Polyhedron& b) {
  std::vector<SeparatingAxis> axes;
  const auto faces = [&](AxisKind kind, const Polyhedron& whose, double sign) {
    for (std::size_t f = 0; f < whose.normals().size(); ++f) {
      const Vec3d n = whose.normals()[f] * sign;
      axes.push_back({kind, lowest(b.vertices(), n) + lowest(a.vertices(), -n), n, f, f});
    }
  };
  faces(AxisKind::face_a, a, 1);
  faces(AxisKind::face_b, b, -1);
  visit_crossing_edges(a, all_edges(a), b, all_edges(b), [&](const SeparatingAxis& axis) { axes.push_back(axis); });
  return axes;
}

}  // namespace graze
