// Even capsules against triangles: distances against GJK's, points of contact against those of the support faces, and
// against themselves, since what contacts, distances and overlaps say has to be the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "narrow/convex_pair.hpp"
#include "narrow/general.hpp"
#include "narrow/round_batch.hpp"

namespace graze::testing {
namespace {

template <class T>
void expect_alike(const Manifolds<T>& fast, const Manifolds<T>& slow, double allowed, int& other_names) {
  ASSERT_EQ(fast.size(), slow.size());
  if (fast.empty()) return;
  ASSERT_EQ(fast[0].points.size(), slow[0].points.size());
  ASSERT_LT(length(cast<double>(fast[0].normal - slow[0].normal)), 1e-5);
  for (std::size_t k = 0; k < fast[0].points.size(); ++k) {
    const ContactPoint<T>&p = fast[0].points[k], &q = slow[0].points[k];
    ASSERT_NEAR(static_cast<double>(p.distance), static_cast<double>(q.distance), allowed);
    ASSERT_LT(length(cast<double>(p.a - q.a)), allowed);
    ASSERT_LT(length(cast<double>(p.b - q.b)), allowed);
    other_names += p.feature != q.feature;
  }
}

/// Every fifth pair is far from the world's origin; some capsules stand upright on level triangles or lie on them.
template <class T>
void expect_as_in_general(unsigned seed, double near) {
  Random random(seed);
  int touching = 0, other_names = 0, single = 0;
  for (int i = 0; i < 8000; ++i) {
    static constexpr float scales[] = {1, 1e-4f, 1e-2f, 1e2f, 1e4f};
    const float scale = scales[i % 5];
    const auto vector = [&](float reach) { return cast<T>(random_vector(random, reach * scale)); };
    const Vec3<T> away = i % 5 == 0 ? vector(100) : Vec3<T>{};
    Vec3<T> p = vector(1), q = vector(1), r = vector(1);
    if (i % 4 == 0) p.y = q.y = r.y = T(0);
    const Shape<T> b(Triangle<T>(p, q, r), i % 7 == 0 ? T(scale) * T(0.1) : T(0)),
        a(Capsule<T>(T(scale) * T(uniform(random, 0.1f, 1.5f)), T(scale) * T(uniform(random, 0, 0.5f))),
          i % 6 == 0 ? T(scale) * T(0.1) : T(0));
    const Pose<T> pose_b{away, i % 3 == 0 ? Quat<T>{} : normalized(cast<T>(random_rotation(random)))},
        pose_a{away + vector(1),
               i % 8 == 0   ? pose_b.rotation
               : i % 8 == 4 ? pose_b.rotation * Quat<T>{T(0), T(0), T(0.70710678118654752), T(0.70710678118654752)}
                            : normalized(cast<T>(random_rotation(random)))};
    const double size = static_cast<double>(scale), allowed = near * (i % 5 == 0 ? 100 : 1) * size;

    const Distance<T> d = distance(a, pose_a, b, pose_b);
    const auto radii = static_cast<double>(a.template as<Capsule<T>>()->core_radius() + a.margin() + b.margin());
    const auto general = general_distance<T>(a, b, relative_in_double(pose_a, pose_b), nullptr);
    ASSERT_NEAR(static_cast<double>(d.distance), general.core.distance - radii, allowed) << i;
    ASSERT_LT(length(cast<double>(d.b - d.a - d.normal * d.distance)), allowed) << i;
    if (general.core.distance > 0.01 * size) {
      const Vec3d normal = rotate(in_double(pose_a).rotation, general.core.normal);
      ASSERT_LT(length(cast<double>(d.normal) - normal), 1000 * near) << i;
    }
    Manifolds<T> fast, slow;
    Trace trace;
    const bool touch = contacts(a, pose_a, b, pose_b, T(0), fast);
    ASSERT_EQ(touch, d.distance <= T(0)) << i;
    ASSERT_EQ(touch, overlap(a, pose_a, b, pose_b)) << i;
    contacts(a, pose_a, b, pose_b, T(0), slow, &trace);
    ASSERT_NO_FATAL_FAILURE(expect_alike(fast, slow, allowed, other_names)) << i;
    touching += touch;
    single += touch && fast[0].points.size() == 1;
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(single, 500);
  EXPECT_LE(other_names, 2);  // where rounding tells which
}

TEST(CapsuleTriangle, IsAsInGeneral) {
  expect_as_in_general<float>(1, 2e-6);
  expect_as_in_general<double>(2, 1e-11);
}

/// Many pairs by pointers: what the kernels tell of each is what the pair alone has, and they leave few to it.
template <class T, class A>
void expect_as_alone(const std::vector<A>& rounds, std::size_t most_unknown) {
  Random random(3);
  std::vector<Triangle<T>> triangles;
  std::vector<Pose<T>> poses;
  const auto vector = [&] { return cast<T>(random_vector(random, 1)); };
  for (std::size_t i = 0; i < 2 * rounds.size(); ++i) {
    triangles.emplace_back(vector(), vector(), vector());
    poses.push_back({vector() * T(0.5), normalized(cast<T>(random_rotation(random)))});
  }
  std::vector<PairRef<T>> pairs;
  for (std::size_t i = 0; i < rounds.size(); ++i)
    pairs.push_back({&rounds[i], &triangles[i], &poses[2 * i], &poses[2 * i + 1], T(0.05)});
  std::size_t unknown = 0, touching = 0;
  for (std::size_t first = 0; first < pairs.size(); first += most_chunk) {
    const PairRef<T>* const chunk = pairs.data() + first;
    const auto alone = [&](std::size_t i, Manifold<T>& found) {
      return convex_contacts<T>(Shape<T>(*static_cast<const A*>(chunk[i].a)), *chunk[i].pose_a,
                                Shape<T>(*static_cast<const Triangle<T>*>(chunk[i].b)), *chunk[i].pose_b,
                                chunk[i].margin, found, nullptr);
    };
    visit_round_contacts<A, Triangle<T>>(
        chunk, std::min(most_chunk, pairs.size() - first), false,
        [&](std::size_t i) {
          Manifold<T> found;
          EXPECT_GT(alone(i, found), chunk[i].margin);
        },
        [&](std::size_t i, const PointContact<T>& contact) {
          Manifold<T> found;
          alone(i, found);
          ASSERT_EQ(found.points.size(), 1u);
          EXPECT_EQ(found.normal, contact.normal);
          const ContactPoint<T>&p = found.points[0], &q = contact.point;
          EXPECT_TRUE(p.a == q.a && p.b == q.b && p.distance == q.distance && p.feature == q.feature);
          ++touching;
        },
        [&](std::size_t i, T, const Vec3<T>&, const auto&) { ADD_FAILURE() << i << " lies"; },
        [&](std::size_t) { ++unknown; });
  }
  EXPECT_GT(touching, rounds.size() / 8);
  EXPECT_LT(unknown, most_unknown);
}

TEST(CapsuleTriangle, ManyAtOnceAreAsEachAlone) {
  expect_as_alone<float>(std::vector<Sphere<float>>(1000, Sphere<float>(0.4f)), 10);
  expect_as_alone<double>(std::vector<Sphere<double>>(1000, Sphere<double>(0.4)), 10);
  expect_as_alone<float>(std::vector<Capsule<float>>(1000, Capsule<float>(0.8f, 0.25f)), 300);
  expect_as_alone<double>(std::vector<Capsule<double>>(1000, Capsule<double>(0.8, 0.25)), 300);
}

TEST(CapsuleTriangle, NearestIsAnEndOrTheSide) {
  const Shape<double> triangle(Triangle<double>({0, 0, 0}, {1, 0, 0}, {0, 0, -1})), capsule(Capsule<double>(1, 0.1));
  const Quatd along_x{0, 0, std::sqrt(0.5), std::sqrt(0.5)}, along_z{std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
  const auto apart = [&](const Vec3d& at, const Quatd& turn) {
    return distance(capsule, {at, turn}, triangle, {}).distance;
  };
  EXPECT_NEAR(apart({0.2, 1, -0.2}, {}), 0.4, 1e-15);
  EXPECT_NEAR(apart({0.2, -2, -0.2}, {}), 1.4, 1e-15);
  EXPECT_NEAR(apart({0.3, 0.5, 0.4}, along_x), std::hypot(0.5, 0.4) - 0.1, 1e-15);
  EXPECT_NEAR(apart({0.5, 0.2, 0.5}, along_z), 0.1, 1e-15);
  EXPECT_NEAR(apart({0.2, 0.3, -0.2}, along_x), 0.2, 1e-15);
  EXPECT_NEAR(apart({1.3, 0, 0}, {}), 0.2, 1e-15);    // across the corner
  EXPECT_NEAR(apart({0.5, 0, 0.3}, {}), 0.2, 1e-15);  // across an edge
  EXPECT_LT(apart({0.2, 0.3, -0.2}, {}), -0.1);
}

}  // namespace
}  // namespace graze::testing
