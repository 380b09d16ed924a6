// The triangles of a surface that a body meets are answered several at a time, or one by one where a test says so:
// both ways give the same bits, at every level of the instruction set.
#include "composite/triangle_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "composite/composite.hpp"
#include "composite/height_grid.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::random_vector;
using testing::uniform;

template <class T>
class TriangleRuns : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(TriangleRuns, Scalars);

enum class Terrain { rough, level, degenerate, soup, field, in_compound };
constexpr Terrain terrains[] = {Terrain::rough, Terrain::level, Terrain::degenerate,
                                Terrain::soup,  Terrain::field, Terrain::in_compound};

/// Eleven cells each way about the origin, of half the width of the bodies below, or less.
template <class T>
Shape<T> terrain_of(Terrain terrain, Sides sides, Random& random) {
  const float cell = uniform(random, 0.1f, 0.5f), rough = terrain == Terrain::level ? 0 : 0.1f;
  const testing::HeightGrid<T> grid(12, cell, rough, random);
  if (terrain == Terrain::field) return grid.field(sides);
  std::vector<Vec3<T>> points = grid.points();
  if (terrain == Terrain::degenerate)
    for (auto& p : points)
      if (random() % 4 == 0) p = points[random() % points.size()];
  if (terrain == Terrain::soup)
    for (Vec3<T>& p : points) p = converted<T>(random_vector(random, 1));
  const Mesh<T> mesh(points, grid.triangles(), sides);
  if (terrain != Terrain::in_compound) return mesh;
  return Compound<T>({{mesh}, {Box<T>({T(1), T(0.5), T(1)}), {{T(0), T(-0.25), T(0)}, {}}}});
}

template <class T>
Shape<T> random_body(int kind, Random& random) {
  const auto size = [&] { return static_cast<T>(uniform(random, 0.2f, 1)); };
  if (kind == 0) return Sphere<T>(size() / 2);
  if (kind == 1) return Capsule<T>(size(), size() / 3);
  const Vec3<T> sizes{size(), size(), size()};
  return Shape<T>(Box<T>(sizes), kind == 2 ? T(0.1) : T(0));
}

template <class T>
void expect_same_bits(const Manifolds<T>& together, const Manifolds<T>& alone) {
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const Manifold<T>&m = together[i], &n = alone[i];
    EXPECT_EQ(m.normal, n.normal);
    EXPECT_EQ(m.piece_a, n.piece_a);
    EXPECT_EQ(m.piece_b, n.piece_b);
    ASSERT_EQ(m.points.size(), n.points.size());
    for (std::size_t k = 0; k < n.points.size(); ++k) {
      const ContactPoint<T>&p = m.points[k], &q = n.points[k];
      EXPECT_TRUE(p.a == q.a && p.b == q.b && p.distance == q.distance && p.feature == q.feature &&
                  p.weight == q.weight);
    }
  }
}

TYPED_TEST(TriangleRuns, AnswerAsOneByOne) {
  using T = TypeParam;
  Random random(17);
  std::size_t points = 0;
  for (int i = 0; i < 36; ++i)
    for (const Terrain terrain : terrains) {
      const Shape<T> floor = terrain_of<T>(terrain, i % 3 == 0 ? Sides::front : Sides::both, random);
      const Shape<T> thing = random_body<T>(i % 6, random);
      const Vec3<T> away = i % 5 == 0 ? Vec3<T>{T(300), T(-20), T(1000)} : Vec3<T>{};
      const Pose<T> ground_pose{away,
                                i % 2 == 0 ? Quat<T>{} : normalized(converted<T>(testing::random_rotation(random)))};
      const Pose<T> on_ground{{static_cast<T>(uniform(random, -1, 1)), static_cast<T>(uniform(random, -0.1f, 0.5f)),
                               static_cast<T>(uniform(random, -1, 1))},
                              i % 12 == 1 ? Quat<T>::from_axis_angle({T(0), T(0), T(1)}, T(std::acos(0.0)))
                                          : normalized(converted<T>(testing::random_rotation(random)))};
      const Pose<T> pose = compose(ground_pose, on_ground);
      const bool first = random() % 2 == 0;
      // A negative margin asks for what is deeper than that.
      const T margin = i % 7 == 0 ? T(-0.01) : static_cast<T>(i % 4) * T(0.02);
      Manifolds<T> together, alone;
      const bool touch = first ? contacts(thing, pose, floor, ground_pose, margin, together)
                               : contacts(floor, ground_pose, thing, pose, margin, together);
      constexpr bool singly = true;
      EXPECT_EQ(touch, (first ? any_contacts<T>(thing, pose, floor, ground_pose, margin, alone, {}, singly)
                              : any_contacts<T>(floor, ground_pose, thing, pose, margin, alone, {}, singly)) <= T(0));
      expect_same_bits(together, alone);
      for (const Manifold<T>& m : alone) points += m.points.size();
    }
  EXPECT_GT(points, 1000u);
}

}  // namespace
}  // namespace graze
