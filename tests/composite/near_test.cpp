// First looks at what is near: triangles that a convex shape may come near, and those of a mesh around a place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/specimen.hpp"
#include "composite/leaves.hpp"
#include "composite/mesh_patch.hpp"
#include "composite/near_convex.hpp"
#include "narrow/pair_table.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::uniform;

template <class T>
class Near : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Near, Scalars);

template <class T>
Corners<T> random_corners(Random& random) {
  Corners<T> corners;
  for (Vec3<T>& p : corners) p = converted<T>(testing::random_vector(random, 2));
  if (random() % 8 == 0) corners[2] = corners[0] + (corners[1] - corners[0]) * T(0.3);  // a sliver, up to rounding
  if (random() % 16 == 0) corners[1] = corners[0];
  return corners;
}

/// Near and far from the origin, what is ruled out at a limit is further apart than that; and of what is clearly
/// further apart most is ruled out.
TYPED_TEST(Near, TrianglesThatAreRuledOutAreFurtherApart) {
  using T = TypeParam;
  Random random(61);
  std::size_t ruled_out = 0, far_apart = 0;
  for (const T away : {T(0), T(100)})
    for (int kind = 0; kind < testing::bounded_kinds; ++kind)
      for (int i = 0; i < 300; ++i) {
        const Shape<T> shape =
            testing::build<T>(testing::random_specimen(static_cast<testing::Kind>(kind), 1.5f, random));
        const Vec3<T> from{away, -away, away};
        const Pose<T> pose{from + converted<T>(testing::random_vector(random, 3)),
                           normalized(converted<T>(testing::random_rotation(random)))};
        Corners<T> corners = random_corners<T>(random);
        for (Vec3<T>& p : corners) p += from;
        const T slack = T(64) * std::numeric_limits<T>::epsilon() * (T(16) + T(6) * away);
        const NearConvex<T> near(shape, pose, slack);
        const T distance = convex_distance<T>(triangle_shape(corners), Pose<T>{}, shape, pose).distance;
        for (const T limit : {T(-0.3), T(0), T(0.5)}) {
          const bool out = near(bounds_of(corners)) > near.key(limit) || !near.may_reach(corners, limit);
          EXPECT_TRUE(!out || distance > limit) << shape.name() << " " << distance << " at " << limit;
          far_apart += distance > limit + T(0.3);
          ruled_out += out && distance > limit + T(0.3);
        }
      }
  EXPECT_GT(ruled_out * 10, far_apart * 9);
}

/// Against a look at all triangles.
TYPED_TEST(Near, PatchesHoldAllTrianglesOfWhatTheyCover) {
  using T = TypeParam;
  Random random(62);
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (std::uint32_t i = 0; i < 400; ++i) {
    const Vec3<T> at = converted<T>(testing::random_vector(random, 5));
    for (int k = 0; k < 3; ++k) points.push_back(at + converted<T>(testing::random_vector(random, 0.7f)));
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Mesh<T> mesh(points, triangles), other(points, triangles);
  int filled = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3<T> low = converted<T>(testing::random_vector(random, 6));
    const T distance = static_cast<T>(uniform(random, 0, 0.4f));
    const BoxQuestion<T> question{{low, low + Vec3<T>{T(1), T(0.5), T(2)}}};
    MeshPatch<T> patch;
    if (!patch.fill(mesh, question, distance)) continue;
    ++filled;
    // A contact lies within the distance of the region, and its neighbours within their reach of it.
    const Aabb<T> covered = inflated(question.region, distance + reach_on(mesh.data(), T(0)) * T(0.99));
    EXPECT_TRUE(patch.covers(mesh.data(), covered));
    EXPECT_FALSE(patch.covers(other.data(), covered));
    EXPECT_FALSE(patch.covers(mesh.data(), inflated(covered, T(0.01))));
    std::vector<std::uint32_t> held;
    const auto all = [](const Aabb<T>&) { return true; };
    patch.each(all, [&](std::uint32_t t) {
      held.push_back(t);
      return true;
    });
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const bool meets = overlap(bounds_of(mesh.data().triangle(t)), covered);
      EXPECT_TRUE(!meets || std::find(held.begin(), held.end(), t) != held.end()) << t;
    }
  }
  EXPECT_GT(filled, 100);
  MeshPatch<T> patch;
  EXPECT_FALSE(patch.fill(mesh, {Aabb<T>::everything()}, T(0)));
}

}  // namespace
}  // namespace graze
