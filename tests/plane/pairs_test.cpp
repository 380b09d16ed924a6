// The special pairs of the plane against the walk around the Minkowski difference, to which a compound of one child
// sends the same shapes, and against a sweep over directions in extended precision.
#include <gtest/gtest.h>

#include "plane/figures.hpp"
#include "plane/pairs/lane_shape.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlanePairs : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlanePairs, Scalars);

constexpr int special_kinds = 5;

/// A shape of a kind that has special pairs; some without a length, a width or a radius, some rounded.
template <class T>
Shape<T> special_shape(int kind, double scale, std::mt19937& random) {
  const auto size = [&](double low, double high) {
    return random() % 8 == 0 ? T(0) : static_cast<T>(scale * std::uniform_real_distribution<double>(low, high)(random));
  };
  const T rounding = random() % 3 == 0 ? size(0, 0.3) : T(0);
  switch (kind) {
  case 0: return {Circle<T>(size(0.1, 1)), rounding};
  case 1: return {Capsule<T>(size(0.2, 2), size(0.1, 0.7)), rounding};
  case 2: {
    const Vec2<T> a{size(-1, 1), size(-1, 1)}, b{size(-1, 1), size(-1, 1)};
    return {random() % 8 == 0 ? Segment<T>(a, a) : Segment<T>(a, b), rounding};
  }
  case 3: return {Box<T>({size(0.2, 2), size(0.2, 2)}), rounding};
  default: return {HalfPlane<T>(), rounding};
  }
}

template <class T>
Shape<T> by_the_walk(const Shape<T>& shape) {
  return Compound<T>({{shape, {}}});
}

template <class T, class F>
void for_special_pairs(int rounds, const F& f) {
  std::mt19937 random(11);
  for (const double scale : {1e-4, 1.0, 1e5})
    for (int round = 0; round < rounds; ++round)
      for (int i = 0; i < special_kinds; ++i)
        for (int j = 0; j < special_kinds; ++j) {
          if (i == 4 && j == 4) continue;
          const Shape<T> a = special_shape<T>(i, scale, random), b = special_shape<T>(j, scale, random);
          const double spread = random() % 2 ? scale / 2 : scale / 8;
          const Pose2<T> pose_a = random_pose<T>(spread, random), pose_b = random_pose<T>(spread, random);
          f(a, pose_a, b, pose_b, scale,
            std::string(a.name()) + " and " + b.name() + " of " + std::to_string(scale) + ", round " +
                std::to_string(round));
        }
}

/// What the points of answers may be off: a few roundings of T, of numbers as large as the pair and where it stands.
template <class T>
double rounding_of(double scale) {
  return 32 * double(std::numeric_limits<T>::epsilon()) * scale;
}

template <class T>
double far(const Vec2<T>& a, const Vec2<T>& b) {
  return std::hypot(double(a.x) - double(b.x), double(a.y) - double(b.y));
}

TYPED_TEST(PlanePairs, DistanceIsThatOfTheWalk) {
  using T = TypeParam;
  for_special_pairs<T>(300, [](const auto& a, const auto& pose_a, const auto& b, const auto& pose_b, double scale,
                               const std::string& pair) {
    const Distance<T> d = distance(a, pose_a, b, pose_b);
    const Distance<T> walk = distance(by_the_walk(a), pose_a, b, pose_b);
    const double allowed = rounding_of<T>(scale);
    ASSERT_NEAR(double(d.distance), double(walk.distance), allowed) << pair;
    ASSERT_EQ(d.status, Status::converged);
    ASSERT_NEAR(length(d.normal), 1, 4 * double(std::numeric_limits<T>::epsilon())) << pair;
    ASSERT_LE(far(d.b, d.a + d.normal * d.distance), allowed) << pair;
    // Both points lie on the surfaces.
    ASSERT_NEAR(double(distance(by_the_walk(a), pose_a, Shape<T>(Circle<T>(T(0))), {d.a, {}}).distance), 0, 4 * allowed)
        << pair;
    ASSERT_NEAR(double(distance(by_the_walk(b), pose_b, Shape<T>(Circle<T>(T(0))), {d.b, {}}).distance), 0, 4 * allowed)
        << pair;
    // Moved apart by the distance the shapes touch.
    const Pose2<T> moved{pose_b.translation - d.normal * d.distance, pose_b.rotation};
    ASSERT_NEAR(double(distance(by_the_walk(a), pose_a, b, moved).distance), 0, 4 * allowed) << pair;
    ASSERT_EQ(overlap(a, pose_a, b, pose_b), d.distance <= T(0)) << pair;
    const Distance<T> back = distance(b, pose_b, a, pose_a);
    ASSERT_NEAR(double(back.distance), double(d.distance), allowed) << pair;
  });
}

