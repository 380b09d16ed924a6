// Batches: for every pair the bits of the question about it alone, in any order, with any neighbours, at every level.
#include "graze/batch.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "common/long_run.hpp"
#include "common/specimen.hpp"
#include "query/crowd.hpp"

namespace graze::testing {
namespace {

/// Kernels write to where the answers stay once there is room, and aside before.
template <class T>
void expect_same_again(const Batch<T>& batch, T margin, const BatchContacts<T>& first) {
  BatchContacts<T> again = first;
  contacts(batch, margin, again);
  ASSERT_EQ(again.pairs.size(), first.pairs.size());
  ASSERT_EQ(again.manifolds.size(), first.manifolds.size());
  ASSERT_EQ(again.points.size(), first.points.size());
  for (std::size_t i = 0; i < first.pairs.size(); ++i) {
    EXPECT_EQ(again.pairs[i].overlap, first.pairs[i].overlap);
    EXPECT_EQ(again.pairs[i].first_manifold, first.pairs[i].first_manifold);
    EXPECT_EQ(again.pairs[i].manifold_count, first.pairs[i].manifold_count);
  }
  for (std::size_t m = 0; m < first.manifolds.size(); ++m)
    EXPECT_TRUE(same_bits(again.manifolds[m], first.manifolds[m]));
  for (std::size_t p = 0; p < first.points.size(); ++p) EXPECT_TRUE(same_bits(again.points[p], first.points[p]));
}

/// In few bytes: each manifold of each pair once, those of a pair in their order.
template <class T>
void expect_same_compact(const Batch<T>& batch, T margin, const BatchContacts<T>& expected) {
  CompactContacts<T> found;
  for (int again = 0; again < 2; ++again) {
    contacts(batch, margin, found);
    ASSERT_EQ(found.manifolds.size(), expected.manifolds.size());
    ASSERT_EQ(found.points.size(), expected.points.size());
    std::vector<std::size_t> told(batch.size(), 0);
    std::size_t next_point = 0;
    for (const auto& m : found.manifolds) {
      const auto manifolds = expected.manifolds_of(m.pair);
      ASSERT_LT(told[m.pair], manifolds.size());
      const auto& there = manifolds[told[m.pair]++];
      EXPECT_TRUE(same_bits(m.normal, there.normal));
      EXPECT_EQ(m.first_point, next_point);
      next_point += m.point_count;
      const auto p = found.points_of(m);
      const auto q = expected.points_of(there);
      ASSERT_EQ(p.size(), q.size());
      for (std::size_t k = 0; k < p.size(); ++k) {
        EXPECT_TRUE(same_bits(p[k].position, q[k].position()));
        EXPECT_TRUE(same_bits(p[k].distance, q[k].distance));
      }
    }
  }
}

template <class T>
void expect_same(const Batch<T>& batch, T margin) {
  std::vector<std::uint8_t> touch;
  std::vector<Distance<T>> distances;
  BatchContacts<T> found;
  overlap(batch, touch);
  distance(batch, distances);
  contacts(batch, margin, found);
  ASSERT_EQ(touch.size(), batch.size());
  ASSERT_EQ(distances.size(), batch.size());
  ASSERT_EQ(found.pairs.size(), batch.size());
  std::size_t points = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const IdPair p = batch[i];
    const Shape<T> a = batch.a().shape(p.a), b = batch.b().shape(p.b);
    const Pose<T>&pose_a = batch.a().pose(p.a), &pose_b = batch.b().pose(p.b);
    EXPECT_EQ(touch[i] != 0, overlap(a, pose_a, b, pose_b));
    EXPECT_TRUE(same_bits(distances[i], distance(a, pose_a, b, pose_b))) << a.name() << ' ' << b.name();
    Manifolds<T> alone;
    EXPECT_EQ(found.pairs[i].overlap, contacts(a, pose_a, b, pose_b, margin, alone));
    const auto manifolds = found.manifolds_of(i);
    ASSERT_EQ(manifolds.size(), alone.size()) << a.name() << ' ' << b.name();
    for (std::size_t m = 0; m < alone.size(); ++m) {
      EXPECT_TRUE(same_bits(manifolds[m].normal, alone[m].normal));
      const auto of = found.points_of(manifolds[m]);
      ASSERT_EQ(of.size(), alone[m].points.size());
      for (std::size_t k = 0; k < of.size(); ++k) EXPECT_TRUE(same_bits(of[k], alone[m].points[k]));
      points += of.size();
    }
  }
  EXPECT_EQ(points, found.points.size());
  expect_same_again(batch, margin, found);
  expect_same_compact(batch, margin, found);
}

TEST(Batch, AnswersAsTheQuestionAboutEachPairDoes) {
  const Crowd<float> floats(150, 1);
  expect_same(Batch<float>(floats.bodies(), floats.bodies(), floats.pairs), 0.02f);
  const Crowd<double> doubles(150, 2);
  expect_same(Batch<double>(doubles.bodies(), doubles.bodies(), doubles.pairs), 0.02);
}

// The neighbours of a pair in its bundle change with every order and every split.
TEST(Batch, GivesEveryPairTheSameBitsInAnyOrderAndSplit) {
  const Crowd<float> crowd(100, 3);
  const Batch<float> whole(crowd.bodies(), crowd.bodies(), crowd.pairs);
  BatchContacts<float> expected, found;
  contacts(whole, 0.02f, expected);
  std::vector<Distance<float>> expected_distances, distances;
  distance(whole, expected_distances);
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::uint32_t> order(crowd.pairs.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    order.resize(1 + random() % order.size());
    for (std::size_t i = 0; i < 10; ++i) order.push_back(order[random() % order.size()]);  // some of them again
    std::vector<IdPair> pairs;
    for (const std::uint32_t i : order) pairs.push_back(crowd.pairs[i]);
    const Batch<float> batch(crowd.bodies(), crowd.bodies(), pairs);
    contacts(batch, 0.02f, found);
    distance(batch, distances);
    for (std::size_t k = 0; k < order.size(); ++k) {
      ASSERT_TRUE(same_bits(distances[k], expected_distances[order[k]]));
      const auto here = found.manifolds_of(k), there = expected.manifolds_of(order[k]);
      ASSERT_EQ(here.size(), there.size());
      for (std::size_t m = 0; m < here.size(); ++m) {
        ASSERT_TRUE(same_bits(here[m].normal, there[m].normal));
        const auto p = found.points_of(here[m]), q = expected.points_of(there[m]);
        ASSERT_EQ(p.size(), q.size());
        for (std::size_t i = 0; i < p.size(); ++i) ASSERT_TRUE(same_bits(p[i], q[i]));
      }
    }
  }
}

// One shape against many poses, one pose for many shapes, and arrays of one kind.
TEST(Batch, TakesOneShapeForAllAndArraysOfOneKind) {
  Random random(5);
  std::vector<Pose<float>> poses;
  std::vector<Box<float>> boxes;
  std::vector<Sphere<float>> spheres;
  std::vector<Triangle<float>> triangles;
  std::vector<Pose<float>> one_pose{Pose<float>{}};
  for (int i = 0; i < 100; ++i) {
    poses.push_back({random_vector(random, 1.0f), random_rotation(random)});
    boxes.emplace_back(abs(random_vector(random, 1.0f)) + Vec3f{0.1f, 0.1f, 0.1f});
    spheres.emplace_back(0.3f, random_vector(random, 1.0f));
    const Vec3f corner = random_vector(random, 1.0f), side = random_vector(random, 1.0f);
    triangles.emplace_back(corner, corner + side, corner + (i % 10 == 0 ? side : random_vector(random, 1.0f)));
  }
  const std::vector<Box<float>> one_box{Box<float>({1, 0.5f, 0.7f})};
  using BoxSpan = std::span<const Box<float>>;
  using PoseSpan = std::span<const Pose<float>>;
  const Bodies<float> one(BoxSpan{one_box}, PoseSpan{one_pose}), many_poses(BoxSpan{one_box}, PoseSpan{poses}),
      many(BoxSpan{boxes}, PoseSpan{poses}), balls(std::span<const Sphere<float>>(spheres), PoseSpan{one_pose}),
      flats(std::span<const Triangle<float>>(triangles), PoseSpan{poses});
  expect_same(Batch<float>(one, many_poses), 0.01f);
  expect_same(Batch<float>(one, many), 0.01f);
  expect_same(Batch<float>(many, many_poses), 0.01f);
  expect_same(Batch<float>(many, balls), 0.01f);
  expect_same(Batch<float>(balls, balls), 0.01f);
  expect_same(Batch<float>(one, flats), 0.01f);
  expect_same(Batch<float>(flats, many), 0.01f);
  expect_same(Batch<float>(flats, flats), 0.01f);
}

// Those that kernels do not take stand among those that they do, over several of their chunks.
TEST(Batch, TakesIrregularOnesAmongManyOfOneKind) {
  Random random(6);
  std::vector<Pose<float>> poses;
  std::vector<Capsule<float>> capsules;
  std::vector<Box<float>> boxes;
  std::vector<IdPair> pairs;
  for (std::uint32_t i = 0; i < 300; ++i) {
    poses.push_back({random_vector(random, 1.0f), random_rotation(random)});
    if (random() % 4 == 0)
      capsules.emplace_back(0.4f, 0.2f, 0.3f);
    else
      capsules.emplace_back(random() % 4 == 0 ? 0.0f : 0.4f, 0.3f);
    boxes.emplace_back(Vec3f{0.5f, 0.3f, random() % 4 == 0 ? 1e-8f : 0.4f});
    pairs.push_back({static_cast<std::uint32_t>(random() % 300), static_cast<std::uint32_t>(random() % 300)});
  }
  const Bodies<float> rods{std::span<const Capsule<float>>(capsules), std::span<const Pose<float>>(poses)},
      cases{std::span<const Box<float>>(boxes), std::span<const Pose<float>>(poses)};
  expect_same(Batch<float>(rods, rods, pairs), 0.01f);
  expect_same(Batch<float>(cases, rods, pairs), 0.01f);
  expect_same(Batch<float>(cases, cases, pairs), 0.01f);
  expect_same(Batch<float>(rods, cases), 0.01f);
}

// So many that kernels write most of them to where they stay when asked again, with some among them that they do not
// know, and pairs that wait from one chunk for the next.
template <class T>
void expect_same_of_boxes(unsigned seed) {
  Random random(seed);
  std::vector<Pose<T>> here, there;
  std::vector<Box<T>> boxes;
  std::vector<IdPair> pairs;
  for (std::uint32_t i = 0; i < 500; ++i) {
    here.push_back({converted<T>(random_vector(random, 0.4f)), converted<T>(random_rotation(random))});
    there.push_back({converted<T>(random_vector(random, 0.4f)), i % 3 == 0 ? here[i].rotation : Quat<T>{}});
    boxes.emplace_back(Vec3<T>{T(0.5), T(0.3), random() % 10 == 0 ? T(sizeof(T) == 4 ? 1e-8 : 1e-80) : T(0.4)});
    pairs.push_back({static_cast<std::uint32_t>(random() % 500), static_cast<std::uint32_t>(random() % 500)});
  }
  const std::span<const Box<T>> shapes(boxes);
  const Bodies<T> a(shapes, std::span<const Pose<T>>(here)), b(shapes, std::span<const Pose<T>>(there));
  expect_same(Batch<T>(a, b), T(0.01));
  expect_same(Batch<T>(a, b, pairs), T(0));
}

TEST(Batch, WritesBoxesToWhereTheyStay) {
  expect_same_of_boxes<float>(9);
  expect_same_of_boxes<double>(10);
}

/// Arrays of one kind each, in order and as places, also with a body that stands against all; the balls centred or not.
template <class T>
struct Rows {
  std::vector<Pose<T>> poses;
  std::vector<Sphere<T>> centred, balls;
  std::vector<Capsule<T>> capsules;
  std::vector<Box<T>> boxes;
  std::vector<Rectangle<T>> rectangles;
  std::vector<Triangle<T>> triangles;
  std::vector<HalfSpace<T>> planes;
  std::vector<IdPair> pairs;

