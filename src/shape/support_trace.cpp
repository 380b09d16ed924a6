#include "graze/shape/support_trace.hpp"

#include <algorithm>
#include <numeric>

#include "shape/hull_descent.hpp"

namespace graze {

namespace {

/// Writes a descent into a trace, but for the winner of each layer.
struct DescentRecorder {
  SupportTrace& trace;

  void layer(std::size_t vertices) const { trace.layers.push_back({vertices, {}, {}, 0}); }
  template <class S>
  void look(std::uint32_t vertex, S along) const {
    trace.layers.back().looked_at.push_back(vertex);
    trace.layers.back().along.push_back(static_cast<double>(along));
  }
};

std::vector<std::uint32_t> all_of(std::size_t vertices) {
  std::vector<std::uint32_t> numbers(vertices);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

template <class T>
HullLayer coarse_layer(const typename HullData<T>::Level& level) {
  HullLayer layer{level.vertices, {}};
  for (std::uint32_t i = 0; i < level.vertices.size(); ++i)
    for (std::uint32_t k = level.neighbor_begin[i]; k < level.neighbor_begin[i + 1]; ++k)
      if (const std::uint32_t n = level.neighbors[k]; i < n)
        layer.edges.push_back({level.vertices[i], level.vertices[n]});
  return layer;
}

}  // namespace

template <class T>
std::vector<HullLayer> hull_layers(const ConvexHull<T>& hull) {
  const HullData<T>& data = hull.data();
  std::vector<HullLayer> layers;
  for (const auto& level : data.hierarchy) layers.push_back(coarse_layer<T>(level));
  layers.push_back({all_of(data.vertices.size()), {}});
  for (const HullEdge& edge : data.edges) layers.back().edges.push_back({edge.vertex[0], edge.vertex[1]});
  return layers;
}

template <class T>
SupportTrace explain_support(const ConvexHull<T>& hull, const Vec3<T>& direction) {
  const HullData<T>& data = hull.data();
  SupportTrace trace;
  trace.vertex = static_cast<std::uint32_t>(hull.support_vertex(direction));
  trace.scanned = data.hierarchy.empty();
  if (trace.scanned) {
    const DescentRecorder record{trace};
    record.layer(data.vertices.size());
    for (std::uint32_t v = 0; v < data.vertices.size(); ++v) record.look(v, dot(data.vertices[v], direction));
    trace.layers.back().winner = trace.vertex;
  } else {
    descended(data, direction, DescentRecorder{trace});
    // The first of the furthest vertices looked at: where the climb stood when the layer ended.
    for (SupportLayer& layer : trace.layers) {
      const auto most = std::max_element(layer.along.begin(), layer.along.end());
      layer.winner = layer.looked_at[static_cast<std::size_t>(most - layer.along.begin())];
    }
  }
  for (const SupportLayer& layer : trace.layers) trace.products += layer.looked_at.size();
  return trace;
}

template std::vector<HullLayer> hull_layers(const ConvexHull<float>&);
template std::vector<HullLayer> hull_layers(const ConvexHull<double>&);
template SupportTrace explain_support(const ConvexHull<float>&, const Vec3<float>&);
template SupportTrace explain_support(const ConvexHull<double>&, const Vec3<double>&);

}  // namespace graze
