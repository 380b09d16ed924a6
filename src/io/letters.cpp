// The letters A and B beside the shapes of an explanation, so that nobody needs their colours to tell them apart.
#include <cmath>
#include <limits>

#include "io/explain_parts.hpp"

namespace graze::io {

namespace {

struct Pixel {
  double x, y;
};

Pixel middle_of(const View& view, const Polygons& shape) {
  Pixel middle{0, 0};
  const auto count = static_cast<double>(shape.points.size());
  for (const Vec3d& p : shape.points) middle.x += view.x(p) / count, middle.y += view.y(p) / count;
  return middle;
}

/// A letter outside of a shape, on the side of the unit vector `way`.
std::string draw_letter(const View& view, const Polygons& shape, const Pixel& way, const char* name) {
  constexpr double beside = 11, size = 13, half_tall = 4;
  Pixel edge{0, 0};
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3d& p : shape.points)
    if (const double along = view.x(p) * way.x + view.y(p) * way.y; along > most)
      most = along, edge = {view.x(p), view.y(p)};
  return text(edge.x + beside * way.x, edge.y + beside * way.y + half_tall, size, name, "ink", "middle");
}

}  // namespace

std::string draw_letters(const View& view, const Polygons& a, const Polygons& b) {
  constexpr double diagonal = 0.7071067811865476;
  Pixel way{diagonal, diagonal};  // of shapes that are alone, or one upon the other
  if (!a.points.empty() && !b.points.empty()) {
    const Pixel from = middle_of(view, a), to = middle_of(view, b);
    const double away = std::hypot(to.x - from.x, to.y - from.y);
    if (away > 1) way = {(to.x - from.x) / away, (to.y - from.y) / away};
  }
  std::string out;
  if (!a.points.empty()) out += draw_letter(view, a, {-way.x, -way.y}, "A");
  if (!b.points.empty()) out += draw_letter(view, b, way, "B");
  return out;
}

}  // namespace graze::io
