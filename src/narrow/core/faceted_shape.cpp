#include "narrow/core/faceted_shape.hpp"

#include <algorithm>

namespace graze {

bool has_facets(const Shape<float>& shape) {
  if (const auto* hull = shape.as<ConvexHull<float>>()) return !hull->data().facets.faces.empty();
  if (const auto* triangle = shape.as<Triangle<float>>()) return triangle_normal(*triangle) != Vec3d{};
  return shape.as<Box<float>>() || shape.as<Rectangle<float>>();
}

FacetedShape::FacetedShape(const Shape<float>& shape) {
  if (const auto* hull = shape.as<ConvexHull<float>>())
    view_ = faceted(hull->data());
  else if (const auto* triangle = shape.as<Triangle<float>>())
    write(*triangle);
  else if (const auto* box = shape.as<Box<float>>())
    write(box->half_extents());
  else if (const auto* rectangle = shape.as<Rectangle<float>>())
    write(rectangle->as_box().half_extents());
}

void FacetedShape::write_rows(std::size_t vertices, std::size_t faces, const std::uint8_t* vertex_of_face) {
  fill_block(vertices_, vertices, block_);
  write_faces({planes_, faces}, &faces_);
  std::copy_n(vertex_of_face, faces, faces_.vertex);
}

void FacetedShape::write(const Vec3<float>& half) {
  static constexpr std::uint8_t vertex_of_face[] = {0, 7, 0, 7, 0, 7};
  for (std::size_t i = 0; i < 8; ++i)
    vertices_[i] = {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
  for (std::size_t f = 0; f < 6; ++f) {
    planes_[f] = {{0, 0, 0}, static_cast<double>(half[f / 2])};
    planes_[f].normal[f / 2] = f % 2 ? 1 : -1;
  }
  write_rows(8, 6, vertex_of_face);
  const float inner = least(half.x, least(half.y, half.z));
  view_ = {{&block_, vertices_, 8, length(half)},
           &faces_,
           &box_edge_block,
           planes_,
           box_parts.edges.data(),
           6,
           12,
           {{}, inner * (1 - std::numeric_limits<float>::epsilon())}};
}

void FacetedShape::write(const Triangle<float>& triangle) {
  static constexpr std::uint8_t vertex_of_face[] = {0, 0, 0, 1, 2};
  Vec3d points[3], sum{};
  float extent = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    vertices_[i] = triangle.point(i);
    points[i] = converted<double>(vertices_[i]);
    sum += points[i];
    extent = greatest(extent, length(vertices_[i]));
  }
  const Vec3d normal = unit(triangle_normal(triangle));
  planes_[0].normal = normal;
  planes_[1].normal = -normal;
  for (std::size_t i = 0; i < 3; ++i) planes_[2 + i].normal = unit(cross(points[(i + 1) % 3] - points[i], normal));
  for (Plane<double>& plane : std::span(planes_, 5)) move_out(plane, points);
  write_rows(3, 5, vertex_of_face);
  view_ = {{&block_, vertices_, 3, extent}, &faces_, &triangle_edge_block, planes_, triangle_edges.data(), 5, 6,
           {converted<float>(sum / 3.0), 0}};
}

}  // namespace graze
