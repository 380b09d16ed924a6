// The cores of the special pairs as polygons, one shape a lane.
//
// Guarantee: the vertices of `core_of`, in its order.
#pragma once

#include "plane/pairs/lane_polygons.hpp"

namespace graze::plane {

/// The vertices of a core; none of a half-plane.
constexpr std::size_t corners_of(LaneCore core) {
  switch (core) {
  case LaneCore::point: return 1;
  case LaneCore::segment: return 2;
  case LaneCore::box: return 4;
  case LaneCore::half_plane: break;
  }
  return 0;
}

template <LaneCore core, class S>
[[gnu::always_inline]] inline LanePolygon<S, corners_of(core)> core_polygon(const LaneShape<S>& shape) {
  LanePolygon<S, corners_of(core)> out;
  out.pose = shape.pose;
  out.count = S(double(corners_of(core)));
  out.radius = shape.radius;
  if constexpr (core == LaneCore::point) {
    out.own[0] = {S(0), S(0)};
  } else if constexpr (core == LaneCore::segment) {
    out.own[0] = {shape.size[0], shape.size[1]};
    out.own[1] = {shape.size[2], shape.size[3]};
  } else {
    const Vec2<S> half{shape.size[0], shape.size[1]};
    out.own[0] = -half;
    out.own[1] = {half.x, -half.y};
    out.own[2] = half;
    out.own[3] = {-half.x, half.y};
  }
  return out;
}

}  // namespace graze::plane
