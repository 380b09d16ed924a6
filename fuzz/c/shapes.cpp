// Shapes, their measures, and the hierarchies of hulls.
#include "c/calls.hpp"

namespace {

GrazeVec3d corner_support(const void*, GrazeVec3d d) {
  return {d.x < 0 ? -1.0 : 1.0, d.y < 0 ? -0.5 : 0.5, d.z < 0 ? -1.0 : 1.0};
}

}  // namespace

void Calls::make_shape() {
  GrazeShaped* made = nullptr;
  GrazeShaped** const out = in.maybe(&made);
  GrazeStatus status = GRAZE_OK;
  std::vector<GrazeVec3d> points;
  std::vector<std::uint32_t> indices;
  switch (in.byte() % 15) {
  case 0: status = graze_shape_sphere_d(in.length(), in.vector(), out); break;
  case 1: status = graze_shape_capsule_d(in.length(), in.length(), in.length(), out); break;
  case 2: status = graze_shape_box_d({in.length(), in.length(), in.length()}, out); break;
  case 3: status = graze_shape_rectangle_d(in.length(), in.length(), out); break;
  case 4: status = graze_shape_cylinder_d(in.length(), in.length(), in.length(), out); break;
  case 5: status = graze_shape_ellipsoid_d({in.length(), in.length(), in.length()}, out); break;
  case 6: status = graze_shape_segment_d(in.vector(), in.vector(), out); break;
  case 7: status = graze_shape_triangle_d(in.vector(), in.vector(), in.vector(), out); break;
  case 8: status = graze_shape_half_space_d(out); break;
  case 9:
    points.resize(in.byte() % 12);
    for (auto& p : points) p = in.vector();
    status = graze_shape_convex_hull_d(in.maybe(points.data()), 0, points.size(), out);
    break;
  case 10:
    points.resize(in.byte() % 8);
    for (auto& p : points) p = in.vector();
    indices.resize(std::size_t{3} * (in.byte() % 8));
    for (auto& i : indices) i = in.byte() % 9;
    status = graze_shape_mesh_d(in.maybe(points.data()), 0, points.size(), in.maybe(indices.data()), 0,
                                indices.size() / 3, in.choice<GrazeSides>(2), in.byte() < 32, out);
    break;
  case 11: {
    const std::size_t columns = in.byte() % 5, rows = in.byte() % 5;
    std::vector<double> heights(columns * rows);
    for (double& h : heights) h = in.number();
    status = graze_shape_height_field_d(in.maybe(heights.data()), 0, columns, in.byte() == 9 ? SIZE_MAX : rows, nullptr,
                                        in.length(), in.length(), in.choice<GrazeSides>(2), out);
    if (in.byte() == 9) told(graze_shape_height_field_d(nullptr, 0, 1, 1, nullptr, 1, 1, GRAZE_SIDES_BOTH, out));
    break;
  }
  case 12: {
    std::vector<GrazeChildd> children(in.byte() % 4);
    for (auto& child : children) child = {shape(), in.pose()};
    status = graze_shape_compound_d(in.maybe(children.data()), 0, children.size(), out);
    break;
  }
  case 13: status = graze_shape_rounded_d(shape(), in.length(), out); break;
  default:
    if (in.byte() < 128) {
      status = graze_shape_user_d(in.byte() < 8 ? nullptr : corner_support, nullptr, nullptr, out);
    } else {
      const GrazePosed pose = in.pose();
      status = graze_shape_swept_d(shape(), in.maybe(&pose), in.vector(), out);
    }
  }
  const bool made_it = told(status);
  require(made_it == (made != nullptr));
  if (made_it) keep(made);
}

void Calls::ask_shape() {
  const GrazeShaped* s = shape();
  const GrazePosed pose = in.pose();
  GrazeAabbd bounds;
  GrazeVec3d point;
  GrazeMassPropertiesd mass;
  GrazeShapeKind kind;
  GrazeClosestd closest;
  told(graze_shape_bounds_d(s, in.maybe(&pose), in.maybe(&bounds)));
  told(graze_shape_support_d(s, in.vector(), in.maybe(&point)));
  GrazePolygons polygons;
  if (told(graze_shape_tessellate_d(s, in.maybe(&pose), in.vector(), in.length(), in.maybe(buffer), &polygons)))
    require(polygons.loop_count == 0 || polygons.corners[polygons.ends[0] - 1] < polygons.point_count);
  // Of a shape known by its support alone they cost the hull of 20,000 points.
  if (masses < 1 && in.byte() < 64) ++masses, told(graze_shape_mass_properties_d(s, in.maybe(&mass)));
  told(graze_shape_kind_d(s, in.maybe(&kind)));
  if (told(graze_closest_d(s, &pose, in.vector(), &closest))) require(closest.certainty <= GRAZE_UNBOUNDED);
}

void Calls::ask_hull() {
  const GrazeShaped* s = shape();
  const GrazeVec3d* vertices;
  const GrazeHullLayer* layers;
  GrazeSupportTrace steps;
  std::size_t count = 0;
  if (told(graze_hull_vertices_d(s, in.maybe(&vertices), &count))) require(count > 0);
  if (told(graze_hull_layers_d(s, in.maybe(buffer), in.maybe(&layers), &count))) require(count > 0);
  if (told(graze_hull_support_d(s, in.vector(), in.maybe(buffer), in.maybe(&steps))))
    require(steps.layers[steps.layer_count - 1].winner == steps.vertex);
}
