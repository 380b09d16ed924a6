// Bodies that lie on flat floors of pieces have the floor's normal. `bench_seams` goes through many more poses.
#include <gtest/gtest.h>

#include <cstdlib>

#include "common/space_slides.hpp"

namespace graze {
namespace {

template <class T>
class SpaceSlides : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SpaceSlides, Scalars);

/// A corner of a body over a corner of the floor is told another normal once in ten thousand poses; a kind of body that
/// is told it over every seam, as a cone whose rim sinks beside one, would be far more.
TYPED_TEST(SpaceSlides, HaveTheNormalOfTheFloor) {
  using T = TypeParam;
  using namespace slides;
  const std::size_t poses = std::getenv("GRAZE_TEST_SLIDING") ? 2000 : 60;
  Random random(1);
  const std::vector<Slider<T>> bodies = slides::sliders<T>(random);
  const std::vector<Floor<T>> all = floors<T>(random);
  for (const auto& [where, frame] : places<T>()) {
    Faults sum;
    for (const Floor<T>& floor : all)
      for (const Slider<T>& body : bodies) {
        const Faults faults = lay(floor, body, frame, poses, random, [](const Pose<T>&, T, bool) {});
        sum.poses += faults.poses, sum.leaning += faults.leaning;
        EXPECT_LE(faults.leaning, poses / 60) << body.name << " on " << floor.name << where;
        EXPECT_EQ(faults.nothing, 0u) << body.name << " on " << floor.name << where;
      }
    EXPECT_LE(sum.leaning, sum.poses / 10000 + 1) << where;
  }
}

}  // namespace
}  // namespace graze
