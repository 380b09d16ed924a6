// Clipping by several planes at a time against one plane after the other: equal at every level of the instruction set.
#include "rays/plane_clip.hpp"

#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/lines.hpp"

namespace graze::testing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
rays::PlaneClip one_by_one(const std::vector<Plane<T>>& planes, const Vec3d& origin, const Vec3d& direction) {
  rays::PlaneClip clip{-infinity, infinity, 0, false};
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Vec3d n = converted<double>(planes[i].normal);
    const double above = dot(n, origin) - static_cast<double>(planes[i].offset), toward = dot(n, direction);
    const double t = -above / toward;
    if (toward == 0) {
      clip.outside = clip.outside || above > 0;
    } else if (toward > 0) {
      clip.leave = least(clip.leave, t);
    } else if (t > clip.enter) {
      clip.enter = t;
      clip.plane = i;
    }
  }
  return clip;
}

template <class T>
class PlaneClips : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneClips, Scalars);

TYPED_TEST(PlaneClips, AreThoseOfOnePlaneAfterTheOther) {
  using T = TypeParam;
  Random random(1);
  for (const std::size_t count : {1u, 2u, 4u, 7u, 8u, 9u, 12u, 13u, 23u, 60u})
    for (int k = 0; k < 100; ++k) {
      std::vector<Plane<T>> planes;
      for (std::size_t i = 0; i < count; ++i) {
        planes.push_back({converted<T>(random_vector(random, 1)), T(uniform(random, 0, 1))});
        if (i % 3 == 2) planes.push_back(planes[i / 2]);  // of equal ones the first counts
      }
      if (k % 5 == 0) planes[random() % planes.size()].normal = {T(0), T(1), T(0)};
      const Vec3d from = converted<double>(random_vector(random, 2));
      const Vec3d way = k % 5 == 0 ? Vec3d{1, 0, 0} : converted<double>(random_vector(random, 1));
      const rays::PlaneClip expected = one_by_one(planes, from, way);
      for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512}) {
        if (!isa_available(level)) continue;
        rays::PlaneClip clip;
        GRAZE_KERNEL(level, clip_by_planes<T>)
        (&planes[0].normal.x, planes.size(), {from.x, from.y, from.z}, {way.x, way.y, way.z}, clip);
        ASSERT_EQ(clip.enter, expected.enter);
        ASSERT_EQ(clip.leave, expected.leave);
        ASSERT_EQ(clip.outside, expected.outside);
        if (expected.enter > -infinity) {
          ASSERT_EQ(clip.plane, expected.plane);
        }
      }
    }
}

}  // namespace
}  // namespace graze::testing
