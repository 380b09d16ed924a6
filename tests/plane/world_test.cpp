// The world of the plane against asking every pair anew: whatever is remembered, on however many threads, changes no
// bit.
#include "graze/plane/world.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "common/executors.hpp"
#include "graze/plane/proximity.hpp"
#include "plane/world_scenario.hpp"

namespace graze::plane {
namespace {

using graze::testing::BusyExecutor;
using graze::testing::ThreadExecutor;

template <class T>
class PlaneWorldOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneWorldOf, Scalars);

/// Whether a body is fixed with another fixed one beside it, with which it is one ground (`ground_test.cpp`).
template <class T>
bool is_beside_another(const World<T>& world, const Body<T>& body, std::uint32_t index) {
  const BodyArrays<T>& bodies = world.bodies();
  if (!body.fixed) return false;
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    if (i != index && bodies.alive()[i] != 0 && bodies.fixed()[i] != 0 &&
        within(body.shape, body.pose, bodies.shapes()[i], bodies.poses()[i], T(0.01)))
      return true;
  return false;
}

/// Every pair there is, asked by itself.
template <class T>
void expect_as_asked_one_by_one(const World<T>& world) {
  const BodyArrays<T>& bodies = world.bodies();
  const ContactArrays<T>& found = world.contacts();
  std::size_t pair = 0;
  for (std::uint32_t i = 0; i < bodies.size(); ++i)
    for (std::uint32_t j = i + 1; j < bodies.size(); ++j) {
      if (bodies.alive()[i] == 0 || bodies.alive()[j] == 0) continue;
      if (bodies.fixed()[i] != 0 && bodies.fixed()[j] != 0) continue;
      if (!may_collide(bodies.filters()[i], bodies.filters()[j])) continue;
      const Body<T> a = bodies.body(bodies.id(i)), b = bodies.body(bodies.id(j));
      Manifolds<T> manifolds;
      bool touch = false;
      if (a.trigger || b.trigger)
        touch = overlap(a.shape, a.pose, b.shape, b.pose);
      else
        touch = contacts(a.shape, a.pose, b.shape, b.pose, contact_margin(a.shape, b.shape), manifolds);
      if (!touch && manifolds.empty()) continue;
      const bool of_ground = is_beside_another(world, a, i) || is_beside_another(world, b, j);
      const bool there = pair < found.pairs.size() && found.pairs[pair].a == i && found.pairs[pair].b == j;
      if (of_ground && !touch && !there) continue;  // within the margin of what another body of the ground covers
      ASSERT_TRUE(there);
      const ContactPair<T>& p = found.pairs[pair++];
      EXPECT_EQ(p.overlap, touch);
      if (of_ground) continue;
      const auto of_pair = found.manifolds_of(p);
      ASSERT_EQ(of_pair.size(), manifolds.size());
      for (std::size_t m = 0; m < manifolds.size(); ++m) {
        EXPECT_EQ(of_pair[m].normal, manifolds[m].normal);
        EXPECT_EQ(of_pair[m].piece_a, manifolds[m].piece_a);
        EXPECT_EQ(of_pair[m].piece_b, manifolds[m].piece_b);
        const auto points = found.points_of(of_pair[m]);
        ASSERT_EQ(points.size(), manifolds[m].points.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
          EXPECT_EQ(points[k].a, manifolds[m].points[k].a);
          EXPECT_EQ(points[k].b, manifolds[m].points[k].b);
          EXPECT_EQ(points[k].distance, manifolds[m].points[k].distance);
          EXPECT_EQ(points[k].feature, manifolds[m].points[k].feature);
        }
      }
    }
  EXPECT_EQ(pair, found.pairs.size());
}

TYPED_TEST(PlaneWorldOf, AnswersAsEveryPairAskedByItself) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    Scenario<TypeParam> scenario(seed, 80, 8);
    std::size_t touched = 0;
    for (int frame = 0; frame < 25; ++frame) {
      scenario.step(frame % 3 != 0);
      expect_as_asked_one_by_one(scenario.world());
      if (this->HasFatalFailure()) FAIL() << "seed " << seed << " frame " << frame;
      touched += scenario.world().contacts().pairs.size();
    }
    EXPECT_GT(touched, 1000u);
  }
}

/// What is said of one update: every bit of it, in numbers that can be compared.
template <class T>
using Frame = std::vector<T>;

