// Bodies that lie on flat floors made of pieces, in a world, and how often the seams are felt.
//
// A floor is the plane y = 0 within 5 of the origin, in the frame where it stands: a mesh, a height field, a compound,
// or many fixed bodies. A body lies on it 0.5 to 20 mm deep, on a face or anyhow, in one of two poses just over a seam,
// so that the least way out of a piece leads sideways. Its normals have to be the floor's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <type_traits>
#include <vector>

#include "graze/world.hpp"

namespace graze::slides {

inline constexpr int reach = 5;            ///< floors go so far from the origin, in x and z
inline constexpr double most_lean = 1e-3;  ///< of a normal, in radians: more is wrong

using Random = std::mt19937_64;
inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

template <class T>
using Bodies = std::vector<Placed<T>>;

/// Triangles that share corners where they are given the same.
template <class T>
struct Sheet {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;

  std::uint32_t point(double x, double z, double y = 0) {
    points.push_back({T(x), T(y), T(z)});
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  /// A triangle with corners of its own, counter-clockwise seen from above.
  void add(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c) {
    const std::uint32_t i = point(a[0], a[1]), j = point(b[0], b[1]), k = point(c[0], c[1]);
    triangles.push_back({i, j, k});
  }
  Shape<T> mesh(Sides sides = Sides::both) const { return Mesh<T>(points, triangles, sides); }
};

/// Squares between the given lines, each cut in two.
template <class T>
Sheet<T> grid(const std::vector<double>& lines) {
  Sheet<T> sheet;
  for (const double z : lines)
    for (const double x : lines) sheet.point(x, z);
  const auto n = static_cast<std::uint32_t>(lines.size());
  for (std::uint32_t j = 0; j + 1 < n; ++j)
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t a = j * n + i, b = a + 1, c = a + n, d = c + 1;
      sheet.triangles.push_back({a, d, b});
      sheet.triangles.push_back({a, c, d});
    }
  return sheet;
}
inline std::vector<double> even_lines(double cell) {
  std::vector<double> lines;
  for (double x = -reach; x < reach + cell / 2; x += cell) lines.push_back(x);
  return lines;
}
/// Whole numbers, and beside each a line as near as a refining tool leaves one.
inline std::vector<double> sliver_lines() {
  std::vector<double> lines;
  for (int i = -reach; i <= reach; ++i) {
    lines.push_back(i);
    lines.push_back(i + 0.01 * std::pow(0.3, (i + reach) % 6));
  }
  return lines;
}

template <class T>
Shape<T> soup(Random& random) {
  Sheet<T> sheet;
  for (int x = -reach; x < reach; ++x)
    for (int z = -reach; z < reach; ++z) {
      const double a = x, b = x + 1, c = z, d = z + 1;
      if (random() % 2 == 0)
        sheet.add({a, c}, {b, d}, {b, c}), sheet.add({a, c}, {a, d}, {b, d});
      else
        sheet.add({a, c}, {a, d}, {b, c}), sheet.add({b, c}, {a, d}, {b, d});
    }
  return sheet.mesh();
}
/// Corners anywhere along the edges of neighbours.
template <class T>
Shape<T> t_junctions(Random& random) {
  Sheet<T> sheet;
  for (int x = -reach; x < reach; ++x) {
    double z = -reach, w = -reach;
    while (z < reach || w < reach) {
      const double step = uniform(random, 0.3, 2);
      if (z <= w)
        sheet.add({double(x), z}, {double(x), z + step}, {x + 1.0, w}), z += step;
      else
        sheet.add({x + 1.0, w}, {double(x), z}, {x + 1.0, w + step}), w += step;
    }
  }
  return sheet.mesh();
}
/// Squares of sixteen triangles about their middle.
template <class T>
Shape<T> fans() {
  Sheet<T> sheet;
  for (int x = -reach; x < reach; x += 2)
    for (int z = -reach; z < reach; z += 2) {
      std::vector<std::array<double, 2>> rim;
      for (int i = 0; i < 4; ++i) rim.push_back({x + i * 0.5, double(z)});
      for (int i = 0; i < 4; ++i) rim.push_back({x + 2.0, z + i * 0.5});
      for (int i = 0; i < 4; ++i) rim.push_back({x + 2 - i * 0.5, z + 2.0});
      for (int i = 0; i < 4; ++i) rim.push_back({double(x), z + 2 - i * 0.5});
      for (std::size_t i = 0; i < rim.size(); ++i) sheet.add({x + 1.0, z + 1.0}, rim[(i + 1) % rim.size()], rim[i]);
    }
  return sheet.mesh();
}
template <class T>
Shape<T> doubled() {
  Sheet<T> sheet = grid<T>(even_lines(1));
  const std::vector<typename Mesh<T>::Index> once = sheet.triangles;
  sheet.triangles.insert(sheet.triangles.end(), once.begin(), once.end());
  return sheet.mesh();
}

// Tiles two units wide, their surface at y = 0.
template <class T>
Shape<T> block() {
  return Box<T>({2, 1, 2});
}
template <class T>
Shape<T> pyramid() {
  return ConvexHull<T>(
      std::vector<Vec3<T>>{{-1, T(0.5), -1}, {1, T(0.5), -1}, {1, T(0.5), 1}, {-1, T(0.5), 1}, {0, -1, 0}});
}
template <class T>
Shape<T> flat_hull() {
  return ConvexHull<T>(std::vector<Vec3<T>>{{-1, T(0.5), -1}, {1, T(0.5), -1}, {1, T(0.5), 1}, {-1, T(0.5), 1}});
}
template <class T>
Shape<T> plate() {
  return Compound<T>({{Rectangle<T>(2, 2), {{0, T(0.5), 0}, {}}}});
}
/// A box of triangles, given by half its sides.
template <class T>
Shape<T> closed_mesh(const Vec3<T>& half) {
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 8; ++i)
    points.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  return Mesh<T>(std::move(points), {{0, 4, 6},
                                     {0, 6, 2},
                                     {1, 3, 7},
                                     {1, 7, 5},
                                     {0, 1, 5},
                                     {0, 5, 4},
                                     {2, 6, 7},
                                     {2, 7, 3},
                                     {0, 2, 3},
                                     {0, 3, 1},
                                     {4, 5, 7},
                                     {4, 7, 6}});
}
template <class T>
Shape<T> closed_block() {
  return closed_mesh<T>({1, T(0.5), 1});
}
template <class T>
Shape<T> patch() {
  return Mesh<T>({{-1, T(0.5), -1}, {-1, T(0.5), 1}, {1, T(0.5), 1}, {1, T(0.5), -1}}, {{0, 1, 2}, {0, 2, 3}});
}
template <class T>
Shape<T> field_patch() {
  return HeightField<T>(5, 5, std::vector<T>(25, T(0.5)), T(0.5), T(0.5));
}
template <class T>
Shape<T> triangle_patch() {
  return Compound<T>({{Triangle<T>({-1, T(0.5), -1}, {-1, T(0.5), 1}, {1, T(0.5), 1}), {}},
                      {Triangle<T>({-1, T(0.5), -1}, {1, T(0.5), 1}, {1, T(0.5), -1}), {}}});
}

