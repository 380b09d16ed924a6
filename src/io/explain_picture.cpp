#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "graze/io/explain.hpp"
#include "io/drawing.hpp"

namespace graze::io {

namespace {

constexpr double page_margin = 28, head_height = 64;
/// Where the shapes are, and beside them the axes one below the other.
constexpr Panel shapes_panel{page_margin, head_height + 8, 520, picture_height - head_height - page_margin - 16};
constexpr double list_x = 590, name_width = 138, bars_x = list_x + name_width, bars_width = 138, number_x = 936;
constexpr std::size_t most_rows = 20, most_points = 10;
constexpr double id_row = 15;

constexpr Color color_a{84, 130, 176}, color_b{224, 142, 69}, color_shared{193, 18, 31}, ink{33, 37, 41};

std::string text(double x, double y, double size, const std::string& words, const Color& color = ink,
                 const char* anchor = "start") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\">{}</text>\n", x,
                     y, size, hex(color), anchor, escaped(words));
}
std::string bar(double x0, double x1, double y, const Color& color) {
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"5\" rx=\"2\" fill=\"{}\"/>\n", x0, y,
                     std::max(x1 - x0, 1.5), hex(color));
}

const TraceAxis* winner(const Trace& trace) {
  const auto found =
      std::find_if(trace.axes.begin(), trace.axes.end(), [&](const TraceAxis& a) { return a.name == trace.winner; });
  return found == trace.axes.end() ? nullptr : &*found;
}

/// An axis in true length: the viewer looks across it, from about where was asked.
Vec3d across(const Vec3d& toward, const Vec3d& axis) {
  const Vec3d seen = toward - axis * dot(toward, axis);
  return length(seen) > 0.05 * length(toward) ? seen : any_perpendicular(axis);
}

/// The winning axis beside the shapes: the interval of each, what they share, and lines down from the shapes.
class AxisDrawing {
 public:
  AxisDrawing(const TraceAxis& axis, const Vec3d& toward, const std::vector<Vec3d>& a, const std::vector<Vec3d>& b)
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

  /// What the picture must have room for.
  std::vector<Vec3d> corners() const { return {at(low_, bar_b_), at(high_, bar_b_)}; }

  std::string draw(const View& view) const {
    std::string out = shadow(view, of_a_, axis_.a_lower, axis_.a_upper, bar_a_, color_a) +
                      shadow(view, of_b_, axis_.b_lower, axis_.b_upper, bar_b_, color_b);
    // Between the bars: red where both are, grey where a gap is.
    const bool overlap = axis_.overlap() >= 0;
    const double middle = (bar_a_ + bar_b_) / 2;
    out += line(view, at(axis_.b_lower, middle), at(axis_.a_upper, middle), overlap ? hex(color_shared) : "#868e96", 3);
    return out + text(page_margin, picture_height - 14, 13,
                      fmt::format("{}: {} {:.4g}", axis_.name, overlap ? "overlap" : "gap", std::abs(axis_.overlap())),
                      overlap ? color_shared : ink);
  }

 private:
  Vec3d at(double along, double aside) const { return axis_.direction * along + beside_ * aside; }

  static std::string line(const View& view, const Vec3d& p, const Vec3d& q, const std::string& stroke, double thickness,
                          const char* more = "") {
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", view.x(p),
                       view.y(p), view.x(q), view.y(q), stroke, thickness, more);
  }

  /// One shape's interval as a bar, with a line to each end from the point of the shape that makes it. What is infinite
  /// is drawn as far as the rest reaches.
  std::string shadow(const View& view, const std::vector<Vec3d>& points, double lower, double upper, double bar,
                     const Color& color) const {
    const double from = std::clamp(lower, low_, high_), to = std::clamp(upper, low_, high_);
    const auto before = [&](const Vec3d& p, const Vec3d& q) {
      return dot(p, axis_.direction) < dot(q, axis_.direction);
    };
    const auto [first, last] = std::minmax_element(points.begin(), points.end(), before);
    const auto dropped = [&](const Vec3d& p, double end) {
      return line(view, at(end, dot(p, beside_)), at(end, bar), "#adb5bd", 1, " stroke-dasharray=\"3 3\"");
    };
    return dropped(*first, from) + dropped(*last, to) + line(view, at(from, bar), at(to, bar), hex(color), 7);
  }

  const TraceAxis& axis_;
  Vec3d beside_;  ///< unit, across the axis in the plane of the picture
  const std::vector<Vec3d>&of_a_, &of_b_;
  double low_, high_, bar_a_, bar_b_;  ///< of the shapes along the axis; where along `beside_` the bars are
};

