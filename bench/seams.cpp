// Are seams felt? How often a contact on a flat floor made of pieces has another normal than the floor's.
//
//   bench_seams [--poses N] [--filter REGEX] [--double] [--show]
//
// The floor is the plane y = 0 within 5 of the origin, in the frame where it stands: at the origin, turned there, or
// turned and far away. A body lies on it 0.5 to 20 mm deep, on a face or anyhow, in one of two poses just over a seam,
// so that the least way out of a piece leads sideways. A row is a floor; of so many poses with each body it counts
// those with a normal that is wrong by more than a milliradian, and those in which nothing touches, and names the
// bodies at fault. Everything is a body of a `World`; compounds are one.
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "graze/world.hpp"

namespace graze::bench {

namespace {

constexpr int reach = 5;            ///< floors go so far from the origin, in x and z
constexpr double most_lean = 1e-3;  ///< a milliradian

struct Options {
  std::size_t poses = 1000;
  std::string filter = ".*";
  bool doubles = false, show = false;
};

using Random = std::mt19937_64;
double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
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
std::vector<double> even_lines(double cell) {
  std::vector<double> lines;
  for (double x = -reach; x < reach + cell / 2; x += cell) lines.push_back(x);
  return lines;
}
/// Whole numbers, and beside each a line as near as a refining tool leaves one.
std::vector<double> sliver_lines() {
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
  std::normal_distribution<double> number;
  return normalized(Quat<T>{T(number(random)), T(number(random)), T(number(random)), T(number(random))});
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

/// Faults by the body's name.
struct Faults {
  std::size_t poses = 0, wrong = 0, none = 0;
  std::map<std::string, std::size_t> bodies;
};

template <class T>
void survey(const Floor<T>& floor, const std::vector<Slider<T>>& sliders, const Pose<T>& frame, const Options& options,
            Random& random, Faults& faults) {
  World<T> world;
  for (const Placed<T>& part : floor.bodies) {
    Body<T> body{part.shape, compose(frame, part.pose)};
    body.fixed = true;
    world.add(std::move(body));
  }
  const Vec3<T> up = rotate(frame.rotation, Vec3<T>{0, 1, 0});
  for (const Slider<T>& slider : sliders) {
    const BodyId id = world.add({slider.shape, frame});
    for (std::size_t i = 0; i < options.poses; ++i) {
      const Pose<T> local = pose_on_floor(slider.shape, random);
      world.move(id, compose(frame, local));
      world.update();
      const auto contacts = world.contacts();
      T worst(0);
      for (const auto& m : contacts.manifolds) {
        // The normal leads from the first body of the pair to the second, which the slider is: it was added last.
        worst = std::max(worst, length(m.normal - up));
      }
      const bool wrong = !(worst <= T(most_lean)), none = contacts.manifolds.empty();
      ++faults.poses;
      faults.wrong += wrong;
      faults.none += none;
      if (wrong || none) ++faults.bodies[slider.name];
      if (options.show && (wrong || none))
        std::printf("  %s: %s at (%.9g, %.9g, %.9g), turned (%.9g, %.9g, %.9g, %.9g): %.3g off\n", floor.name,
                    slider.name, double(local.translation.x), double(local.translation.y), double(local.translation.z),
                    double(local.rotation.x), double(local.rotation.y), double(local.rotation.z),
                    double(local.rotation.w), none ? -1.0 : double(worst));
    }
    world.remove(id);
  }
}

template <class T>
void print_table(const Options& options) {
  Random random(1);
  const std::vector<Slider<T>> bodies = sliders<T>(random);
  const T away = std::is_same_v<T, float> ? T(5) : T(1e4);
  const Quat<T> turn = normalized(Quat<T>{T(0.3), T(0.5), T(-0.2), T(0.7)});
  const std::pair<const char*, Pose<T>> frames[] = {
      {"", {}}, {", turned", {{}, turn}}, {", far", {{away, -away, away / 2}, turn}}};
  const std::regex filter(options.filter);
  std::printf("| floor, %s | poses | wrong normal | nothing | bodies |\n|---|--:|--:|--:|---|\n",
              std::is_same_v<T, float> ? "float" : "double");
  std::size_t wrong = 0, none = 0, poses = 0;
  for (const Floor<T>& floor : floors<T>(random))
    for (const auto& [where, frame] : frames) {
      const std::string name = std::string(floor.name) + where;
      if (!std::regex_search(name, filter)) continue;
      Faults faults;
      Random of_row(2);  // so that a row is the same whatever is left out
      survey(floor, bodies, frame, options, of_row, faults);
      std::string at_fault;
      for (const auto& [body, count] : faults.bodies)
        at_fault += (at_fault.empty() ? "" : ", ") + body + " " + std::to_string(count);
      std::printf("| %s | %zu | %zu | %zu | %s |\n", name.c_str(), faults.poses, faults.wrong, faults.none,
                  at_fault.c_str());
      std::fflush(stdout);
      wrong += faults.wrong, none += faults.none, poses += faults.poses;
    }
  std::printf("| all | %zu | %zu | %zu | |\n\n", poses, wrong, none);
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) {
  graze::bench::Options options;
  graze::bench::CommandLine("How often seams of flat floors are felt.")
      .number("--poses", options.poses, "poses of each body on each floor in each place")
      .expression("--filter", options.filter, "floors to look at")
      .flag("--double", options.doubles, "in double precision alone, else in single alone")
      .flag("--show", options.show, "each pose at fault")
      .read(argc, argv);
  options.doubles ? graze::bench::print_table<double>(options) : graze::bench::print_table<float>(options);
}
