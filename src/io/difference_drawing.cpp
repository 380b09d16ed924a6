// The parts that only a picture of the plane has: the projections of two boxes on all of their axes, and the Minkowski
// difference with the steps of a search in it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/explain_parts.hpp"

namespace graze::io {

namespace {

constexpr double band_height = 372, step_size = 142, step_gap = 8;
constexpr std::size_t step_columns = 4, step_rows = 2, most_steps = step_columns * step_rows;
constexpr Panel difference_panel{page_margin, 40, 300, 310};
constexpr double steps_x = difference_panel.x + difference_panel.width + 14;

/// A point of B - A.
Vec3d of(const TraceSupport& p) { return p.b - p.a; }

std::vector<Vec3d> of(const std::vector<TraceSupport>& points) {
  std::vector<Vec3d> out;
  out.reserve(points.size());
  for (const TraceSupport& p : points) out.push_back(of(p));
  return out;
}

std::string path(const View& view, const std::vector<Vec3d>& points, const std::string& attributes, bool closed) {
  std::string d;
  for (std::size_t i = 0; i < points.size(); ++i)
    d += fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', view.x(points[i]), view.y(points[i]));
  return "<path d=\"" + d + (closed ? "Z" : "") + "\" " + attributes + "/>\n";
}

/// The origin, as a cross.
std::string origin(const View& view) {
  const double x = view.x({}), y = view.y({});
  return fmt::format("<path d=\"M{:.1f} {:.1f}h10M{:.1f} {:.1f}v10\" class=\"arrow\" stroke-width=\"1.6\"/>\n", x - 5,
                     y, x, y - 5);
}

std::string frame(const Panel& p, bool chosen) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"6\" class=\"{}\"{}/>\n",
                     p.x, p.y, p.width, p.height, chosen ? "chosen" : "rule",
                     chosen ? "" : R"( fill="none" stroke-width=".8")");
}

/// The panel without the room of its caption.
Panel inner(const Panel& p) { return {p.x + 10, p.y + 24, p.width - 20, p.height - 34}; }

constexpr const char* difference_look = R"(fill="#81b29a" fill-opacity=".28" stroke="#5f8f78" stroke-width="1.2")";

/// One step of a search: the polygon or simplex before it, the direction of the search and the point found there.
struct Step {
  std::string caption;
  std::vector<Vec3d> polygon, simplex;
  Vec3d foot, found;  ///< where the search began, and the support point there
  bool searched;
};

std::vector<Step> steps_of(const Trace& trace) {
  std::vector<Step> out;
  std::size_t number = 0;
  for (const TraceGjk& s : trace.gjk) {
    const bool searched = s.direction != Vec3d{};
    const std::string bounds =
        searched ? fmt::format("{:.3g} to {:.3g}", s.lower, s.upper) : std::string("holds the origin");
    out.push_back({fmt::format("GJK {}: {}", ++number, bounds), of(s.polygon), of(s.simplex), s.direction * s.upper,
                   of(s.found), searched});
  }
  number = 0;
  for (const TraceEpa& s : trace.epa) {
    std::vector<Vec3d> polygon = of(s.polygon), edge;
    // The edge nearest to the origin: the one with that normal.
    double most = -1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3d p = polygon[i], q = polygon[(i + 1) % polygon.size()], e = q - p;
      const double along = dot(normalized(Vec3d{e.y, -e.x, 0}), -s.normal);
      if (p != q && along > most) most = along, edge = {p, q};
    }
    out.push_back({fmt::format("EPA {}: {:.3g} to {:.3g}", ++number, s.face_depth, s.found_depth), std::move(polygon),
                   std::move(edge), -s.normal * s.face_depth, of(s.found), true});
  }
  return out;
}

std::string draw_step(const Step& step, const std::vector<Vec3d>& difference, const Panel& panel) {
  std::vector<Vec3d> all = difference;
  all.push_back({});
  const View view({0, 0, 1}, all, inner(panel));
  std::string out = frame(panel, false) + text(panel.x + 8, panel.y + 16, 11, step.caption, "soft") +
                    path(view, difference,
                         "fill=\"#81b29a\" fill-opacity=\".16\" stroke=\"#5f8f78\" "
                         "stroke-width=\".8\"",
                         true);
  if (step.polygon.size() > 1)
    out += path(view, step.polygon,
                fmt::format(R"(fill="{0}" fill-opacity=".18" stroke="{0}" stroke-width="1")", hex(color_a)), true);
  const bool filled = step.simplex.size() > 2;
  if (step.simplex.size() > 1)
    out += path(view, step.simplex,
                (filled ? fmt::format(R"(fill="{}" fill-opacity=".3" )", hex(color_b)) : std::string()) +
                    fmt::format(R"(stroke="{}" stroke-width="2.4")", hex(color_b)),
                filled);
  for (const Vec3d& p : step.simplex) out += dot_at(view, p, hex(color_b));
  if (step.searched) {
    out += line(view, step.foot, step.found, "arrow", 1, " stroke-dasharray=\"3 3\"");
    out += dot_at(view, step.found, "red");
  }
  return out + origin(view);
}