template <class T>
Frame<T> frame_of(const World<T>& world) {
  Frame<T> all;
  const auto add = [&](auto... numbers) { (all.push_back(static_cast<T>(numbers)), ...); };
  const ContactArrays<T>& c = world.contacts();
  for (const auto& p : c.pairs) add(p.a, p.b, p.overlap, p.first_manifold, p.manifold_count);
  for (const auto& m : c.manifolds) add(m.normal.x, m.normal.y, m.piece_a, m.piece_b, m.first_point, m.point_count);
  for (const auto& p : c.points)
    add(p.a.x, p.a.y, p.b.x, p.b.y, p.distance, p.feature >> 16, p.feature & 0xffff, p.impulse.x, p.impulse.y);
  for (const ContactEvent& e : world.events())
    add(static_cast<int>(e.kind), e.trigger, e.a.index, e.a.generation, e.b.index, e.b.generation);
  return all;
}

/// A scenario on an executor, or without one, whose points are pushed in every frame.
template <class T>
std::vector<Frame<T>> frames_on(Executor* executor, std::size_t& points) {
  Scenario<T> scenario(2, 1500, 18, executor);  // thousands of pairs: every stage goes to the threads
  std::vector<Frame<T>> frames;
  for (std::size_t frame = 0; frame < 6; ++frame) {
    scenario.step(frame % 2 == 0);
    for (SolverPoint<T>& p : scenario.world().contacts().points) p.impulse += p.a;
    frames.push_back(frame_of(scenario.world()));
  }
  points = scenario.world().contacts().points.size();
  EXPECT_GT(scenario.world().contacts().pairs.size(), 4096u);
  return frames;
}

TYPED_TEST(PlaneWorldOf, GivesTheSameBitsOnAnyNumberOfThreads) {
  std::size_t points = 0;
  const auto expected = frames_on<TypeParam>(nullptr, points);
  EXPECT_GT(points, 1000u);
  for (const std::size_t threads : {2, 3}) {
    ThreadExecutor executor(threads);
    EXPECT_EQ(frames_on<TypeParam>(&executor, points), expected) << threads << " threads";
  }
  for (const bool last_first : {false, true}) {
    BusyExecutor executor(last_first);
    EXPECT_EQ(frames_on<TypeParam>(&executor, points), expected) << last_first;
  }
}

/// Two bodies by their handles.
using Touching = std::set<std::pair<BodyId, BodyId>>;

TYPED_TEST(PlaneWorldOf, EventsBeginAndEndInTurns) {
  using T = TypeParam;
  Scenario<T> scenario(3, 150, 9);
  Touching open;
  std::map<EventKind, std::size_t> count;
  for (int frame = 0; frame < 60; ++frame) {
    scenario.step(frame % 4 != 0);
    const auto& c = scenario.world().contacts();
    Touching now;
    for (const ContactEvent& e : scenario.world().events()) {
      ++count[e.kind];
      EXPECT_LT(e.a.index, e.b.index);
      EXPECT_EQ(open.count({e.a, e.b}) != 0, e.kind != EventKind::begin);
      if (e.kind == EventKind::end) {
        EXPECT_EQ(e.pair, ContactEvent::no_pair);
        EXPECT_EQ(open.erase({e.a, e.b}), 1u);
        continue;
      }
      ASSERT_LT(e.pair, c.pairs.size());
      EXPECT_EQ(c.pairs[e.pair].a, e.a.index);
      EXPECT_EQ(c.pairs[e.pair].b, e.b.index);
      EXPECT_TRUE(now.insert({e.a, e.b}).second);
    }
    // Whatever was open went on or ended, and all that overlaps is open.
    for (const auto& pair : open) EXPECT_TRUE(now.count(pair) != 0);
    const BodyArrays<T>& bodies = scenario.world().bodies();
    for (const ContactPair<T>& p : c.pairs) EXPECT_TRUE(!p.overlap || now.count({bodies.id(p.a), bodies.id(p.b)}) != 0);
    open = now;
  }
  // All that began and did not end is open when all are removed: then all end.
  for (const BodyId id : scenario.ids()) scenario.world().remove(id);
  scenario.world().update();
  EXPECT_EQ(scenario.world().events().size(), open.size());
  for (const ContactEvent& e : scenario.world().events()) EXPECT_EQ(e.kind, EventKind::end);
  EXPECT_EQ(count[EventKind::begin], count[EventKind::end] + open.size());
  EXPECT_GT(count[EventKind::end], 50u);
}