  explicit Rows(std::uint32_t count, Random& random) {
    for (std::uint32_t i = 0; i < count; ++i) {
      Vec3f place = random_vector(random, 0.8f);
      if (i % 3 == 0) place = {-0.0f, i % 2 == 0 ? 0.0f : -0.0f, place.z};  // where zeros keep or lose their sign
      poses.push_back({converted<T>(place), converted<T>(random_rotation(random))});
      centred.emplace_back(T(0.4));
      balls.emplace_back(T(0.3), i % 2 == 0 ? Vec3<T>{} : converted<T>(random_vector(random, 0.5f)));
      capsules.emplace_back(T(i % 7 == 0 ? 0.0 : 0.6), T(0.2));
      boxes.emplace_back(converted<T>(abs(random_vector(random, 0.5f)) + Vec3f{0.1f, 0.1f, i % 5 == 0 ? 1e-8f : 0.1f}));
      const Vec3<T>& half = boxes.back().half_extents();
      rectangles.emplace_back(i % 9 == 1 ? T(0) : half.y, T(2) * half.z);
      const Vec3<T> corner = converted<T>(random_vector(random, 0.5f)),
                    side = converted<T>(random_vector(random, 0.5f));
      // Some slivers and points.
      triangles.emplace_back(corner, corner + side,
                             corner + (i % 7 == 0   ? side
                                       : i % 7 == 1 ? side * T(0.5)
                                                    : converted<T>(random_vector(random, 0.5f))));
      planes.emplace_back();
      pairs.push_back({static_cast<std::uint32_t>(random() % count), static_cast<std::uint32_t>(random() % count)});
    }
  }
  template <class C>
  Bodies<T> bodies(const std::vector<C>& shapes) const {
    return {std::span<const C>(shapes), std::span<const Pose<T>>(poses)};
  }
  void expect_all_same() const {
    const Bodies<T> sides[] = {bodies(centred),    bodies(balls),     bodies(capsules), bodies(boxes),
                               bodies(rectangles), bodies(triangles), bodies(planes)};
    const std::vector<Sphere<T>> one{Sphere<T>(T(0.5))};
    const Bodies<T> single(std::span<const Sphere<T>>(one), std::span<const Pose<T>>(poses).first(1));
    for (const Bodies<T>& a : sides) {
      expect_same(Batch<T>(single, a), T(0.05));
      expect_same(Batch<T>(a, single), T(0));
      for (const Bodies<T>& b : sides) {
        expect_same(Batch<T>(a, b), T(0.05));
        expect_same(Batch<T>(a, b, pairs), T(0));
      }
    }
  }
};

TEST(Batch, TakesRowsOfAnyLength) {
  Random random(7);
  for (const std::uint32_t count : {1u, 2u, 7u, 15u, 16u, 17u, 33u, 150u}) Rows<float>(count, random).expect_all_same();
  for (const std::uint32_t count : {1u, 3u, 16u, 21u}) Rows<double>(count, random).expect_all_same();
}

/// Balls and capsules at triangles, of all sizes, some far away. Among them are points, slivers, segments, radii and
/// heights of zero, tapered capsules, and shapes that touch a triangle exactly, stand or lie on it or cut it.
template <class T>
struct RoundsAndTriangles {
  std::vector<Sphere<T>> balls;
  std::vector<Capsule<T>> capsules;
  std::vector<Triangle<T>> triangles;
  std::vector<Pose<T>> at, triangles_at;
  std::vector<IdPair> pairs;

