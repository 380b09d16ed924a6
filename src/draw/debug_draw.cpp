// What a renderer does by itself with what it has no better way for, and the colours that pictures have.
#include "draw/cut_polygon.hpp"
#include "graze/draw.hpp"

namespace graze {

DebugDraw::~DebugDraw() = default;

void DebugDraw::polygons(const Polygons& shape, DrawLayer layer, Meaning meaning) {
  std::vector<Mesh<double>::Index> triangles;
  for (const auto& loop : shape.loops)
    if (loop.size() > 2) cut_polygon(shape.points, loop, triangles);
  for (const auto& [i, j, k] : triangles) triangle(shape.points[i], shape.points[j], shape.points[k], layer, meaning);
  for (const auto& loop : shape.loops) {
    if (shape.smooth && loop.size() > 2) continue;
    const std::size_t edges = loop.size() > 2 ? loop.size() : loop.size() - 1;
    for (std::size_t i = 0; i < edges; ++i)
      line(shape.points[loop[i]], shape.points[loop[(i + 1) % loop.size()]], layer, meaning);
    if (edges == 0) point(shape.points[loop[0]], layer, meaning);
  }
}

void DebugDraw::arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, Meaning meaning) {
  const double length = area_.size / 12;
  const Vec3d to = from + direction * length, aside = any_perpendicular(direction) * (length / 8);
  const Vec3d back = to - direction * (length / 4);
  line(from, to, layer, meaning);
  line(to, back + aside, layer, meaning);
  line(to, back - aside, layer, meaning);
}

DrawColor suggested_color(Meaning meaning) {
  switch (meaning) {
  case Meaning::a: return {84, 130, 176};
  case Meaning::b: return {224, 142, 69};
  case Meaning::fixed: return {206, 211, 218};
  case Meaning::touched: return {211, 189, 187};
  case Meaning::moving: return {141, 169, 196};
  case Meaning::touching: return {203, 134, 120};
  case Meaning::asleep: return {160, 166, 173};
  case Meaning::trigger: return {129, 178, 154};
  case Meaning::contact:
  case Meaning::gap: return {193, 18, 31};
  case Meaning::normal:
  case Meaning::path: return {29, 53, 87};
  case Meaning::ruled_out:
  case Meaning::bounds: return {173, 181, 189};
  case Meaning::ghost: return {242, 153, 26};
  case Meaning::joint: return {106, 76, 147};
  }
  return {};
}

}  // namespace graze
