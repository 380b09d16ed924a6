// Things that slide over a surface cut into pieces meet the surface, not the cuts.
#include "composite/internal_edges/ghost_contacts.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "composite/sliding.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

using testing::lowest;
using testing::Random;
using testing::sliders;

std::size_t positions() {
  const char* asked = std::getenv("GRAZE_TEST_SLIDES");
  return asked ? std::strtoull(asked, nullptr, 10) : 400;
}

template <class T>
struct Soup {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;

  void add(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
    const auto n = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), {a, b, c});
    triangles.push_back({n, n + 1, n + 2});
  }
  Shape<T> mesh() const { return Mesh<T>(points, triangles); }
};

/// A floor from -8 to 8 of squares cut along either diagonal; each triangle has corners of its own.
template <class T>
Soup<T> floor_of_triangles(Random& random) {
  Soup<T> soup;
  for (int x = -8; x < 8; ++x)
    for (int z = -8; z < 8; ++z) {
      const T x0 = T(x), x1 = T(x + 1), z0 = T(z), z1 = T(z + 1);
      const Vec3<T> a{x0, 0, z0}, b{x1, 0, z0}, c{x1, 0, z1}, d{x0, 0, z1};
      if (random() % 2 == 0)
        soup.add(a, c, b), soup.add(a, d, c);
      else
        soup.add(a, d, b), soup.add(b, d, c);
    }
  return soup;
}

/// Slabs of triangles whose corners lie anywhere along the edges of their neighbours.
template <class T>
Soup<T> floor_with_t_junctions(Random& random) {
  Soup<T> soup;
  for (int x = -8; x < 8; x += 2) {
    T z(-8), w(-8);
    const T x0 = T(x), x1 = T(x + 2);
    while (z < T(8) || w < T(8)) {
      const T step = static_cast<T>(testing::uniform(random, 0.3f, 2.5f));
      if (z <= w) {
        soup.add({x0, 0, z}, {x0, 0, z + step}, {x1, 0, w});
        z += step;
      } else {
        soup.add({x1, 0, w}, {x0, 0, z}, {x1, 0, w + step});
        w += step;
      }
    }
  }
  return soup;
}

/// A floor of boxes side by side, children of one body.
template <class T>
Shape<T> floor_of_boxes() {
  std::vector<Placed<T>> children;
  for (int x = -8; x < 8; x += 2)
    for (int z = -8; z < 8; z += 2)
      children.push_back({Shape<T>(Box<T>({2, 1, 2})), {{T(x + 1), T(-0.5), T(z + 1)}, {}}});
  return Compound<T>(std::move(children));
}

/// A body somewhere on the floor, a little deep, lying on a face or anyhow.
template <class T>
void expect_the_floors_normal(const Shape<T>& floor, const Shape<T>& body, Random& random, bool level) {
  const auto yaw = static_cast<T>(testing::uniform(random, -3, 3));
  const Quat<T> turn =
      level ? Quat<T>::from_axis_angle({0, 1, 0}, yaw) : normalized(converted<T>(testing::random_rotation(random)));
  const T depth = static_cast<T>(testing::uniform(random, 0.0005f, 0.02f));
  Vec3<T> at = converted<T>(testing::random_vector(random, 4));
  at.y = -lowest(body, turn) - depth;
  // Now and then just over an edge, where the least way out is sideways.
  if (random() % 3 == 0) at.x = std::round(at.x) + static_cast<T>(testing::uniform(random, -0.003f, 0.003f));
  const Pose<T> pose{at, turn};
  for (const bool swapped : {false, true}) {
    Manifolds<T> manifolds;
    const T margin = contact_margin(floor, body);
    const bool touch = swapped ? contacts(body, pose, floor, Pose<T>{}, margin, manifolds)
                               : contacts(floor, Pose<T>{}, body, pose, margin, manifolds);
    EXPECT_TRUE(touch);
    ASSERT_FALSE(manifolds.empty()) << body.name() << " at " << at.x << ' ' << at.y << ' ' << at.z;
    T deepest(0);
    for (const Manifold<T>& m : manifolds) {
      ASSERT_NEAR(m.normal.y, swapped ? T(-1) : T(1), 1e-6) << body.name() << " at " << at.x << ' ' << at.y << ' '
                                                            << at.z << " normal " << m.normal.x << ' ' << m.normal.z;
      for (const ContactPoint<T>& p : m.points) deepest = std::min(deepest, p.distance);
    }
    // Deep curved shapes touch deeper beside an edge than on it; none is deeper than the floor.
    EXPECT_GE(deepest, -depth - T(1e-4));
    EXPECT_LE(deepest, level ? -depth + T(1e-4) : T(0));
  }
}

