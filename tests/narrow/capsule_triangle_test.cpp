// Untapered capsules against triangles: distances against GJK's, points of contact against those of the support faces,
// and against themselves, since what contacts, distances and overlaps say has to be the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "by_faces.hpp"
#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "in_general.hpp"
#include "narrow/batch/lane_pairs.hpp"
#include "narrow/general.hpp"
#include "narrow/pair_table.hpp"

namespace graze::testing {
namespace {

/// Of two points with the same names that are equally deep one is kept, and rounding chooses which: `ties`, nearer to
/// each other than `near`.
template <class T>
void expect_alike(const Manifolds<T>& fast, const Manifolds<T>& slow, double allowed, double near, int& other_names,
                  int& ties) {
  ASSERT_EQ(fast.size(), slow.size());
  if (fast.empty()) return;
  ASSERT_EQ(fast[0].points.size(), slow[0].points.size());
  ASSERT_LT(length(converted<double>(fast[0].normal - slow[0].normal)), 1e-5);
  for (std::size_t k = 0; k < fast[0].points.size(); ++k) {
    const ContactPoint<T>&p = fast[0].points[k], &q = slow[0].points[k];
    ASSERT_NEAR(static_cast<double>(p.distance), static_cast<double>(q.distance), allowed);
    other_names += p.feature != q.feature;
    const double off = std::max(length(converted<double>(p.a - q.a)), length(converted<double>(p.b - q.b)));
    if (off > allowed && p.feature == q.feature && fast[0].points.size() == 1) {
      ++ties;
      ASSERT_LT(off, near);
      continue;
    }
    ASSERT_LT(off, allowed);
  }
}

/// Every fifth pair is far from the world's origin; some capsules stand upright on level triangles or lie on them.
template <class T>
void expect_as_in_general(unsigned seed, double near) {
  Random random(seed);
  int touching = 0, other_names = 0, single = 0, ties = 0;
  for (int i = 0; i < 8000; ++i) {
    static constexpr float scales[] = {1, 1e-4f, 1e-2f, 1e2f, 1e4f};
    const float scale = scales[i % 5];
    const auto vector = [&](float reach) { return converted<T>(random_vector(random, reach * scale)); };
    const Vec3<T> away = i % 5 == 0 ? vector(100) : Vec3<T>{};
    Vec3<T> p = vector(1), q = vector(1), r = vector(1);
    if (i % 4 == 0) p.y = q.y = r.y = T(0);
    const Shape<T> b(Triangle<T>(p, q, r), i % 7 == 0 ? T(scale) * T(0.1) : T(0)),
        a(Capsule<T>(T(scale) * T(uniform(random, 0.1f, 1.5f)), T(scale) * T(uniform(random, 0, 0.5f))),
          i % 6 == 0 ? T(scale) * T(0.1) : T(0));
    const Pose<T> pose_b{away, i % 3 == 0 ? Quat<T>{} : normalized(converted<T>(random_rotation(random)))},
        pose_a{away + vector(1),
               i % 8 == 0   ? pose_b.rotation
               : i % 8 == 4 ? pose_b.rotation * Quat<T>{T(0), T(0), T(0.70710678118654752), T(0.70710678118654752)}
                            : normalized(converted<T>(random_rotation(random)))};
    const double size = static_cast<double>(scale), allowed = near * (i % 5 == 0 ? 100 : 1) * size;

    const Distance<T> d = distance(a, pose_a, b, pose_b);
    const auto radii = static_cast<double>(a.template as<Capsule<T>>()->core_radius() + a.rounding() + b.rounding());
    const auto general = general_distance<T>(a, b, relative_in_double(pose_a, pose_b));
    ASSERT_NEAR(static_cast<double>(d.distance), general.core.distance - radii, allowed) << i;
    ASSERT_LT(length(converted<double>(d.b - d.a - d.normal * d.distance)), allowed) << i;
    if (general.core.distance > 0.01 * size) {
      const Vec3d normal = rotate(in_double(pose_a).rotation, general.core.normal);
      ASSERT_LT(length(converted<double>(d.normal) - normal), 1000 * near) << i;
    }
    Manifolds<T> fast, slow;
    const bool touch = contacts(a, pose_a, b, pose_b, T(0), fast);
    ASSERT_EQ(touch, d.distance <= T(0)) << i;
    ASSERT_EQ(touch, overlap(a, pose_a, b, pose_b)) << i;
    contacts_in_general(a, pose_a, b, pose_b, T(0), slow);
    ASSERT_NO_FATAL_FAILURE(expect_alike(fast, slow, allowed, 0.02 * size, other_names, ties)) << i;
    touching += touch;
    single += touch && fast[0].points.size() == 1;
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(single, 500);
  EXPECT_LE(other_names, 2);  // where rounding tells which
  EXPECT_LE(ties, 8);
}

TEST(CapsuleTriangle, IsAsInGeneral) {
  expect_as_in_general<float>(1, 2e-6);
  expect_as_in_general<double>(2, 1e-11);
}

/// A capsule whose side lies on a triangle or along one of its edges, tilted by up to `tilt`, a little apart to sunk
/// in; the triangle is about its own origin or away from it, some nearly slivers, some rounded.
template <class T>
ByFaces compare_lying_on_triangles(unsigned seed, double tilt, double scale) {
  Random random(seed);
  ByFaces found;
  const auto some = [&](double low, double high) {
    return static_cast<double>(uniform(random, static_cast<float>(low), static_cast<float>(high)));
  };
  const auto vector = [&](double reach) { return converted<double>(random_vector(random, static_cast<float>(reach))); };
  for (int i = 0; i < 2000; ++i) {
    const double radius = i % 5 == 0 ? 0 : some(0.01, 0.5), rounded = i % 8 == 0 ? 0.1 : 0,
                 edges = i % 7 == 0 ? 0.1 : 0, half = some(0.05, 2);
    const Vec3d own = i % 4 == 0 ? vector(10) : Vec3d{};
    Vec3d corners[3] = {vector(1), vector(1), vector(1)};
    if (i % 10 == 3) corners[2] = corners[0] + (corners[1] - corners[0]) * some(0, 1) + vector(0.05);
    const Vec3d along = normalized(corners[1] - corners[0]),
                face = normalized(cross(corners[1] - corners[0], corners[2] - corners[0])),
                up = i % 2 == 0 ? face : -face, inward = cross(face, along);
    // Along the face; else about along the first edge, seen from the face, from beyond the edge or from between.
    const bool of_face = i % 3 != 0;
    const double turn = of_face       ? some(0, 6)
                        : i % 12 == 0 ? 0
                                      : some(-0.1, 0.1),
                 lean = i % 3 == 1 ? 0 : some(-tilt, tilt), beyond = of_face ? 0 : some(0, 3.1);
    const Vec3d flat = along * std::cos(turn) + inward * std::sin(turn),
                normal = up * std::cos(beyond) - inward * std::sin(beyond),
                across = normalized(flat - normal * dot(flat, normal)),
                axis = across * std::cos(lean) + normal * std::sin(lean);
    const double u = some(-0.3, 1.3), v = of_face ? some(-0.3, 1.3) : i % 6 == 0 ? 0 : some(-0.01, 0.01);
    const Vec3d place = corners[0] + (corners[1] - corners[0]) * u + (corners[2] - corners[0]) * v +
                        normal * (radius + rounded + edges + some(-0.1, 0.02));
    const Posed ground{vector(1) * scale,
                       i % 2 == 0 ? Quatd{} : normalized(converted<double>(random_rotation(random)))};
    const Vec3d y{0, 1, 0}, between = cross(y, axis);
    const Posed on{(place + own) * scale, normalized(Quatd{between.x, between.y, between.z, 1 + dot(y, axis)})};
    const Shape<T> capsule(Capsule<T>(T(half * scale), T(radius * scale)), T(rounded * scale));
    const Shape<T> triangle(Triangle<T>(converted<T>((corners[0] + own) * scale),
                                        converted<T>((corners[1] + own) * scale),
                                        converted<T>((corners[2] + own) * scale)),
                            T(edges * scale));
    const Pose<T> pose = converted<T>(compose(ground, on)), pose_triangle = converted<T>(ground);
    const T margin = T(i % 6 == 0 ? 0 : 0.05 * scale);
    if (i % 5 == 1)
      found.compare(triangle, pose_triangle, capsule, pose, margin, scale);
    else
      found.compare(capsule, pose, triangle, pose_triangle, margin, scale);
  }
  return found;
}

TEST(CapsuleTriangle, LyingIsAsTheFacesGive) {
  expect_as_faces_give([]<class T>(unsigned seed, double tilt,
                                   double scale) { return compare_lying_on_triangles<T>(seed, tilt, scale); },
                       500);
}

// Edges that fall away steeply are no sides, though one looks parallel to the capsule.
TEST(CapsuleTriangle, LyingOnAVertexIsOnePoint) {
  const Shape<double> triangle(Triangle<double>({0, 0, 0}, {0.3, -1, 0}, {-0.2, -1, 0})),
      capsule(Capsule<double>(2, 0.1));
  const Posed on{{0.2, 0.1, 0}, {0, 0, std::sqrt(0.5), std::sqrt(0.5)}};
  ByFaces found;
  found.compare(capsule, on, triangle, Posed{}, 2.0, 1);
  found.expect_all_same(1e-12);
  EXPECT_EQ(found.one, 1);
}

/// A sink that compares what kernels find with the answer to each pair alone.
template <class T, class Alone>
struct AloneSink {
  using Scalar = T;
  static constexpr std::size_t most = most_chunk;
  const PairRef<T>* pairs;
  const Alone& alone;
  std::size_t &touching, &not_known;

  void apart(std::size_t i) {
    Manifold<T> found;
    EXPECT_GT(alone(i, found), pairs[i].margin);
  }
  void unknown(std::size_t) { ++not_known; }
  void one(std::size_t i, const PointContact<T>& contact) {
    Manifold<T> found;
    alone(i, found);
    ASSERT_EQ(found.points.size(), 1u);
    EXPECT_EQ(found.normal, contact.normal);
    expect_same(found.points[0], contact.point);
    ++touching;
  }
  template <class Points>
  void several(std::size_t i, T distance, const Vec3<T>& normal, const Points& points, std::size_t) {
    Manifold<T> found, told;
    EXPECT_EQ(alone(i, found), distance);
    EXPECT_EQ(found.normal, normal);
    points.append(told.points);
    ASSERT_EQ(found.points.size(), told.points.size());
    for (std::size_t k = 0; k < told.points.size(); ++k) expect_same(found.points[k], told.points[k]);
  }
  void met(const MetPairs<T>&, bool) { ADD_FAILURE() << "of other pairs"; }

 private:
  static void expect_same(const ContactPoint<T>& p, const ContactPoint<T>& q) {
    EXPECT_TRUE(p.a == q.a && p.b == q.b && p.distance == q.distance && p.feature == q.feature);
  }
};

/// Many pairs by pointers: what the kernels tell of each is what the pair alone has, and they leave few to it.
template <class T, class A>
void expect_as_alone(const std::vector<A>& rounds, std::size_t most_unknown) {
  Random random(3);
  std::vector<Triangle<T>> triangles;
  std::vector<Pose<T>> poses;
  const auto vector = [&] { return converted<T>(random_vector(random, 1)); };
  for (std::size_t i = 0; i < 2 * rounds.size(); ++i) {
    triangles.emplace_back(vector(), vector(), vector());
    poses.push_back({vector() * T(0.5), normalized(converted<T>(random_rotation(random)))});
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
                                chunk[i].margin, found);
    };
    AloneSink<T, decltype(alone)> sink{chunk, alone, touching, unknown};
    const LanesFor lanes = lane_table<T>(detail::kind_of<A, T>(), detail::kind_of<Triangle<T>, T>());
    visit_lane_contacts(lanes, chunk, std::min(most_chunk, pairs.size() - first), sink);
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
