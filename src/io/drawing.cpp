#include "io/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace graze::io {

std::string hex(const Color& c, double light) {
  const auto part = [&](std::size_t i) { return static_cast<int>(std::clamp(c[i] * light, 0.0, 255.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

Color color_of(DrawMeaning meaning) {
  const DrawColor c = suggested_color(meaning);
  return {double(c.red), double(c.green), double(c.blue)};
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

View::View(const Vec3d& toward_viewer, const std::vector<Vec3d>& points, const Panel& panel)
    : toward_(normalized(toward_viewer)) {
  const Vec3d up = std::abs(toward_.y) > 0.999 ? Vec3d{0, 0, -1} : Vec3d{0, 1, 0};
  right_ = normalized(cross(up, toward_));
  up_ = cross(toward_, right_);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low_x = infinity, high_x = -infinity, low_y = infinity, high_y = -infinity;
  for (const Vec3d& p : points) {
    low_x = std::min(low_x, dot(p, right_)), high_x = std::max(high_x, dot(p, right_));
    low_y = std::min(low_y, dot(p, up_)), high_y = std::max(high_y, dot(p, up_));
  }
  const double wide = std::max(high_x - low_x, least_size), tall = std::max(high_y - low_y, least_size);
  scale_ = std::min(panel.width / wide, panel.height / tall);
  x_ = panel.x + panel.width / 2 - scale_ * (low_x + high_x) / 2;
  y_ = panel.y + panel.height / 2 + scale_ * (low_y + high_y) / 2;
}

double View::light(const Vec3d& normal) const {
  const Vec3d lamp = normalized(toward_ + up_ * 1.2 - right_ * 0.6);
  return 0.62 + 0.42 * std::max(0.0, dot(normal, lamp));
}

namespace {

constexpr Color pale{160, 166, 173};

/// The class or colour of a thing that is drawn over the shapes.
std::string look_of(DrawMeaning meaning) {
  switch (meaning) {
  case DrawMeaning::contact: return "red";
  case DrawMeaning::gap: return "shared";
  case DrawMeaning::normal:
  case DrawMeaning::path: return "arrow";
  case DrawMeaning::ruled_out:
  case DrawMeaning::bounds: return "rule";
  default: return hex(color_of(meaning));
  }
}

bool is_glass(DrawMeaning meaning) {
  return meaning == DrawMeaning::a || meaning == DrawMeaning::b || meaning == DrawMeaning::trigger ||
         meaning == DrawMeaning::ghost;
}

Vec3d face_normal(const Polygons& shape, const std::vector<std::uint32_t>& loop) {
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(shape.points[loop[i]] - shape.points[loop[0]], shape.points[loop[i + 1]] - shape.points[loop[0]]);
  return normalized(sum, Vec3d{});
}

}  // namespace

std::string arrow(const View& view, const Vec3d& from, const Vec3d& along) {
  const Vec3d to = from + along * (34 / view.scale());
  const double dx = view.x(to) - view.x(from), dy = view.y(to) - view.y(from), l = std::hypot(dx, dy);
  if (l < 1) return "";
  const double ux = dx / l, uy = dy / l, x = view.x(to), y = view.y(to);
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke-width=\"1.8\"/><path d=\"M{:.1f} {:.1f}L{:.1f} "
                     "{:.1f}L{:.1f} {:.1f}Z\" "
                     "class=\"tip\"/>\n",
                     view.x(from), view.y(from), x - 4 * ux, y - 4 * uy, x + 2 * ux, y + 2 * uy, x - 7 * ux - 3.5 * uy,
                     y - 7 * uy + 3.5 * ux, x - 7 * ux + 3.5 * uy, y - 7 * uy - 3.5 * ux);
}

std::string line(const View& view, const Vec3d& p, const Vec3d& q, const std::string& look, double thickness,
                 const char* more) {
  const std::string stroke = look.starts_with('#') ? "stroke=\"" + look + '"' : "class=\"" + look + '"';
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {} stroke-width=\"{}\"{}/>\n", view.x(p), view.y(p),
                     view.x(q), view.y(q), stroke, thickness, more);
}

std::string dot_at(const View& view, const Vec3d& p, const std::string& look) {
  const std::string fill =
      look.starts_with('#') ? R"(fill=")" + look + R"(" class="rim")" : "class=\"rim " + look + '"';
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" {} stroke-width=\".8\"/>\n", view.x(p), view.y(p),
                     fill);
}

void SvgDraw::point(const Vec3d& at, DrawLayer, DrawMeaning meaning) { dots_ += dot_at(view_, at, look_of(meaning)); }

void SvgDraw::line(const Vec3d& from, const Vec3d& to, DrawLayer, DrawMeaning meaning) {
  lines_ += io::line(view_, from, to, look_of(meaning), meaning == DrawMeaning::gap ? 2 : 1.8);
}

void SvgDraw::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, DrawLayer layer, DrawMeaning meaning) {
  polygons({{a, b, c}, {{0, 1, 2}}, false, false}, layer, meaning);
}

void SvgDraw::text(const Vec3d& at, std::string_view words, DrawLayer, DrawMeaning) {
  words_ += io::text(view_.x(at) + 6, view_.y(at) - 6, 12, std::string(words));
}

void SvgDraw::polygons(const Polygons& shape, DrawLayer layer, DrawMeaning meaning) {
  const Color own = tint_.value_or(color_of(meaning)), color = layer == DrawLayer::casts ? mixed(own, pale, 0.7) : own;
  const char* glass = is_glass(meaning) ? R"( fill-opacity=".3" stroke-opacity=".5")" : "";
  for (const auto& loop : shape.loops) {
    if (loop.size() < 3) {
      const Vec3d &from = shape.points[loop.front()], &to = shape.points[loop.back()];
      faces_.push_back({view_.depth((from + to) * 0.5), false, thin(from, to, hex(color))});
      continue;
    }
    Vec3d normal = face_normal(shape, loop);
    const double facing = dot(normal, view_.toward());
    if (shape.closed && facing <= 0) continue;
    if (facing < 0) normal = -normal;
    Vec3d middle;
    Aabbd box = Aabbd::empty();
    std::string points;
    for (const std::uint32_t i : loop) {
      const Vec3d& p = shape.points[i];
      middle += p / static_cast<double>(loop.size());
      box = merged(box, p);
      points += fmt::format("{:.1f},{:.1f} ", view_.x(p), view_.y(p));
    }
    points.pop_back();
    const std::string fill = hex(color, view_.light(normal));
    // A smooth shape's facets are sealed in their own colour, a polyhedron's edges drawn.
    const std::string stroke = shape.smooth ? fill : hex(color, tint_ ? 0.88 * view_.light(normal) : 0.55);
    faces_.push_back(
        {view_.depth(middle), max_abs(box.extent()) > background_,
         fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"{}/>\n", points, fill, stroke, glass)});
  }
}