std::string draw_points(const Explanation& e, const View& view) {
  std::string out;
  const auto dot_at = [&](const Vec3d& p, const Color& color) {
    out +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\" stroke=\"#fff\" stroke-width=\".8\"/>\n",
                    view.x(p), view.y(p), hex(color));
  };
  int number = 0;
  for (const Manifold<double>& m : e.manifolds) {
    Vec3d middle;
    for (const auto& p : m.points) middle += p.position() / static_cast<double>(m.points.size());
    out += R"(<g stroke="#1d3557" fill="none">)" + arrow(view, middle, m.normal) + "</g>\n";
    for (const auto& p : m.points) {
      dot_at(p.position(), color_shared);
      out += text(view.x(p.position()), view.y(p.position()) - 7, 11, std::to_string(++number), ink, "middle");
    }
  }
  if (e.distance) {
    out += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#c1121f\" stroke-width=\"2\"/>\n",
                       view.x(e.distance->a), view.y(e.distance->a), view.x(e.distance->b), view.y(e.distance->b));
    dot_at(e.distance->a, color_a);
    dot_at(e.distance->b, color_b);
  }
  return out;
}

/// The axes of least overlap, in the order in which they were tried.
std::vector<const TraceAxis*> shown_axes(const Trace& trace) {
  std::vector<const TraceAxis*> axes;
  for (const TraceAxis& axis : trace.axes) axes.push_back(&axis);
  if (axes.size() <= most_rows) return axes;
  std::stable_sort(axes.begin(), axes.end(), [](auto* p, auto* q) { return p->overlap() < q->overlap(); });
  axes.resize(most_rows);
  std::sort(axes.begin(), axes.end());
  return axes;
}

/// The ids of the points by their numbers in the picture, from the bottom up. Returns where the list begins.
double draw_ids(const Explanation& e, std::string& out) {
  std::vector<const ContactPoint<double>*> points;
  for (const Manifold<double>& m : e.manifolds)
    for (const auto& p : m.points) points.push_back(&p);
  if (points.empty()) return picture_height - page_margin;
  const std::size_t count = std::min(points.size(), most_points);
  double y = picture_height - page_margin - id_row * static_cast<double>(count);
  const double top = y - 8;
  for (std::size_t i = 0; i < count; ++i, y += id_row)
    out += text(list_x, y + 12, 11,
                fmt::format("{:>2}  {:08x}  {}", i + 1, points[i]->feature, feature_text(points[i]->feature))) +
           text(number_x, y + 12, 11, fmt::format("{:.4g}", points[i]->distance), ink, "end");
  return top;
}

