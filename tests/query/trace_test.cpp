// Explanations: what a trace holds is for show, and asking for it changes no bit of an answer.
#include "graze/trace.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

template <class T>
bool same_bits(const Vec3<T>& a, const Vec3<T>& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

template <class T>
void expect_same_bits(const Distance<T>& with, const Distance<T>& without) {
  EXPECT_TRUE(same_bits(with.distance, without.distance) && same_bits(with.normal, without.normal) &&
              same_bits(with.a, without.a) && same_bits(with.b, without.b) && with.status == without.status &&
              same_bits(with.error, without.error));
}

template <class T>
void expect_same_bits(const Manifolds<T>& with, const Manifolds<T>& without) {
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t m = 0; m < with.size(); ++m) {
    EXPECT_TRUE(same_bits(with[m].normal, without[m].normal));
    ASSERT_EQ(with[m].points.size(), without[m].points.size());
    for (std::size_t i = 0; i < with[m].points.size(); ++i) {
      const ContactPoint<T>&p = with[m].points[i], &q = without[m].points[i];
      EXPECT_TRUE(same_bits(p.a, q.a) && same_bits(p.b, q.b) && same_bits(p.distance, q.distance) &&
                  p.feature == q.feature && same_bits(p.weight, q.weight));
    }
  }
}

/// Every query with a trace and without one. Returns how many points of contact there were.
template <class T>
std::size_t expect_explained(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b) {
  Trace of_distance, of_overlap, of_contacts, of_closest;
  expect_same_bits(distance(a, pose_a, b, pose_b, &of_distance), distance(a, pose_a, b, pose_b));
  EXPECT_EQ(overlap(a, pose_a, b, pose_b, &of_overlap), overlap(a, pose_a, b, pose_b));
  Manifolds<T> with, without;
  const T margin = contact_margin(a, b);
  EXPECT_EQ(contacts(a, pose_a, b, pose_b, margin, with, &of_contacts),
            contacts(a, pose_a, b, pose_b, margin, without));
  expect_same_bits(with, without);
  const Vec3<T> point = pose_b.translation;
  const Closest<T> nearest = closest(a, pose_a, point, &of_closest), alone = closest(a, pose_a, point);
  EXPECT_TRUE(same_bits(nearest.distance, alone.distance) && same_bits(nearest.point, alone.point) &&
              same_bits(nearest.normal, alone.normal));
  for (const Trace* trace : {&of_distance, &of_overlap, &of_contacts, &of_closest}) EXPECT_FALSE(trace->method.empty());
  if (a.convex() && b.convex()) {
    // The last axis is that of the answer, along which the intervals overlap by the depth.
    EXPECT_EQ(of_distance.axes.back().name, "normal");
    if (!with.empty()) {
      EXPECT_EQ(of_contacts.axes.back().name, "normal");
    }
  }
  std::size_t points = 0;
  for (const Manifold<T>& m : with) points += m.points.size();
  return points;
}

template <class T>
Shape<T> composite(int which) {
  const std::vector<Vec3<T>> points{{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {0, T(0.7), 0}};
  if (which == 0) return Mesh<T>(points, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}});
  return Compound<T>({{Box<T>({1, 1, 1}), {{T(-0.6), 0, 0}, {}}}, {Cylinder<T>(1, T(0.4)), {{T(0.6), 0, 0}, {}}}});
}

template <class T>
void expect_all_explained(unsigned seed) {
  Random random(seed);
  std::size_t points = 0;
  for (int i = 0; i < kind_count; ++i)
    for (int j = 0; j < kind_count; ++j)
      for (int k = 0; k < 6; ++k) {
        const auto placed = [&](int kind) {
          return PlacedSpecimen{random_specimen(static_cast<Kind>(kind), 1, random), random_vector(random, 0.7f),
                                k % 3 == 0 ? Quatf{} : random_rotation(random)};
        };
        const PlacedSpecimen a = placed(i), b = placed(j);
        const Shape<T> sa = k == 4 ? composite<T>(i % 2) : build<T>(a.specimen),
                       sb = k == 5 ? composite<T>(j % 2) : build<T>(b.specimen);
        points += expect_explained(sa, pose_of<T>(a), sb, pose_of<T>(b));
      }
  EXPECT_GT(points, 500u);
}

TEST(Trace, AskingForItChangesNoBitOfAnyAnswer) {
  expect_all_explained<double>(3);
  expect_all_explained<float>(4);
}

// Stacked and tilted boxes, whose points come from a routine of their own: the trace shows the axis that these stand
// on.
TEST(Trace, ContactsOfBoxesStandOnTheWinner) {
  Random random(5);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Shape<double> a = Box<double>({1, 1, 1}), b = Box<double>({1, 0.5, 2});
    const Pose<double> pose_a{},
        pose_b{converted<double>(random_vector(random, 0.8f)), normalized(converted<double>(random_rotation(random)))};
    Manifolds<double> manifolds, alone;
    Trace trace;
    contacts(a, pose_a, b, pose_b, 0.0, manifolds, &trace);
    contacts(a, pose_a, b, pose_b, 0.0, alone);
    expect_same_bits(manifolds, alone);
    if (manifolds.empty()) continue;
    ++touching;
    ASSERT_EQ(trace.axes.size(), 16u);  // with the normal of the answer
    if (trace.method != "separating axes") continue;
    for (const TraceAxis& axis : trace.axes)
      if (axis.name == trace.winner) {
        EXPECT_LT(length(axis.direction - manifolds[0].normal), 1e-9) << trace.winner;
      }
  }
  EXPECT_GT(touching, 500);
}

}  // namespace
}  // namespace graze::testing
