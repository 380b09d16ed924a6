#include "graze/feature_corners.hpp"

#include "narrow/manifold/features.hpp"
#include "shape/compound_data.hpp"

namespace graze {

namespace {

template <class T>
using Corners = SmallVector<Vec3<T>, 8>;

/// Number of vertices of a shape below which an edge's two vertices follow from its number (`edge_feature`).
constexpr std::uint32_t certain_edges = 127;

/// The corners of a feature of a shape with `count` vertices, which `vertex(i)` returns; those of a face are `loop`.
template <class T, class Vertex>
Corners<T> named(const Feature& feature, std::uint32_t count, const Vertex& vertex,
                 std::initializer_list<std::uint32_t> loop) {
  Corners<T> corners;
  const std::uint32_t low = feature.number / certain_edges, high = feature.number % certain_edges;
  if (feature.kind == FeatureKind::vertex && feature.number < count) corners.push_back(vertex(feature.number));
  if (feature.kind == FeatureKind::edge && low < high && high < count)
    corners.push_back(vertex(low)), corners.push_back(vertex(high));
  if (feature.kind == FeatureKind::face)
    for (const std::uint32_t i : loop) corners.push_back(vertex(i));
  return corners;
}

template <class T>
Corners<T> corners_of(const Box<T>& box, const Feature& feature) {
  const Vec3<T>& half = box.half_extents();
  const auto corner = [&](std::uint32_t i) {
    return Vec3<T>{i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
  };
  if (feature.kind != FeatureKind::face) return named<T>(feature, 8, corner, {});
  if (feature.number >= 6) return {};
  const std::uint32_t axis = feature.number / 2, u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3;
  if (feature.number % 2 == 0) return named<T>(feature, 8, corner, {0, v, u | v, u});
  const std::uint32_t far = 1u << axis;
  return named<T>(feature, 8, corner, {far, far | u, far | u | v, far | v});
}
template <class T>
Corners<T> corners_of(const Rectangle<T>& rectangle, const Feature& feature) {
  return corners_of(rectangle.as_box(), feature);
}
template <class T>
Corners<T> corners_of(const Triangle<T>& triangle, const Feature& feature) {
  const auto corner = [&](std::uint32_t i) { return triangle.point(i); };
  if (feature.number == 0) return named<T>(feature, 3, corner, {0, 1, 2});
  if (feature.number == 1) return named<T>(feature, 3, corner, {2, 1, 0});
  return named<T>(feature, 3, corner, {});
}
template <class T>
Corners<T> corners_of(const LineSegment<T>& segment, const Feature& feature) {
  return named<T>(feature, 2, [&](std::uint32_t i) { return segment.point(i); }, {});
}
template <class T>
Corners<T> corners_of(const ConvexHull<T>& hull, const Feature& feature) {
  constexpr std::size_t most = std::size_t(1) << detail::feature_number_bits;
  const HullData<T>& data = hull.data();
  Corners<T> corners;
  if (feature.kind == FeatureKind::vertex && data.vertices.size() <= most && feature.number < data.vertices.size())
    corners.push_back(data.vertices[feature.number]);
  if (feature.kind == FeatureKind::face && data.planes.size() <= most && feature.number < data.planes.size())
    for (const std::uint32_t v : data.loop(feature.number)) corners.push_back(data.vertices[v]);
  if (feature.kind != FeatureKind::edge) return corners;
  const std::uint32_t id = detail::feature_of_kind(2, feature.number);
  for (const HullEdge& edge : data.edges) {
    if (edge_feature(edge.vertex[0], edge.vertex[1]) != id) continue;
    if (!corners.empty()) return {};  // two edges have the number
    corners.push_back(data.vertices[edge.vertex[0]]), corners.push_back(data.vertices[edge.vertex[1]]);
  }
  return corners;
}
/// Round or unbounded shapes have no corners.
template <class T, class C>
Corners<T> corners_of(const C&, const Feature&) {
  return {};
}

}  // namespace

template <class T>
SmallVector<Vec3<T>, 8> feature_corners(const Shape<T>& shape, std::uint32_t piece, Feature feature) {
  const auto* compound = shape.template as<Compound<T>>();
  if (!compound) {
    return shape.visit([&](const auto& concrete) -> Corners<T> {
      if constexpr (requires { corners_of(concrete, feature); })
        return corners_of(concrete, feature);
      else
        return {};
    });
  }
  if (piece >= compound->children().size()) return {};
  const Placed<T>& child = compound->children()[piece];
  // The piece of a composite in a compound is unknown.
  if (child.shape.template as<Compound<T>>()) return {};
  Corners<T> corners = feature_corners(child.shape, 0, feature);
  for (Vec3<T>& corner : corners) corner = transform(child.pose, corner);
  return corners;
}

template SmallVector<Vec3<float>, 8> feature_corners(const Shape<float>&, std::uint32_t, Feature);
template SmallVector<Vec3<double>, 8> feature_corners(const Shape<double>&, std::uint32_t, Feature);

}  // namespace graze
