#include "shape/hull_polygons.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "shape/facet_rows.hpp"

namespace graze {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// The directed edges in order, each with the face on its left.
std::vector<std::pair<DirectedEdge, std::uint32_t>> directed_edges(const Loops& loops) {
  std::vector<std::pair<DirectedEdge, std::uint32_t>> edges;
  for (std::uint32_t f = 0; f < loops.size(); ++f)
    for (std::size_t i = 0; i < loops[f].size(); ++i)
      edges.push_back({{loops[f][i], loops[f][(i + 1) % loops[f].size()]}, f});
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::uint32_t left_of(const std::vector<std::pair<DirectedEdge, std::uint32_t>>& edges, const DirectedEdge& e) {
  const auto found = std::lower_bound(edges.begin(), edges.end(), std::pair{e, 0u});
  return found != edges.end() && found->first == e ? found->second : HullData<double>::no_face;
}

/// Whether the loops close a surface: every edge once in each direction, no loop shorter than three or through a vertex
/// twice.
bool closed(const Loops& loops) {
  const auto edges = directed_edges(loops);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i + 1 < edges.size() && edges[i].first == edges[i + 1].first) return false;
    if (left_of(edges, {edges[i].first.second, edges[i].first.first}) == HullData<double>::no_face) return false;
  }
  for (const auto& loop : loops) {
    auto sorted = loop;
    std::sort(sorted.begin(), sorted.end());
    if (loop.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
  }
  return loops.size() >= 4;
}

class Merger {
 public:
  Merger(const Triangles& triangles, std::span<const Vec3d> points, double tolerance)
      : triangles_(triangles), points_(points), tolerance_(tolerance), region_(triangles.size(), 0) {
    Loops loops;
    for (const auto& t : triangles) loops.push_back({t.begin(), t.end()});
    edges_ = directed_edges(loops);
  }

  Loops run() {
    std::vector<std::uint32_t> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<double> area;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) area.push_back(length(area_normal(t)));
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
    Loops loops;
    for (const std::uint32_t seed : order)
      if (region_[seed] == 0) {
        const std::vector<std::uint32_t> members = grow(seed);
        if (auto loop = outline(members)) {
          loops.push_back(std::move(*loop));
        } else {
          for (const std::uint32_t t : members) loops.push_back({triangles_[t].begin(), triangles_[t].end()});
        }
      }
    drop_needless_vertices(loops);
    return loops;
  }

 private:
  Vec3d area_normal(std::uint32_t t) const {
    const auto& v = triangles_[t];
    return cross(points_[v[1]] - points_[v[0]], points_[v[2]] - points_[v[0]]);
  }

  std::vector<std::uint32_t> grow(std::uint32_t seed) {
    const Vec3d normal = normalized(area_normal(seed));
    const Vec3d& origin = points_[triangles_[seed][0]];
    const std::uint32_t number = ++regions_;
    std::vector<std::uint32_t> members{seed};
    region_[seed] = number;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const auto v = triangles_[members[i]];
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t t = left_of(edges_, {v[(e + 1) % 3], v[e]});
        if (region_[t] != 0 || dot(area_normal(t), normal) < 0) continue;
        const auto& w = triangles_[t];
        const bool near = std::all_of(w.begin(), w.end(), [&](std::uint32_t p) {
          return std::abs(dot(points_[p] - origin, normal)) <= tolerance_;
        });
        if (!near) continue;
        region_[t] = number;
        members.push_back(t);
      }
    }
    return members;
  }

  /// The loop around a region, or nothing when it is not one simple loop.
  std::optional<std::vector<std::uint32_t>> outline(const std::vector<std::uint32_t>& members) const {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const std::uint32_t t : members)
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t from = triangles_[t][e], to = triangles_[t][(e + 1) % 3];
        if (region_[left_of(edges_, {to, from})] == region_[t]) continue;
        if (!next.emplace(from, to).second) return std::nullopt;
      }
    if (next.size() < 3) return std::nullopt;
    std::vector<std::uint32_t> loop{next.begin()->first};
    while (loop.size() <= next.size()) {
      const std::uint32_t to = next.at(loop.back());
      if (to == loop.front()) break;
      loop.push_back(to);
    }
    if (loop.size() != next.size()) return std::nullopt;
    return loop;
  }

  /// Drops vertices at which only two faces meet. Such a vertex lies on their common edge, but for one at the tip of a
  /// sliver: there everything as thin as the tolerance has become one of the two faces.
  void drop_needless_vertices(Loops& loops) const {
    std::vector<std::uint32_t> uses(points_.size(), 0);
    for (const auto& loop : loops)
      for (const std::uint32_t v : loop) ++uses[v];
    // The two faces have the same two neighbours of such a vertex, and so the same answer.
    std::vector<bool> needless(points_.size(), false);
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        needless[loop[i]] = uses[loop[i]] < 3 &&
                            between(loop[i], loop[(i + loop.size() - 1) % loop.size()], loop[(i + 1) % loop.size()]);
    for (auto& loop : loops) std::erase_if(loop, [&](std::uint32_t v) { return needless[v]; });
  }

  /// Whether a point lies on the segment between two others.
  bool between(std::uint32_t point, std::uint32_t from, std::uint32_t to) const {
    const Vec3d along = points_[to] - points_[from], way = points_[point] - points_[from];
    const double length_along = length(along), on = dot(way, along) / length_along;
    return length(cross(way, along)) <= tolerance_ * length_along && on >= -tolerance_ &&
           on <= length_along + tolerance_;
  }

  const Triangles& triangles_;
  std::span<const Vec3d> points_;
  double tolerance_;
  std::vector<std::pair<DirectedEdge, std::uint32_t>> edges_;
  std::vector<std::uint32_t> region_;
  std::uint32_t regions_ = 0;
};

