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

/// The bounds of all bounded shapes; a unit box when there are none.
Aabbd scene_bounds(const Scene& scene) {
  Aabbd all = Aabbd::empty();
  for (const Collider& c : scene.colliders)
    if (const Aabbd box = bounds(c.shape, c.pose); max_abs(box.extent()) < 1e300) all = merged(all, box);
  return all.lower.x <= all.upper.x ? all : Aabbd{{-1, -1, -1}, {1, 1, 1}};
}

/// The kinds of bodies in a picture, by their names in its legend. A body that does not move is tinted a
/// little where it is touched.
constexpr std::pair<DrawMeaning, const char*> legend_names[] = {{DrawMeaning::fixed, "static"},
                                                                {DrawMeaning::touched, "static, touched"},
                                                                {DrawMeaning::moving, "moving"},
                                                                {DrawMeaning::touching, "touching"},
                                                                {DrawMeaning::trigger, "trigger"}};

template <class AnyScene, class AnyCollider>
DrawMeaning meaning_of(const AnyScene& scene, const AnyCollider& collider, bool touching) {
  if (collider.trigger) return DrawMeaning::trigger;
  if (scene.bodies[collider.body].type == MotionType::fixed)
    return touching ? DrawMeaning::touched : DrawMeaning::fixed;
  return touching ? DrawMeaning::touching : DrawMeaning::moving;
}

/// "1 pair", "2 pairs".
std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The title, and below the looks that are in the picture.
template <class AnyScene>
std::string legend(const AnyScene& scene, const std::vector<TouchingPair>& pairs, const std::set<DrawMeaning>& used) {
  std::string out = "<g font-family=\"system-ui, sans-serif\">\n" +
                    text(24, 32, 17,
                         fmt::format("{}: {}, {} in contact", scene.source, counted(scene.colliders.size(), "collider"),
                                     counted(count_in_contact(pairs), "pair")));
  double x = 24;
  for (const auto& [meaning, called] : legend_names) {
    if (used.count(meaning) == 0) continue;
    const std::string name = called;
    out += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"13\" height=\"13\" rx=\"3\" fill=\"{}\"/>\n", x,
                       picture_height - 30, hex(color_of(meaning)));
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

/// Draws the colliders of a scene, of space or of the plane, and the contacts of those that overlap.
template <class AnyScene>
std::string draw_on(const View& view, const AnyScene& scene, const Aabbd& box, const std::vector<TouchingPair>& pairs) {
  const double size = std::max(max_abs(box.extent()), least_size);
  SvgDraw canvas(view, {box.center(), size}, 0.45 * size);
  const std::set<std::uint32_t> touching = touching_colliders(pairs);
  std::set<DrawMeaning> used;
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const auto& collider = scene.colliders[i];
    const DrawMeaning meaning = meaning_of(scene, collider, touching.count(i) != 0);
    used.insert(meaning);
    draw(canvas, collider.shape, collider.pose, meaning);
  }
  for (const TouchingPair& pair : pairs)
    if (!pair.trigger && pair.overlap)
      for (const auto& manifold : pair.manifolds) draw(canvas, manifold);
  return svg_head() + canvas.faces() + canvas.over() + legend(scene, pairs, used) + "</svg>\n";
}

}  // namespace

std::string draw_picture(const Scene& scene, const std::vector<TouchingPair>& pairs, const Vec3d& direction) {
  const Aabbd box = scene_bounds(scene);
  std::vector<Vec3d> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i)
    corners.push_back(
        {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y, i & 4 ? box.upper.z : box.lower.z});
  return draw_on(View(direction, corners, scene_panel), scene, box, pairs);
}

std::string draw_picture(const PlaneScene& scene, const std::vector<TouchingPair>& pairs) {
  Aabbd box = Aabbd::empty();
  for (const PlaneCollider& c : scene.colliders)
    if (const Aabbd of = plane_bounds(c.shape, c.pose); max_abs(of.extent()) < 1e300) box = merged(box, of);
  if (!(box.lower.x <= box.upper.x)) box = {{-1, -1, 0}, {1, 1, 0}};
  return draw_on(View({0, 0, 1}, {box.lower, box.upper}, scene_panel), scene, box, pairs);
}

void write_picture(const std::filesystem::path& file, const Scene& scene, const std::vector<TouchingPair>& pairs,
                   const Vec3d& direction) {
  if (direction == Vec3d{}) throw InvalidValue("direction", "a direction that is not zero", "0, 0, 0");
  write_file(file, draw_picture(scene, pairs, direction));
}

}  // namespace graze::io
