// Contacts that stand clear of what is beside, against the search that settles all others.
#include "composite/internal_edges/face_contact.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "composite/internal_edges/ghost_contacts.hpp"
#include "narrow/pair_table.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::uniform;

template <class T>
class Standing : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Standing, Scalars);

/// Nine boxes side by side, some a little or much higher than others, some apart, some turned; and a half-space.
template <class T>
struct TiledGround {
  std::vector<Shape<T>> shapes;
  std::vector<Pose<T>> poses;
  std::vector<PlacedRef<T>> all;

  TiledGround(const Vec3<T>& away, Random& random) {
    const auto number = [&](float low, float high) { return static_cast<T>(uniform(random, low, high)); };
    for (int i = 0; i < 9; ++i) {
      const T step = random() % 3 != 0 ? T(0) : number(-0.02f, 0.02f), gap = random() % 4 != 0 ? T(0) : T(0.05);
      shapes.push_back(Box<T>(Vec3<T>{T(1) - gap, T(1), T(1)}));
      poses.push_back({away + Vec3<T>{T(i % 3 - 1), T(-0.5) + (random() % 8 != 0 ? step : T(0.6)), T(i / 3 - 1)},
                       random() % 8 != 0 ? Quat<T>{} : normalized(Quat<T>{0, number(-0.1f, 0.1f), 0, 1})});
    }
    shapes.push_back(HalfSpace<T>());
    poses.push_back({away, Quat<T>{}});
    for (std::size_t i = 0; i < shapes.size(); ++i) all.push_back({&shapes[i], &poses[i]});
  }
};

TYPED_TEST(Standing, ClearIsWhatTheSearchLeavesAsItIs) {
  using T = TypeParam;
  Random random(71);
  std::size_t clear = 0, settled_otherwise = 0;
  for (int scene = 0; scene < 400; ++scene) {
    const T away = scene % 2 == 0 ? T(0) : T(20);
    const TiledGround<T> ground({away, T(0), -away}, random);
    const Shape<T> body = scene % 3 == 0
                              ? Shape<T>(Sphere<T>(T(0.4)))
                              : Shape<T>(Box<T>(Vec3<T>{T(0.9), T(0.7), static_cast<T>(uniform(random, 0.2f, 1.2f))}));
    const T lift = scene % 3 == 0 ? T(0.4) : T(0.35);
    // A statement each: compilers draw the two sides of a sum in different orders.
    const Vec3<T> aside{static_cast<T>(uniform(random, -1, 1)), T(0), static_cast<T>(uniform(random, -1, 1))};
    const T sunk = static_cast<T>(uniform(random, 0, 0.01f));
    const Pose<T> pose{Vec3<T>{away, lift - sunk, -away} + aside,
                       normalized(Quat<T>{0, static_cast<T>(uniform(random, -1, 1)), 0, 1})};
    for (std::size_t i = 0; i < ground.shapes.size(); ++i) {
      const LeafInContext<T> self{ground.shapes[i], ground.poses[i], ground.shapes[i], ground.poses[i], ground.all},
          other{body, pose, body, pose};
      Manifold<T> manifold;
      const T distance = convex_contacts<T>(self.piece, self.pose, body, pose, T(0.005), manifold);
      if (manifold.points.empty()) continue;
      const Settled<T> settled = settle_normal<T>(self, other, T(0.005), manifold, distance);
      const bool same = length(settled.manifold.normal - manifold.normal) < T(1e-5) &&
                        settled.manifold.points.size() == manifold.points.size();
      const Vec3<T> point = standing_point<T>(manifold.points, &ContactPoint<T>::a);
      const bool is_clear = stands_clear(self, other, manifold.normal, point);
      clear += is_clear;
      settled_otherwise += !same;
      EXPECT_TRUE(!is_clear || same) << self.piece.name() << " and " << body.name() << ", scene " << scene;
    }
  }
  EXPECT_GT(clear, 500u);
  EXPECT_GT(settled_otherwise, 50u);
}

}  // namespace
}  // namespace graze
