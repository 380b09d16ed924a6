// The scenes: what many engines of the plane are measured by, with this library's own measures. A pyramid, many of
// them, a net of hinges, a drum, a heap that is shot at, a paddle in a ring, and a rain of people.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "plane_scene.hpp"

namespace graze::plane {

std::size_t Scene::add(SceneBody body) {
  bodies.push_back(std::move(body));
  return bodies.size() - 1;
}

namespace {

constexpr double pi = std::numbers::pi;

SceneBody fixed(Shape<double> shape, const Pose2d& pose) {
  SceneBody body{{std::move(shape), pose}};
  body.body.fixed = true;
  return body;
}

Box<double> box(double width, double height) { return Box<double>({width, height}); }

/// A floor with its top at `top`.
SceneBody floor_at(double top, double width, double thickness) {
  return fixed(box(width, thickness), {{0, top - thickness / 2}, {}});
}

/// How many, at least two.
std::size_t scaled(double scale, double count) {
  return static_cast<std::size_t>(std::max(2.0, std::round(scale * count)));
}

/// Boxes of 1 m, those of a row 5 cm apart, each on two of the row below.
void add_pyramid(Scene& scene, std::size_t base, const Vec2d& middle) {
  constexpr double gap = 0.05;
  for (std::size_t row = 0; row < base; ++row)
    for (std::size_t i = 0; i + row < base; ++i) {
      const Vec2d center{(double(i) - 0.5 * double(base - row - 1)) * (1 + gap), 0.5 + double(row)};
      scene.add({{box(1, 1), {middle + center, {}}}});
    }
}

Scene pyramid(double scale) {
  const std::size_t base = scaled(scale, 100);
  Scene scene{"pyramid", "one of base " + std::to_string(base), 600};
  scene.add(floor_at(0, 4 * double(base), 2 * double(base)));
  add_pyramid(scene, base, {0, 0});
  return scene;
}

Scene many_pyramids(double scale) {
  constexpr std::size_t base = 10;
  const std::size_t side = scaled(scale, 20);
  Scene scene{"pyramids", std::to_string(side * side) + " of base 10, on as many floors as stand side by side", 200};
  for (std::size_t row = 0; row < side; ++row) {
    const double top = double(row) * (base + 3), apart = base + 4;
    scene.add(floor_at(top, double(side + 2) * apart, 1));
    for (std::size_t column = 0; column < side; ++column)
      add_pyramid(scene, base, {(double(column) - 0.5 * double(side - 1)) * apart, top});
  }
  return scene;
}

/// Discs side by side that touch nothing, each hinged to its neighbours; some in the middle of the top row are fixed.
Scene net(double scale) {
  const std::size_t side = scaled(scale, 100), first = side / 2 - std::min<std::size_t>(3, side / 2),
                    last = side / 2 + 3;
  Scene scene{"net", "discs and the hinges between them", 300};
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column) {
      SceneBody disc{{Circle<double>(0.4), {{double(column), -double(row)}, {}}}};
      disc.body.filter.group = -1;
      disc.body.fixed = row == 0 && first <= column && column <= last;
      const std::size_t at = scene.add(disc);
      if (column > 0) scene.hinges.push_back({at - 1, at, {double(column) - 0.5, -double(row)}});
      if (row > 0) scene.hinges.push_back({at - side, at, {double(column), 0.5 - double(row)}});
    }
  return scene;
}

/// Small boxes in a square drum that turns.
Scene drum(double scale) {
  const std::size_t side = scaled(scale, 45);
  const double half = std::max(2.0, 0.22 * double(side)), size = 0.25, thickness = 1;
  Scene scene{"drum", "boxes in one that turns", 600};
  const auto wall = [&](const Vec2d& at, double width, double height) {
    return Placed<double>{box(width, height), {at, {}}};
  };
  const double long_side = 2 * half + 2 * thickness, off = half + thickness / 2;
  SceneBody walls{{Compound<double>({wall({-off, 0}, thickness, long_side), wall({off, 0}, thickness, long_side),
                                     wall({0, -off}, long_side, thickness), wall({0, off}, long_side, thickness)})}};
  walls.kinematic = true;
  walls.body.angular = 25 * pi / 180;
  scene.add(walls);
  const double apart = 1.2 * size;
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column)
      scene.add({{box(size, size),
                  {{(double(column) - 0.5 * double(side - 1)) * apart, (double(row) - 0.5 * double(side - 1)) * apart},
                   {}}}});
  return scene;
}

/// A wall of small boxes without gravity, and a large heavy one that flies into it.
Scene smash(double scale) {
  const std::size_t rows = scaled(scale, 80), columns = scaled(scale, 120);
  const double size = 0.4, large = 0.25 * size * double(rows);
  Scene scene{"smash", "boxes, and a large one that flies into them", 300, {}, {}, {0, 0}};
  SceneBody hammer{{box(large, large), {{-large, 0}, {}}, {40, 0}}};
  hammer.density = 8000;
  scene.add(hammer);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      scene.add(
          {{box(size, size), {{(double(column) + 1) * size, (double(row) - 0.5 * double(rows - 1)) * size}, {}}}});
  return scene;
}

