// The default ways of a renderer to draw, and the colours of pictures.
#include <array>
#include <set>

#include "draw/cut_polygon.hpp"
#include "graze/draw.hpp"

namespace graze {

namespace {

/// Edges by their ends, in either order.
class DrawnEdges {
 public:
  /// Whether the edge is new.
  bool add(const Vec3d& p, const Vec3d& q) {
    const Place a{p.x, p.y, p.z}, b{q.x, q.y, q.z};
    return edges_.insert(a < b ? std::pair{a, b} : std::pair{b, a}).second;
  }

 private:
  using Place = std::array<double, 3>;
  std::set<std::pair<Place, Place>> edges_;
};

}  // namespace

DebugDraw::~DebugDraw() = default;

void DebugDraw::polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning) {
  std::vector<Mesh<double>::Index> triangles;
  for (const auto& loop : shape.loops)
    if (loop.size() > 2) cut_polygon(shape.points, loop, triangles);
  for (const auto& [i, j, k] : triangles) triangle(shape.points[i], shape.points[j], shape.points[k], layer, meaning);
  DrawnEdges drawn;
  for (const auto& loop : shape.loops) {
    if (loop.size() == 1) point(shape.points[loop[0]], layer, meaning);
    if (shape.smooth && loop.size() > 2) continue;
    const std::size_t edges = loop.size() > 2 ? loop.size() : loop.size() - 1;
    for (std::size_t i = 0; i < edges; ++i) {
      const Vec3d &from = shape.points[loop[i]], &to = shape.points[loop[(i + 1) % loop.size()]];
      if (drawn.add(from, to)) line(from, to, layer, meaning);
    }
  }
}

void DebugDraw::arrow(const Vec3d& from, const Vec3d& direction, DrawLayer layer, DrawMeaning meaning) {
  const double length = area_.size / 12;
  const Vec3d to = from + direction * length, aside = any_perpendicular(direction) * (length / 8);
  const Vec3d back = to - direction * (length / 4);
  line(from, to, layer, meaning);
  line(to, back + aside, layer, meaning);
  line(to, back - aside, layer, meaning);
}

DrawColor suggested_color(DrawMeaning meaning) {
  switch (meaning) {
  case DrawMeaning::a: return {31, 111, 235};
  case DrawMeaning::b: return {217, 130, 43};
  case DrawMeaning::fixed: return {206, 211, 218};
  case DrawMeaning::touched: return {211, 189, 187};
  case DrawMeaning::moving: return {141, 169, 196};
  case DrawMeaning::touching: return {203, 134, 120};
  case DrawMeaning::asleep: return {160, 166, 173};
  case DrawMeaning::trigger: return {129, 178, 154};
  case DrawMeaning::contact:
  case DrawMeaning::gap: return {193, 18, 31};
  case DrawMeaning::normal:
  case DrawMeaning::path: return {29, 53, 87};
  case DrawMeaning::ruled_out:
  case DrawMeaning::bounds: return {173, 181, 189};
  case DrawMeaning::ghost: return {242, 153, 26};
  case DrawMeaning::joint: return {106, 76, 147};
  }
  return {};
}

}  // namespace graze
