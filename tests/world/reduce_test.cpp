// Fewer points of a pair, over all of its manifolds: of one pair, of a batch and of a world.
#include "graze/world/reduce.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/executors.hpp"
#include "graze/batch.hpp"
#include "graze/plane/reduce.hpp"
#include "graze/plane/world.hpp"
#include "graze/world.hpp"

namespace graze::testing {
namespace {

/// A point and its normal, as it is compared.
template <class T>
struct Seen {
  Vec3<T> normal, a, b;
  T distance;
  std::uint32_t feature;
  bool operator==(const Seen&) const = default;
};

template <class T>
std::vector<Seen<T>> seen(const Manifolds<T>& manifolds) {
  std::vector<Seen<T>> all;
  for (const auto& m : manifolds)
    for (const auto& p : m.points) all.push_back({m.normal, p.a, p.b, p.distance, p.feature});
  return all;
}

/// Of one pair of arrays.
template <class Arrays, class Pair>
auto seen(const Arrays& arrays, const Pair& pair) {
  using T = std::decay_t<decltype(arrays.points[0].distance)>;
  std::vector<Seen<T>> all;
  for (std::uint32_t i = pair.first_manifold; i < pair.first_manifold + pair.manifold_count; ++i)
    for (const auto& p : arrays.points_of(arrays.manifolds[i]))
      all.push_back({arrays.manifolds[i].normal, p.a, p.b, p.distance, p.feature});
  return all;
}

/// A hilly ground of triangles, two in each cell.
template <class T>
Mesh<T> hills(int cells, double cell = 0.25) {
  std::vector<Vec3<T>> points;
  std::vector<typename Mesh<T>::Index> triangles;
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * (cells + 1) + k); };
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k) {
      const double x = cell * (i - cells / 2.0), z = cell * (k - cells / 2.0);
      points.push_back({T(x), T(0.3 * std::sin(1.7 * x) * std::cos(1.3 * z)), T(z)});
    }
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k) {
      triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k)});
      triangles.push_back({at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)});
    }
  return {points, triangles};
}

template <class T>
class ReducePairs : public ::testing::Test {
 public:
  const Shape<T> ground = hills<T>(48), crate = Box<T>({T(1), T(1), T(1)});

  /// Crates half sunk in the ground, each turned otherwise; and one above it.
  std::vector<Pose<T>> poses() const {
    std::vector<Pose<T>> all;
    for (int i = 0; i < 5; ++i)
      for (int k = 0; k < 5; ++k)
        all.push_back({{T(2 * i - 4), T(0), T(2 * k - 4)},
                       Quat<T>::from_axis_angle({T(0.1 * i), T(1), T(0.1 * k)}, T(0.37 * (5 * i + k)))});
    all.push_back({{T(0), T(3), T(0)}, {}});
    return all;
  }
};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ReducePairs, Scalars);

template <class T>
std::vector<Seen<T>> found_alone(const Shape<T>& ground, const Shape<T>& crate, const Pose<T>& pose,
                                 std::size_t count) {
  Manifolds<T> manifolds;
  contacts(ground, Pose<T>{}, crate, pose, T(0), manifolds);
  reduce(manifolds, count);
  for (const auto& m : manifolds) EXPECT_FALSE(m.points.empty());
  return seen(manifolds);
}

/// How far apart two contacts are: see the header.
template <class T>
T apart(const Seen<T>& p, const Seen<T>& q, T reach) {
  const Vec3<T> place = (p.a + p.b) * T(0.5) - (q.a + q.b) * T(0.5);
  return std::sqrt(length_squared(place) + length_squared(p.normal - q.normal) * reach * reach);
}

