// Two shapes of one kind in each other's place: the same contacts, mirrored to the last bit, though often two choices
// are as good. One pair in four lies exactly flat, as they are and turned.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "graze/query.hpp"
#include "narrow/manifold/features.hpp"

namespace graze::testing {
namespace {

template <class T>
class SwappedContacts : public ::testing::Test {
 protected:
  double draw(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  T size() { return T(draw(0.15, 0.55)); }

  static constexpr int kinds = 8;
  Shape<T> shape(int kind) {
    if (kind == 0) return Rectangle<T>(2 * size(), 2 * size());
    if (kind == 1) return Cylinder<T>(size(), size());
    if (kind == 2) return Shape<T>(Cylinder<T>(size(), size()), size() / 8);
    if (kind == 3) return Cylinder<T>(size(), size(), size() / 2);
    if (kind == 4) return Ellipsoid<T>({size(), size(), size()});
    if (kind == 5) return box();
    if (kind == 6) return Shape<T>(box(), size() / 8);
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 10; ++i) points.push_back({T(draw(-0.5, 0.5)), T(draw(-0.5, 0.5)), T(draw(-0.5, 0.5))});
    return ConvexHull<T>(points);
  }
  Box<T> box() {
    const T x = 2 * size(), y = 2 * size();
    return Box<T>({x, y, 2 * size()});
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

 private:
  std::mt19937 random_{5};
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SwappedContacts, Scalars);

TYPED_TEST(SwappedContacts, OfOneKindAreTheSameMirrored) {
  using T = TypeParam;
  for (int kind = 0; kind < this->kinds; ++kind)
    for (int i = 0; i < 2000; ++i) {
      const Shape<T> a = this->shape(kind), b = i % 3 == 0 ? a : this->shape(kind);
      Pose<T> pa = this->pose(i), pb = this->pose(i);
      pb.translation.y = bounds(a, pa).upper.y - bounds(b, pb).lower.y - T(this->draw(0, 0.02));
      if (i % 3 == 1) {
        const Quatd turn = this->turn();
        pa = this->turned(turn, pa);
        pb = this->turned(turn, pb);
      }
      const T margin = i % 5 == 0 ? T(0.3) : T(0.01);
      Manifolds<T> there, back;
      contacts(a, pa, b, pb, margin, there);
      contacts(b, pb, a, pa, margin, back);
      ASSERT_EQ(there.size(), back.size()) << a.name() << ' ' << i;
      if (there.empty()) continue;
      ASSERT_EQ(there[0].points.size(), back[0].points.size()) << a.name() << ' ' << i;
      EXPECT_EQ(there[0].normal, -back[0].normal);
      for (std::size_t k = 0; k < there[0].points.size(); ++k) {
        const ContactPoint<T> one = there[0].points[k], other = mirrored(back[0].points[k]);
        EXPECT_EQ(one.a, other.a) << a.name() << ' ' << i;
        EXPECT_EQ(one.b, other.b);
        EXPECT_EQ(one.distance, other.distance);
        EXPECT_EQ(one.feature, other.feature);
      }
    }
}

}  // namespace
}  // namespace graze::testing
