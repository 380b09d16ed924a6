// Capsules that touch boxes with an end or lie on them: the routine of its own against the general path,
// which goes by the faces.
#include <gtest/gtest.h>

#include <cmath>

#include "by_faces.hpp"
#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "in_general.hpp"

namespace graze::testing {
namespace {

template <class T>
void expect_as_by_faces(unsigned seed, double near) {
  Random random(seed);
  int compared = 0, other_names = 0;
  for (int i = 0; i < 4000; ++i) {
    const Shape<T> capsule(Capsule<T>(T(uniform(random, 0.1f, 1)), T(uniform(random, 0, 0.5f))),
                           T(i % 8 == 0 ? 0.1 : 0));
    const Shape<T> box(Box<T>(converted<T>(abs(random_vector(random, 1)) + Vec3f{0.1f, 0.1f, 0.1f})),
                       T(i % 7 == 0 ? 0.1 : 0));
    const Pose<T> pose{converted<T>(random_vector(random, 0.7f)),
                       i % 3 == 0 ? Quat<T>{} : normalized(converted<T>(random_rotation(random)))};
    const Pose<T> ground{converted<T>(random_vector(random, 0.7f)),
                         i % 2 == 0 ? Quat<T>{} : normalized(converted<T>(random_rotation(random)))};
    const bool turned = i % 5 == 0;
    Manifolds<T> fast, slow;
    const bool touch = turned ? contacts<T>(box, ground, capsule, pose, T(0.05), fast)
                              : contacts<T>(capsule, pose, box, ground, T(0.05), fast);
    EXPECT_EQ(touch, turned ? contacts_in_general<T>(box, ground, capsule, pose, T(0.05), slow)
                            : contacts_in_general<T>(capsule, pose, box, ground, T(0.05), slow));
    ASSERT_EQ(fast.size(), slow.size());
    if (fast.empty()) continue;
    ASSERT_EQ(fast[0].points.size(), slow[0].points.size());
    EXPECT_LT(length(converted<double>(fast[0].normal - slow[0].normal)), near);
    for (std::size_t k = 0; k < fast[0].points.size(); ++k, ++compared) {
      const ContactPoint<T>&p = fast[0].points[k], &q = slow[0].points[k];
      EXPECT_NEAR(static_cast<double>(p.distance), static_cast<double>(q.distance), near);
      EXPECT_LT(length(converted<double>(p.a - q.a)), near);
      EXPECT_LT(length(converted<double>(p.b - q.b)), near);
      other_names += p.feature != q.feature;
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_EQ(other_names, 0);
}

/// A capsule about lying on the upper side of a box: tilted by up to `tilt`, over the middle or beyond the rim, some
/// square to the box, some along its rim, some sunk in so far that another side is nearer.
template <class T>
ByFaces compare_lying(unsigned seed, double tilt, double scale) {
  Random random(seed);
  ByFaces found;
  const auto some = [&](double low, double high) {
    return static_cast<double>(uniform(random, static_cast<float>(low), static_cast<float>(high)));
  };
  const Quatd on_its_side = Quatd::from_axis_angle({0, 0, 1}, std::acos(0.0));
  for (int i = 0; i < 1000; ++i) {
    const double radius = i % 5 == 0 ? 0 : some(0.01, 0.5), rounded = i % 8 == 0 ? 0.1 : 0,
                 edges = i % 7 == 0 ? 0.1 : 0;
    const Vec3d size{some(0.1, 2), some(0.1, 2), some(0.1, 2)};
    Vec3d place{some(-0.7, 0.7) * size.x, size.y / 2 + radius + rounded + edges + some(-0.1, 0.02),
                some(-0.7, 0.7) * size.z};
    if (i % 13 == 0) place.y = some(-0.5, 0.5) * size.y;
    if (i % 17 == 0) place.z = size.z / 2;
    const double yaw = i % 11 == 0 ? std::acos(0.0) * (i % 4) : some(0, 6);
    const Quatd lean = Quatd::from_axis_angle({0, 0, 1}, i % 3 == 0 ? 0 : some(-tilt, tilt));
    const Posed ground{Vec3d{some(-1, 1), some(-1, 1), some(-1, 1)} * scale,
                       i % 2 == 0 ? Quatd{} : normalized(converted<double>(random_rotation(random)))};
    const Posed on{place * scale, Quatd::from_axis_angle({0, 1, 0}, yaw) * lean * on_its_side};
    const Shape<T> capsule(Capsule<T>(T(some(0.05, 2) * scale), T(radius * scale)), T(rounded * scale));
    const Shape<T> box(Box<T>(converted<T>(size * scale)), T(edges * scale));
    const Pose<T> pose = converted<T>(compose(ground, on)), pose_box = converted<T>(ground);
    const T margin = T(i % 6 == 0 ? 0 : 0.05 * scale);
    if (i % 5 == 1)
      found.compare(box, pose_box, capsule, pose, margin, scale);
    else
      found.compare(capsule, pose, box, pose_box, margin, scale);
  }
  return found;
}

TEST(CapsuleBoxContacts, OfThoseThatLieAreThoseOfTheFaces) {
  expect_as_faces_give(
      []<class T>(unsigned seed, double tilt, double scale) { return compare_lying<T>(seed, tilt, scale); }, 500);
}

TEST(CapsuleBoxContacts, AreThoseOfTheFaces) {
  expect_as_by_faces<float>(1, 1e-5);
  expect_as_by_faces<double>(2, 1e-10);
}

}  // namespace
}  // namespace graze::testing