TYPED_TEST(ReducePairs, KeepsTheDeepestAndWhatIsSpread) {
  using T = TypeParam;
  int many = 0;
  for (const Pose<T>& pose : this->poses())
    for (const std::size_t count : {1u, 2u, 4u, 8u}) {
      const auto all = found_alone(this->ground, this->crate, pose, 1000000);
      const auto kept = found_alone(this->ground, this->crate, pose, count);
      ASSERT_EQ(kept.size(), std::min(count, all.size()));
      if (all.size() <= count) continue;
      ++many;
      // They are of the old ones, in their order, with the deepest among them.
      auto at = all.begin();
      for (const auto& p : kept) {
        at = std::find(at, all.end(), p);
        ASSERT_NE(at, all.end());
        ++at;
      }
      const auto by_depth = [](const auto& p, const auto& q) { return p.distance < q.distance; };
      const Seen<T> deepest = *std::min_element(all.begin(), all.end(), by_depth);
      EXPECT_EQ(std::min_element(kept.begin(), kept.end(), by_depth)->distance, deepest.distance);
      // Nothing that is left out is further from what is kept than those are from each other.
      T reach(0), furthest(0), nearest = std::numeric_limits<T>::infinity();
      for (const auto& p : all)
        reach = std::max(reach, length((p.a + p.b) * T(0.5) - (deepest.a + deepest.b) * T(0.5)));
      for (const auto& p : all) {
        T to_kept = std::numeric_limits<T>::infinity();
        for (const auto& q : kept) to_kept = std::min(to_kept, apart(p, q, reach));
        furthest = std::max(furthest, to_kept);
      }
      for (std::size_t i = 0; i < kept.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) nearest = std::min(nearest, apart(kept[i], kept[k], reach));
      EXPECT_LE(furthest, nearest * T(1.0001));
    }
  EXPECT_GE(many, 80);
}

TYPED_TEST(ReducePairs, OfOneManifoldAsThatAlone) {
  using T = TypeParam;
  const Shape<T> box = Box<T>({T(2), T(2), T(2)});
  for (const std::size_t count : {0u, 1u, 3u, 4u, 6u, 8u, 9u}) {
    Manifolds<T> together;
    contacts(box, Pose<T>{}, box, Pose<T>{{T(0.1), T(1.99), T(0)}, Quat<T>::from_axis_angle({0, 1, 0}, T(0.7))}, T(0),
             together);
    ASSERT_EQ(together.size(), 1u);
    Manifolds<T> alone = together;
    reduce(alone[0], count);
    reduce(together, count);
    EXPECT_EQ(seen(together), seen(alone)) << count;
    EXPECT_EQ(together.empty(), count == 0);
  }
}

// A ball in a groove and on a wall: two points at most, of other normals and not beside each other.
TYPED_TEST(ReducePairs, NormalsCountAsPlacesDo) {
  using T = TypeParam;
  Manifolds<T> manifolds(3);
  const Vec3<T> normals[] = {{0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    manifolds[i].normal = normals[i];
    manifolds[i].piece_b = static_cast<std::uint32_t>(i);
  }
  // On the ground a patch of four near each other, and a point on each of two walls that face each other.
  for (int k = 0; k < 4; ++k) {
    const Vec3<T> p{T(k & 1) / 10, 0, T(k / 2) / 10};
    manifolds[0].points.push_back({p, p, T(-0.2) + T(k) / 100, static_cast<std::uint32_t>(k)});
  }
  for (std::size_t i = 1; i < 3; ++i) {
    const Vec3<T> p{i == 1 ? T(0.3) : T(-0.3), T(0.3), 0};
    manifolds[i].points.push_back({p, p, T(-0.1), 0});
  }
  reduce(manifolds, 3);
  ASSERT_EQ(manifolds.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(manifolds[i].points.size(), 1u);
    EXPECT_EQ(manifolds[i].piece_b, i);
  }
  EXPECT_EQ(manifolds[0].points[0].feature, 0u);
  reduce(manifolds, 1);
  ASSERT_EQ(manifolds.size(), 1u);
  EXPECT_EQ(manifolds[0].points[0].distance, T(-0.2));
  reduce(manifolds, 0);
  EXPECT_TRUE(manifolds.empty());
}

TYPED_TEST(ReducePairs, OfABatchAsOfEachPair) {
  using T = TypeParam;
  // Pairs of kinds that are found in another order stand among the others.
  std::vector<Shape<T>> shapes_a, shapes_b;
  std::vector<Pose<T>> at_a, at_b;
  const std::vector<Pose<T>> poses = this->poses();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool ball = i % 3 == 0;
    shapes_a.push_back(ball ? Shape<T>(Sphere<T>(T(0.6))) : this->ground);
    at_a.push_back(ball ? poses[i] : Pose<T>{});
    shapes_b.push_back(this->crate);
    at_b.push_back(poses[i]);
  }
  for (const std::size_t count : {0u, 1u, 4u, 8u}) {
    BatchContacts<T> found;
    contacts(Batch<T>(Bodies<T>(shapes_a, at_a), Bodies<T>(shapes_b, at_b)), T(0), found);
    const BatchContacts<T> whole = found;
    reduce(found, count);
    ASSERT_EQ(found.pairs.size(), poses.size());
    std::size_t points = 0, manifolds = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      Manifolds<T> alone;
      contacts(shapes_a[i], at_a[i], shapes_b[i], at_b[i], T(0), alone);
      reduce(alone, count);
      EXPECT_EQ(seen(found, found.pairs[i]), seen(alone)) << i;
      EXPECT_EQ(found.pairs[i].overlap, whole.pairs[i].overlap);
      EXPECT_EQ(found.pairs[i].manifold_count, alone.size());
      points += seen(alone).size();
      manifolds += alone.size();
    }
    EXPECT_EQ(found.points.size(), points);
    EXPECT_EQ(found.manifolds.size(), manifolds);
    EXPECT_LT(found.points.size(), whole.points.size());
  }
}