/// All axes as rows: the intervals of both shapes, to one scale; down to `bottom`.
std::string draw_list(const Explanation& e, double bottom) {
  const auto axes = shown_axes(e.trace);
  double widest = 0;
  const auto ends = [](const TraceAxis& axis) {
    double low = std::min(axis.a_lower, axis.b_lower), high = std::max(axis.a_upper, axis.b_upper);
    if (!std::isfinite(low)) low = std::max(axis.a_lower, axis.b_lower);
    if (!std::isfinite(high)) high = std::min(axis.a_upper, axis.b_upper);
    return std::pair{low, high};
  };
  for (const TraceAxis* axis : axes) widest = std::max(widest, ends(*axis).second - ends(*axis).first);
  if (!(widest > 0)) return "";
  const double row = std::min(26.0, (bottom - head_height - 34) / static_cast<double>(axes.size()));
  std::string out = text(bars_x, head_height + 4, 12, "A", color_a) +
                    text(bars_x + 14, head_height + 4, 12, "B", color_b) +
                    text(number_x, head_height + 4, 12, "overlap", ink, "end");
  double y = head_height + 14;
  for (const TraceAxis* axis : axes) {
    const auto [low, high] = ends(*axis);
    const double scale = bars_width / widest, start = bars_x + (bars_width - (high - low) * scale) / 2;
    const auto x = [&, low = low, high = high](double t) { return start + (std::clamp(t, low, high) - low) * scale; };
    if (axis->name == e.trace.winner)
      out += fmt::format("<rect x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\" rx=\"4\" fill=\"#ffe8cc\"/>\n",
                         list_x - 8, y - 1, number_x - list_x + 16, row - 1);
    out += text(list_x, y + row / 2 + 4, 12, axis->name);
    out += bar(x(axis->a_lower), x(axis->a_upper), y + row / 2 - 6, color_a);
    out += bar(x(axis->b_lower), x(axis->b_upper), y + row / 2 + 1, color_b);
    out += text(number_x, y + row / 2 + 4, 12, fmt::format("{:.4g}", axis->overlap()), ink, "end");
    y += row;
  }
  if (axes.size() < e.trace.axes.size())
    out += text(list_x, picture_height - 16, 12,
                fmt::format("the {} of {} axes that overlap least", axes.size(), e.trace.axes.size()));
  return out;
}

std::string headline(const Explanation& e) {
  std::string words = e.query + ": the shapes " + (e.overlap ? "overlap" : "are apart");
  if (e.distance) words += fmt::format(", {} {:.4g}", e.overlap ? "depth" : "distance", std::abs(e.distance->distance));
  if (!e.manifolds.empty())
    words += fmt::format(", {} point{}", e.manifolds[0].points.size(), e.manifolds[0].points.size() == 1 ? "" : "s");
  std::string method = e.trace.method;
  if (!e.trace.reason.empty()) method += ": " + e.trace.reason;
  constexpr std::size_t longest = 150;
  if (method.size() > longest) method = method.substr(0, longest) + "...";
  return text(page_margin, 34, 17, words) + text(page_margin, 54, 12, method, {73, 80, 87});
}

}  // namespace

std::string draw_explanation(const Explanation& e, const Vec3d& toward_viewer) {
  const TraceAxis* axis = winner(e.trace);
  Vec3d toward = e.dimension == 2 ? Vec3d{0, 0, 1} : toward_viewer;
  if (axis && e.dimension == 3) toward = across(toward_viewer, axis->direction);

  Aabbd box = Aabbd::empty();
  for (const auto* body : {&*e.a, &*e.b})
    if (const Aabbd of = bounds(body->shape, body->pose); max_abs(of.extent()) < 1e300) box = merged(box, of);
  if (!(box.lower.x <= box.upper.x)) box = {{-1, -1, -1}, {1, 1, 1}};
  const double size = std::max(max_abs(box.extent()), least_size);
  const Polygons a = tessellate(e.a->shape, e.a->pose, box.center(), 0.7 * size);
  const Polygons b = tessellate(e.b->shape, e.b->pose, box.center(), 0.7 * size);

  std::vector<Vec3d> points = a.points;
  points.insert(points.end(), b.points.begin(), b.points.end());
  std::optional<AxisDrawing> beside;
  if (axis) {
    beside.emplace(*axis, normalized(toward), a.points, b.points);
    for (const Vec3d& p : beside->corners()) points.push_back(p);
  }
  const View view(toward, points, shapes_panel);
  std::vector<DrawnFace> faces;
  draw_shape(view, a, color_a, true, size, faces);
  draw_shape(view, b, color_b, true, size, faces);
  std::string out =
      svg_head() + painted(std::move(faces)) + "<g font-family=\"system-ui, sans-serif\" fill=\"none\">\n";
  if (beside) out += beside->draw(view);
  const double bottom = draw_ids(e, out);
  return out + draw_points(e, view) + draw_list(e, bottom) + headline(e) + "</g>\n</svg>\n";
}

}  // namespace graze::io
