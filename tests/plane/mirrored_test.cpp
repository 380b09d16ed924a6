// Contacts of A and B, and of B and A: the same points, with both halves of their names exchanged, on both surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "plane/figures.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneMirrored : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneMirrored, Scalars);

template <class T>
struct Named {
  const char* name;
  Shape<T> shape;
};

/// Shapes with straight sides and names, sharp and rounded, of one piece and of several.
template <class T>
std::vector<Named<T>> shapes_with_sides() {
  const auto points = [](std::initializer_list<Vec2d> from) {
    std::vector<Vec2<T>> to;
    for (const Vec2d& p : from) to.push_back(converted<T>(p));
    return to;
  };
  const auto notched = points({{-1, -1}, {1, -1}, {1, 1}, {0, -0.4}, {-1, 1}});
  const auto line = points({{-2, 0}, {-0.7, -0.3}, {0.3, -0.2}, {2, 0.2}});
  const auto ring = points({{-0.8, -0.5}, {0.5, -0.5}, {0.6, 0.5}, {-0.5, 0.4}});
  return {
      {"capsule", Capsule<T>(T(0.8), T(0.3))},
      {"tapered capsule", Capsule<T>(T(0.8), T(0.3), T(0.2))},
      {"segment", Segment<T>({T(-0.5), T(0)}, {T(0.6), T(0.1)})},
      {"box", Box<T>({T(1.4), T(0.9)})},
      {"rounded box", {Box<T>({T(1.4), T(0.9)}), T(0.2)}},
      {"convex polygon", ConvexPolygon<T>(points({{-0.6, -0.5}, {0.7, -0.4}, {0.9, 0.3}, {0.1, 0.8}, {-0.7, 0.4}}))},
      {"polygon", Polygon<T>(notched)},
      {"chain", Chain<T>(line)},
      {"closed chain", Chain<T>(ring, true)}};
}

/// Whether its normals are searched for, within the root of what a distance is right to.
template <class T>
bool is_searched(const Named<T>& shape) {
  const auto* capsule = shape.shape.template as<Capsule<T>>();
  return capsule && capsule->radius_bottom() != capsule->radius_top();
}

/// A pose of B in some direction from A, about `gap` apart; less than zero is deep.
template <class T>
Pose2<T> pose_near(const Shape<T>& a, const Shape<T>& b, double gap, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-3.2, 3.2);
  const double way = any(random);
  Pose2<T> pose{converted<T>(Vec2d{std::cos(way), std::sin(way)} * 5),
                Rot2<T>::from_angle(static_cast<T>(any(random)))};
  const Distance<T> d = distance<T>(a, {}, b, pose);
  pose.translation -= d.normal * (d.distance - static_cast<T>(gap));
  return pose;
}

std::uint32_t mirrored(std::uint32_t feature) { return (feature << 16) | (feature >> 16); }

template <class T>
std::size_t point_count(const Manifolds<T>& manifolds) {
  std::size_t count = 0;
  for (const Manifold<T>& m : manifolds) count += m.points.size();
  return count;
}

/// Whether the points of one are those of the other, in whatever order.
template <class T>
bool mirror(const Manifolds<T>& there, const Manifolds<T>& back, T near) {
  if (point_count(there) != point_count(back)) return false;
  for (const Manifold<T>& m : there)
    for (const ContactPoint<T>& p : m.points) {
      const bool found = std::any_of(back.begin(), back.end(), [&](const Manifold<T>& n) {
        return std::any_of(n.points.begin(), n.points.end(), [&](const ContactPoint<T>& q) {
          return q.feature == mirrored(p.feature) && length(q.a - p.b) <= near && length(q.b - p.a) <= near;
        });
      });
      if (!found) return false;
    }
  return true;
}

