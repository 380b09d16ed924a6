#include "graze/io/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "graze/io/file.hpp"
#include "graze/io/plane_scene.hpp"
#include "io/drawing.hpp"
#include "io/plane_shapes.hpp"

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
  return "<g class=\"arrow\" fill=\"none\">\n" + arrows + "</g>\n<g class=\"red rim\" stroke-width=\".8\">\n" + dots +
         "</g>\n";
}

/// The bounds of all that is bounded; a unit box when nothing is.
Aabbd scene_bounds(const Scene& scene) {
  Aabbd all = Aabbd::empty();
  for (const Collider& c : scene.colliders)
    if (const Aabbd box = bounds(c.shape, c.pose); max_abs(box.extent()) < 1e300) all = merged(all, box);
  return all.lower.x <= all.upper.x ? all : Aabbd{{-1, -1, -1}, {1, 1, 1}};
}

/// What a collider is drawn as. A body that does not move is tinted a little where it is touched.
struct Tint {
  const char* name;
  Color color;
};
constexpr Tint looks[] = {{"static", fixed_color},
                          {"static, touched", mixed(fixed_color, touching_color, 0.25)},
                          {"moving", moving_color},
                          {"touching", mixed(moving_color, touching_color, 0.75)},
                          {"trigger", trigger_color}};

template <class AnyScene, class AnyCollider>
std::size_t look_of(const AnyScene& scene, const AnyCollider& collider, bool touching) {
  if (collider.trigger) return 4;
  const bool fixed = scene.bodies[collider.body].type == MotionType::fixed;
  return (fixed ? 0u : 2u) + (touching ? 1u : 0u);
}

/// "1 pair", "2 pairs".
std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The title, and below the looks that are in the picture.
template <class AnyScene>
std::string legend(const AnyScene& scene, const std::vector<TouchingPair>& pairs, const std::set<std::size_t>& used) {
  std::string out = "<g font-family=\"system-ui, sans-serif\">\n" +
                    text(24, 32, 17,
                         fmt::format("{}: {}, {} in contact", scene.source, counted(scene.colliders.size(), "collider"),
                                     counted(pairs.size(), "pair")));
  double x = 24;
  for (const std::size_t i : used) {
    const std::string name = looks[i].name;
    out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"13\" height=\"13\" rx=\"3\" fill=\"{}\"/>\n", x,
                       picture_height - 30, hex(looks[i].color));
    out += text(x + 19, picture_height - 18.5, 14, name, "soft");
    x += 46 + 7.5 * static_cast<double>(name.size());
  }
  const bool points =
      std::any_of(pairs.begin(), pairs.end(), [](const TouchingPair& p) { return p.overlap && !p.trigger; });
  if (points)
    out += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" class=\"red\"/>\n", x + 4, picture_height - 23.5) +
           text(x + 15, picture_height - 18.5, 14, "contact point, with its normal", "soft");
  return out + "</g>\n";
}

/// The numbers of the colliders that touch others.
std::set<std::uint32_t> touching_colliders(const std::vector<TouchingPair>& pairs) {
  std::set<std::uint32_t> touching;
  for (const TouchingPair& p : pairs)
    if (p.overlap && !p.trigger) touching.insert({p.a, p.b});
  return touching;
}

constexpr Panel scene_panel{edge, edge + 25, picture_width - 2 * edge, picture_height - 2 * edge - 30};

}  // namespace

std::string draw_picture(const Scene& scene, const std::vector<TouchingPair>& pairs, const Vec3d& direction) {
  const Aabbd box = scene_bounds(scene);
  const double size = std::max(max_abs(box.extent()), least_size);
  std::vector<Vec3d> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i)
    corners.push_back(
        {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z});
  const View view(direction, corners, scene_panel);
  const std::set<std::uint32_t> touching = touching_colliders(pairs);
  std::vector<DrawnFace> faces;
  std::set<std::size_t> used;
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& c = scene.colliders[i];
    const std::size_t look = look_of(scene, c, touching.count(i) != 0);
    used.insert(look);
    draw_shape(view, tessellate(c.shape, c.pose, box.center(), size), looks[look].color, c.trigger, size, faces);
  }
  return svg_head() + painted(std::move(faces)) + draw_contacts(view, pairs) + legend(scene, pairs, used) + "</svg>\n";
}

std::string draw_picture(const PlaneScene& scene, const std::vector<TouchingPair>& pairs) {
  Aabbd box = Aabbd::empty();
  for (const PlaneCollider& c : scene.colliders)
    if (const Aabbd of = plane_bounds(c.shape, c.pose); max_abs(of.extent()) < 1e300) box = merged(box, of);
  if (!(box.lower.x <= box.upper.x)) box = {{-1, -1, 0}, {1, 1, 0}};
  const double size = std::max(max_abs(box.extent()), least_size);
  const View view({0, 0, 1}, {box.lower, box.upper}, scene_panel);
  const std::set<std::uint32_t> touching = touching_colliders(pairs);
  std::vector<DrawnFace> faces;
  std::set<std::size_t> used;
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const PlaneCollider& c = scene.colliders[i];
    const std::size_t look = look_of(scene, c, touching.count(i) != 0);
    used.insert(look);
    draw_shape(view, tessellate(c.shape, c.pose, box.center(), size), looks[look].color, c.trigger, 1e300, faces);
  }
  return svg_head() + painted(std::move(faces)) + draw_contacts(view, pairs) + legend(scene, pairs, used) + "</svg>\n";
}

void write_picture(const std::filesystem::path& file, const Scene& scene, const std::vector<TouchingPair>& pairs,
                   const Vec3d& direction) {
  if (direction == Vec3d{}) throw InvalidValue("direction", "a direction that is not zero", "0, 0, 0");
  write_file(file, draw_picture(scene, pairs, direction));
}

}  // namespace graze::io