/// Of a pair with more points than it may have those are left that `reduce` of its manifolds leaves.
TYPED_TEST(PlaneWorldOf, KeepsNoMorePointsThanAsked) {
  using T = TypeParam;
  for (const std::size_t most : {1u, 2u, 3u}) {
    WorldSettings<T> settings;
    settings.points_per_pair = most;
    Scenario<T> whole(5, 120, 7), fewer(5, 120, 7, nullptr, settings);
    std::size_t left_out = 0;
    for (int frame = 0; frame < 6; ++frame) {
      whole.step(true);
      fewer.step(true);
      ContactArrays<T> expected = whole.world().contacts();
      left_out += expected.points.size();
      reduce(expected, most);
      left_out -= expected.points.size();
      const ContactArrays<T>& found = fewer.world().contacts();
      ASSERT_EQ(found.pairs.size(), expected.pairs.size());
      for (std::size_t i = 0; i < found.pairs.size(); ++i) {
        std::vector<std::pair<Vec2<T>, Vec2<T>>> points[2];
        for (const ContactArrays<T>* arrays : {&std::as_const(expected), &found})
          for (const auto& m : arrays->manifolds_of(arrays->pairs[i]))
            for (const auto& p : arrays->points_of(m)) points[arrays == &found].push_back({p.a, p.b});
        EXPECT_LE(points[1].size(), most);
        EXPECT_EQ(points[0], points[1]);
      }
    }
    EXPECT_GT(left_out, 10u) << most;
  }
}

Body<double> unit_box(double y) { return {Box<double>({1, 1}), {{0, y}, {}}}; }

TEST(PlaneWorld, RestingIsOneTouchWhileTheDepthCrossesZero) {
  Worldd world;
  Body<double> ground{HalfPlane<double>()};
  ground.fixed = true;
  world.add(ground);
  const BodyId box = world.add(unit_box(0.5));
  std::vector<EventKind> kinds;
  for (const double y : {0.52, 0.499, 0.501, 0.4999, 0.505, 0.52, 0.49}) {
    world.move(box, {{0, y}, {}});
    world.update();
    for (const ContactEvent& e : world.events()) kinds.push_back(e.kind);
  }
  using enum EventKind;
  EXPECT_EQ(kinds, (std::vector{begin, stay, stay, stay, end, begin}));
}

TEST(PlaneWorld, PointsCarryTheirImpulsesWhileTheirFeaturesTouch) {
  Worldd world;
  world.add(unit_box(0));
  const BodyId upper = world.add(unit_box(0));
  const auto place = [&](double x, double y) {
    world.move(upper, {{x, y}, {}});
    world.update();
    return world.contacts().points.size();
  };
  ASSERT_EQ(place(0.2, 0.999), 2u);
  std::map<std::uint32_t, Vec2d> impulses;
  for (auto& p : world.contacts().points) impulses[p.feature] = p.impulse = p.a * 10.0 + Vec2d{0, 100};
  ASSERT_EQ(impulses.size(), 2u);
  ASSERT_EQ(place(0.21, 0.9985), 2u);
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, impulses.at(p.feature));
  ASSERT_EQ(place(0.21, 0.9985), 2u);  // nothing changed: all stays
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, impulses.at(p.feature));
  ASSERT_EQ(place(0.2, 3), 0u);
  ASSERT_EQ(place(0.2, 0.999), 2u);
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, Vec2d{});
}

/// A body at an index that another one had has none of its impulses.
TEST(PlaneWorld, ABodyDoesNotInheritTheImpulsesOfTheOneBefore) {
  Worldd world;
  Body<double> floor = unit_box(0);
  floor.fixed = true;
  world.add(floor);
  const BodyId crate = world.add(unit_box(0.99));
  world.update();
  for (auto& p : world.contacts().points) p.impulse = {0, 7};
  world.remove(crate);
  const BodyId next = world.add(unit_box(0.99));
  ASSERT_EQ(next.index, crate.index);
  world.update();
  ASSERT_EQ(world.contacts().points.size(), 2u);
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, Vec2d{});
}

TEST(PlaneWorld, LeavesItsArraysAsTheyAreWhereNothingChanged) {
  Worldd world;
  world.add({.shape = HalfPlane<double>(), .fixed = true});
  std::vector<BodyId> boxes;
  for (int i = 0; i < 5; ++i) boxes.push_back(world.add(unit_box(0.5 + 0.999 * i)));
  world.update();
  auto& contacts = world.contacts();
  ASSERT_EQ(contacts.pairs.size(), 5u);
  ASSERT_EQ(contacts.points.size(), 10u);
  for (auto& p : contacts.points) p.impulse = p.a;
  const auto* const where = contacts.points.data();
  for (int frame = 0; frame < 2; ++frame) {
    world.update();
    EXPECT_EQ(contacts.points.data(), where);
    for (const auto& p : contacts.points) EXPECT_EQ(p.impulse, p.a);
    ASSERT_EQ(world.events().size(), 5u);
    for (const ContactEvent& e : world.events()) EXPECT_EQ(e.kind, EventKind::stay);
  }
  // Two boxes that may not collide any more are another list of pairs, though nobody moved.
  world.set_filter(boxes[4], {.mask = 0});
  world.update();
  EXPECT_EQ(contacts.pairs.size(), 4u);
  EXPECT_EQ(contacts.points.size(), 8u);
  for (const auto& p : contacts.points) EXPECT_EQ(p.impulse, p.a);
  EXPECT_EQ(world.events().back().kind, EventKind::end);
}

