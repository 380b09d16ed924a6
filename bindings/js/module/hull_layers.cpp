// The layers of convex hulls and their support queries step by step for JavaScript, in the manner of the C interface:
// answers are numbers one behind the other, which stay until the next question.
#include <atomic>

#include "graze/shape.hpp"
#include "graze/shape/support_trace.hpp"

#include "c/arguments.hpp"
#include "scalar.hpp"

#include "c/shape_handle.inc"

namespace {

using graze::c::guarded;

const graze::ConvexHull<T>& hull_of(const TYPE(Shape) * shape) {
  const graze::Shape<T>& value = graze::c::opened(shape, "shape").value;
  const auto* hull = value.as<graze::ConvexHull<T>>();
  if (hull == nullptr) graze::validate::fail("shape", "a convex hull", value.name());
  return *hull;
}

std::vector<std::uint32_t> answer;  ///< the last one
std::vector<double> products;       ///< of the last support query, layer by layer

void append(const std::vector<std::uint32_t>& numbers) { answer.insert(answer.end(), numbers.begin(), numbers.end()); }
void append(std::size_t number) { answer.push_back(static_cast<std::uint32_t>(number)); }

void show(const std::uint32_t** first, std::size_t* count) {
  *first = answer.data();
  *count = answer.size();
}

}  // namespace

extern "C" {

EXPORTED("hull_vertices")
GrazeStatus graze_js_hull_vertices(const TYPE(Shape) * shape, const graze::Vec3<T>** first, std::size_t* count) {
  return guarded([&] {
    const auto& vertices = hull_of(shape).data().vertices;
    *first = vertices.data();
    *count = vertices.size();
  });
}

/// A layer: how many vertices and edges, then the vertices, then two ends an edge.
EXPORTED("hull_layers")
GrazeStatus graze_js_hull_layers(const TYPE(Shape) * shape, const std::uint32_t** first, std::size_t* count) {
  return guarded([&] {
    answer.clear();
    for (const graze::HullLayer& layer : graze::hull_layers(hull_of(shape))) {
      append(layer.vertices.size());
      append(layer.edges.size());
      append(layer.vertices);
      for (const auto& edge : layer.edges) append(edge[0]), append(edge[1]);
    }
    show(first, count);
  });
}

/// The vertex, whether all were scanned, the products; then a layer: how many vertices, which won, how many were looked
/// at, and these.
EXPORTED("hull_support")
GrazeStatus graze_js_hull_support(const TYPE(Shape) * shape, const graze::Vec3<T>* direction,
                                  const std::uint32_t** first, std::size_t* count) {
  return guarded([&] {
    const graze::ConvexHull<T>& hull = hull_of(shape);
    const graze::Vec3<T> d = graze::validate::point(*direction, "direction");
    answer.clear();
    products.clear();
    const graze::SupportTrace trace = graze::explain_support(hull, d);
    append(trace.vertex);
    append(std::size_t{trace.scanned});
    append(trace.products);
    for (const graze::SupportLayer& layer : trace.layers) {
      append(layer.vertices);
      append(layer.winner);
      append(layer.looked_at.size());
      append(layer.looked_at);
      products.insert(products.end(), layer.along.begin(), layer.along.end());
    }
    show(first, count);
  });
}

/// Of the last support query: the product of each vertex that was looked at, those of all layers one behind the other.
EXPORTED("hull_products")
GrazeStatus graze_js_hull_products(const double** first, std::size_t* count) {
  *first = products.data();
  *count = products.size();
  return GRAZE_OK;
}

}  // extern "C"
