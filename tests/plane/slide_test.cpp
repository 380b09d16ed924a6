// Bodies that slide over floors of pieces meet a half-plane. `bench_slides` goes through a million poses.
#include <gtest/gtest.h>

#include <cstdlib>

#include "common/plane_slides.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneSlides : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneSlides, Scalars);

TYPED_TEST(PlaneSlides, MeetNoBump) {
  using T = TypeParam;
  using namespace slides;
  const std::size_t poses = std::getenv("GRAZE_TEST_SLIDING") ? 100000 : 700;
  Random random(1);
  const std::vector<Floor<T>> all = floors<T>(random);
  for (const Pose2<T>& frame : {Pose2<T>{}, Pose2<T>{{T(20), T(-30)}, Rot2<T>::from_angle(T(0.7))}})
    for (const Floor<T>& floor : all)
      for (const Slider<T>& body : slides::sliders<T>()) {
        const Faults faults = slide(floor, body, frame, poses, random, [](const Pose2<T>&) {});
        EXPECT_EQ(faults.leaning, 0u) << body.name << " on " << floor.name;
        EXPECT_EQ(faults.nothing, 0u) << body.name << " on " << floor.name;
        EXPECT_EQ(faults.other, 0u) << body.name << " on " << floor.name;
      }
}

}  // namespace
}  // namespace graze::plane
