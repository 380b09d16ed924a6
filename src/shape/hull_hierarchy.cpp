#include "shape/hull_hierarchy.hpp"

#include <algorithm>
#include <numeric>

namespace graze {

namespace {

/// The greatest degree of vertices that are taken out. A planar graph has an independent set of at least a fixed
/// share of its vertices among those of such a degree, so every level is smaller than the one below by a factor, and
/// has as few steps to climb.
constexpr std::size_t removable_degree = 8;
constexpr std::size_t coarsest = 24;
/// The factor by which each kept level is smaller than the next; the levels between them are dropped. A climb
/// then takes two or three steps instead of one, but the levels are few and take little memory, for which a
/// query waits at a large hull.
constexpr std::size_t shrink = 4;

/// One level in the making: vertices of the hull and, by place, their neighbours.
struct Graph {
  std::vector<std::uint32_t> vertices;
  std::vector<std::vector<std::uint32_t>> neighbors;
};

/// The places that stay when an independent set of low degree is taken out.
std::vector<std::uint32_t> thinned(const Graph& graph) {
  std::vector<char> touched(graph.vertices.size(), 0);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < graph.vertices.size(); ++i) {
    if (!touched[i] && graph.neighbors[i].size() <= removable_degree) {
      for (const std::uint32_t n : graph.neighbors[i]) touched[n] = 1;
    } else {
      touched[i] = 1;
      kept.push_back(i);
    }
  }
  return kept;
}

/// The hull of some of a level's vertices, with `finer` their places in it.
Graph hull_of(const Graph& fine, const std::vector<std::uint32_t>& kept, std::span<const GridPoint> grid,
              std::vector<std::uint32_t>& finer) {
  std::vector<GridPoint> points;
  points.reserve(kept.size());
  for (const std::uint32_t i : kept) points.push_back(grid[fine.vertices[i]]);
  const HullSurface surface = hull_surface(points);
  Graph coarse;
  finer.clear();
  std::vector<std::uint32_t> place(kept.size(), HullData<double>::no_face);
  const auto placed = [&](std::uint32_t i) {
    if (place[i] == HullData<double>::no_face) {
      place[i] = static_cast<std::uint32_t>(coarse.vertices.size());
      coarse.vertices.push_back(fine.vertices[kept[i]]);
      coarse.neighbors.emplace_back();
      finer.push_back(kept[i]);
    }
    return place[i];
  };
  for (const auto& t : surface.triangles)
    for (std::size_t e = 0; e < 3; ++e) {
      const std::uint32_t from = placed(t[e]), to = placed(t[(e + 1) % 3]);
      coarse.neighbors[from].push_back(to);
    }
  return coarse;
}

template <class T>
typename HullData<T>::Level stored(const Graph& graph, std::vector<std::uint32_t> finer) {
  typename HullData<T>::Level level{graph.vertices, std::move(finer), {0}, {}};
  for (const auto& list : graph.neighbors) {
    level.neighbors.insert(level.neighbors.end(), list.begin(), list.end());
    level.neighbor_begin.push_back(static_cast<std::uint32_t>(level.neighbors.size()));
  }
  return level;
}

}  // namespace

template <class T>
void build_hierarchy(HullData<T>& hull, std::span<const GridPoint> grid) {
  if (hull.vertices.size() <= scan_limit) return;
  Graph level;
  for (std::uint32_t v = 0; v < hull.vertices.size(); ++v) {
    level.vertices.push_back(v);
    const auto around = hull.around(v);
    level.neighbors.emplace_back(around.begin(), around.end());
  }
  std::vector<std::uint32_t> finer(level.vertices.size());  // a vertex of `level` in the last level that was kept
  std::iota(finer.begin(), finer.end(), 0u);
  std::size_t last_kept = level.vertices.size();
  while (level.vertices.size() > coarsest) {
    const std::vector<std::uint32_t> kept = thinned(level);
    if (kept.size() < 4 || kept.size() == level.vertices.size()) break;
    std::vector<std::uint32_t> below;
    Graph coarse = hull_of(level, kept, grid, below);
    if (coarse.vertices.size() < 4) break;
    for (std::uint32_t& place : below) place = finer[place];
    finer = std::move(below);
    level = std::move(coarse);
    if (level.vertices.size() > coarsest && level.vertices.size() * shrink > last_kept) continue;
    last_kept = level.vertices.size();
    hull.hierarchy.push_back(stored<T>(level, std::move(finer)));
    finer = std::vector<std::uint32_t>(last_kept);
    std::iota(finer.begin(), finer.end(), 0u);
  }
  std::reverse(hull.hierarchy.begin(), hull.hierarchy.end());
}
template void build_hierarchy(HullData<float>&, std::span<const GridPoint>);
template void build_hierarchy(HullData<double>&, std::span<const GridPoint>);

}  // namespace graze