// What was reduced stays what it is where nothing changes, is found whole again where something does, and carries its
// impulses on.
TYPED_TEST(ReducePairs, AWorldGoesOnFromReducedContacts) {
  using T = TypeParam;
  World<T> world, untouched;
  Body<T> ground{this->ground, {}};
  ground.fixed = true;
  world.add(ground);
  untouched.add(ground);
  std::vector<BodyId> ids;
  for (const Pose<T>& pose : this->poses()) {
    ids.push_back(world.add({this->crate, pose}));
    untouched.add({this->crate, pose});
  }
  world.update();
  untouched.update();
  const ContactArrays<T> whole = world.contacts();
  reduce(world.contacts(), 4);
  ASSERT_EQ(world.contacts().pairs.size(), whole.pairs.size());
  for (std::size_t i = 0; i < whole.pairs.size(); ++i) {
    const auto& pair = world.contacts().pairs[i];
    EXPECT_EQ(seen(world.contacts(), pair).size(), std::min<std::size_t>(4, seen(whole, whole.pairs[i]).size()));
  }
  for (auto& p : world.contacts().points) p.impulse = {T(1), T(2), T(3)};
  const ContactArrays<T> reduced = world.contacts();

  Pose<T> moved = this->poses()[7];
  moved.translation.y += T(0.001);
  world.move(ids[7], moved);
  world.update();
  ASSERT_EQ(world.contacts().pairs.size(), whole.pairs.size());
  untouched.move(ids[7], moved);
  untouched.update();
  int again = 0;
  for (std::size_t i = 0; i < whole.pairs.size(); ++i) {
    const auto& pair = world.contacts().pairs[i];
    const bool changed = pair.a == ids[7].index || pair.b == ids[7].index;
    again += changed;
    const auto anew = seen(untouched.contacts(), untouched.contacts().pairs[i]);
    EXPECT_TRUE(seen(world.contacts(), pair) == (changed ? anew : seen(reduced, reduced.pairs[i]))) << i;
    if (changed) {
      EXPECT_GT(anew.size(), 8u);
    }
    std::size_t pushed = 0;
    for (const auto& m : world.contacts().manifolds_of(pair))
      for (const auto& p : world.contacts().points_of(m)) pushed += p.impulse == Vec3<T>{T(1), T(2), T(3)};
    EXPECT_GE(pushed, std::min<std::size_t>(4, seen(reduced, reduced.pairs[i]).size()));
  }
  EXPECT_EQ(again, 1);
}

