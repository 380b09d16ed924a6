// Floors of tiles of several kinds, as bodies beside each other and as children of one compound: what lies on them is
// never deeper in them than it lies below their tops.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "graze/query.hpp"
#include "graze/world.hpp"

namespace graze::testing {
namespace {

constexpr double half_tile = 0.25;

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

 private:
  std::mt19937 random_;
};

/// A tile whose top is the square of `half_tile` about the origin at y = 0: a block, a pyramid that stands on its tip,
/// a sheet or a block that is a hull.
template <class T>
Placed<T> random_tile(Draw& draw) {
  const T q(half_tile), height = static_cast<T>(draw(0.2, 0.6));
  const int kind = static_cast<int>(draw(0, 4));
  if (kind == 0) return {Box<T>({2 * q, height, 2 * q}), {{0, -height / 2, 0}, {}}};
  if (kind == 1) return {Rectangle<T>(2 * q, 2 * q), {}};
  std::vector<Vec3<T>> corners{{-q, 0, -q}, {-q, 0, q}, {q, 0, q}, {q, 0, -q}};
  if (kind == 2)
    corners.push_back({0, -height, 0});
  else
    for (int i = 0; i < 4; ++i) corners.push_back({i & 1 ? q : -q, -height, i & 2 ? q : -q});
  return {ConvexHull<T>(corners), {}};
}

/// Four by four tiles about the origin.
template <class T>
std::vector<Placed<T>> random_floor(Draw& draw) {
  std::vector<Placed<T>> tiles;
  for (int i = -2; i < 2; ++i)
    for (int k = -2; k < 2; ++k) {
      Placed<T> tile = random_tile<T>(draw);
      tile.pose.translation += Vec3<T>{T(half_tile * (2 * i + 1)), 0, T(half_tile * (2 * k + 1))};
      tiles.push_back(tile);
    }
  return tiles;
}

/// A body of about `size`, one in two rounded.
template <class T>
Shape<T> random_body(double size, Draw& draw) {
  const double x = size, y = size * draw(0.3, 1), z = size * draw(0.3, 1.2);
  const T margin = draw(0, 1) < 0.5 ? T(0) : static_cast<T>(draw(0.02, 0.25) * size);
  const int kind = static_cast<int>(draw(0, 5));
  if (kind < 2) return Shape<T>(Box<T>({T(x), T(y), T(z)}), margin);
  if (kind == 2) return Shape<T>(Cylinder<T>(T(y), T(x / 2)), margin);
  if (kind == 3) return Capsule<T>(T(x), T(y / 2));
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 10; ++i) points.push_back({T(draw(-x, x)), T(draw(-y, y)), T(draw(-z, z))});
  return Shape<T>(ConvexHull<T>(points), margin);
}

/// Any turn about Y, and in most cases a lean of up to some degrees.
template <class T>
Quat<T> random_stand(Draw& draw) {
  const double lean = draw(0, 1) < 0.4 ? 0 : draw(0, 0.3) * draw(0, 1) * draw(0, 1), about = draw(-3, 3);
  const Quatd leans = Quatd::from_axis_angle({std::cos(about), 0, std::sin(about)}, lean);
  return converted<T>(normalized(leans * Quatd::from_axis_angle({0, 1, 0}, draw(-3.2, 3.2))));
}

template <class T>
struct Lying {
  Shape<T> body;
  Pose<T> pose;
  T depth;    ///< below the tops of the tiles
  T allowed;  ///< what a contact may be deeper: a face is taken that is worse by a two-hundredth of the smaller size
};

template <class T>
Lying<T> random_lying(Draw& draw) {
  const double size = draw(0.05, 0.75);
  Lying<T> lying{
      random_body<T>(size, draw), {{T(draw(-1.2, 1.2)), 0, T(draw(-1.2, 1.2))}, random_stand<T>(draw)}, 0, 0};
  lying.pose.translation.y = -bounds(lying.body, lying.pose).lower.y - T(draw(0, 0.06) * size);
  lying.depth = -bounds(lying.body, lying.pose).lower.y;
  lying.allowed = T(0.006) * T(size + 2 * half_tile);
  return lying;
}

template <class T>
class MixedTiles : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(MixedTiles, Scalars);

TYPED_TEST(MixedTiles, HoldNothingDeeperThanItLies) {
  using T = TypeParam;
  std::size_t met = 0;
  for (unsigned seed = 1; seed <= 8000; ++seed) {
    Draw draw(seed);
    const std::vector<Placed<T>> tiles = random_floor<T>(draw);
    const Lying<T> lying = random_lying<T>(draw);
    World<T> world;
    for (const Placed<T>& tile : tiles) {
      Body<T> body{tile.shape, tile.pose};
      body.fixed = true;
      world.add(body);
    }
    world.add({lying.body, lying.pose});
    world.update();
    for (const auto& point : world.contacts().points)
      ASSERT_GE(point.distance, -lying.depth - lying.allowed) << lying.body.name() << ' ' << seed << " on bodies";
    met += world.contacts().pairs.size();

    Manifolds<T> manifolds;
    contacts(Shape<T>(Compound<T>(tiles)), Pose<T>{}, lying.body, lying.pose, T(0), manifolds);
    for (const Manifold<T>& manifold : manifolds)
      for (const ContactPoint<T>& point : manifold.points)
        ASSERT_GE(point.distance, -lying.depth - lying.allowed) << lying.body.name() << ' ' << seed << " on children";
  }
  EXPECT_GT(met, 8000u);
}

/// A block, a pyramid and a sheet meet in a corner below a rounded box. The wall of the pyramid, which points down, was
/// taken for the surface of the block: depth 0.927 where the box lies 0.038 deep.
TEST(CornerOfTiles, WhereThreeMeetInACornerNoWallIsTheSurface) {
  World<double> world;
  const auto fix = [&](const Shape<double>& shape, const Vec3d& place) {
    Body<double> body{shape, {place, {}}};
    body.fixed = true;
    world.add(body);
  };
  const double tip = -0.30821560255574759;
  fix(Box<double>({0.5, 0.4767997475996324, 0.5}), {-0.25, -0.2383998737998162, 0.25});
  fix(ConvexHull<double>(
          std::vector<Vec3d>{{-.25, 0, -.25}, {-.25, 0, .25}, {.25, 0, .25}, {.25, 0, -.25}, {0, tip, 0}}),
      {-.25, 0, .75});
  fix(Rectangle<double>(0.5, 0.5), {0.25, 0, 0.75});
  const Shape<double> box(Box<double>({1.2675094452983393, 0.76050566717900359, 1.2675094452983393}),
                          0.12675094452983393);
  world.add({box,
             {{0.81480752539597567, 0.46923397423086061, 0.17799590156950185},
              {0, 0.61422687237290829, 0, 0.78912948826855744}}});
  world.update();
  ASSERT_EQ(world.contacts().manifolds.size(), 3u);
  for (const auto& manifold : world.contacts().manifolds) EXPECT_NEAR(manifold.normal.y, 1, 1e-12);
  for (const auto& point : world.contacts().points) EXPECT_GE(point.distance, -0.03777);
}

}  // namespace
}  // namespace graze::testing