/// Lists of lists in one array, with the beginnings in another.
void fill_lists(const std::vector<std::vector<std::uint32_t>>& lists, std::vector<std::uint32_t>& begin,
                std::vector<std::uint32_t>& items) {
  begin.assign(1, 0);
  items.clear();
  for (const auto& list : lists) {
    items.insert(items.end(), list.begin(), list.end());
    begin.push_back(static_cast<std::uint32_t>(items.size()));
  }
}

/// The plane with this unit normal, moved out until no vertex of the loop lies outside.
template <class T>
Plane<T> plane_of(const HullData<T>& hull, std::span<const std::uint32_t> loop, const Vec3d& n) {
  double offset = dot(n, converted<double>(hull.vertices[loop[0]]));
  for (const std::uint32_t v : loop) offset = std::max(offset, dot(n, converted<double>(hull.vertices[v])));
  return {converted<T>(n), static_cast<T>(offset)};
}

}  // namespace

Loops merged_loops(const Triangles& triangles, std::span<const Vec3d> points, double tolerance) {
  Loops merged = Merger(triangles, points, tolerance).run();
  if (closed(merged)) return merged;
  Loops plain;
  for (const auto& t : triangles) plain.push_back({t.begin(), t.end()});
  return plain;
}

template <class T>
void fill_faces(HullData<T>& hull, const Loops& loops, std::span<const Vec3<T>> points,
                std::span<const GridPoint> grid) {
  std::vector<std::uint32_t> place(points.size(), HullData<T>::no_face);
  Loops renumbered = loops;
  for (auto& loop : renumbered)
    for (std::uint32_t& v : loop) {
      if (place[v] == HullData<T>::no_face) {
        place[v] = static_cast<std::uint32_t>(hull.vertices.size());
        hull.vertices.push_back(points[v]);
      }
      v = place[v];
    }
  fill_lists(renumbered, hull.face_begin, hull.loops);
  std::vector<Vec3d> normals;
  for (std::size_t f = 0; f < renumbered.size(); ++f) {
    normals.push_back(normalized(grid_normal(grid, loops[f])));
    hull.planes.push_back(plane_of(hull, hull.loop(f), normals.back()));
  }

  const auto edges = directed_edges(renumbered);
  std::vector<std::vector<std::uint32_t>> neighbors(hull.vertices.size()), incident(hull.vertices.size());
  for (const auto& [edge, left] : edges) {
    neighbors[edge.first].push_back(edge.second);
    incident[edge.first].push_back(left);
    if (edge.first < edge.second)
      hull.edges.push_back({{edge.first, edge.second}, {left, left_of(edges, {edge.second, edge.first})}});
  }
  fill_lists(neighbors, hull.neighbor_begin, hull.neighbors);
  fill_lists(incident, hull.incident_begin, hull.incident);
  if constexpr (std::is_same_v<T, float>)
    if (hull.dimension == 3 && hull.edges.size() <= most_faceted_edges) fill_facets(hull, normals);
}

template void fill_faces(HullData<float>&, const Loops&, std::span<const Vec3<float>>, std::span<const GridPoint>);
template void fill_faces(HullData<double>&, const Loops&, std::span<const Vec3<double>>, std::span<const GridPoint>);

}  // namespace graze
