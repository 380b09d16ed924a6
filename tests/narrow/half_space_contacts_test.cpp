// Boxes, triangles, balls and capsules on half-spaces: the routines of their own against the general path in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "in_general.hpp"

namespace graze::testing {
namespace {

template <class T>
Shape<T> random_resting_shape(int i, Random& random) {
  const Vec3f size = abs(random_vector(random, 1.0f)) + Vec3f{0.05f, 0.05f, 0.05f};
  if (i % 4 == 0)
    return Shape<T>(Sphere<T>(T(size.x), converted<T>(random_vector(random, 0.2f))), T(i % 8 == 0 ? 0.1 : 0));
  if (i % 16 == 3) {
    // Slivers, sides of no length and points too.
    const Vec3<T> a = converted<T>(random_vector(random, 0.5f)), b = a + converted<T>(random_vector(random, 1.0f));
    return Triangle<T>(a, i % 80 == 3 ? a : b,
                       i % 48 == 3    ? a
                       : i % 48 == 19 ? (a + b) * T(0.5)
                                      : a + converted<T>(random_vector(random, 1.0f)));
  }
  if (i % 16 == 7) {
    // Lies, where what it is turned by does not lean.
    const T y(random_vector(random, 0.5f).y);
    return Triangle<T>({T(0), y, T(size.x)}, {T(size.y), y, T(0)}, {T(-size.z), y, T(-size.y)});
  }
  if (i % 4 == 1) return Shape<T>(Capsule<T>(T(size.x), T(size.y)), T(i % 8 == 1 ? 0.1 : 0));
  return Box<T>(converted<T>(i % 16 == 2 ? Vec3f{size.x, 0, size.z} : size));
}

/// A direction of the body that points about down, by less than what makes a flat part its support face, by more, or
/// any.
Quatf random_lean(int i, Random& random) {
  constexpr Quatf faces[] = {{0, 0, 0, 1}, {1, 0, 0, 0}, {0.5f, 0.5f, 0.5f, 0.5f}, {0, 0, 0.70710678f, 0.70710678f}};
  if (i % 3 == 0) return random_rotation(random);
  const float lean = i % 3 == 1 ? 0.005f : 0.1f;
  const Vec3f v = random_vector(random, lean);
  return normalized(Quatf{v.x, v.y, v.z, 1} * faces[random() % 4]);
}

/// Whether the corners of a triangle lie on a line, as far as rounding tells: its edges then lean alike, and which of
/// them is the lower one is rounding's choice.
template <class T>
bool edges_lean_alike(const Shape<T>& shape, double rounding) {
  const auto* triangle = shape.template as<Triangle<T>>();
  if (!triangle) return false;
  const Vec3<T> along = triangle->point(1) - triangle->point(0), other = triangle->point(2) - triangle->point(0);
  return static_cast<double>(length(cross(along, other))) <=
         rounding * static_cast<double>(length(along) * length(other));
}

template <class T>
void expect_as_in_double(unsigned seed, double tolerance_of_size) {
  Random random(seed);
  int compared = 0;
  for (int i = 0; i < 8000; ++i) {
    const Shape<T> shape = random_resting_shape<T>(i, random), plane(HalfSpace<T>(), T(i % 5 == 0 ? 0.2 : 0));
    const Pose<T> ground{converted<T>(random_vector(random, 3.0f)), normalized(converted<T>(random_rotation(random)))};
    const Quat<T> lean = normalized(converted<T>(random_lean(i, random)));
    const Pose<T> upright{Vec3<T>{T(random_vector(random, 2.0f).x), T(0), T(0)}, lean};
    // Lifted until its lowest point is about at the surface.
    const T lift =
        -distance<T>(shape, upright, plane, Pose<T>{}).distance + converted<T>(random_vector(random, 0.1f)).x;
    const Pose<T> pose = compose(ground, Pose<T>{upright.translation + Vec3<T>{T(0), lift, T(0)}, lean});

    const bool turned = i % 2 == 0;
    Manifolds<T> fast, slow;
    const bool touch = turned ? contacts<T>(plane, ground, shape, pose, T(0.05), fast)
                              : contacts<T>(shape, pose, plane, ground, T(0.05), fast);
    EXPECT_EQ(touch, turned ? contacts_in_general<T>(plane, ground, shape, pose, T(0.05), slow)
                            : contacts_in_general<T>(shape, pose, plane, ground, T(0.05), slow));
    ASSERT_EQ(fast.size(), slow.size());
    if (fast.empty()) continue;
    const double near = tolerance_of_size * 5;
    EXPECT_LT(length(converted<double>(fast[0].normal - slow[0].normal)), near);
    T lowest = fast[0].points[0].distance;
    for (const auto& p : fast[0].points) {
      lowest = std::min(lowest, p.distance);
      const auto same = std::find_if(slow[0].points.begin(), slow[0].points.end(),
                                     [&](const auto& q) { return q.feature == p.feature; });
      if (same == slow[0].points.end()) {
        // Either it lies as high as points are wanted, or another edge leans as much.
        if (!edges_lean_alike(shape, tolerance_of_size)) {
          EXPECT_NEAR(static_cast<double>(p.distance), 0.05, near);
        }
        continue;
      }
      ++compared;
      EXPECT_NEAR(static_cast<double>(p.distance), static_cast<double>(same->distance), near);
      EXPECT_LT(length(converted<double>(p.a - same->a)), near);
      EXPECT_LT(length(converted<double>(p.b - same->b)), near);
    }
    EXPECT_NEAR(
        static_cast<double>(lowest),
        static_cast<double>(
            (turned ? distance<T>(plane, ground, shape, pose) : distance<T>(shape, pose, plane, ground)).distance),
        near);
  }
  EXPECT_GT(compared, 6000);
}

TEST(HalfSpaceContacts, AreThoseOfTheGeneralPath) {
  expect_as_in_double<float>(1, 1e-5);
  expect_as_in_double<double>(2, 1e-10);
}

TEST(HalfSpaceContacts, OfAFaceThatTouchesAreAllItsCorners) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    // Turned with its ground, so that rounding alone lifts one of its corners or the other.
    const Posed ground{{}, normalized(converted<double>(random_rotation(random)))};
    const Posed box = compose(ground, Posed{{0.3, 0.5, 0.2}, {}});
    Manifolds<double> found;
    contacts<double>(Box<double>({1, 1, 1}), box, HalfSpace<double>(), ground, 1e-14, found);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].points.size(), 4u);

    const Posed flat = compose(ground, Posed{{0.3, 0, 0.2}, {}});
    found.clear();
    contacts<double>(Triangle<double>({0, 0, 1}, {1, 0, -1}, {-1, 0, -1}), flat, HalfSpace<double>(), ground, 1e-14,
                     found);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].points.size(), 3u);
  }
}

}  // namespace
}  // namespace graze::testing