template <class T>
using Tile = Shape<T> (*)();

/// Six by six tiles of the kinds by turns, at a height.
template <class T>
Bodies<T> tiles(const std::vector<Tile<T>>& kinds, double height = -0.5) {
  Bodies<T> all;
  for (int i = -3; i < 3; ++i)
    for (int j = -3; j < 3; ++j)
      all.push_back({kinds[static_cast<std::size_t>(i + 3 + (j + 3) * 5) % kinds.size()](),
                     {{T(2 * i + 1), T(height), T(2 * j + 1)}, {}}});
  return all;
}
/// Blocks that are turned about the vertical by multiples of 30 degrees, and large enough to overlap.
template <class T>
Bodies<T> yawed_blocks() {
  Bodies<T> all;
  for (int i = -3; i < 3; ++i)
    for (int j = -3; j < 3; ++j) {
      const T angle = static_cast<T>((i + 2 * j + 9) % 12) * std::numbers::pi_v<T> / T(6);
      all.push_back(
          {Box<T>({3, 1, 3}), {{T(2 * i + 1), T(-0.5), T(2 * j + 1)}, Quat<T>::from_axis_angle({0, 1, 0}, angle)}});
    }
  return all;
}
template <class T>
Bodies<T> with_ground(Bodies<T> bodies) {
  bodies.push_back({HalfSpace<T>(), {}});
  return bodies;
}
template <class T>
Bodies<T> as_one(Bodies<T> bodies) {
  return {{Compound<T>(std::move(bodies)), {}}};
}
template <class T>
Bodies<T> alone(Shape<T> shape) {
  return {{std::move(shape), {}}};
}

