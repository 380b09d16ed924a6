// Cores above a half-plane: the vertex that lies lowest.
#pragma once

#include "plane/pairs/box_point.hpp"

namespace graze::plane {

template <LaneCore core>
struct HalfPlaneAnd {
  static constexpr LaneCore a = LaneCore::half_plane, b = core;

  template <class S>
  [[gnu::always_inline]] static LaneNearest<S> nearest(const LanePair<S>& pair, const S&) {
    const S zero(0), one(1);
    const Vec2<S> down = -inverse_rotate(pair.b_in_a.rotation, Vec2<S>{zero, one});
    LaneNearest<S> out;
    out.feature_b = vertex_number(zero);
    Vec2<S> lowest{zero, zero};
    if constexpr (core == LaneCore::box) {
      const Vec2<S> corner{sign_of(down.x), sign_of(down.y)};
      lowest = {corner.x * pair.b.size[0], corner.y * pair.b.size[1]};
      out.feature_b = vertex_number(corner_number(corner));
    } else if constexpr (core == LaneCore::segment) {
      const Vec2<S> p{pair.b.size[0], pair.b.size[1]}, q{pair.b.size[2], pair.b.size[3]};
      const auto second = dot(q, down) > dot(p, down);
      lowest = select(second, q, p);
      out.feature_b = vertex_number(select(second, one, zero));
    }
    out.b = transform(pair.b_in_a, lowest);
    out.a = {out.b.x, zero};
    out.normal = {zero, one};
    out.distance = out.b.y;
    out.feature_a = side_number(zero);
    return out;
  }
};

using HalfPlanePoint = HalfPlaneAnd<LaneCore::point>;
using HalfPlaneSegment = HalfPlaneAnd<LaneCore::segment>;
using HalfPlaneBox = HalfPlaneAnd<LaneCore::box>;

}  // namespace graze::plane
