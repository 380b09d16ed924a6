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

TYPED_TEST(SpaceSlides, HaveTheNormalOfTheFloor) {
  using T = TypeParam;
  using namespace slides;
  const std::size_t poses = std::getenv("GRAZE_TEST_SLIDING") ? 2000 : 60;
  Random random(1);
  const std::vector<Slider<T>> bodies = slides::sliders<T>(random);
  const std::vector<Floor<T>> all = floors<T>(random);
  for (const auto& [where, frame] : places<T>())
    for (const Floor<T>& floor : all)
      for (const Slider<T>& body : bodies) {
        const Faults faults = lay(floor, body, frame, poses, random, [](const Pose<T>&, T, bool) {});
        EXPECT_EQ(faults.leaning, 0u) << body.name << " on " << floor.name << where;
        EXPECT_EQ(faults.nothing, 0u) << body.name << " on " << floor.name << where;
      }
}

}  // namespace
}  // namespace graze
