// Capsules that touch boxes with an end: the routine of its own against the faces, which answer wherever an explanation
// is asked for.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

template <class T>
void expect_as_by_faces(unsigned seed, double near) {
  Random random(seed);
  int compared = 0, other_names = 0;
  for (int i = 0; i < 4000; ++i) {
    const Shape<T> capsule(Capsule<T>(T(uniform(random, 0.1f, 1)), T(uniform(random, 0, 0.5f))),
                           T(i % 8 == 0 ? 0.1 : 0));
    const Shape<T> box(Box<T>(cast<T>(abs(random_vector(random, 1)) + Vec3f{0.1f, 0.1f, 0.1f})),
                       T(i % 7 == 0 ? 0.1 : 0));
    const Pose<T> pose{cast<T>(random_vector(random, 0.7f)),
                       i % 3 == 0 ? Quat<T>{} : normalized(cast<T>(random_rotation(random)))};
    const Pose<T> ground{cast<T>(random_vector(random, 0.7f)),
                         i % 2 == 0 ? Quat<T>{} : normalized(cast<T>(random_rotation(random)))};
    const bool turned = i % 5 == 0;
    Manifolds<T> fast, slow;
    Trace trace;
    const auto ask = [&](Manifolds<T>& found, Trace* explain) {
      return turned ? contacts<T>(box, ground, capsule, pose, T(0.05), found, explain)
                    : contacts<T>(capsule, pose, box, ground, T(0.05), found, explain);
    };
    EXPECT_EQ(ask(fast, nullptr), ask(slow, &trace));
    ASSERT_EQ(fast.size(), slow.size());
    if (fast.empty()) continue;
    ASSERT_EQ(fast[0].points.size(), slow[0].points.size());
    EXPECT_LT(length(cast<double>(fast[0].normal - slow[0].normal)), near);
    for (std::size_t k = 0; k < fast[0].points.size(); ++k, ++compared) {
      const ContactPoint<T>&p = fast[0].points[k], &q = slow[0].points[k];
      EXPECT_NEAR(static_cast<double>(p.distance), static_cast<double>(q.distance), near);
      EXPECT_LT(length(cast<double>(p.a - q.a)), near);
      EXPECT_LT(length(cast<double>(p.b - q.b)), near);
      other_names += p.feature != q.feature;
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_EQ(other_names, 0);
}

TEST(CapsuleBoxContacts, AreThoseOfTheFaces) {
  expect_as_by_faces<float>(1, 1e-5);
  expect_as_by_faces<double>(2, 1e-10);
}

}  // namespace
}  // namespace graze::testing