/// The whole difference, and from the origin the shortest way to its outline; of bodies that move, their path in it.
std::string draw_whole(const Explanation& e, const std::vector<Vec3d>& difference, const Panel& panel) {
  const TraceAxis* axis = named(e.trace.axes, e.trace.winner);
  const double rounding = e.trace.rounding;
  std::vector<Vec3d> all = difference;
  all.insert(all.end(), {{}, {rounding, 0, 0}, {-rounding, 0, 0}, {0, rounding, 0}, {0, -rounding, 0}});
  Vec3d path_end;
  if (e.cast) {
    const double t = e.cast->hit ? e.cast->hit->t : e.cast->duration;
    path_end = (e.cast->a.linear - e.cast->b.linear) * t;
    // A path that misses is drawn as far as it is worth seeing.
    double size = rounding;
    for (const Vec3d& p : difference) size = std::max(size, length(p));
    if (length(path_end) > 2 * size) path_end = normalized(path_end) * (2 * size);
    all.push_back(path_end);
  }
  const View view({0, 0, 1}, all, {panel.x + 16, panel.y + 16, panel.width - 32, panel.height - 32});
  std::string out = path(view, difference, difference_look, true);
  if (difference.size() == 1) out += dot_at(view, difference[0], "#5f8f78");
  if (rounding > 0)
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" class=\"gap\" stroke-width=\"1\" "
                       "stroke-dasharray=\"4 3\"/>\n",
                       view.x({}), view.y({}), rounding * view.scale());
  if (e.cast) {
    out += line(view, {}, path_end, "arrow", 1.8) + dot_at(view, path_end, e.cast->hit ? "red" : "#868e96");
  } else if (axis) {
    // The way from the origin to the nearest point of the outline: the depth or the distance, and the rounding with it.
    const Vec3d nearest = axis->direction * (rounding - axis->overlap());
    out += line(view, {}, nearest, axis->overlap() >= 0 ? "shared" : "gap", 2.4) +
           dot_at(view, nearest, axis->overlap() >= 0 ? "red" : "#868e96");
  }
  return out + origin(view);
}

bool is_box_axis(const std::string& name) {
  return name.size() == 2 && (name[0] == 'A' || name[0] == 'B') && (name[1] == '0' || name[1] == '1');
}

}  // namespace

std::string draw_projections(const Explanation& e, const Polygons& a, const Polygons& b, double bottom) {
  std::vector<const TraceAxis*> axes;
  for (const TraceAxis& axis : e.trace.axes)
    if (is_box_axis(axis.name)) axes.push_back(&axis);
  if (axes.size() != 4) return "";
  constexpr double gap = 8, width = (number_x - list_x + 16 - gap) / 2;
  const double top = head_height + 8, height = std::min(230.0, (bottom - top - 12 - gap) / 2);
  const Vec3d toward{0, 0, 1};
  std::string out;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t row = i / 2, column = i % 2;
    const Panel panel{list_x - 8 + double(column) * (width + gap), top + double(row) * (height + gap), width, height};
    const AxisDrawing drawing(*axes[i], toward, a.points, b.points);
    std::vector<Vec3d> points = a.points;
    points.insert(points.end(), b.points.begin(), b.points.end());
    for (const Vec3d& p : drawing.corners()) points.push_back(p);
    const View view(toward, points, inner(panel));
    SvgDraw canvas(view, {}, std::numeric_limits<double>::infinity());
    canvas.polygons(a, DrawLayer::shapes, DrawMeaning::a);
    canvas.polygons(b, DrawLayer::shapes, DrawMeaning::b);
    const bool won = axes[i]->name == e.trace.winner;
    out += frame(panel, won) + canvas.faces() + drawing.draw(view) +
           text(panel.x + 10, panel.y + 16, 12, drawing.caption(), won ? "ink" : "soft");
  }
  return out;
}

double difference_height(const Trace& trace) { return trace.difference.empty() ? 0 : band_height; }

std::string draw_difference(const Explanation& e, double top) {
  if (e.trace.difference.empty()) return "";
  const std::vector<Vec3d> difference = of(e.trace.difference);
  const std::vector<Step> steps = steps_of(e.trace);
  std::string out =
      fmt::format("<path d=\"M{} {}H{}\" class=\"rule\" stroke-width=\"1\"/>\n", page_margin, top,
                  picture_width - page_margin) +
      text(page_margin, top + 26, 14,
           e.trace.rounding > 0 ? "Minkowski difference B - A of the cores: the shapes overlap where it comes into the "
                                  "circle of both roundings"
                                : "Minkowski difference B - A: the shapes overlap where it holds the origin");
  Panel whole = difference_panel;
  whole.y += top;
  out += draw_whole(e, difference, whole);
  // The first and the last of many steps: in between each is a little nearer.
  const std::size_t shown = std::min(steps.size(), most_steps), first = shown < steps.size() ? shown / 2 : shown;
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t i = k < first ? k : steps.size() - (shown - k);
    const std::size_t row = k / step_columns, column = k % step_columns;
    out += draw_step(steps[i], difference,
                     {steps_x + double(column) * (step_size + step_gap),
                      top + 42 + double(row) * (step_size + step_gap), step_size, step_size});
  }
  if (shown < steps.size())
    out += text(picture_width - page_margin, top + band_height - 12, 11,
                fmt::format("the first {} and the last {} of {} steps", first, shown - first, steps.size()), "soft",
                "end");
  return out;
}

}  // namespace graze::io
