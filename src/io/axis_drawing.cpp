#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/explain_parts.hpp"

namespace graze::io {

AxisDrawing::AxisDrawing(const TraceAxis& axis, const Vec3d& toward, const std::vector<Vec3d>& a,
                         const std::vector<Vec3d>& b)
    : axis_(axis), beside_(normalized(cross(toward, axis.direction))), of_a_(a), of_b_(b) {
  if (beside_.y > 0 || (beside_.y == 0 && beside_.x > 0)) beside_ = -beside_;  // below, or on the left
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double edge = -infinity, inner = infinity;
  low_ = infinity, high_ = -infinity;
  for (const auto* points : {&a, &b})
    for (const Vec3d& p : *points) {
      edge = std::max(edge, dot(p, beside_)), inner = std::min(inner, dot(p, beside_));
      low_ = std::min(low_, dot(p, axis.direction)), high_ = std::max(high_, dot(p, axis.direction));
    }
  const double step = 0.07 * std::max(edge - inner, high_ - low_);
  bar_a_ = edge + step, bar_b_ = edge + 2 * step;
}

std::string AxisDrawing::draw(const View& view) const {
  std::string out = shadow(view, of_a_, axis_.a_lower, axis_.a_upper, bar_a_, color_a) +
                    shadow(view, of_b_, axis_.b_lower, axis_.b_upper, bar_b_, color_b);
  // Between the bars: red where both are, grey where a gap is.
  const bool overlap = axis_.overlap() >= 0;
  const double middle = (bar_a_ + bar_b_) / 2;
  const double from = std::clamp(axis_.b_lower, low_, high_), to = std::clamp(axis_.a_upper, low_, high_);
  return out + line(view, at(from, middle), at(to, middle), overlap ? "shared" : "gap", 3);
}

std::string AxisDrawing::caption() const {
  return fmt::format("{}: {} {:.4g}", axis_.name, axis_.overlap() >= 0 ? "overlap" : "gap", std::abs(axis_.overlap()));
}

/// One shape's interval as a bar, with a line to each end from the point of the shape that makes it. An infinite
/// interval is drawn as far as the rest reaches.
std::string AxisDrawing::shadow(const View& view, const std::vector<Vec3d>& points, double lower, double upper,
                                double bar, const Color& color) const {
  const double from = std::clamp(lower, low_, high_), to = std::clamp(upper, low_, high_);
  const auto before = [&](const Vec3d& p, const Vec3d& q) { return dot(p, axis_.direction) < dot(q, axis_.direction); };
  const auto [first, last] = std::minmax_element(points.begin(), points.end(), before);
  const auto dropped = [&](const Vec3d& p, double end) {
    return line(view, at(end, dot(p, beside_)), at(end, bar), "rule", 1, " stroke-dasharray=\"3 3\"");
  };
  return dropped(*first, from) + dropped(*last, to) + line(view, at(from, bar), at(to, bar), hex(color), 7);
}

namespace {

struct Place {
  double x, y;
};

/// The corners of a panel on one side of a straight line: where (p - through) . u <= 0 (Sutherland, Hodgman 1974).
std::string half_panel(const Panel& panel, const Place& through, const Place& u) {
  const std::array<Place, 4> corners{Place{panel.x, panel.y}, Place{panel.x + panel.width, panel.y},
                                     Place{panel.x + panel.width, panel.y + panel.height},
                                     Place{panel.x, panel.y + panel.height}};
  const auto side = [&](const Place& p) { return (p.x - through.x) * u.x + (p.y - through.y) * u.y; };
  std::string points;
  const auto add = [&](double x, double y) { points += fmt::format("{:.1f},{:.1f} ", x, y); };
  for (std::size_t i = 0; i < 4; ++i) {
    const Place &p = corners[i], &q = corners[(i + 1) % 4];
    const double at_p = side(p), at_q = side(q);
    if (at_p <= 0) add(p.x, p.y);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      const double part = at_p / (at_p - at_q);
      add(p.x + part * (q.x - p.x), p.y + part * (q.y - p.y));
    }
  }
  return points;
}

/// An enlargement in words, with 3 digits at most, and groups of three: "1,250", or a power of ten beyond a million.
std::string enlargement(double times) {
  const double power = std::pow(10.0, std::floor(std::log10(times)) - 1);
  const double rounded = std::round(times / power) * power;
  if (rounded >= 1e6) return fmt::format("{:.1e}", rounded);
  const auto whole = static_cast<long>(std::lround(rounded));
  return whole >= 1000 ? fmt::format("{},{:03}", whole / 1000, whole % 1000) : std::to_string(whole);
}

}  // namespace

bool needs_inset(const View& view, const TraceAxis& axis) {
  constexpr double seen = 4;  // pixels
  const Vec3d tip = axis.direction * (1 / view.scale());
  // An axis that points at the viewer has no length on the picture.
  const bool in_picture = std::hypot(view.x(tip) - view.x({}), view.y(tip) - view.y({})) > 0.5;
  const double pixels = std::abs(axis.overlap()) * view.scale();
  // A gap that is only rounding is not worth seeing.
  return pixels > 1e-9 && pixels < seen && in_picture;
}

std::string draw_inset(const View& view, const TraceAxis& axis, const Vec3d& place) {
  constexpr double enlarged = 26;  // pixels
  constexpr Panel panel{shapes_panel.x + shapes_panel.width - 150, head_height + 6, 150, inset_height - 30};
  const double overlap = axis.overlap(), pixels = std::abs(overlap) * view.scale();
  const Vec3d tip = place + axis.direction * (1 / view.scale());
  const Place u{view.x(tip) - view.x(place), view.y(tip) - view.y(place)};
  const Place middle{panel.x + panel.width / 2, panel.y + panel.height / 2};
  const double half = (overlap > 0 ? 0.5 : -0.5) * enlarged;
  const auto moved = [&](double by) { return Place{middle.x + by * u.x, middle.y + by * u.y}; };
  const auto body = [&](const Place& through, const Place& outward, const Color& color) {
    return fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\".55\"/>\n",
                       half_panel(panel, through, outward), hex(color));
  };
  const auto letter = [&](double by, const char* name) {
    const Place at = moved(by);
    return text(at.x, at.y + 4, 12, name, "ink", "middle");
  };
  const auto frame = [&](const char* look) {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" class=\"{}\"/>\n", panel.x, panel.y,
                       panel.width, panel.height, look);
  };
  const std::string words = fmt::format("{} {:.3g}, × {}", overlap > 0 ? "overlap" : "gap", std::abs(overlap),
                                        enlargement(enlarged / pixels));
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" class=\"rule\" stroke-width=\"1\"/>\n", view.x(place),
                     view.y(place), panel.x, panel.y + panel.height) +
         frame("paper") + body(moved(half), u, color_a) + body(moved(-half), {-u.x, -u.y}, color_b) +
         fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" class=\"{}\" stroke-width=\"2.5\"/>\n", moved(half).x,
                     moved(half).y, moved(-half).x, moved(-half).y, overlap > 0 ? "shared" : "gap") +
         frame("rule") + letter(-34, "A") + letter(34, "B") +
         text(middle.x, panel.y + panel.height + 14, 11, words, "soft", "middle");
}

}  // namespace graze::io
