#include "io/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/drawing.hpp"

namespace graze::io {

namespace {

constexpr double font = 11, tall = 11;
/// The width of digits and small letters, a little more than they have.
constexpr double letter = 0.62 * font;
/// Rings around the point that are tried, and directions on each, from above on clockwise.
constexpr double first_ring = 11, ring_step = 9;
constexpr int rings = 12, directions = 12;

}  // namespace

void Labels::keep_clear(double x, double y, double radius) {
  taken_.push_back({x - radius, y - radius, x + radius, y + radius});
}

bool Labels::free(const Rectangle& wanted) const {
  return std::none_of(taken_.begin(), taken_.end(), [&](const Rectangle& t) {
    return wanted.x0 < t.x1 && t.x0 < wanted.x1 && wanted.y0 < t.y1 && t.y0 < wanted.y1;
  });
}

std::string Labels::at(double x, double y, const std::string& words) {
  const double wide = letter * static_cast<double>(words.size());
  const auto place = [&](int ring, int direction) {
    constexpr double turn = 6.283185307179586;
    const double angle = turn * direction / directions, away = first_ring + ring_step * ring;
    const double cx = x + std::sin(angle) * (away + wide / 2 - letter / 2), cy = y - std::cos(angle) * away;
    return Rectangle{cx - wide / 2, cy - tall / 2, cx + wide / 2, cy + tall / 2};
  };
  Rectangle found = place(0, 0);
  int found_ring = 0;
  for (int ring = 0, done = 0; ring < rings && done == 0; ++ring)
    for (int direction = 0; direction < directions && done == 0; ++direction) {
      const Rectangle wanted = place(ring, direction);
      const bool inside = wanted.x0 > 0 && wanted.y0 > 0 && wanted.x1 < picture_width && wanted.y1 < picture_height;
      if (!inside || !free(wanted)) continue;
      found = wanted;
      found_ring = ring;
      done = 1;
    }
  taken_.push_back(found);
  const double cx = (found.x0 + found.x1) / 2, cy = (found.y0 + found.y1) / 2;
  const std::string line =
      found_ring < 1 ? ""
                     : fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" class=\"rule\" stroke-width=\".8\"/>\n", x,
                                   y, cx + (x - cx) * 0.45, cy + (y - cy) * 0.45);
  return line + text(cx, cy + 4, font, words, "ink", "middle");
}

}  // namespace graze::io
