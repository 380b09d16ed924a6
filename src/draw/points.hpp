// Points of contact with their normal, of one query or of a world.
//
// Guarantee: every point once, and one arrow from their middle; nothing without points.
#pragma once

#include <span>

#include "draw/in_space.hpp"
#include "graze/draw.hpp"

namespace graze::draw_detail {

template <class Vec, class Point>
void draw_points(DebugDraw& on, const Vec& normal, std::span<const Point> points) {
  if (!on.wants(DrawLayer::contacts) || points.empty()) return;
  Vec3d middle;
  for (const Point& p : points) {
    const Vec3d at = in_space(p.position());
    on.point(at, DrawLayer::contacts, DrawMeaning::contact);
    middle += at / static_cast<double>(points.size());
  }
  on.arrow(middle, in_space(normal), DrawLayer::contacts, DrawMeaning::normal);
}

}  // namespace graze::draw_detail
