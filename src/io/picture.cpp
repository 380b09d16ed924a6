#include "graze/io/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "graze/io/file.hpp"
#include "io/drawing.hpp"

namespace graze::io {

namespace {

constexpr double edge = 40;

constexpr Color fixed_color{206, 211, 218}, moving_color{141, 169, 196}, trigger_color{129, 178, 154},
    touching_color{224, 122, 95};

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
      {"static", fixed_color}, {"moving", moving_color}, {"touching", touching_color}, {"trigger", trigger_color}};
  double x = 24;
  for (const auto& [name, color] : entries) {
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"13\" height=\"13\" rx=\"3\" fill=\"{}\"/><text x=\"{}\" y=\"{}\">{}</text>\n",
        x, picture_height - 30, hex(color, 1), x + 19, picture_height - 18.5, name);
    x += 92;
  }
  return out + fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"#c1121f\"/><text x=\"{}\" y=\"{}\">contact "
                           "point, with its normal</text></g>\n",
                           x + 4, picture_height - 23.5, x + 15, picture_height - 18.5);
}

}  // namespace

std::string draw_picture(const Scene& scene, const std::vector<TouchingPair>& pairs, const Vec3d& direction) {
  const Aabbd box = scene_bounds(scene);
  const double size = std::max(max_abs(box.extent()), least_size);
  std::vector<Vec3d> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i)
    corners.push_back(
        {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z});
  const View view(direction, corners, {edge, edge + 25, picture_width - 2 * edge, picture_height - 2 * edge - 30});
  std::set<std::uint32_t> touching;
  for (const TouchingPair& p : pairs)
    if (p.overlap && !p.trigger) touching.insert({p.a, p.b});

  std::vector<DrawnFace> faces;
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& c = scene.colliders[i];
    const bool fixed = scene.bodies[c.body].type == MotionType::fixed;
    const Color base = c.trigger ? trigger_color : fixed ? fixed_color : moving_color;
    const double part = touching.count(i) == 0 ? 0 : fixed ? 0.25 : 0.75;
    draw_shape(view, tessellate(c.shape, c.pose, box.center(), size), mixed(base, touching_color, part), c.trigger,
               size, faces);
  }
  return svg_head() + painted(std::move(faces)) + draw_contacts(view, pairs) + legend(scene, pairs) + "</svg>\n";
}

void write_picture(const std::filesystem::path& file, const Scene& scene, const std::vector<TouchingPair>& pairs,
                   const Vec3d& direction) {
  if (direction == Vec3d{}) throw InvalidValue("direction", "a direction that is not zero", "0, 0, 0");
  write_file(file, draw_picture(scene, pairs, direction));
}

}  // namespace graze::io