/// Discs, boxes and pentagons in a ring of fixed boxes, which a long box stirs that turns.
Scene stir(double scale) {
  const std::size_t side = scaled(scale, 55), sides = 120;
  const double size = 0.5, radius = std::max(4.0, 0.73 * double(side)), thickness = 2;
  Scene scene{"stir", "discs, boxes and pentagons in a ring, stirred", 600};
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * pi * double(i) / double(sides), off = radius + thickness / 2;
    const double width = 2 * (radius + thickness) * std::tan(pi / double(sides));
    scene.add(fixed(box(thickness, width), {{off * std::cos(angle), off * std::sin(angle)}, Rot2d::from_angle(angle)}));
  }
  SceneBody paddle{{box(1.8 * radius, 0.8)}};
  paddle.kinematic = true;
  paddle.body.angular = 0.5;
  scene.add(paddle);
  std::vector<Vec2d> corners;
  for (int i = 0; i < 5; ++i)
    corners.push_back({size / 2 * std::cos(0.4 * pi * double(i)), size / 2 * std::sin(0.4 * pi * double(i))});
  const Shape<double> kinds[] = {Circle<double>(size / 2), box(size, size), ConvexPolygon<double>(corners)};
  const double apart = 1.15 * size;
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column) {
      const double y = (double(row / 2) + 1.5) * apart * (row % 2 == 0 ? 1 : -1);
      scene.add({{kinds[(row + column) % 3], {{(double(column) - 0.5 * double(side - 1)) * apart, y}, {}}}});
    }
  return scene;
}

/// A person of eleven boxes and ten hinges, from the feet up. No part of a person touches another one of it.
void add_person(Scene& scene, const Vec2d& feet, int group) {
  struct Part {
    int onto;  ///< the part that it hangs on
    double width, height;
    Vec2d center, hinge;
    double least, most;
  };
  static const Part parts[] = {
      {-1, 0.28, 0.20, {0, 0.92}, {}, 0, 0},                     // hips
      {0, 0.30, 0.44, {0, 1.24}, {0, 1.02}, -0.4, 0.6},          // chest
      {1, 0.18, 0.24, {0, 1.58}, {0, 1.46}, -0.5, 0.5},          // head
      {0, 0.15, 0.44, {-0.07, 0.62}, {-0.07, 0.84}, -0.6, 1.6},  // thighs
      {0, 0.15, 0.44, {0.07, 0.62}, {0.07, 0.84}, -0.6, 1.6},    //
      {3, 0.12, 0.40, {-0.07, 0.20}, {-0.07, 0.40}, -2.0, 0.1},  // shins
      {4, 0.12, 0.40, {0.07, 0.20}, {0.07, 0.40}, -2.0, 0.1},    //
      {1, 0.10, 0.32, {-0.16, 1.24}, {-0.16, 1.40}, -1.5, 2.5},  // arms
      {1, 0.10, 0.32, {0.16, 1.24}, {0.16, 1.40}, -1.5, 2.5},    //
      {7, 0.09, 0.28, {-0.16, 0.94}, {-0.16, 1.08}, -0.1, 2.2},  // forearms
      {8, 0.09, 0.28, {0.16, 0.94}, {0.16, 1.08}, -0.1, 2.2},    //
  };
  const std::size_t first = scene.bodies.size();
  for (const Part& part : parts) {
    SceneBody body{{box(part.width, part.height), {feet + part.center, {}}}};
    body.body.filter.group = -group;
    const std::size_t at = scene.add(body);
    if (part.onto >= 0)
      scene.hinges.push_back({first + std::size_t(part.onto), at, feet + part.hinge, part.least, part.most});
  }
}

Scene rain(double scale) {
  const std::size_t side = scaled(scale, 15);
  Scene scene{"rain", std::to_string(side * side) + " people of eleven boxes that fall on steps", 400};
  for (std::size_t i = 0; i < side; ++i)
    scene.add(fixed(box(2, 0.6 * double(i % 3) + 0.4), {{2 * (double(i) - 0.5 * double(side - 1)), 0}, {}}));
  scene.add(floor_at(-0.1, 8 * double(side), 4));
  int group = 0;
  for (std::size_t row = 0; row < side; ++row)
    for (std::size_t column = 0; column < side; ++column)
      add_person(scene,
                 {1.1 * (double(column) - 0.5 * double(side - 1)) + 0.2 * double(row % 3), 2 + 2.2 * double(row)},
                 ++group);
  return scene;
}

}  // namespace

std::vector<Scene> played_scenes(double scale) {
  return {pyramid(scale), many_pyramids(scale), net(scale), drum(scale), smash(scale), stir(scale), rain(scale)};
}

}  // namespace graze::plane
