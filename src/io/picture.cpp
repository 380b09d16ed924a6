#include "graze/io/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>

#include "graze/io/tessellate.hpp"

namespace graze::io {

namespace {

constexpr double width = 960, height = 600, edge = 40;

using Color = std::array<double, 3>;
constexpr Color still{206, 211, 218}, moving{141, 169, 196}, trigger{129, 178, 154}, tint{224, 122, 95};

Color mixed(const Color& a, const Color& b, double part) {
  Color c{};
  for (std::size_t i = 0; i < 3; ++i) c[i] = a[i] + (b[i] - a[i]) * part;
  return c;
}

std::string hex(const Color& c, double light) {
  const auto part = [&](std::size_t i) { return static_cast<int>(std::clamp(c[i] * light, 0.0, 255.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

/// The world as seen from a direction, fitted into the picture.
class View {
 public:
  View(const Vec3d& direction, const Aabbd& box) : toward_(normalized(direction)) {
    const Vec3d up = std::abs(toward_.y) > 0.999 ? Vec3d{0, 0, -1} : Vec3d{0, 1, 0};
    right_ = normalized(cross(up, toward_));
    up_ = cross(toward_, right_);
    double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
    for (int i = 0; i < 8; ++i) {
      const Vec3d p{i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                    i & 4 ? box.upper.z : box.lower.z};
      low_x = std::min(low_x, dot(p, right_)), high_x = std::max(high_x, dot(p, right_));
      low_y = std::min(low_y, dot(p, up_)), high_y = std::max(high_y, dot(p, up_));
    }
    const double wide = std::max(high_x - low_x, 1e-300), tall = std::max(high_y - low_y, 1e-300);
    scale_ = std::min((width - 2 * edge) / wide, (height - 2 * edge - 30) / tall);
    x_ = width / 2 - scale_ * (low_x + high_x) / 2;
    y_ = height / 2 + scale_ * (low_y + high_y) / 2 + 10;
  }

  double x(const Vec3d& p) const { return x_ + scale_ * dot(p, right_); }
  double y(const Vec3d& p) const { return y_ - scale_ * dot(p, up_); }
  double depth(const Vec3d& p) const { return dot(p, toward_); }
  const Vec3d& toward() const { return toward_; }
  /// Lights from above, a little to the left of the viewer.
  double light(const Vec3d& normal) const {
    const Vec3d lamp = normalized(toward_ + up_ * 1.2 - right_ * 0.6);
    return 0.62 + 0.42 * std::max(0.0, dot(normal, lamp));
  }
  double scale() const { return scale_; }

 private:
  Vec3d toward_, right_, up_;
  double scale_ = 1, x_ = 0, y_ = 0;
};

struct DrawnFace {
  double depth;
  bool background;  ///< so large that the middle says nothing about what it hides
  std::string text;
};

Vec3d face_normal(const Polygons& shape, const std::vector<std::uint32_t>& loop) {
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(shape.points[loop[i]] - shape.points[loop[0]], shape.points[loop[i + 1]] - shape.points[loop[0]]);
  return normalized(sum, Vec3d{});
}

void draw_shape(const View& view, const Polygons& shape, const Color& color, bool glass, double scene_size,
                std::vector<DrawnFace>& faces) {
  for (const auto& loop : shape.loops) {
    Vec3d normal = face_normal(shape, loop);
    const double facing = dot(normal, view.toward());
    if (shape.closed && facing <= 0) continue;
    if (facing < 0) normal = -normal;
    Vec3d middle;
    Aabbd box = Aabbd::empty();
    std::string points;
    for (const std::uint32_t i : loop) {
      const Vec3d& p = shape.points[i];
      middle += p / static_cast<double>(loop.size());
      box = merged(box, p);
      points += fmt::format("{:.1f},{:.1f} ", view.x(p), view.y(p));
    }
    points.pop_back();
    const std::string fill = hex(color, view.light(normal));
    // A smooth shape's facets are sealed in their own colour, a polyhedron's edges drawn.
    const std::string stroke = shape.smooth ? fill : hex(color, 0.55);
    faces.push_back({view.depth(middle), max_abs(box.extent()) > 0.45 * scene_size,
                     fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"{}/>\n", points, fill, stroke,
                                 glass ? " fill-opacity=\".3\" stroke-opacity=\".5\"" : "")});
  }
}

std::string arrow(const View& view, const Vec3d& from, const Vec3d& along) {
  const Vec3d to = from + along * (34 / view.scale());
  const double dx = view.x(to) - view.x(from), dy = view.y(to) - view.y(from), l = std::hypot(dx, dy);
  if (l < 1) return "";
  const double ux = dx / l, uy = dy / l, x = view.x(to), y = view.y(to);
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke-width=\"1.8\"/><path d=\"M{:.1f} {:.1f}L{:.1f} "
                     "{:.1f}L{:.1f} {:.1f}Z\" "
                     "fill=\"#1d3557\"/>\n",
                     view.x(from), view.y(from), x - 4 * ux, y - 4 * uy, x + 2 * ux, y + 2 * uy, x - 7 * ux - 3.5 * uy,
                     y - 7 * uy + 3.5 * ux, x - 7 * ux + 3.5 * uy, y - 7 * uy - 3.5 * ux);
}

/// Contacts of what overlaps: an arrow a manifold, from the middle of its points, and a dot a point.
std::string draw_contacts(const View& view, const std::vector<TouchingPair>& pairs) {
  std::string arrows, dots;
  for (const TouchingPair& pair : pairs) {
    if (pair.trigger || !pair.overlap) continue;
    for (const auto& m : pair.manifolds) {
      Vec3d middle;
      for (const auto& p : m.points) {
        middle += p.position() / static_cast<double>(m.points.size());
        dots +=
            fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>\n", view.x(p.position()), view.y(p.position()));
      }
      arrows += arrow(view, middle, m.normal);
    }
  }
  return "<g stroke=\"#1d3557\" fill=\"none\">\n" + arrows +
         "</g>\n<g fill=\"#c1121f\" stroke=\"#fff\" stroke-width=\".8\">\n" + dots + "</g>\n";
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

/// The bounds of all that is bounded; a unit box when nothing is.
Aabbd scene_bounds(const Scene& scene) {
  Aabbd all = Aabbd::empty();
  for (const Collider& c : scene.colliders)
    if (const Aabbd box = bounds(c.shape, c.pose); max_abs(box.extent()) < 1e300) all = merged(all, box);
  return all.lower.x <= all.upper.x ? all : Aabbd{{-1, -1, -1}, {1, 1, 1}};
}

std::string legend(const Scene& scene, const std::vector<TouchingPair>& pairs) {
  std::string out = fmt::format("<g font-family=\"system-ui, sans-serif\" font-size=\"14\" fill=\"#495057\"><text "
                                "x=\"24\" y=\"32\" font-size=\"17\" "
                                "fill=\"#212529\">{}: {} colliders, {} pairs in contact</text>\n",
                                escaped(scene.source), scene.colliders.size(), pairs.size());
  const std::pair<const char*, Color> entries[] = {
      {"static", still}, {"moving", moving}, {"touching", tint}, {"trigger", trigger}};
  double x = 24;
  for (const auto& [name, color] : entries) {
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"13\" height=\"13\" rx=\"3\" fill=\"{}\"/><text x=\"{}\" y=\"{}\">{}</text>\n",
        x, height - 30, hex(color, 1), x + 19, height - 18.5, name);
    x += 92;
  }
  return out + fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"#c1121f\"/><text x=\"{}\" y=\"{}\">contact "
                           "point, with its normal</text></g>\n",
                           x + 4, height - 23.5, x + 15, height - 18.5);
}

}  // namespace

std::string draw_picture(const Scene& scene, const std::vector<TouchingPair>& pairs, const Vec3d& direction) {
  const Aabbd box = scene_bounds(scene);
  const double size = std::max(max_abs(box.extent()), 1e-300);
  const View view(direction, box);
  std::set<std::uint32_t> touching;
  for (const TouchingPair& p : pairs)
    if (p.overlap && !p.trigger) touching.insert({p.a, p.b});

  std::vector<DrawnFace> faces;
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& c = scene.colliders[i];
    const bool fixed = scene.bodies[c.body].type == MotionType::fixed;
    const Color base = c.trigger ? trigger : fixed ? still : moving;
    const double part = touching.count(i) == 0 ? 0 : fixed ? 0.25 : 0.75;
    draw_shape(view, tessellate(c.shape, c.pose, box.center(), size), mixed(base, tint, part), c.trigger, size, faces);
  }
  std::stable_sort(faces.begin(), faces.end(), [](const DrawnFace& a, const DrawnFace& b) {
    return a.background != b.background ? a.background : a.depth < b.depth;
  });

  std::string out =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
                  "<rect width=\"{0}\" height=\"{1}\" rx=\"10\" fill=\"#f8f9fa\"/>\n<g stroke-width=\".8\" "
                  "stroke-linejoin=\"round\">\n",
                  width, height);
  for (const DrawnFace& face : faces) out += face.text;
  return out + "</g>\n" + draw_contacts(view, pairs) + legend(scene, pairs) + "</svg>\n";
}

void write_picture(const std::filesystem::path& file, const Scene& scene, const std::vector<TouchingPair>& pairs,
                   const Vec3d& direction) {
  if (direction == Vec3d{}) throw InvalidValue("direction", "a direction that is not zero", "0, 0, 0");
  std::ofstream out(file, std::ios::binary);
  out << draw_picture(scene, pairs, direction);
  out.close();
  if (!out) throw InvalidValue(file.string(), "a file that can be written", "an error");
}

}  // namespace graze::io
