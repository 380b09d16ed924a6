// The points of contact that two shapes get by a routine of their own against those of the general path, which lays the
// faces over each other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "graze/query.hpp"
#include "in_general.hpp"

namespace graze::testing {

/// What a number of comparisons came to. Where points of the same features are equally deep only one is kept, and
/// rounding chooses which: `ties` counts those.
struct ByFaces {
  int one = 0, two = 0, other_counts = 0, other_names = 0, ties = 0, far = 0;
  double furthest = 0;  ///< between two points that should be the same, relative to the scale

  template <class T>
  void compare(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
               double scale) {
    Manifolds<T> fast, slow;
    const bool touch = contacts<T>(a, pose_a, b, pose_b, margin, fast);
    EXPECT_EQ(touch, contacts_in_general<T>(a, pose_a, b, pose_b, margin, slow));
    ASSERT_EQ(fast.size(), slow.size());
    if (fast.empty()) return;
    const auto &p = fast[0].points, &q = slow[0].points;
    ++(p.size() == 1 ? one : two);
    ASSERT_LE(p.size(), 2u);
    if (p.size() != q.size()) {
      ++other_counts;
      return;
    }
    const auto apart = [&](const Vec3<T>& x, const Vec3<T>& y) { return length(converted<double>(x - y)) / scale; };
    EXPECT_LT(apart(fast[0].normal * T(scale), slow[0].normal * T(scale)), 1e-6);
    for (std::size_t k = 0; k < p.size(); ++k) {
      other_names += p[k].feature != q[k].feature;
      const double off = std::max(apart(p[k].a, q[k].a), apart(p[k].b, q[k].b)),
                   deeper = std::abs(static_cast<double>(p[k].distance - q[k].distance)) / scale;
      EXPECT_LT(length(p[k].b - p[k].a - fast[0].normal * p[k].distance), T(1e-5 * scale));
      const bool tie = p.size() == 1 && off < 0.02 && p[k].feature == q[k].feature && deeper < 1e-6;
      ties += tie && off > 1e-6;
      if (!tie) furthest = std::max({furthest, off, deeper});
    }
  }
  void expect_all_same(double near) const { expect_all_but(0, near); }
  /// But for so many on the verge of another count or name, which rounding decides.
  void expect_all_but(int few, double near) const {
    EXPECT_LE(other_counts, few);
    EXPECT_LE(other_names, few);
    EXPECT_LE(ties, 5);
    EXPECT_LT(furthest, near);
  }
};

/// Of shapes of a thousandth to a thousand, tilted by two angles: `compare<T>(seed, tilt, scale)` returns what random
/// pairs came to, of which at least so many must touch in two points.
template <class Compare>
void expect_as_faces_give(const Compare& compare, int two) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    for (const double tilt : {0.02, 0.06}) {
      const ByFaces in_double = compare.template operator()<double>(3, tilt, scale),
                    in_float = compare.template operator()<float>(4, tilt, scale);
      in_double.expect_all_same(1e-9);
      in_float.expect_all_but(3, 2e-5);
      EXPECT_GT(in_double.two, two);
      EXPECT_GT(in_double.one, 60);
    }
  }
}

}  // namespace graze::testing
