#include "narrow/sat/hull_axes.hpp"

#include "narrow/sat/gauss_map.hpp"
#include "narrow/sat/hull_sat_culling.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// Rounding of a separation in float, relative to the two extents and the offset between the shapes: a normal, a
/// rotation and a vertex are each off by two roundings at most, and three products of each of the three sums add two
/// and a half; times the root of three. Planes and inner balls of merged faces are off by eight each. All that,
/// doubled.
constexpr float slack_of_lanes = 48 * std::numeric_limits<float>::epsilon();

/// Limits of floats, not tolerances. The smallest product that matters is the slack, 6e-6 of the size, times the size:
/// for 1e-15 that is 6e-36, and floats keep their digits down to 1e-38. The largest is a sum of some squares: for 1e18,
/// more than shapes and poses may have together, 1e37 of 3e38.
constexpr double least_size = 1e-15, most_size = 1e18;

[[gnu::always_inline]] inline PlacedEdge edge_of(const FacetedHull& hull, std::uint32_t edge) {
  const HullEdge& e = hull.edges[edge];
  const Vec3d point = corner(hull, e.vertex[0]);
  return {hull.planes[e.face[0]].normal, hull.planes[e.face[1]].normal, corner(hull, e.vertex[1]) - point, point};
}

[[gnu::always_inline]] inline PlacedEdge edge_of_b(const FacetedPair& pair, std::uint32_t edge) {
  const PlacedEdge e = edge_of(pair.b, edge);
  return {pair.rotation * e.left, pair.rotation * e.right, pair.rotation * e.along,
          pair.rotation * e.point + pair.translation};
}

/// Numbers of edges; with room for one more than allowed.
struct EdgeList {
  std::uint32_t edges[most_promising + 1];
  std::size_t count;
};

[[gnu::always_inline]] inline void best_of_edges(const FacetedPair& pair, const EdgeList& of_a, const EdgeList& of_b,
                                                 SeparatingAxis& best) {
  for (std::size_t i = 0; i < of_a.count; ++i) {
    const PlacedEdge a = edge_of(pair.a, of_a.edges[i]);
    for (std::size_t j = 0; j < of_b.count; ++j) {
      const PlacedEdge b = edge_of_b(pair, of_b.edges[j]);
      const Vec3d normal = crossing_normal(a, b);
      const double separation = dot(b.point - a.point, normal);
      if (normal != Vec3d{} && separation > best.separation)
        best = {AxisKind::edges, separation, normal, of_a.edges[i], of_b.edges[j]};
    }
  }
}

}  // namespace

[[gnu::flatten]] bool hull_axes(const FacetedPair& pair, double enough, SeparatingAxes& axes) {
  const double size = static_cast<double>(pair.a.corners.extent) + static_cast<double>(pair.b.corners.extent) +
                      max_abs(pair.translation);
  if (!(size > least_size && size < most_size)) return false;
  const float slack = slack_of_lanes * static_cast<float>(size);
  HullSatCulling of_a(pair.a, pair.b, pair.rotation, pair.translation, slack);
  HullSatCulling of_b(pair.b, pair.a, transposed(pair.rotation), -transposed_times(pair.rotation, pair.translation),
                      slack);

  FaceSeen seen_a{}, seen_b{};
  const auto keep_face_of_a = [&](std::uint32_t f) {
    const FaceSeen seen = of_a.see(f);
    if (!(seen.separation > axes.face_a.separation)) return;
    axes.face_a = {AxisKind::face_a, seen.separation, of_a.normal(f), f, f};
    seen_a = seen;
  };
  const auto keep_face_of_b = [&](std::uint32_t f) {
    const FaceSeen seen = of_b.see(f);
    if (!(seen.separation > axes.face_b.separation)) return;
    axes.face_b = {AxisKind::face_b, seen.separation, -(pair.rotation * of_b.normal(f)), f, f};
    seen_b = seen;
  };

  // The two faces that the other's inner ball lies furthest in front of.
  const std::uint32_t first_a = of_a.bound_faces(), first_b = of_b.bound_faces();
  const float of_first_a = of_a.separation(first_a), of_first_b = of_b.separation(first_b);
  float most = greatest(of_first_a, of_first_b);
  if (static_cast<double>(most) > enough) {
    if (of_first_a > of_first_b)
      keep_face_of_a(first_a);
    else
      keep_face_of_b(first_b);
    if (axes.best_face().separation > enough) return true;
  }
  // All faces that may be equally good.
  most = of_a.measure(most - slack, most);
  most = of_b.measure(most - slack, most);
  of_a.visit_measured(most - slack, keep_face_of_a);
  of_b.visit_measured(most - slack, keep_face_of_b);
  const double best = axes.best_face().separation;
  if (best > enough) return true;

  const auto level = static_cast<float>(best);
  const bool by_a = &axes.best_face() == &axes.face_a;
  EdgeList edges_a, edges_b;
  edges_a.count = of_a.promising_edges(level, by_a ? seen_a.nearest : seen_b.vertex, edges_a.edges);
  if (edges_a.count == 0) return true;
  edges_b.count = of_b.promising_edges(level, by_a ? seen_a.vertex : seen_b.nearest, edges_b.edges);
  if (edges_b.count == 0) return true;
  if (edges_a.count > most_promising || edges_b.count > most_promising) return false;
  best_of_edges(pair, edges_a, edges_b, axes.edge);
  return true;
}

}  // namespace graze::GRAZE_ISA