/// A thousand crates half sunk in hilly ground, each turned otherwise; neighbours touch here and there.
template <class T>
struct Crates {
  Shape<T> ground = hills<T>(72, 0.5), crate = Box<T>({T(1), T(1), T(1)});
  std::vector<Pose<T>> poses;

  Crates() {
    for (int i = 0; i < 40; ++i)
      for (int k = 0; k < 25; ++k) {
        const double x = 0.85 * (i - 19.5), z = 1.35 * (k - 12);
        poses.push_back({{T(x), T(0.3 * std::sin(1.7 * x) * std::cos(1.3 * z)), T(z)},
                         Quat<T>::from_axis_angle({T(0.1 * (i % 7)), T(1), T(0.1 * (k % 5))}, T(0.37 * (25 * i + k)))});
      }
  }
  std::vector<BodyId> fill(World<T>& world) const {
    Body<T> fixed{ground, {}};
    fixed.fixed = true;
    world.add(fixed);
    std::vector<BodyId> ids;
    for (const Pose<T>& pose : poses) ids.push_back(world.add({crate, pose}));
    return ids;
  }
  /// Two of three move a little, otherwise in every step; the others' contacts with the ground stay.
  void move(World<T>& world, const std::vector<BodyId>& ids, std::size_t step) const {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (i % 3 == step % 3) continue;
      Pose<T> moved = poses[i];
      moved.translation.y += T(0.001) * T(step + 1);
      world.move(ids[i], moved);
    }
  }
};

/// A solver that notes at each point which it was.
template <class T>
void push(ContactArrays<T>& contacts, T step) {
  for (const auto& pair : contacts.pairs) {
    T number(0);
    for (const auto& m : contacts.manifolds_of(pair))
      for (std::uint32_t k = 0; k < m.point_count; ++k)
        contacts.points[m.first_point + k].impulse = {T(pair.a) + step, T(pair.b), ++number};
  }
}

/// What an update found, pair by pair.
template <class T>
struct Answer {
  std::vector<std::vector<Seen<T>>> points;
  std::vector<std::vector<Vec3<T>>> impulses;
  std::vector<std::uint32_t> manifolds;
  bool operator==(const Answer&) const = default;

  explicit Answer(const ContactArrays<T>& contacts) {
    for (const auto& pair : contacts.pairs) {
      points.push_back(seen(contacts, pair));
      manifolds.push_back(pair.manifold_count);
      impulses.emplace_back();
      for (const auto& m : contacts.manifolds_of(pair)) {
        EXPECT_GT(m.point_count, 0u);
        for (const auto& p : contacts.points_of(m)) impulses.back().push_back(p.impulse);
      }
    }
  }
};

/// A box that leans on a bumpy chain, whose pieces each have a manifold with it.
TYPED_TEST(ReducePairs, InThePlaneAsAWorldLeavesThem) {
  using T = TypeParam;
  std::vector<plane::Vec2<T>> bumps;
  for (int i = -8; i <= 8; ++i) bumps.push_back({T(-i) / T(4), (i % 2 == 0 ? T(0) : T(0.125)) + T(i * i) / T(512)});
  const plane::Shape<T> ground = plane::Chain<T>(bumps, false, plane::ChainSides::both), crate = plane::Box<T>({2, 1});
  int reduced = 0;
  for (const std::size_t count : {1u, 2u, 3u, 100u})
    for (int turn = -3; turn <= 3; ++turn) {
      const plane::Pose2<T> pose{{T(0.1), T(0.45)}, plane::Rot2<T>::from_angle(T(0.05) * T(turn))};
      plane::Manifolds<T> all, kept;
      plane::contacts(ground, plane::Pose2<T>{}, crate, pose, T(0), all);
      plane::contacts(ground, plane::Pose2<T>{}, crate, pose, T(0), kept);
      plane::reduce(kept, count);
      std::size_t points = 0;
      T deepest(1), deepest_kept(1);
      for (const auto& m : all)
        for (const auto& p : m.points) ++points, deepest = std::min(deepest, p.distance);
      for (const auto& m : kept)
        for (const auto& p : m.points) deepest_kept = std::min(deepest_kept, p.distance);
      EXPECT_EQ(deepest_kept, deepest);
      reduced += points > count;

      WorldSettings<T> settings;
      settings.margin = T(0);
      settings.points_per_pair = count;
      plane::World<T> world(settings);
      world.add({ground, {}});
      world.add({crate, pose});
      world.update();
      const auto& found = world.contacts();
      ASSERT_EQ(kept.size(), found.manifolds.size());
      std::size_t k = 0;
      for (std::size_t i = 0; i < kept.size(); ++i) {
        ASSERT_EQ(kept[i].points.size(), found.manifolds[i].point_count);
        for (const auto& p : kept[i].points) {
          EXPECT_EQ(p.feature, found.points[k].feature);
          EXPECT_EQ(p.a, found.points[k++].a);
        }
      }
      EXPECT_EQ(k, std::min(points, count));
    }
  EXPECT_GE(reduced, 14);
}

