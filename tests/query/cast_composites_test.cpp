// Casts of meshes and compounds: against their own distance, over the seams of floors, into steps, all hits in order.
#include "cast_fixture.hpp"
#include "common/specimen.hpp"

namespace graze {
namespace {

template <class T>
class CastComposites : public CastTest<T> {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(CastComposites, Scalars);

template <class T>
Shape<T> terrain(int cells, T spacing) {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  const auto side = static_cast<std::uint32_t>(cells + 1);
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k)
      points.push_back({(T(k) - T(cells) / T(2)) * spacing, T((i * 7 + k * 13) % 5) * spacing / T(10),
                        (T(i) - T(cells) / T(2)) * spacing});
  for (std::uint32_t i = 0; i + 1 < side; ++i)
    for (std::uint32_t k = 0; k + 1 < side; ++k) {
      const std::uint32_t p = i * side + k;
      triangles.push_back({p, p + side, p + side + 1});
      triangles.push_back({p, p + side + 1, p + 1});
    }
  return {Mesh<T>(points, triangles)};
}

template <class T>
Shape<T> dumbbell() {
  std::vector<Placed<T>> children;
  children.push_back({Shape<T>(Sphere<T>(T(0.5))), {{T(-1.5), 0, 0}, {}}});
  children.push_back({Shape<T>(Box<T>({T(3), T(0.2), T(0.2)})), {}});
  children.push_back({Shape<T>(Sphere<T>(T(0.5))), {{T(1.5), 0, 0}, {}}});
  return {Compound<T>(std::move(children))};
}

/// Judged by the signed distance of the whole composites, sampled.
template <class T>
int check_composite(const Shape<T>& a, const Velocity<T>& va, const Shape<T>& b, const Pose<T>& pose_b,
                    const Velocity<T>& vb, double size) {
  const auto hit = cast(a, {}, va, b, pose_b, vb, T(1));
  const auto apart = [&](T t) { return distance(a, pose_at(Pose<T>{}, va, t), b, pose_at(pose_b, vb, t)).distance; };
  const T allowed = static_cast<T>(size) * (std::is_same_v<T, float> ? T(1e-5) : T(2e-9));
  if (hit) {
    EXPECT_EQ(hit->status, Status::converged);
    if (hit->t > T(0)) {
      EXPECT_NEAR(apart(hit->t), T(0), allowed);
    } else {
      EXPECT_LE(apart(T(0)), allowed);
    }
  }
  const T until = hit ? hit->t : T(1);
  for (int i = 0; i < 64; ++i) {
    if (hit && hit->t == T(0)) break;
    const T d = apart(until * T(i) / T(64));
    EXPECT_GT(d, T(0)) << until * T(i) / T(64) << " of " << until;
  }
  return hit ? hit->t > T(0) ? 1 : 2 : 0;
}

TYPED_TEST(CastComposites, CompositesAgreeWithTheirDistance) {
  using T = TypeParam;
  const Shape<T> ground = terrain<T>(12, T(1)), body = dumbbell<T>();
  unsigned state = 1;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<T>(state >> 8) / T(1 << 24) * T(2) - T(1);
  };
  int outcomes[3] = {0, 0, 0};
  for (int i = 0; i < 120; ++i) {
    const Quat<T> q = normalized(Quat<T>{next(), next(), next(), next()});
    const Pose<T> start{{next() * T(5), T(3), next() * T(5)}, q};
    Velocity<T> va, vb{{next() * T(4), T(-3) + next(), next() * T(4)}, {}};
    if (i % 3 > 0) vb.angular = Vec3<T>{next(), next(), next()} * T(6);
    if (i % 3 > 1) va.angular = Vec3<T>{next(), next(), next()} * T(0.3);
    const Shape<T>& mover = i % 4 == 0 ? this->cube : body;
    ++outcomes[check_composite<T>(ground, va, mover, start, vb, 9)];
    ++outcomes[check_composite<T>(body, va, mover, {{T(5), next(), next()}, q}, {{T(-6), next(), next()}, vb.angular},
                                  2)];
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_GT(outcomes[0], 15);
  EXPECT_GT(outcomes[1], 80);
}

TYPED_TEST(CastComposites, ABodySlidesOverATriangulatedFloor) {
  using T = TypeParam;
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (int i = 0; i <= 20; ++i) {
    points.push_back({T(i - 10), 0, T(-5)});
    points.push_back({T(i - 10), 0, T(5)});
  }
  for (std::uint32_t i = 0; i < 40; i += 2) {
    triangles.push_back({i, i + 1, i + 3});
    triangles.push_back({i, i + 3, i + 2});
  }
  const Shape<T> floor{Mesh<T>(points, triangles)};
  EXPECT_FALSE(this->thrown(floor, {}, this->cube, {T(-7), T(1), 0}, {T(14), 0, T(0.5)}, T(1), Separating::ignored));
  EXPECT_FALSE(this->thrown(floor, {}, this->cube, {T(-7), T(1.001), 0}, {T(14), 0, T(0.5)}));
  EXPECT_TRUE(this->thrown(floor, {}, this->cube, {T(-7), T(1.001), 0}, {T(14), T(-0.01), T(0.5)}));
}

/// A level floor of triangles, with seams along x, z and the diagonals of its cells, as a mesh and as a height field.
template <class T>
std::vector<Shape<T>> level_floors() {
  constexpr std::uint32_t n = 9;
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      points.push_back({T(i) - T(4), 0, T(j) - T(4)});
      if (i + 1 == n || j + 1 == n) continue;
      const std::uint32_t a = i * n + j;
      triangles.push_back({a, a + 1, a + n + 1});
      triangles.push_back({a, a + n + 1, a + n});
    }
  return {Mesh<T>(points, triangles), HeightField<T>(n, n, std::vector<T>(n * n, T(0)), T(1), T(1))};
}

/// Each triangle beside a seam leaves a thin body that stands in the plane of that seam to one side; the floor does
/// not.
TYPED_TEST(CastComposites, ThinBodiesDoNotSlideIntoSeams) {
  using T = TypeParam;
  const Shape<T> thin[] = {LineSegment<T>({0, T(-0.5), 0}, {0, T(0.5), 0}),
                           Box<T>({0, 1, T(0.25)}),
                           Box<T>({T(1e-5), 1, T(0.25)}),
                           Box<T>({T(1e-3), 1, T(0.25)}),
                           Capsule<T>(1, 0, 0),
                           Triangle<T>({0, T(0.5), T(-0.1)}, {0, T(0.5), T(0.1)}, {0, T(-0.5), 0})};
  const T eighth = T(0.78539816339744831);
  for (const Shape<T>& floor : level_floors<T>())
    for (const Shape<T>& body : thin)
      for (const T above : {T(0), T(1e-6), T(0.5)})
        for (const T turn : {T(0), eighth, 2 * eighth})
          for (int k = 0; k <= 8; ++k) {
            // In the plane of a seam along z, of a diagonal, or along x, from vertex to vertex.
            const T along = T(0.125) * T(k);
            const Vec3<T> at{turn == T(0) ? T(0) : along, T(0.5) + above, turn == 2 * eighth ? T(0) : along};
            const Pose<T> pose{at, Quat<T>::from_axis_angle({0, 1, 0}, turn)};
            for (const T aside : {T(0), T(0.1)}) {
              const auto hit = cast(floor, {}, {}, body, pose, {{aside, T(-1), 0}, {}}, T(1), {Separating::ignored});
              ASSERT_TRUE(hit) << body.name() << " above " << above << " turned " << turn << " along " << along;
              EXPECT_NEAR(hit->t, above, near_enough<T>);
            }
          }
}

/// What is sunk in more than a tolerance meets the triangle beyond each seam from its side, and slides all the same.
TYPED_TEST(CastComposites, BodiesSunkInSlideOverSeams) {
  using T = TypeParam;
  testing::Random random(3);
  const Shape<T> bodies[] = {this->cube,
                             this->ball,
                             Capsule<T>(1, T(0.25), T(0.25)),
                             Box<T>({0, 1, 1}),
                             Cylinder<T>(1, T(0.5)),
                             Shape<T>(Box<T>({T(0.8), T(0.8), T(0.8)}), T(0.1))};
  for (const Shape<T>& floor : level_floors<T>())
    for (const Shape<T>& body : bodies)
      for (const T sunk : {T(0), T(1e-7), T(1e-4), T(1e-2)})
        for (int k = 0; k < 60; ++k) {
          const auto drawn = [&](float reach) { return T(testing::uniform(random, -reach, reach)); };
          const T at_x = drawn(2), at_z = drawn(2), turn = drawn(3), x = drawn(1.5f), z = drawn(1.5f);
          Pose<T> pose{{at_x, T(5), at_z}, Quat<T>::from_axis_angle({0, 1, 0}, turn)};
          pose.translation.y -= distance(this->ground, {}, body, pose).distance + sunk;
          const auto hit = cast(floor, {}, {}, body, pose, {{x, 0, z}, {}}, T(1), {Separating::ignored});
          ASSERT_FALSE(hit) << body.name() << " sunk " << sunk << " case " << k;
        }
}

TYPED_TEST(CastComposites, ASlidingBodyIsStoppedByAStep) {
  using T = TypeParam;
  // A floor of two triangles, a wall of two more, and a body that stands on the floor, sunk in by rounding.
  const Shape<T> room{Mesh<T>(
      {{T(-9), 0, T(-9)}, {T(5), 0, T(-9)}, {T(5), 0, T(9)}, {T(-9), 0, T(9)}, {T(5), T(3), T(-9)}, {T(5), T(3), T(9)}},
      {{0, 2, 1}, {0, 3, 2}, {1, 5, 4}, {1, 2, 5}})};
  for (const T sunk : {T(0), T(3), T(-3)}) {
    const auto hit = this->thrown(room, {}, this->cube, {T(-6), T(1) - sunk * cast_tolerance<T>, T(0.3)},
                                  {T(20), 0, T(1)}, T(1), Separating::ignored);
    ASSERT_TRUE(hit) << sunk;
    EXPECT_NEAR(hit->t, T(0.5), near_enough<T> * T(4));
    EXPECT_NEAR(hit->normal.x, T(-1), T(1e-4));
    EXPECT_EQ(hit->piece_a / 2, 1u);  // one of the wall's
  }
}

TYPED_TEST(CastComposites, AllHitsComeInOrderOneForEachPiece) {
  using T = TypeParam;
  std::vector<Placed<T>> fence;
  for (int i = 0; i < 5; ++i) fence.push_back({this->ball, {{T(4 * ((i * 3) % 5)), 0, 0}, {}}});
  const Shape<T> row{Compound<T>(std::move(fence))};
  std::vector<CastHit<T>> hits;
  const Pose<T> start{{T(-4), 0, 0}, {}};
  for (const Vec3<T>& angular : {Vec3<T>{}, Vec3<T>{T(9), 0, 0}}) {  // the spin does not change a ball
    hits.clear();
    cast_all(row, {}, {}, this->ball, start, {{T(20), 0, 0}, angular}, T(1), hits);
    ASSERT_EQ(hits.size(), 5u);
    for (int i = 0; i < 5; ++i) {
      EXPECT_NEAR(hits[i].t, T(0.1) + T(0.2) * T(i), T(100) * cast_tolerance<T>);
      EXPECT_EQ(hits[i].piece_a * 3 % 5, static_cast<std::uint32_t>(i));
      EXPECT_EQ(hits[i].piece_b, 0u);
    }
    const auto first = cast(row, {}, {}, this->ball, start, {{T(20), 0, 0}, angular}, T(1));
    ASSERT_TRUE(first);
    EXPECT_EQ(first->t, hits[0].t);
    EXPECT_EQ(first->piece_a, hits[0].piece_a);
  }
  hits.clear();
  cast_all(this->ball, {}, {}, this->ball, {{T(3), 0, 0}, {}}, {{T(-2), 0, 0}, {}}, T(1), hits);
  EXPECT_EQ(hits.size(), 1u);  // convex shapes have one piece each
}

// Far along a path the rounding of float is larger than the shapes: the tree has to allow for it.
TYPED_TEST(CastComposites, BulletsHitMeshesFarAway) {
  using T = TypeParam;
  const Shape<T> ground = terrain<T>(40, T(1)), bullet{Sphere<T>(T(0.01))};
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3<T> target{T(i % 20) * T(1.7) - T(17), T(-1), T(i / 20) * T(3.1) - T(15)};
    const Vec3<T> from = target + Vec3<T>{T(31 * (i % 7)), T(100), T(i % 5)};
    const Vec3<T> v = (target - from) * T(40);
    const auto hit = cast(ground, {}, {}, bullet, {from, {}}, {v, {}}, T(0.05));
    ASSERT_TRUE(hit) << i;
    // The same against the triangles one by one.
    const auto& mesh = *ground.template as<Mesh<T>>();
    T first = T(1);
    for (const auto& c : mesh.triangles()) {
      const Shape<T> piece{Triangle<T>(mesh.points()[c[0]], mesh.points()[c[1]], mesh.points()[c[2]])};
      if (const auto alone = cast(piece, {}, {}, bullet, {from, {}}, {v, {}}, T(0.05)))
        first = std::min(first, alone->t);
    }
    const T near = T(40) * cast_tolerance<T> / length(v) + T(4) * std::numeric_limits<T>::epsilon() * first;
    EXPECT_NEAR(hit->t, first, near * T(8)) << i;
    ++hits;
  }
  EXPECT_EQ(hits, 200);
}

}  // namespace
}  // namespace graze
