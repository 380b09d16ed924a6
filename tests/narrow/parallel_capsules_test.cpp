// Capsules that lie side by side: the routine of its own against the faces, and where it has little to go by.
#include <gtest/gtest.h>

#include <cmath>

#include "by_faces.hpp"
#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

template <class T>
ByFaces compare_parallel(unsigned seed, double tilt, double scale) {
  Random random(seed);
  ByFaces found;
  const auto some = [&](double low, double high) {
    return static_cast<double>(uniform(random, static_cast<float>(low), static_cast<float>(high)));
  };
  const double straight = std::acos(-1);
  for (int i = 0; i < 1000; ++i) {
    const double radius_a = i % 5 == 0 ? 0 : some(0.01, 0.5), radius_b = i % 10 == 0 ? 0 : some(0.01, 0.5),
                 rounded = i % 8 == 0 ? 0.1 : 0, half_a = some(0.05, 2), half_b = some(0.05, 2), turn = some(0, 6);
    const double apart = radius_a + radius_b + rounded + some(-0.1, 0.02);
    const Vec3d beside{apart * std::cos(turn), some(-0.7, 0.7) * (half_a + half_b), apart * std::sin(turn)};
    const Quatd lean = Quatd::from_axis_angle(normalized(Vec3d{some(-1, 1), 0, some(-1, 1)}, {1, 0, 0}),
                                              (i % 3 == 0 ? 0 : some(-tilt, tilt)) + (i % 19 == 0 ? straight : 0));
    const Posed frame{Vec3d{some(-1, 1), some(-1, 1), some(-1, 1)} * scale,
                      normalized(converted<double>(random_rotation(random)))};
    const Shape<T> a(Capsule<T>(T(half_a * scale), T(radius_a * scale)), T(rounded * scale));
    const Shape<T> b(Capsule<T>(T(half_b * scale), T(radius_b * scale)));
    found.compare(a, converted<T>(compose(frame, Posed{beside * scale, lean})), b, converted<T>(frame),
                  T(i % 6 == 0 ? 0 : 0.05 * scale), scale);
  }
  return found;
}

TEST(ParallelCapsules, TouchWhereTheirFacesDo) {
  expect_as_faces_give(
      []<class T>(unsigned seed, double tilt, double scale) { return compare_parallel<T>(seed, tilt, scale); }, 300);
}

template <class T>
Manifold<T> between(const Capsule<T>& a, const Pose<T>& pose_a, const Capsule<T>& b, const Pose<T>& pose_b) {
  Manifolds<T> found;
  contacts<T>(Shape<T>(a), pose_a, Shape<T>(b), pose_b, T(0.1), found);
  EXPECT_EQ(found.size(), 1u);
  return found.empty() ? Manifold<T>() : found[0];
}

// One above the other, shifted along: both points lie at the ends of the stretch that they share.
TEST(ParallelCapsules, TouchAtTheEndsOfWhatTheyShare) {
  const Capsule<double> rod(2, 0.5);
  const Manifold<double> m = between<double>(rod, {}, rod, {{0.95, 1.2, 0}, {}});
  ASSERT_EQ(m.points.size(), 2u);
  EXPECT_EQ(m.normal, (Vec3d{1, 0, 0}));
  const double ends[] = {0.2, 1};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(m.points[i].distance, -0.05, 1e-12);
    EXPECT_LT(length(m.points[i].a - Vec3d{0.5, ends[i], 0}), 1e-12);
    EXPECT_LT(length(m.points[i].b - Vec3d{0.45, ends[i], 0}), 1e-12);
  }
}

// Which of the two comes first changes their places and nothing else.
TEST(ParallelCapsules, AreTheSameTheOtherWayRound) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Capsule<double> a(static_cast<double>(uniform(random, 0.2f, 2)), 0.3),
        b(static_cast<double>(uniform(random, 0.2f, 2)), 0.2);
    const Quatd lean = Quatd::from_axis_angle({1, 0, 0}, static_cast<double>(uniform(random, -0.02f, 0.02f)));
    const Posed beside{{0.48, static_cast<double>(uniform(random, -0.3f, 0.3f)), 0.05}, lean};
    const Manifold<double> one = between<double>(a, {}, b, beside), other = between<double>(b, beside, a, {});
    ASSERT_EQ(one.points.size(), other.points.size());
    EXPECT_LT(length(one.normal + other.normal), 1e-12);
    for (const ContactPoint<double>& p : one.points) {
      double nearest = 1;
      for (const ContactPoint<double>& q : other.points)
        nearest = std::min(nearest, length(p.a - q.b) + length(p.b - q.a));
      EXPECT_LT(nearest, 1e-3);  // ends are sought across the first of the two, and lean from those across the second
    }
  }
}

// Lines without a radius, one on the other; the same capsule twice; ends that meet: numbers come out, and at least one
// point.
TEST(ParallelCapsules, AnswerWhereNothingTellsADirection) {
  const Quatd over = Quatd::from_axis_angle({1, 0, 0}, std::acos(-1));
  for (const double radius : {0.0, 1e-4, 0.5})
    for (const Posed& pose : {Posed{}, Posed{{0, 0.5, 0}, {}}, Posed{{0, 2, 0}, {}}, Posed{{0, 0, 0}, over}}) {
      const Capsule<double> rod(2, radius);
      const Manifold<double> m = between<double>(rod, {}, rod, pose);
      ASSERT_GE(m.points.size(), 1u);
      EXPECT_NEAR(length(m.normal), 1, 1e-12);
      for (const ContactPoint<double>& p : m.points) {
        EXPECT_LE(p.distance, 1e-12);
        EXPECT_LT(length(p.b - p.a - m.normal * p.distance), 1e-12);
      }
    }
}

}  // namespace
}  // namespace graze::testing