TYPED_TEST(PlaneMirrored, PointsAndNamesAreExchangedByASwap) {
  using T = TypeParam;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> gaps(-0.08, 0.04);
  const auto margin = static_cast<T>(0.05);
  const T rounding = 16 * std::numeric_limits<T>::epsilon();
  const auto shapes = shapes_with_sides<T>();
  for (const auto& a : shapes)
    for (const auto& b : shapes) {
      int differ = 0, twice = 0, off = 0;
      const T near = is_searched(a) || is_searched(b) ? static_cast<T>(1e-4) : 32 * rounding;
      for (int i = 0; i < 300; ++i) {
        const Pose2<T> pose = pose_near<T>(a.shape, b.shape, gaps(random), random);
        Manifolds<T> there, back;
        contacts<T>(a.shape, {}, b.shape, pose, margin, there);
        contacts<T>(b.shape, pose, a.shape, {}, margin, back);
        differ += mirror(there, back, near) ? 0 : 1;
        for (const Manifold<T>& m : there) {
          twice += m.points.size() == 2 && length(m.points[0].a - m.points[1].a) <= rounding ? 1 : 0;
          for (const ContactPoint<T>& p : m.points) {
            const T from_a = std::abs(closest<T>(a.shape, {}, p.a).distance),
                    from_b = std::abs(closest<T>(b.shape, pose, p.b).distance);
            off += std::max(from_a, from_b) > static_cast<T>(1e-4) ? 1 : 0;
          }
        }
      }
      // Which of two pieces has a contact may be a matter of rounding.
      const int allowed = a.shape.convex() && b.shape.convex() ? 0 : 1;
      EXPECT_TRUE(differ <= allowed && twice == 0 && off == 0)
          << a.name << " and " << b.name << ": " << differ << " differ, " << twice << " twice, " << off
          << " on no surface";
    }
}

// The side of a closed chain that begins at a corner of the bottom has no part in what lies below the whole bottom.
TYPED_TEST(PlaneMirrored, AChainTouchesWhereItIs) {
  using T = TypeParam;
  const auto number = [](double x) { return static_cast<T>(x); };
  const std::vector<Vec2<T>> square{{number(-0.5), number(-0.5)},
                                    {number(0.5), number(-0.5)},
                                    {number(0.5), number(0.5)},
                                    {number(-0.5), number(0.5)}};
  const Shape<T> chain = Chain<T>(square, true), table = Box<T>({T(10), T(2)});
  for (const double turn : {-1e-5, 0.0, 1e-5}) {
    const Pose2<T> pose{{number(0.73), number(1.498)}, Rot2<T>::from_angle(number(turn))};
    Manifolds<T> found;
    EXPECT_TRUE(contacts<T>(table, {}, chain, pose, T(0), found));
    ASSERT_EQ(point_count(found), 2u) << turn;
    for (const ContactPoint<T>& p : found[0].points) EXPECT_NEAR(double(p.b.x), 0.73, 0.501) << turn;
  }
}

// Two children whose contacts have the same normal are one manifold where they are in line, and two where one of them
// is deeper between the ends of the other.
TYPED_TEST(PlaneMirrored, WhatBulgesOutBetweenTwoPointsIsKept) {
  using T = TypeParam;
  const auto number = [](double x) { return static_cast<T>(x); };
  const Shape<T> compound = Compound<T>({{Circle<T>(number(0.4)), {{number(0.5), T(0)}, {}}},
                                         {Box<T>({T(1), number(0.4)}), {{}, Rot2<T>::from_angle(number(0.7))}}});
  for (const double lifted : {0.0, 0.2, 0.4, 0.6}) {
    const Pose2<T> pose{{T(0), number(lifted)}, Rot2<T>::from_angle(number(-0.6))};
    const Shape<T> ground = HalfPlane<T>();
    Manifolds<T> found;
    contacts<T>(ground, {}, compound, pose, T(0), found);
    T deepest(0);
    for (const Manifold<T>& m : found)
      for (const ContactPoint<T>& p : m.points) deepest = std::min(deepest, p.distance);
    EXPECT_NEAR(double(deepest), double(distance<T>(ground, {}, compound, pose).distance), 1e-6) << lifted;
  }
}

}  // namespace
}  // namespace graze::plane