template <class T>
struct Floor {
  const char* name;
  Bodies<T> bodies;
};
template <class T>
std::vector<Floor<T>> floors(Random& random) {
  const std::vector<T> level(21 * 21, T(0));
  const std::vector<Tile<T>> mixed{block<T>,     plate<T>,        pyramid<T>,    patch<T>,
                                   flat_hull<T>, closed_block<T>, field_patch<T>};
  return {{"mesh, cells of 1", alone(grid<T>(even_lines(1)).mesh())},
          {"mesh, cells of 0.25", alone(grid<T>(even_lines(0.25)).mesh())},
          {"mesh, front alone", alone(grid<T>(even_lines(1)).mesh(Sides::front))},
          {"mesh of slivers", alone(grid<T>(sliver_lines()).mesh())},
          {"triangles without shared corners", alone(soup<T>(random))},
          {"T-junctions", alone(t_junctions<T>(random))},
          {"fans", alone(fans<T>())},
          {"doubled triangles", alone(doubled<T>())},
          {"height field", alone(Shape<T>(HeightField<T>(21, 21, level, T(0.5), T(0.5))))},
          {"children: blocks", as_one(tiles<T>({block<T>}))},
          {"children: pyramids", as_one(tiles<T>({pyramid<T>}))},
          {"children: rectangles", as_one(tiles<T>({plate<T>}))},
          {"children: flat hulls", as_one(tiles<T>({flat_hull<T>}))},
          {"children: closed meshes", as_one(tiles<T>({closed_block<T>}))},
          {"children: triangles", as_one(tiles<T>({triangle_patch<T>}))},
          {"children of all kinds", as_one(tiles<T>(mixed))},
          {"children: blocks that overlap, yawed", as_one(yawed_blocks<T>())},
          {"bodies: blocks", tiles<T>({block<T>})},
          {"bodies: rectangles", tiles<T>({plate<T>})},
          {"bodies: flat hulls", tiles<T>({flat_hull<T>})},
          {"bodies: meshes", tiles<T>({patch<T>})},
          {"bodies: closed meshes", tiles<T>({closed_block<T>})},
          {"bodies of all kinds", tiles<T>(mixed)},
          {"bodies: blocks that overlap, yawed", yawed_blocks<T>()},
          {"blocks flush with a half-space", with_ground<T>(tiles<T>({block<T>}))},
          {"blocks 5 mm below a half-space", with_ground<T>(tiles<T>({block<T>}, -0.505))}};
}

template <class T>
struct Slider {
  const char* name;
  Shape<T> shape;
};
template <class T>
std::vector<Slider<T>> sliders(Random& random) {
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 20; ++i)
    points.push_back({T(uniform(random, -0.6, 0.6)), T(uniform(random, -0.6, 0.6)), T(uniform(random, -0.6, 0.6))});
  const Shape<T> table = Compound<T>({{Box<T>({T(1.2), T(0.1), T(0.8)}), {{0, T(0.4), 0}, {}}},
                                      {Box<T>({T(0.1), T(0.8), T(0.8)}), {{T(-0.55), 0, 0}, {}}},
                                      {Box<T>({T(0.1), T(0.8), T(0.8)}), {{T(0.55), 0, 0}, {}}}});
  return {{"ball", Sphere<T>(T(0.5))},
          {"small ball", Sphere<T>(T(0.05))},
          {"capsule", Capsule<T>(1, T(0.3), T(0.3))},
          {"tapered capsule", Capsule<T>(1, T(0.3), T(0.15))},
          {"box", Box<T>({1, T(0.5), T(1.5)})},
          {"rounded box", Shape<T>(Box<T>({1, 1, 1}), T(0.1))},
          {"cylinder", Cylinder<T>(T(0.8), T(0.5), T(0.5))},
          {"cone", Cylinder<T>(T(0.8), T(0.5), T(0))},
          {"ellipsoid", Ellipsoid<T>({T(0.5), T(0.3), T(0.4)})},
          {"hull", ConvexHull<T>(points)},
          {"table", table},
          {"closed mesh", closed_mesh<T>({T(0.4), T(0.3), T(0.5)})}};
}

