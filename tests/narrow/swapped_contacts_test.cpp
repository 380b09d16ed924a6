// Two shapes in each other's place: the same contacts, mirrored to the last bit, though often two choices are as good;
// of two triangles but for rounding. One pair in four lies exactly flat, as they are and turned.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "graze/query.hpp"
#include "narrow/manifold/features.hpp"

namespace graze::testing {
namespace {

template <class T>
struct SwappedPair {
  Shape<T> a, b;
  Pose<T> pose_a, pose_b;
  T margin;

  Manifolds<T> there() const { return contacts_of(a, pose_a, b, pose_b); }
  Manifolds<T> back() const { return contacts_of(b, pose_b, a, pose_a); }

 private:
  Manifolds<T> contacts_of(const Shape<T>& one, const Pose<T>& at, const Shape<T>& other,
                           const Pose<T>& other_at) const {
    Manifolds<T> found;
    contacts(one, at, other, other_at, margin, found);
    return found;
  }
};

template <class T>
class SwappedContacts : public ::testing::Test {
 protected:
  double draw(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  T size() { return T(draw(0.15, 0.55)); }

  static constexpr int kinds = 8, all_kinds = 11;  ///< of which the first are mirrored exactly on their own kind too
  static constexpr int sharp_triangle = 8, rounded_triangle = 11;
  Shape<T> shape(int kind) {
    if (kind == 0) return Rectangle<T>(2 * size(), 2 * size());
    if (kind == 1) return Cylinder<T>(size(), size());
    if (kind == 2) return Shape<T>(Cylinder<T>(size(), size()), size() / 8);
    if (kind == 3) return Cylinder<T>(size(), size(), size() / 2);
    if (kind == 4) return Ellipsoid<T>({size(), size(), size()});
    if (kind == 5) return box();
    if (kind == 6) return Shape<T>(box(), size() / 8);
    if (kind == sharp_triangle) return triangle();
    if (kind == 9) return Sphere<T>(size());
    if (kind == 10) return Capsule<T>(size(), size(), size() / 4);
    if (kind == rounded_triangle) return Shape<T>(triangle(), size() / 8);
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 10; ++i) points.push_back({T(draw(-0.5, 0.5)), T(draw(-0.5, 0.5)), T(draw(-0.5, 0.5))});
    return ConvexHull<T>(points);
  }
  Box<T> box() {
    const T x = 2 * size(), y = 2 * size();
    return Box<T>({x, y, 2 * size()});
  }
  Triangle<T> triangle() {
    const T left = -size(), back = -size(), right = size();
    return {{left, 0, back}, {right, 0, 0}, {0, 0, size()}};
  }
  /// Upright in one case of two, exactly or up to a milliradian.
  Pose<T> pose(int i) {
    const double lean = i % 4 == 0 ? 0 : i % 2 == 0 ? 1e-3 * draw(-1, 1) : draw(-3, 3), about = draw(-3, 3);
    const Quatd leans = Quatd::from_axis_angle({std::cos(about), 0, std::sin(about)}, lean);
    const Quatd turned = Quatd::from_axis_angle({0, 1, 0}, draw(-3, 3));
    return {{T(draw(-0.3, 0.3)), 0, T(draw(-0.3, 0.3))}, converted<T>(normalized(leans * turned))};
  }
  Quatd turn() {
    const double x = draw(-1, 1), y = draw(-1, 1), z = draw(-1, 1);
    return normalized(Quatd{x, y, z, draw(-1, 1)});
  }
  static Pose<T> turned(const Quatd& turn, const Pose<T>& pose) {
    return {converted<T>(rotate(turn, converted<double>(pose.translation))),
            converted<T>(normalized(turn * converted<double>(pose.rotation)))};
  }
  /// The i-th pair of two kinds: B's lowest point a little below A's highest, all turned in one case of three.
  SwappedPair<T> pair(int kind_a, int kind_b, int i) {
    const Shape<T> a = shape(kind_a), b = kind_a == kind_b && i % 3 == 0 ? a : shape(kind_b);
    Pose<T> pa = pose(i), pb = pose(i);
    pb.translation.y = bounds(a, pa).upper.y - bounds(b, pb).lower.y - T(draw(0, 0.02));
    if (i % 3 == 1) {
      const Quatd turn = this->turn();
      pa = turned(turn, pa);
      pb = turned(turn, pb);
    }
    return {a, b, pa, pb, i % 5 == 0 ? T(0.3) : T(0.01)};
  }

 private:
  std::mt19937 random_{5};
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SwappedContacts, Scalars);

template <class T>
void expect_mirrored(const SwappedPair<T>& pair, int i) {
  const Manifolds<T> there = pair.there(), back = pair.back();
  const std::string which = std::string(pair.a.name()) + " on " + std::string(pair.b.name()) + ' ' + std::to_string(i);
  ASSERT_EQ(there.size(), back.size()) << which;
  if (there.empty()) return;
  ASSERT_EQ(there[0].points.size(), back[0].points.size()) << which;
  EXPECT_EQ(there[0].normal, -back[0].normal) << which;
  for (std::size_t k = 0; k < there[0].points.size(); ++k) {
    const ContactPoint<T> one = there[0].points[k], other = mirrored(back[0].points[k]);
    EXPECT_EQ(one.a, other.a) << which;
    EXPECT_EQ(one.b, other.b) << which;
    EXPECT_EQ(one.distance, other.distance) << which;
    EXPECT_EQ(one.feature, other.feature) << which;
  }
}

TYPED_TEST(SwappedContacts, OfOneKindAreTheSameMirrored) {
  for (int kind = 0; kind < this->kinds; ++kind)
    for (int i = 0; i < 2000; ++i) expect_mirrored(this->pair(kind, kind, i), i);
}

TYPED_TEST(SwappedContacts, OfTwoKindsAreTheSameMirrored) {
  for (int a = 0; a < this->all_kinds; ++a)
    for (int b = 0; b < a; ++b)
      for (int i = 0; i < 200; ++i) expect_mirrored(this->pair(a, b, i), i);
}

/// Corners of two triangles' common area that are about one are joined, and points with the same features: the one that
/// stays is the same. Of axes that are equally good rounded triangles take the same.
TYPED_TEST(SwappedContacts, OfTrianglesAreTheSamePoints) {
  using T = TypeParam;
  const T close = std::is_same_v<T, float> ? T(2e-5) : T(1e-9);
  for (const int kind : {this->sharp_triangle, this->rounded_triangle}) {
    int touching = 0;
    for (int i = 0; i < 60000; ++i) {
      const SwappedPair<T> pair = this->pair(kind, kind, i);
      const Manifolds<T> there = pair.there(), back = pair.back();
      ASSERT_EQ(there.size(), back.size()) << i;
      if (there.empty()) continue;
      ++touching;
      ASSERT_EQ(there[0].points.size(), back[0].points.size()) << i;
      for (const ContactPoint<T>& one : there[0].points) {
        T nearest = 1, depth = 0;
        for (const ContactPoint<T>& other : back[0].points)
          if (length(one.a - other.b) < nearest) nearest = length(one.a - other.b), depth = other.distance;
        EXPECT_LE(nearest, close) << i;
        EXPECT_NEAR(one.distance, depth, close) << i;
      }
    }
    EXPECT_GT(touching, 15000);
  }
}

}  // namespace
}  // namespace graze::testing
