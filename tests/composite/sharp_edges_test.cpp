// Closed meshes with edges sharper than a right angle: between the faces of such an edge are normals that one of the
// two has behind it, and that lead out of the body all the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze {
namespace {

using testing::Random;
using testing::uniform;

template <class T>
class SharpEdges : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SharpEdges, Scalars);

/// A wedge: a prism over a triangle of random sides, about 1 across and `middle` beside its frame's origin; as a mesh,
/// and as the hull of its corners.
template <class T>
struct Wedge {
  Shape<T> mesh, hull;
};

template <class T>
Wedge<T> random_wedge(Random& random, bool solid, const Vec3<T>& middle) {
  const T a = uniform(random, 0.1f, 0.5f), b = uniform(random, 0.1f, 0.5f), high = uniform(random, 0.1f, 0.5f);
  const T tip = uniform(random, -0.5f, 0.5f);
  std::vector<Vec3<T>> points{{-a, -high, b}, {a, -high, b}, {tip, -high, -b},
                              {-a, high, b},  {a, high, b},  {tip, high, -b}};
  for (Vec3<T>& p : points) p += middle;
  const std::vector<typename Mesh<T>::Index> triangles{{3, 4, 5}, {0, 2, 1}, {0, 1, 4}, {0, 4, 3},
                                                       {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return {Mesh<T>(points, triangles, Sides::both, solid), ConvexHull<T>(points)};
}

template <class T>
Pose<T> turned(Random& random) {
  const Quatf q = testing::random_rotation(random);
  return {{}, normalized(Quat<T>{q.x, q.y, q.z, q.w})};
}

/// Two wedges that are a little apart or in each other, and how far along which direction, as their hulls are.
template <class T>
struct TwoWedges {
  Wedge<T> a, b;
  Pose<T> pose_a, pose_b;
  Distance<T> apart;

  TwoWedges(Random& random, int k, const Vec3<T>& middle = {})
      : a(random_wedge<T>(random, k % 2 == 0, middle)),
        b(random_wedge<T>(random, k % 3 == 0, middle)),
        pose_a(turned<T>(random)),
        pose_b(turned<T>(random)) {
    const Pose<T> way = turned<T>(random);
    pose_a.translation = -rotate(pose_a.rotation, middle);
    pose_b.translation = rotate(way.rotation, Vec3<T>{T(3), T(0), T(0)}) - rotate(pose_b.rotation, middle);
    apart = distance(a.hull, pose_a, b.hull, pose_b);
    const T gap = T(uniform(random, -0.01f, 0.01f)) * (k % 4 == 0 ? T(1e-6) : T(1));
    pose_b.translation -= apart.normal * (apart.distance - gap);
    apart = distance(a.hull, pose_a, b.hull, pose_b);
  }
  bool leads_apart(const Manifold<T>& m) const { return dot(m.normal, apart.normal) > T(0); }
};

/// Wedges that touch, or are nearer than the margin, have a point, and one along whose normal they part. Of those in
/// each other, whose triangles cross, about one in a hundred has the normal of edges that neither body has.
TYPED_TEST(SharpEdges, AreMetFromOutside) {
  using T = TypeParam;
  constexpr int count = 2000;
  Random random(847);
  int pulled = 0;
  for (int k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    const TwoWedges<T> two(random, k);
    Manifolds<T> manifolds;
    contacts(two.a.mesh, two.pose_a, two.b.mesh, two.pose_b, T(0.02), manifolds);
    ASSERT_FALSE(manifolds.empty());
    const bool parts =
        std::any_of(manifolds.begin(), manifolds.end(), [&](const auto& m) { return two.leads_apart(m); });
    if (two.apart.distance > T(0))
      EXPECT_TRUE(parts) << two.apart.distance;
    else
      pulled += !parts;
  }
  EXPECT_LT(pulled, count / 100);
}

/// The points of a mesh far beside its frame's origin are rounded there, and so are places in that frame; and how large
/// its triangles are has nothing to do with how far from the origin they are.
TYPED_TEST(SharpEdges, AreMetWhereMeshesLieBesideTheirOrigins) {
  using T = TypeParam;
  for (const T far : {T(50), T(500)}) {
    Random random(847);
    for (int k = 0; k < 2000; ++k) {
      const TwoWedges<T> two(random, k, {far, far / 2, -far});
      Manifolds<T> there, back;
      contacts(two.a.mesh, two.pose_a, two.b.mesh, two.pose_b, T(0.02), there);
      contacts(two.b.mesh, two.pose_b, two.a.mesh, two.pose_a, T(0.02), back);
      EXPECT_FALSE(there.empty()) << far << ' ' << k;
      EXPECT_EQ(there.size(), back.size()) << far << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace graze