template <class T>
class InternalEdges : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(InternalEdges, Scalars);

TYPED_TEST(InternalEdges, NothingCatchesOnFloorsOfTriangles) {
  using T = TypeParam;
  Random random(1);
  const std::vector<T> level(17 * 17, T(0));
  const Shape<T> floors[] = {floor_of_triangles<T>(random).mesh(), floor_with_t_junctions<T>(random).mesh(),
                             Shape<T>(HeightField<T>(17, 17, level))};
  for (const Shape<T>& floor : floors)
    for (const Shape<T>& body : sliders<T>(random))
      for (std::size_t i = 0; i < positions(); ++i) {
        expect_the_floors_normal(floor, body, random, i % 2 == 0);
        if (this->HasFatalFailure()) return;
      }
}

TYPED_TEST(InternalEdges, NothingCatchesOnAFloorOfBoxes) {
  using T = TypeParam;
  Random random(2);
  const Shape<T> floor = floor_of_boxes<T>();
  for (const Shape<T>& body : sliders<T>(random))
    for (std::size_t i = 0; i < positions(); ++i) {
      expect_the_floors_normal(floor, body, random, i % 2 == 0);
      if (this->HasFatalFailure()) return;
    }
}

/// A ridge and a step have edges of their own, and those are felt.
TEST(InternalEdgesOfShape, EdgesThatStickOutCount) {
  Soup<double> ridge;
  ridge.add({0, 0, -1}, {0, 0, 1}, {1, -1, 0});
  ridge.add({0, 0, -1}, {-1, -1, 0}, {0, 0, 1});
  Manifolds<double> manifolds;
  const Shaped ball(Sphere<double>(0.5));
  ASSERT_TRUE(contacts(ridge.mesh(), Posed{}, ball, Posed{{0.05, 0.49, 0}, {}}, 0.0, manifolds));
  ASSERT_EQ(manifolds.size(), 1u);
  const Vec3d expected = normalized(Vec3d{0.05, 0.49, 0});
  EXPECT_NEAR(length(manifolds[0].normal - expected), 0, 1e-9);
}

/// The corners of what lies on a cut floor, and none of the places where the cuts cross it. Where a cut goes through
/// the outermost hundredth of a face, the small piece is rounded off as any small edge is: that makes two corners of
/// one, in one place of twenty.
TEST(InternalEdgesOfShape, CutsAddNoPoints) {
  Random random(3);
  const Shaped floors[] = {floor_of_triangles<double>(random).mesh(), floor_with_t_junctions<double>(random).mesh(),
                           floor_of_boxes<double>()};
  const auto points = [](const Shaped& floor, const Shaped& body, const Posed& pose) {
    Manifolds<double> manifolds;
    EXPECT_TRUE(contacts(floor, Posed{}, body, pose, 0.01, manifolds));
    EXPECT_EQ(manifolds.size(), 1u) << body.name() << " on " << floor.name() << ", normals " << manifolds[0].normal.x
                                    << ' ' << manifolds[0].normal.y << ' ' << manifolds.back().normal.x << ' '
                                    << manifolds.back().normal.y << ' ' << manifolds.back().normal.z;
    return manifolds.empty() ? 0 : manifolds[0].points.size();
  };
  std::size_t rounded_off = 0;
  for (const Shaped& floor : floors)
    for (int i = 0; i < 200; ++i) {
      const Quatd yaw = Quatd::from_axis_angle({0, 1, 0}, 0.1 * i + 0.01);
      Vec3d at = converted<double>(testing::random_vector(random, 3));
      at.y = 0.499;
      const std::size_t of_box = points(floor, Shaped(Box<double>({2, 1, 3})), {at, yaw});
      EXPECT_GE(of_box, 4u);
      EXPECT_LE(of_box, 6u);
      rounded_off += of_box > 4;
      const Quatd lying = yaw * Quatd::from_axis_angle({1, 0, 0}, std::acos(-1.0) / 2);
      EXPECT_EQ(points(floor, Shaped(Capsule<double>(3, 0.5, 0.5)), {at, lying}), 2u);
    }
  EXPECT_LT(rounded_off, 40u);  // of 600
}

}  // namespace
}  // namespace graze
