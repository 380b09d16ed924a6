// The kernels for contacts of two boxes, and of a box and a triangle, against the general way to lay faces over each
// other, as the general path does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "in_general.hpp"

namespace graze::testing {
namespace {

/// Area of the points' hull across the normal, by Jarvis' march (1973): from each corner to the one with all others
/// left.
template <class T>
double hull_area(const Manifold<T>& m) {
  const Vec3d n = normalized(converted<double>(m.normal)), u = any_perpendicular(n), v = cross(n, u);
  std::vector<std::pair<double, double>> points;
  for (const auto& p : m.points) {
    const Vec3d q = converted<double>(p.a) - converted<double>(m.points[0].a);
    points.push_back({dot(q, u), dot(q, v)});
  }
  const auto start = std::min_element(points.begin(), points.end());
  double twice = 0;
  auto at = *start;
  for (std::size_t step = 0; step < points.size(); ++step) {
    auto next = points[0];
    for (const auto& q : points) {
      const double left =
          (next.first - at.first) * (q.second - at.second) - (next.second - at.second) * (q.first - at.first);
      if (next == at || left < 0) next = q;
    }
    twice += at.first * next.second - at.second * next.first;
    at = next;
    if (at == *start) break;
  }
  return std::abs(twice) / 2;
}

template <class T>
T deepest(const Manifold<T>& m) {
  return std::min_element(m.points.begin(), m.points.end(),
                          [](const auto& p, const auto& q) { return p.distance < q.distance; })
      ->distance;
}

Vec3f half_extents(Random& random) { return abs(random_vector(random, 0.8f)) + Vec3f{0.2f, 0.2f, 0.2f}; }

template <class T>
Shape<T> random_box(Random& random, T scale) {
  return Box<T>(converted<T>(half_extents(random)) * scale);
}
/// Some of them slivers, to which other ways lead.
template <class T>
Shape<T> random_triangle(Random& random, T scale) {
  const auto corner = [&] { return converted<T>(random_vector(random, 1)) * scale; };
  const Vec3<T> a = corner(), b = corner(), c = corner(), middle = (a + b + c) / T(3);
  return Triangle<T>(a - middle, b - middle, c - middle);
}

/// `make(random, scale)` gives the second shape of each pair.
template <class T, class Make>
void expect_agreement(const Make& make, unsigned seed, double scale, double tolerance_of_size) {
  Random random(seed);
  std::size_t compared = 0, other_axis = 0, other_area = 0, other_count = 0;
  for (int i = 0; i < 10000; ++i) {
    const Shape<T> a = random_box(random, T(scale)), b = make(random, T(scale));
    const Quatf turn = random_rotation(random), other = random_rotation(random);
    const Vec3f lean = random_vector(random, 0.01f);
    const auto pose = [&](const Vec3f& place, const Quatf& q) {
      return Pose<T>{converted<T>(place) * T(scale), normalized(converted<T>(q))};
    };
    const Pose<T> pose_a = pose(random_vector(random, 0.4f), turn);
    const Pose<T> pose_b =
        pose(random_vector(random, 0.4f), i % 2 == 0 ? other : turn * Quatf{lean.x, lean.y, lean.z, 1});
    Manifolds<T> fast, general;
    const T margin = contact_margin(a, b);
    const bool touch = contacts(a, pose_a, b, pose_b, margin, fast),
               known = contacts_in_general(a, pose_a, b, pose_b, margin, general);
    const T close = T(tolerance_of_size * scale);
    if (fast.empty() != general.empty() || touch != known) {
      // Only where rounding decides.
      const T distance = graze::distance(a, pose_a, b, pose_b).distance;
      ASSERT_LE(least(std::abs(distance), std::abs(distance - margin)), close);
      continue;
    }
    if (fast.empty()) continue;
    ++compared;
    ASSERT_NEAR(deepest(fast[0]), deepest(general[0]), margin);
    if (dot(fast[0].normal, general[0].normal) < T(1 - 1e-6)) {
      ++other_axis;
      continue;
    }
    ASSERT_NEAR(deepest(fast[0]), deepest(general[0]), close);
    const double area = hull_area(general[0]);
    other_area += std::abs(hull_area(fast[0]) - area) > 0.05 * area + scale * scale * 1e-5;
    other_count += fast[0].points.size() != general[0].points.size();
  }
  EXPECT_GT(compared, 5000u);
  // Which of two axes that are about as good is taken, and which corners count as one: seldom another. The two ways
  // measure what is near in planes that lean by up to 55 degrees.
  EXPECT_LT(other_axis, compared / 100);
  EXPECT_LT(other_area, compared / 100);
  EXPECT_LT(other_count, compared / 50);
}

template <class T>
void expect_agreement(unsigned seed, double tolerance_of_size) {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    expect_agreement<T>(random_box<T>, seed, scale, tolerance_of_size);
    expect_agreement<T>(random_triangle<T>, seed, scale, tolerance_of_size);
  }
}

TEST(ContactSlots, AgreesWithFacesLaidOverEachOtherInDouble) { expect_agreement<double>(1, 1e-9); }

TEST(ContactSlots, AgreesWithFacesLaidOverEachOtherInFloat) { expect_agreement<float>(2, 2e-5); }

}  // namespace
}  // namespace graze::testing
