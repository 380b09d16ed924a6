// What edges tell at once of the contacts on triangles is what a search tells: refused contacts of round bodies, and
// whether a triangle is covered.
#include "composite/internal_edges/sphere_capsule_on_surface.hpp"

#include <gtest/gtest.h>

#include "composite/height_grid.hpp"
#include "composite/internal_edges/ghost_contacts.hpp"
#include "composite/internal_edges/occluders.hpp"
#include "graze/query.hpp"
#include "narrow/pair_table.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::random_vector;
using testing::uniform;

template <class T>
class SphereCapsuleOnSurfaces : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SphereCapsuleOnSurfaces, Scalars);

enum class Relief { smooth, creased, crumpled, soup, field };
constexpr Relief reliefs[] = {Relief::smooth, Relief::creased, Relief::crumpled, Relief::soup, Relief::field};

/// Eleven cells each way of half a unit, or triangles anywhere in their place.
template <class T>
Shape<T> relief_of(Relief relief, Random& random) {
  const float rough = relief == Relief::smooth ? 0.01f : relief == Relief::crumpled ? 1.0f : 0.2f;
  const testing::HeightGrid<T> grid(12, 0.5f, rough, random);
  if (relief == Relief::field) return grid.field();
  std::vector<Vec3<T>> points = grid.points();
  if (relief == Relief::soup)
    for (Vec3<T>& p : points) p = converted<T>(random_vector(random, 1));
  return Mesh<T>(points, grid.triangles());
}

template <class T>
Shape<T> round_body(Random& random) {
  const auto size = [&] { return static_cast<T>(uniform(random, 0.05f, 1)); };
  if (random() % 2 == 0) return Sphere<T>(size(), converted<T>(random_vector(random, 0.2f)));
  return Capsule<T>(size(), size() / 2);
}

TYPED_TEST(SphereCapsuleOnSurfaces, WhatIsRefusedHasNoPointsAndWhatIsCoveredIsSeenToBe) {
  using T = TypeParam;
  Random random(29);
  std::size_t refused = 0, kept = 0, covered = 0, open = 0;
  for (int round = 0; round < 60; ++round)
    for (const Relief relief : reliefs) {
      const Shape<T> surface = relief_of<T>(relief, random), body = round_body<T>(random);
      const Vec3<T> away = round % 3 == 0 ? Vec3<T>{300, -20, 1000} : Vec3<T>{};
      const Pose<T> pose{away, normalized(converted<T>(testing::random_rotation(random)))};
      const Pose<T> body_pose = compose(pose, Pose<T>{converted<T>(random_vector(random, 0.7f)),
                                                      normalized(converted<T>(testing::random_rotation(random)))});
      const auto edges = SphereCapsuleOnSurface<T>::of(surface, pose, body, body_pose);
      ASSERT_TRUE(edges);
      const LeafInContext<T> other{body, body_pose, body, body_pose};
      const T margin = contact_margin(surface, body);
      with_surface(surface, [&](const auto& data) {
        for (std::uint32_t i = 0; i < 2 * 11 * 11; ++i) {
          const Shape<T> triangle = triangle_shape(data.triangle(i));
          Manifold<T> manifold;
          const T distance = convex_contacts(triangle, pose, body, body_pose, margin, manifold);
          if (manifold.points.empty()) continue;
          const LeafInContext<T> self{surface, pose, triangle, pose, {}, i};
          const Settled<T> settled = settle_normal(self, other, margin, manifold, distance);
          if (edges->is_ghost(i, manifold, true)) {
            EXPECT_TRUE(settled.manifold.points.empty()) << "triangle " << i;
            ++refused;
          } else {
            kept += settled.manifold.points.empty() ? 0 : 1;
          }
          const Vec3<T>& point = manifold.points[0].a;
          const bool seen = is_covered(self, point, manifold.normal, other);
          EXPECT_EQ(seen, surface_over(self, point, manifold.normal, other).has_value()) << "triangle " << i;
          ++(seen ? covered : open);
        }
      });
    }
  EXPECT_GT(refused, 1000u);
  EXPECT_GT(kept, 300u);
  EXPECT_GT(covered, 300u);
  EXPECT_GT(open, 1000u);
}

TYPED_TEST(SphereCapsuleOnSurfaces, NothingIsKnownOfOtherBodies) {
  using T = TypeParam;
  const Shape<T> surface = Mesh<T>({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 2, 1}});
  EXPECT_FALSE(SphereCapsuleOnSurface<T>::of(surface, {}, Shape<T>(Box<T>({1, 1, 1})), {}));
  EXPECT_FALSE(SphereCapsuleOnSurface<T>::of(surface, {}, Shape<T>(Capsule<T>(1, T(0.2), T(0.5))), {}));
}

}  // namespace
}  // namespace graze