TEST(PlaneWorld, HandlesAreRefusedAfterRemovalAndSoAreBadNumbers) {
  Worldd world;
  const BodyId first = world.add(unit_box(0));
  world.remove(first);
  EXPECT_THROW(world.remove(first), InvalidValue);
  const BodyId second = world.add(unit_box(0));
  EXPECT_EQ(second.index, first.index);
  EXPECT_FALSE(world.bodies().contains(first));
  EXPECT_THROW(world.move(first, {}), InvalidValue);
  EXPECT_THROW(world.set_shape(first, Circle<double>(1.0)), InvalidValue);
  EXPECT_THROW(world.set_filter(first, {}), InvalidValue);
  EXPECT_THROW(world.bodies().body(first), InvalidValue);
  EXPECT_THROW(world.move(second, {{std::nan(""), 0}, {}}), InvalidValue);
  EXPECT_THROW(world.move(second, {{}, {0, 0}}), InvalidValue);
  EXPECT_THROW(world.move(second, {{}, {HUGE_VAL, 0}}), InvalidValue);
  EXPECT_THROW(world.move(second, {{0, 1e60}, {}}), InvalidValue);
  EXPECT_THROW(world.move(second, {}, {0, HUGE_VAL}, 0), InvalidValue);
  EXPECT_THROW(world.move(second, {}, {}, std::nan("")), InvalidValue);
  EXPECT_THROW(world.update(-1), InvalidValue);
  WorldSettings<double> negative;
  negative.margin = -1.0;
  EXPECT_THROW(Worldd{negative}, InvalidValue);
  world.move(second, {{1, 2}, {3, 4}});  // a rotation is turned to unit length
  EXPECT_NEAR(world.bodies().body(second).pose.rotation.cosine, 0.6, 1e-15);
  world.update();
  EXPECT_EQ(world.bodies().count(), 1u);
}

TEST(PlaneWorld, TheCallerHasTheLastWord) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> asked;
  WorldSettings<double> settings;
  settings.allow = [&](BodyId a, BodyId b) {
    asked.emplace_back(a.index, b.index);
    return b.index != 2;
  };
  Worldd world(settings);
  for (int i = 0; i < 3; ++i) world.add(unit_box(0.1 * i));
  world.update();
  EXPECT_EQ(asked.size(), 3u);
  ASSERT_EQ(world.contacts().pairs.size(), 1u);
  EXPECT_EQ(world.contacts().pairs[0].b, 1u);
}

TEST(PlaneWorld, TriggersTellWithoutPoints) {
  Worldd world;
  Body<double> zone = unit_box(0);
  zone.trigger = zone.fixed = true;
  world.add(zone);
  world.add(unit_box(0.9));
  world.add(unit_box(1.001));  // within the margin only
  world.update();
  std::size_t in_zone = 0;
  for (const ContactEvent& e : world.events()) {
    EXPECT_EQ(e.trigger, e.a.index == 0);
    if (e.a.index != 0) continue;
    ++in_zone;
    EXPECT_EQ(e.b.index, 1u);
    EXPECT_EQ(world.contacts().pairs[e.pair].manifold_count, 0u);
  }
  EXPECT_EQ(in_zone, 1u);
}

TEST(PlaneWorld, AMarginOfItsOwn) {
  WorldSettings<double> settings;
  settings.margin = 0.5;
  Worldd world(settings);
  world.add(unit_box(0));
  world.add(unit_box(1.4));
  world.add(unit_box(2.95));  // 0.55 from the second
  world.update();
  ASSERT_EQ(world.contacts().pairs.size(), 1u);
  EXPECT_FALSE(world.contacts().pairs[0].overlap);
  EXPECT_TRUE(world.events().empty());
}

/// What slides along a chain has one normal, over all of its seams.
TEST(PlaneWorld, NothingCatchesOnTheSeamsOfAChain) {
  Worldd world;
  std::vector<Vec2d> points;
  for (int i = -10; i <= 10; ++i) points.push_back({static_cast<double>(i), 0});
  world.add({.shape = Chain<double>(points), .fixed = true});
  const BodyId box = world.add(unit_box(0));
  for (int i = 0; i < 2000; ++i) {
    world.move(box, {{-8 + i * 0.00801, 0.499}, {}});
    world.update();
    ASSERT_EQ(world.contacts().manifolds.size(), 1u);
    EXPECT_NEAR(std::abs(world.contacts().manifolds[0].normal.y), 1, 1e-12);
    EXPECT_EQ(world.contacts().points.size(), 2u);
  }
}

}  // namespace
}  // namespace graze::plane