template <class T>
Quat<T> random_turn(Random& random) {
  const auto number = [&] { return static_cast<T>(uniform(random, -1, 1)); };
  return normalized(Quat<T>{number(), number(), number(), number()});
}

/// A pose in the floor's frame, the lowest point 0.5 to 20 mm below y = 0.
template <class T>
Pose<T> pose_on_floor(const Shape<T>& shape, Random& random) {
  const Quat<T> turn = random() % 3 == 0
                           ? random_turn<T>(random)
                           : Quat<T>::from_axis_angle({0, 1, 0}, random() % 2 == 0 ? T(0) : T(uniform(random, -3, 3)));
  const Aabb<T> box = bounds(shape, Pose<T>{{}, turn});
  Pose<T> pose{{T(uniform(random, -3, 3)), -box.lower.y - T(uniform(random, 5e-4, 0.02)), T(uniform(random, -3, 3))},
               turn};
  if (random() % 2 == 0) {
    const std::size_t axis = random() % 2 == 0 ? 0 : 2;
    const T side = random() % 2 == 0 ? box.lower[axis] : box.upper[axis];
    pose.translation[axis] = std::round(pose.translation[axis]) - side + T(uniform(random, -0.02, 0.02));
  }
  return pose;
}

/// Poses, and those of them with a normal that leans, and without a contact.
struct Faults {
  std::size_t poses = 0, leaning = 0, nothing = 0;
};

/// Lays a body on a floor that stands in `frame`, in so many poses. `report(pose in the floor's frame, lean of the
/// normal that leans most, whether anything touches)` is told of each at fault.
template <class T, class Report>
Faults lay(const Floor<T>& floor, const Slider<T>& slider, const Pose<T>& frame, std::size_t poses, Random& random,
           const Report& report) {
  World<T> world;
  for (const Placed<T>& part : floor.bodies) {
    Body<T> body{part.shape, compose(frame, part.pose)};
    body.fixed = true;
    world.add(std::move(body));
  }
  const BodyId id = world.add({slider.shape, frame});
  const Vec3<T> up = rotate(frame.rotation, Vec3<T>{0, 1, 0});
  Faults faults;
  for (std::size_t i = 0; i < poses; ++i) {
    const Pose<T> local = pose_on_floor(slider.shape, random);
    world.move(id, compose(frame, local));
    world.update();
    const auto contacts = world.contacts();
    T lean(0);
    // Normals lead from the first body of a pair to the second, which the slider is: it was added last.
    for (const auto& m : contacts.manifolds) lean = std::max(lean, length(m.normal - up));
    const bool leaning = !(lean <= T(most_lean)), nothing = contacts.manifolds.empty();
    ++faults.poses;
    faults.leaning += leaning, faults.nothing += nothing;
    if (leaning || nothing) report(local, lean, !nothing);
  }
  return faults;
}

/// Where floors stand: at the origin, turned there, and turned and far away.
template <class T>
struct Place {
  const char* name;
  Pose<T> frame;
};
template <class T>
std::array<Place<T>, 3> places() {
  const T away = std::is_same_v<T, float> ? T(5) : T(1e4);
  const Quat<T> turn = normalized(Quat<T>{T(0.3), T(0.5), T(-0.2), T(0.7)});
  return {{{"", {}}, {", turned", {{}, turn}}, {", far", {{away, -away, away / 2}, turn}}}};
}

}  // namespace graze::slides
