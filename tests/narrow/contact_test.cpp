// What is done with contacts: fewer points, and how the bodies move there.
#include "graze/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "graze/contact_motion.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

Manifold<double> manifold_of(const std::vector<Vec3d>& points) {
  Manifold<double> m;
  m.normal = {0, 1, 0};
  for (const Vec3d& p : points)
    m.points.push_back({p, p, p.y, static_cast<std::uint32_t>(m.points.size())});  // as deep as it is low
  return m;
}
std::vector<std::uint32_t> names(const Manifold<double>& m) {
  std::vector<std::uint32_t> all;
  for (const auto& p : m.points) all.push_back(p.feature);
  return all;
}

TEST(Reduce, KeepsTheDeepestThenWhatSpansMost) {
  // A square, the middles of its sides, and a point inside that is deepest.
  Manifold<double> m = manifold_of(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}, {0, 0, 2}, {0, 0, 1}, {0.2, -1, 0.2}});
  Manifold<double> one = m;
  reduce(one, 1);
  EXPECT_EQ(names(one), (std::vector<std::uint32_t>{8}));
  Manifold<double> two = m;
  reduce(two, 2);
  EXPECT_EQ(names(two), (std::vector<std::uint32_t>{4, 8}));
  Manifold<double> four = m;
  reduce(four, 4);
  EXPECT_EQ(names(four), (std::vector<std::uint32_t>{2, 4, 6, 8}));
  Manifold<double> all = m;
  reduce(all, 9);
  EXPECT_EQ(all.points.size(), 9u);
  reduce(all, 0);
  EXPECT_TRUE(all.points.empty());
}

TEST(Reduce, OfAnOctagonFourPointsKeepMostOfTheArea) {
  const Shaped box = Box<double>({2, 2, 2});
  Manifolds<double> manifolds;
  contacts(box, Posed{}, box, Posed{{0, 1.99, 0}, Quatd::from_axis_angle({0, 1, 0}, std::acos(-1) / 4)}, 0.0,
           manifolds);
  Manifold<double> m = manifolds.at(0);
  ASSERT_EQ(m.points.size(), 8u);
  reduce(m, 4);
  double widest = 0;
  for (const auto& p : m.points)
    for (const auto& q : m.points) widest = std::max(widest, length(p.a - q.a));
  EXPECT_NEAR(widest, 2 / std::cos(std::acos(-1) / 8), 1e-9);  // opposite corners of the octagon
}

TEST(Reduce, ManagesCollinearAndCoincidentPoints) {
  Manifold<double> line = manifold_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  reduce(line, 3);
  EXPECT_EQ(names(line), (std::vector<std::uint32_t>{0, 1, 3}));
  Manifold<double> same = manifold_of({{1, 0, 1}, {1, 0, 1}, {1, 0, 1}});
  reduce(same, 2);
  EXPECT_EQ(same.points.size(), 2u);
}

// A wheel of radius 1 rolls to the right on the ground below it: its lowest point stands still.
TEST(ContactMotion, ARollingWheelDoesNotSlide) {
  const ContactPoint<double> contact{{0, 0, 0}, {0, 0, 0}, 0, 0};
  const Vec3d up{0, 1, 0};  // from the ground, A, to the wheel, B
  const Motion<double> ground{}, wheel{{2, 0, 0}, {0, 0, -2}, {0, 1, 0}}, locked{{2, 0, 0}, {}, {0, 1, 0}};
  EXPECT_EQ(relative_velocity(contact, up, ground, wheel).whole, (Vec3d{}));
  const RelativeVelocity<double> sliding = relative_velocity(contact, up, ground, locked);
  EXPECT_EQ(sliding.normal, 0);
  EXPECT_EQ(sliding.tangential, (Vec3d{2, 0, 0}));
  EXPECT_EQ(velocity_at(wheel, Vec3d{0, 2, 0}), (Vec3d{4, 0, 0}));
}

TEST(ContactMotion, PartsAddUpAndTheNormalPartIsNegativeWhenApproaching) {
  const ContactPoint<double> contact{{0, 0, 0}, {0, -0.1, 0}, -0.1, 0};
  const Vec3d n = normalized(Vec3d{1, 2, 3});
  const Motion<double> a{{1, -2, 0.5}, {0.3, 0.1, -0.2}, {1, 0, 0}}, b{{-1, 0.5, -3}, {0, 1, 0}, {0, 0, 2}};
  const RelativeVelocity<double> v = relative_velocity(contact, n, a, b);
  EXPECT_LT(length(v.tangential + n * v.normal - v.whole), 1e-15);
  EXPECT_NEAR(dot(v.tangential, n), 0, 1e-15);
  EXPECT_LT(v.normal, 0);
}

TEST(ContactMotion, AtFaultIsWhoMovesIntoTheOther) {
  const ContactPoint<double> contact{};
  const Vec3d n{1, 0, 0};
  const auto moving = [](double x) { return Motion<double>{{x, 0, 0}, {}, {}}; };
  EXPECT_EQ(at_fault(contact, n, moving(1), moving(0)), AtFault::a);
  EXPECT_EQ(at_fault(contact, n, moving(0), moving(-1)), AtFault::b);
  EXPECT_EQ(at_fault(contact, n, moving(1), moving(-1)), AtFault::both);
  EXPECT_EQ(at_fault(contact, n, moving(2), moving(1)), AtFault::a);  // runs into one that flees
  EXPECT_EQ(at_fault(contact, n, moving(1), moving(2)), AtFault::neither);
  EXPECT_EQ(at_fault(contact, n, moving(0), moving(0)), AtFault::neither);
}

TEST(ContactMargin, FollowsTheSmallerShape) {
  const Shaped small = Sphere<double>(0.5), big = Box<double>({200, 200, 200}), ground = HalfSpace<double>();
  EXPECT_EQ(contact_margin(small, big), 0.005);
  EXPECT_EQ(contact_margin(ground, small), 0.005);
  EXPECT_EQ(contact_margin(ground, ground), 0);
}

}  // namespace
}  // namespace graze
