// Shapes at rest that tremble: which points touch, and their names, stay what they were.
#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "plane/figures.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneJitter : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneJitter, Scalars);

/// A shape that rests: turned so that it stands on what is below it, and how high its middle is then.
template <class T>
struct Resting {
  std::string name;
  Shape<T> shape;
  double height;
  bool turned = false;  ///< by a quarter
  std::size_t points = 2;
};

/// A polygon of an even number of vertices that stands on an edge.
template <class T>
std::vector<Vec2<T>> even_polygon(int count, double radius) {
  std::vector<Vec2<T>> points;
  for (int i = 0; i < count; ++i) {
    const double angle = (2 * i + 1) * std::numbers::pi / count - std::numbers::pi / 2;
    points.push_back(converted<T>(Vec2d{radius * std::cos(angle), radius * std::sin(angle)}));
  }
  return points;
}
template <class T>
Resting<T> polygon_at_rest(int count, double rounding, double size) {
  const double inner = 0.5 * size * std::cos(std::numbers::pi / count);
  return {std::to_string(count) + " vertices rounded by " + std::to_string(rounding),
          {ConvexPolygon<T>(even_polygon<T>(count, 0.5 * size)), static_cast<T>(rounding * size)},
          inner + rounding * size};
}

/// Polygons that the batches, the axes of edges and the walk answer for, capsules, circles and boxes.
template <class T>
std::vector<Resting<T>> shapes_at_rest(double size) {
  const auto number = [&](double x) { return static_cast<T>(x * size); };
  std::vector<Resting<T>> out;
  for (const int count : {4, 6, 8, 12, 20})
    for (const double rounding : {0.0, 0.1}) out.push_back(polygon_at_rest<T>(count, rounding, size));
  const std::vector<Vec2<T>> triangle{{number(-0.5), number(-0.5)}, {number(0.5), number(-0.5)}, {T(0), number(0.5)}};
  out.push_back({"triangle", ConvexPolygon<T>(triangle), 0.5 * size});
  out.push_back({"box", Box<T>({number(0.8), number(1)}), 0.5 * size});
  out.push_back({"rounded box", {Box<T>({number(0.8), number(1)}), number(0.1)}, 0.6 * size});
  out.push_back({"lying capsule", Capsule<T>(number(0.8), number(0.2)), 0.2 * size, true});
  out.push_back({"standing capsule", Capsule<T>(number(0.8), number(0.2)), 0.6 * size, false, 1});
  out.push_back({"circle", Circle<T>(number(0.5)), 0.5 * size, false, 1});
  // Several pieces, of which the one beside the bottom has one of its corners.
  const std::vector<Vec2<T>> notched{{number(-0.5), number(-0.5)},
                                     {number(0.5), number(-0.5)},
                                     {number(0.5), number(0.5)},
                                     {T(0), T(0)},
                                     {number(-0.5), number(0.5)}};
  out.push_back({"notched polygon", Polygon<T>(notched), 0.5 * size});
  out.push_back({"closed chain", Chain<T>(notched, true), 0.5 * size});
  out.push_back({"compound",
                 Compound<T>({{Box<T>({number(0.8), number(1)}), {}},
                              {Circle<T>(number(0.3)), {{number(0.5), number(0.2)}, {}}}}),
                 0.5 * size});
  return out;
}

/// Shapes to rest on, each a shape whose top is at `height`, long enough for none to hang over.
template <class T>
std::vector<Resting<T>> grounds(double size) {
  const auto number = [&](double x) { return static_cast<T>(x * size); };
  std::vector<Resting<T>> out{{"half-plane", HalfPlane<T>(), 0},
                              {"box", Box<T>({number(3), number(1)}), 0.5 * size},
                              {"rounded box", {Box<T>({number(3), number(1)}), number(0.2)}, 0.7 * size},
                              {"capsule", Capsule<T>(number(3), number(0.3)), 0.3 * size, true},
                              polygon_at_rest<T>(6, 0, 6 * size),
                              polygon_at_rest<T>(8, 0.1, 8 * size)};
  // Seams lie where no shape ends.
  std::vector<Vec2<T>> line;
  for (const double x : {2.0, 0.62, 0.35, 0.03, -0.3, -2.0}) line.push_back({number(x), T(0)});
  out.push_back({"chain", Chain<T>(line), 0});
  out.push_back({"chain of one side", Chain<T>(line, false, ChainSides::one), 0});
  out.push_back({"rounded chain", {Chain<T>(line), number(0.1)}, 0.1 * size});
  // Cut somewhere: the notch below leaves no convex piece with all of the top.
  const std::vector<Vec2<T>> notched{
      {number(-2), number(-1)}, {T(0), number(-0.5)}, {number(2), number(-1)}, {number(2), T(0)}, {number(-2), T(0)}};
  out.push_back({"notched polygon", Polygon<T>(notched), 0});
  return out;
}

template <class T>
using Names = std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>>;

template <class T>
Names<T> names_of(const Manifolds<T>& manifolds) {
  Names<T> names;
  for (const auto& m : manifolds)
    for (const auto& p : m.points) names.push_back({m.piece_a, m.piece_b, p.feature});
  return names;
}

template <class T>
Pose2<T> trembling(const Vec2d& at, bool turned, double size, std::mt19937& random) {
  std::uniform_real_distribution<double> jitter(-1e-4, 1e-4);
  const double x = jitter(random), y = jitter(random), angle = jitter(random);
  return {converted<T>(at + Vec2d{x, y} * size),
          Rot2<T>::from_angle(static_cast<T>(angle + (turned ? std::numbers::pi / 2 : 0)))};
}

TYPED_TEST(PlaneJitter, NamesOfWhatRestsStay) {
  using T = TypeParam;
  std::mt19937 random(12);
  for (const double size : {1e-4, 1.0, 1e5})
    for (const Resting<T>& ground : grounds<T>(size))
      for (const Resting<T>& body : shapes_at_rest<T>(size)) {
        // Lines that cross have no inside to be pushed out of.
        if (ground.shape.template as<Chain<T>>() && body.shape.template as<Chain<T>>()) continue;
        const std::string pair = body.name + " on " + ground.name + " of " + std::to_string(size);
        Names<T> first, first_back;
        for (int frame = 0; frame < 100; ++frame) {
          const Pose2<T> below = trembling<T>({0, -ground.height}, ground.turned, size, random);
          const Pose2<T> above = trembling<T>({0.07 * size, body.height - 1e-3 * size}, body.turned, size, random);
          Manifolds<T> there, back;
          contacts(ground.shape, below, body.shape, above, static_cast<T>(0.01 * size), there);
          contacts(body.shape, above, ground.shape, below, static_cast<T>(0.01 * size), back);
          const Names<T> names = names_of(there), names_back = names_of(back);
          if (frame == 0) first = names, first_back = names_back;
          ASSERT_EQ(names.size(), body.points) << pair << ", frame " << frame;
          ASSERT_EQ(names, first) << pair << ", frame " << frame;
          ASSERT_EQ(names_back, first_back) << pair << ", frame " << frame;
          for (const auto& [piece_a, piece_b, feature] : names) {
            const std::tuple mirrored{piece_b, piece_a, (feature << 16) | (feature >> 16)};
            ASSERT_EQ(std::count(names_back.begin(), names_back.end(), mirrored), 1) << pair << ", frame " << frame;
          }
        }
      }
}

}  // namespace
}  // namespace graze::plane