  explicit RoundsAndTriangles(std::uint32_t count, Random& random) {
    static constexpr float scales[] = {1, 1e-4f, 1e-2f, 1e2f, 1e4f};
    for (std::uint32_t i = 0; i < count; ++i) {
      const float scale = scales[i % 5];
      const auto vector = [&](float reach) { return converted<T>(random_vector(random, reach * scale)); };
      const Vec3<T> away = i % 10 == 5 ? vector(1e4f) : Vec3<T>{}, p = vector(1);
      Vec3<T> q = vector(1), r = vector(1);
      if (i % 16 == 1) q = p;
      if (i % 16 == 2) q = r = p;
      if (i % 16 == 3) r = p + (q - p) * T(1.0 / 3) + vector(1) * T(std::exp2(-uniform(random, 0, 40)));
      triangles.emplace_back(p, q, r);
      const T radius = i % 11 == 0 ? T(0) : T(scale) * T(uniform(random, 0.1f, 0.6f)),
              height = i % 13 == 0 ? T(0) : T(scale) * T(uniform(random, 0.1f, 2));
      balls.emplace_back(radius, i % 4 == 0 ? vector(0.5f) : Vec3<T>{});
      capsules.emplace_back(height, radius, i % 17 == 0 ? radius / 2 : radius);
      const Quat<T> turn = i % 3 == 0 ? Quat<T>{} : converted<T>(random_rotation(random));
      triangles_at.push_back({away, turn});
      // Over the triangle's middle, and just its radius away, or anywhere.
      const Vec3<T> n = rotate(turn, normalized(cross(q - p, r - p))), middle = rotate(turn, (p + q + r) * T(1.0 / 3));
      const bool exact = i % 6 == 0;
      at.push_back({exact ? away + middle + n * radius : away + vector(i % 6 == 1 ? 0.01f : 0.8f),
                    i % 6 < 2 ? turn : converted<T>(random_rotation(random))});
      pairs.push_back({static_cast<std::uint32_t>(random() % count), static_cast<std::uint32_t>(random() % count)});
    }
  }
  void expect_all_same() const {
    const std::span<const Pose<T>> poses(at);
    const Bodies<T> flats{std::span<const Triangle<T>>(triangles), std::span<const Pose<T>>(triangles_at)};
    for (const Bodies<T>& rounds : {Bodies<T>(std::span<const Sphere<T>>(balls), poses),
                                    Bodies<T>(std::span<const Capsule<T>>(capsules), poses)}) {
      expect_same(Batch<T>(rounds, flats), T(0));
      expect_same(Batch<T>(flats, rounds), T(0.05));
      expect_same(Batch<T>(rounds, flats, pairs), T(1e3));
    }
  }
};

TEST(Batch, TakesRoundShapesAndTriangles) {
  Random random(8);
  for (const std::uint32_t count : {1u, 3u, 9u, 300u}) RoundsAndTriangles<float>(count, random).expect_all_same();
  for (const std::uint32_t count : {1u, 5u, 300u}) RoundsAndTriangles<double>(count, random).expect_all_same();
}

/// Capsules that lie on boxes and triangles and along other capsules, some hardly and some beyond the rim, among others
/// that stand.
template <class T>
void expect_same_of_lying() {
  Random random(8);
  std::vector<Capsule<T>> rods, others;
  std::vector<Box<T>> boxes;
  std::vector<Triangle<T>> triangles;  // of which one edge is a box's
  std::vector<Pose<T>> on, ground, beside;
  std::vector<Shape<T>> shapes;
  const double quarter = std::acos(0.0);
  const auto some = [&](double low, double high) {
    return static_cast<double>(uniform(random, static_cast<float>(low), static_cast<float>(high)));
  };
  for (int i = 0; i < 150; ++i) {
    const double radius = some(0.1, 0.4), lean = some(-0.05, 0.05) + (i % 9 == 0 ? 1 : 0);
    const Vec3d size{some(0.3, 2), some(0.3, 2), some(0.3, 2)};
    rods.emplace_back(T(some(0.3, 1.6)), T(radius));
    others.emplace_back(T(some(0.3, 1.6)), T(radius));
    boxes.emplace_back(converted<T>(size));
    const Vec3d half = size * 0.5, away{some(-1, 1), i % 4 == 0 ? some(-1, 1) : 0, some(-1, 1)};
    triangles.emplace_back(converted<T>(half), converted<T>(Vec3d{half.x, half.y, -half.z}), converted<T>(half - away));
    const Posed floor{converted<double>(random_vector(random, 1.0f)),
                      normalized(converted<double>(random_rotation(random)))};
    const Quatd side =
        Quatd::from_axis_angle({0, 1, 0}, some(0, 6)) * Quatd::from_axis_angle({0, 0, 1}, quarter + lean);
    const Posed rod =
        compose(floor, Posed{{some(-0.6, 0.6) * size.x, size.y / 2 + radius + some(-0.05, 0.05), 0}, side});
    ground.push_back(converted<T>(floor));
    on.push_back(converted<T>(rod));
    beside.push_back(converted<T>(compose(
        rod, Posed{{2 * radius + some(-0.05, 0.05), some(-1, 1), 0}, Quatd::from_axis_angle({1, 0, 0}, lean)})));
    shapes.emplace_back(rods.back());
  }
  const std::span<const Capsule<T>> rod_span(rods), other_span(others);
  const std::span<const Pose<T>> on_span(on), beside_span(beside), ground_span(ground);
  const Bodies<T> a{rod_span, on_span}, b{other_span, beside_span}, c{std::span<const Box<T>>(boxes), ground_span},
      flats{std::span<const Triangle<T>>(triangles), ground_span}, mixed{std::span<const Shape<T>>(shapes), on_span};
  for (const T margin : {T(0), T(0.05)})
    for (const Batch<T>& batch : {Batch<T>(a, b), Batch<T>(b, a), Batch<T>(a, c), Batch<T>(c, a), Batch<T>(mixed, b),
                                  Batch<T>(b, mixed), Batch<T>(mixed, c), Batch<T>(c, mixed), Batch<T>(a, flats),
                                  Batch<T>(flats, a), Batch<T>(mixed, flats), Batch<T>(flats, mixed)})
      expect_same(batch, margin);
  BatchContacts<T> found;
  contacts(Batch<T>(a, c), T(0.05), found);
  EXPECT_GT(found.points.size(), found.manifolds.size() + 80);
  contacts(Batch<T>(a, b), T(0.05), found);
  EXPECT_GT(found.points.size(), found.manifolds.size() + 50);
  contacts(Batch<T>(a, flats), T(0.05), found);
  EXPECT_GT(found.points.size(), found.manifolds.size() + 30);
}

TEST(Batch, TakesCapsulesThatLie) {
  expect_same_of_lying<float>();
  expect_same_of_lying<double>();
}

TEST(Batch, GivesTheGoldenBits) {
  EXPECT_EQ(hash_of_a_long_run<float>(), golden_bits<float>);
  EXPECT_EQ(hash_of_a_long_run<double>(), golden_bits<double>);
}

TEST(Batch, RefusesNumbersThatDoNotGoTogether) {
  const std::vector<Sphere<double>> spheres(3, Sphere<double>(1));
  const std::vector<Pose<double>> poses(2), three(3);
  using SphereSpan = std::span<const Sphere<double>>;
  using PoseSpan = std::span<const Pose<double>>;
  EXPECT_THROW(Bodies<double>(SphereSpan{spheres}, PoseSpan{poses}), InvalidValue);
  const Bodies<double> bodies(SphereSpan{spheres}, PoseSpan{three}), two(SphereSpan{spheres}.first(2), PoseSpan{poses});
  EXPECT_THROW(Batch<double>(bodies, two), InvalidValue);
  const std::vector<IdPair> pairs{{0, 1}, {2, 3}};
  try {
    Batch<double>(bodies, bodies, pairs);
    FAIL() << "a place that there is not was taken";
  } catch (const InvalidValue& e) {
    EXPECT_STREQ(e.what(), "pairs[1].b: expected a place below 3, got 3");
  }
  std::vector<std::uint8_t> touch;
  overlap(Batch<double>(bodies, bodies, std::span<const IdPair>{}), touch);
  EXPECT_TRUE(touch.empty());
}

}  // namespace
}  // namespace graze::testing