// A world that leaves so many points of a pair finds what `reduce` leaves of all that another finds, impulses carried
// on and pairs of which nothing changed included, and whatever its threads.
TYPED_TEST(ReducePairs, AWorldLeavesSoManyPointsOfAPair) {
  using T = TypeParam;
  const Crates<T> crates;
  WorldSettings<T> settings;
  settings.points_per_pair = 4;
  ThreadExecutor threads(3);
  World<T> whole, alone(settings), on_threads(settings, &threads);
  const std::vector<BodyId> ids = crates.fill(whole);
  for (World<T>* world : {&alone, &on_threads}) crates.fill(*world);
  std::size_t carried = 0, points = 0;
  for (std::size_t step = 0; step < 3; ++step) {
    whole.update();
    const std::size_t all_points = whole.contacts().points.size();
    reduce(whole.contacts(), 4);
    const Answer<T> expected(whole.contacts());
    ASSERT_GE(expected.points.size(), crates.poses.size());
    push(whole.contacts(), T(step));
    crates.move(whole, ids, step);
    for (World<T>* world : {&alone, &on_threads}) {
      world->update();
      EXPECT_TRUE(Answer<T>(world->contacts()) == expected) << "in step " << step;
      push(world->contacts(), T(step));
      crates.move(*world, ids, step);
    }
    for (const auto& of_pair : expected.points) ASSERT_LE(of_pair.size(), 4u);
    EXPECT_LT(alone.contacts().points.size() * 2, all_points);
    if (step == 0) continue;
    points += alone.contacts().points.size();
    for (const auto& of_pair : expected.impulses)
      for (const Vec3<T>& impulse : of_pair) carried += impulse != Vec3<T>{};
  }
  // Mostly the same ones are left from step to step, so that a solver goes on from what it found.
  EXPECT_GT(carried * 10, points * 9);
}

TYPED_TEST(ReducePairs, AWorldWithoutPointsStillKnowsWhatTouches) {
  using T = TypeParam;
  WorldSettings<T> settings;
  settings.points_per_pair = 0;
  World<T> world(settings), whole;
  for (World<T>* w : {&world, &whole}) {
    w->add({this->ground, {}});
    for (const Pose<T>& pose : this->poses()) w->add({this->crate, pose});
    w->update();
  }
  EXPECT_TRUE(world.contacts().points.empty());
  EXPECT_TRUE(world.contacts().manifolds.empty());
  ASSERT_EQ(world.contacts().pairs.size(), whole.contacts().pairs.size());
  for (std::size_t i = 0; i < whole.contacts().pairs.size(); ++i)
    EXPECT_EQ(world.contacts().pairs[i].overlap, whole.contacts().pairs[i].overlap);
  EXPECT_EQ(world.events().size(), whole.events().size());
}

}  // namespace
}  // namespace graze::testing