std::string SvgDraw::thin(const Vec3d& from, const Vec3d& to, const std::string& color) const {
  return from == to ? dot_at(view_, from, color) : io::line(view_, from, to, color, 2.4, " stroke-linecap=\"round\"");
}

void SvgDraw::arrow(const Vec3d& from, const Vec3d& direction, DrawLayer, DrawMeaning) {
  arrows_ += io::arrow(view_, from, direction);
}

std::string SvgDraw::faces() const {
  std::vector<const Face*> sorted;
  sorted.reserve(faces_.size());
  for (const Face& face : faces_) sorted.push_back(&face);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Face* a, const Face* b) {
    return a->background != b->background ? a->background : a->depth < b->depth;
  });
  std::string out = "<g stroke-width=\".8\" stroke-linejoin=\"round\">\n";
  for (const Face* face : sorted) out += face->text;
  return out + "</g>\n";
}

std::string SvgDraw::over() const {
  return "<g class=\"arrow\" fill=\"none\">\n" + arrows_ + "</g>\n" + lines_ + dots_ + words_;
}

std::string text(double x, double y, double size, const std::string& words, const std::string& look,
                 const char* anchor) {
  const std::string color = look.starts_with('#') ? "fill=\"" + look + '"' : "class=\"" + look + '"';
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" {} text-anchor=\"{}\">{}</text>\n", x, y, size,
                     color, anchor, escaped(words));
}

std::string svg_head(double height) {
  // Colours of paper, ink and lines follow the reader's choice; those of shapes stand out from both.
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<style>\n"
      ".paper{{fill:#f8f9fa}} .ink{{fill:#212529}} .soft{{fill:#495057}} .chosen{{fill:#ffe8cc}} .tip{{fill:#1d3557}}\n"
      ".red{{fill:#c1121f}} .arrow{{stroke:#1d3557}} .rule{{stroke:#adb5bd}} .gap{{stroke:#868e96}} "
      ".shared{{stroke:#c1121f}} .rim{{stroke:#f8f9fa}}\n"
      "@media (prefers-color-scheme:dark){{\n"
      ".paper{{fill:#161b22}} .ink{{fill:#e6edf3}} .soft{{fill:#9aa4af}} .chosen{{fill:#5a3a14}} .tip{{fill:#a5c8ff}}\n"
      ".red{{fill:#ff6b6b}} .arrow{{stroke:#a5c8ff}} .rule{{stroke:#57606a}} .gap{{stroke:#8b949e}} "
      ".shared{{stroke:#ff6b6b}} .rim{{stroke:#161b22}}\n"
      "}}\n</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" rx=\"10\" class=\"paper\"/>\n",
      picture_width, height);
}

}  // namespace graze::io