TYPED_TEST(PlanePairs, ContactsAreThoseOfTheWalk) {
  using T = TypeParam;
  int points = 0, other_axes = 0;
  for_special_pairs<T>(300, [&](const auto& a, const auto& pose_a, const auto& b, const auto& pose_b, double scale,
                                const std::string& pair) {
    const T margin = static_cast<T>(0.1 * scale);
    const double allowed = rounding_of<T>(scale);
    Manifolds<T> special, walk, back;
    const bool touch = contacts(a, pose_a, b, pose_b, margin, special);
    const Distance<T> d = distance(a, pose_a, b, pose_b);
    ASSERT_EQ(touch, d.distance <= T(0)) << pair;
    if (std::abs(double(d.distance) - double(margin)) <= allowed) return;
    contacts(by_the_walk(a), pose_a, b, pose_b, margin, walk);
    contacts(b, pose_b, a, pose_a, margin, back);
    ASSERT_EQ(special.size(), walk.size()) << pair;
    ASSERT_EQ(special.size(), back.size()) << pair;
    if (special.empty()) return;
    // Two axes of equal overlap, and shapes that touch in a point without a direction, leave a choice.
    if (far(special[0].normal, walk[0].normal) > 1e-4 || far(special[0].normal, -back[0].normal) > 1e-4) {
      ++other_axes;
      return;
    }
    T deepest = special[0].points[0].distance;
    for (const ContactPoint<T>& p : special[0].points) {
      ++points;
      deepest = std::min(deepest, p.distance);
      ASSERT_LE(far(p.b, p.a + special[0].normal * p.distance), allowed) << pair;
    }
    ASSERT_NEAR(double(deepest), double(d.distance), 4 * allowed) << pair;
    // A point may be left out or go with its feature where the other end of a side is within rounding of the margin or
    // of the shared stretch's length; elsewhere all agree.
    const auto settled = [&](const Manifolds<T>& m) {
      for (const ContactPoint<T>& p : m[0].points)
        if (std::abs(double(p.distance) - double(margin)) <= 64 * allowed) return false;
      return m[0].points.size() < 2 || far(m[0].points[0].a, m[0].points[1].a) > 64 * allowed;
    };
    if (!settled(special) || !settled(walk) || !settled(back)) return;
    ASSERT_EQ(special[0].points.size(), walk[0].points.size()) << pair;
    ASSERT_EQ(special[0].points.size(), back[0].points.size()) << pair;
    if (special[0].points.size() < 2) return;
    for (const ContactPoint<T>& p : special[0].points) {
      const auto same = [&](const Manifolds<T>& m, std::uint32_t feature) {
        return std::count_if(m[0].points.begin(), m[0].points.end(),
                             [&](const auto& q) { return q.feature == feature; });
      };
      ASSERT_EQ(same(walk, p.feature), 1) << pair;
      ASSERT_EQ(same(back, (p.feature << 16) | (p.feature >> 16)), 1) << pair;
    }
  });
  EXPECT_GT(points, 20000);
  EXPECT_LT(other_axes, points / 20);
}

// Boxes and rounded boxes that rest on each other or on a half-plane: the names of their points stay.
TYPED_TEST(PlanePairs, NamesOfRestingBoxesStayUnderJitter) {
  using T = TypeParam;
  std::mt19937 random(3);
  for (const double scale : {1e-4, 1.0, 1e5})
    for (const double rounding : {0.0, 0.1})
      for (const double offset : {0.0, 0.3, -0.7}) {
        const Shape<T> box{Box<T>({static_cast<T>(scale), static_cast<T>(scale)}), static_cast<T>(rounding * scale)};
        const Shape<T> ground = HalfPlane<T>();
        std::uniform_real_distribution<double> jitter(-1e-4, 1e-4);
        const auto pose = [&](double x, double y) {
          return Pose2<T>{{static_cast<T>(scale * (x + jitter(random))), static_cast<T>(scale * (y + jitter(random)))},
                          Rot2<T>::from_angle(static_cast<T>(jitter(random)))};
        };
        const auto names = [&](const Shape<T>& a, const Pose2<T>& pose_a, const Pose2<T>& pose_b) {
          Manifolds<T> m;
          contacts(a, pose_a, box, pose_b, static_cast<T>(0.01 * scale), m);
          std::vector<std::uint32_t> found;
          if (m.size() == 1)
            for (const auto& p : m[0].points) found.push_back(p.feature);
          return found;
        };
        std::vector<std::uint32_t> on_box, on_ground;
        for (int frame = 0; frame < 500; ++frame) {
          const auto stacked = names(box, pose(0, 0), pose(offset, 0.999 + 2 * rounding));
          const auto grounded = names(ground, {}, pose(offset, 0.499 + rounding));
          if (frame == 0) on_box = stacked, on_ground = grounded;
          ASSERT_EQ(stacked.size(), 2u) << scale << " " << rounding << " " << offset << ", frame " << frame;
          ASSERT_EQ(stacked, on_box) << scale << " " << rounding << " " << offset << ", frame " << frame;
          ASSERT_EQ(grounded.size(), 2u) << scale << " " << rounding << " " << offset << ", frame " << frame;
          ASSERT_EQ(grounded, on_ground) << scale << " " << rounding << " " << offset << ", frame " << frame;
        }
      }
}

// Boxes exactly edge on edge and shapes upon each other: rounding has no say in the normal.
TYPED_TEST(PlanePairs, TouchingEdgesHaveTheirNormal) {
  using T = TypeParam;
  const Shape<T> box = Box<T>({2, 1}), segment = Segment<T>({-1, 0}, {1, 0});
  for (const T x : {T(0), T(2), T(-2), T(0.7)}) {
    const Distance<T> d = distance(box, {}, box, {{x, 1}, {}});
    EXPECT_EQ(d.distance, T(0));
    if (std::abs(x) < T(2)) {
      EXPECT_EQ(d.normal, (Vec2<T>{0, 1})) << x;
    }
    EXPECT_NEAR(length(d.normal), T(1), 4 * std::numeric_limits<T>::epsilon());
  }
  EXPECT_EQ(distance(box, {}, segment, {{0.25, T(0.5)}, {}}).normal, (Vec2<T>{0, 1}));
  const Distance<T> same = distance(segment, {}, segment, {});
  EXPECT_EQ(same.distance, T(0));
  EXPECT_EQ(std::abs(same.normal.y), T(1));
  const Distance<T> in_line = distance(segment, {}, segment, {{5, 0}, {}});
  EXPECT_EQ(in_line.distance, T(3));
  EXPECT_EQ(in_line.normal, (Vec2<T>{1, 0}));
}

}  // namespace
}  // namespace graze::plane
