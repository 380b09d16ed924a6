// The world against asking every pair anew: whatever is remembered, on however many threads, changes no bit.
#include "graze/world.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "common/executors.hpp"
#include "graze/query.hpp"
#include "world/scenario.hpp"

namespace graze {
namespace {

using testing::BusyExecutor;
using testing::Random;
using testing::Scenario;
using testing::Snapshot;
using testing::ThreadExecutor;

template <class T>
class WorldOf : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WorldOf, Scalars);

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
      ASSERT_LT(pair, found.pairs.size());
      const ContactPair<T>& p = found.pairs[pair++];
      ASSERT_EQ(p.a, i);
      ASSERT_EQ(p.b, j);
      EXPECT_EQ(p.overlap, touch);
      const auto of_pair = found.manifolds_of(p);
      ASSERT_EQ(of_pair.size(), manifolds.size());
      for (std::size_t m = 0; m < manifolds.size(); ++m) {
        EXPECT_EQ(of_pair[m].normal, manifolds[m].normal);
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

TYPED_TEST(WorldOf, AnswersAsEveryPairAskedByItself) {
  Scenario<TypeParam> scenario(1, 60, nullptr, false);  // over fixed bodies side by side they move as over one
  std::size_t touched = 0;
  for (int frame = 0; frame < 25; ++frame) {
    scenario.step(frame % 3 != 0);
    expect_as_asked_one_by_one(scenario.world());
    if (this->HasFatalFailure()) FAIL() << "frame " << frame;
    touched += scenario.world().contacts().pairs.size();
  }
  EXPECT_GT(touched, 100u);
}

/// A scenario on an executor, or without one, whose points are pushed in every frame.
template <class T>
std::vector<Snapshot<T>> frames_on(Executor* executor) {
  Scenario<T> scenario(2, 520, executor);  // thousands of pairs: every stage goes to the threads
  std::vector<Snapshot<T>> frames;
  for (std::size_t frame = 0; frame < 6; ++frame) {
    scenario.step(frame % 2 == 0);
    for (SolverPoint<T>& p : scenario.world().contacts().points) p.impulse += p.a;
    frames.push_back(Snapshot<T>::of(scenario.world()));
  }
  return frames;
}

TYPED_TEST(WorldOf, GivesTheSameBitsOnAnyNumberOfThreads) {
  const auto expected = frames_on<TypeParam>(nullptr);
  EXPECT_GT(expected.back().points.size(), 100u);
  for (const std::size_t threads : {1, 2, 3, 8}) {
    ThreadExecutor executor(threads);
    EXPECT_EQ(frames_on<TypeParam>(&executor), expected) << threads << " threads";
  }
  for (const bool last_first : {false, true}) {
    BusyExecutor executor(last_first);
    EXPECT_EQ(frames_on<TypeParam>(&executor), expected) << last_first;
  }
}

/// Contacts of the same pairs, with the same bits and impulses, wherever they stand.
template <class T>
void expect_same_contacts(const ContactArrays<T>& one, const ContactArrays<T>& other) {
  ASSERT_EQ(one.pairs.size(), other.pairs.size());
  for (std::size_t i = 0; i < one.pairs.size(); ++i) {
    const ContactPair<T>&p = one.pairs[i], &q = other.pairs[i];
    ASSERT_TRUE(p.a == q.a && p.b == q.b && p.overlap == q.overlap && p.manifold_count == q.manifold_count);
    for (std::size_t k = 0; k < p.manifold_count; ++k) {
      const ContactManifold<T>&m = one.manifolds_of(p)[k], &n = other.manifolds_of(q)[k];
      ASSERT_TRUE(m.normal == n.normal && m.piece_a == n.piece_a && m.piece_b == n.piece_b);
      const auto of_m = one.points_of(m), of_n = other.points_of(n);
      ASSERT_TRUE(std::equal(of_m.begin(), of_m.end(), of_n.begin(), of_n.end(), [](const auto& a, const auto& b) {
        return a.a == b.a && a.b == b.b && a.distance == b.distance && a.feature == b.feature && a.impulse == b.impulse;
      }));
    }
  }
}

/// Few bodies move in one world; in the other all are said to have moved, so that nothing is kept.
template <class T>
void expect_as_found_anew(std::uint64_t seed) {
  Random random(seed);
  World<T> few, all;
  std::vector<BodyId> ids;
  for (int i = 0; i < 120; ++i) {
    const Body<T> body = testing::random_body<T>(random, 3);
    ids.push_back(few.add(body));
    all.add(body);
  }
  std::size_t in_place = 0;
  constexpr std::size_t frames = 80;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const auto* const before = few.contacts().points.data();
    const std::size_t moves = 1 + random() % 3;
    for (std::size_t i = 0; i < moves; ++i) {
      const BodyId id = ids[random() % ids.size()];
      Pose<T> pose = few.bodies().body(id).pose;
      // Mostly so little that what touches goes on to.
      pose.translation += converted<T>(testing::random_vector(random, frame % 8 == 0 ? 0.5f : 1e-4f));
      few.move(id, pose);
      all.move(id, pose);
      if (random() % 40 != 0) continue;
      const Shape<T> shape = testing::random_shape<T>(random);
      few.set_shape(id, shape);
      all.set_shape(id, shape);
    }
    for (const BodyId id : ids) {
      const Pose<T> pose = all.bodies().body(id).pose;
      all.move(id, {pose.translation + Vec3<T>{1, 0, 0}, pose.rotation});
      all.move(id, pose);
    }
    for (World<T>* world : {&few, &all}) {
      world->update();
      for (SolverPoint<T>& p : world->contacts().points) p.impulse += p.a;
    }
    SCOPED_TRACE("seed " + std::to_string(seed) + ", frame " + std::to_string(frame));
    expect_same_contacts(few.contacts(), all.contacts());
    if (::testing::Test::HasFatalFailure()) return;
    EXPECT_EQ(few.events().size(), all.events().size());
    in_place += few.contacts().points.data() == before ? 1 : 0;
  }
  EXPECT_GT(few.contacts().points.size(), 50u);
  EXPECT_GT(in_place, frames / 4) << "contacts were never put in the place of the last ones";
}

TYPED_TEST(WorldOf, FewChangesLeaveWhatFindingAllAnewDoes) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) expect_as_found_anew<TypeParam>(seed);
}

/// Two bodies by their handles.
using Touching = std::set<std::pair<BodyId, BodyId>>;

TYPED_TEST(WorldOf, EventsBeginAndEndInTurns) {
  using T = TypeParam;
  Scenario<T> scenario(3, 150);
  Touching open;
  std::map<EventKind, std::size_t> count;
  for (int frame = 0; frame < 60; ++frame) {
    scenario.step(frame % 4 != 0);
    const auto& c = scenario.world().contacts();
    Touching now;
    for (const ContactEvent& e : scenario.world().events()) {
      ++count[e.kind];
      EXPECT_LT(e.a.index, e.b.index);
      const bool known = open.count({e.a, e.b}) != 0;
      EXPECT_EQ(known, e.kind != EventKind::begin);
      if (e.kind == EventKind::end) {
        EXPECT_EQ(e.pair, ContactEvent::no_pair);
        EXPECT_EQ(open.erase({e.a, e.b}), 1u);
        continue;
      }
      EXPECT_TRUE(scenario.world().bodies().contains(e.a));
      EXPECT_TRUE(scenario.world().bodies().contains(e.b));
      ASSERT_LT(e.pair, c.pairs.size());
      EXPECT_EQ(c.pairs[e.pair].a, e.a.index);
      EXPECT_EQ(c.pairs[e.pair].b, e.b.index);
      EXPECT_TRUE(now.insert({e.a, e.b}).second);
    }
    // Whatever was open went on or ended, and all that overlaps is open.
    for (const auto& pair : open) EXPECT_TRUE(now.count(pair) != 0);
    for (const ContactPair<T>& p : c.pairs)
      EXPECT_TRUE(!p.overlap || now.count({scenario.world().bodies().id(p.a), scenario.world().bodies().id(p.b)}) != 0);
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

Body<double> unit_box(double y) { return {Shaped(Box<double>({1, 1, 1})), {{0, y, 0}, {}}}; }

TEST(World, RestingIsOneTouchWhileTheDepthCrossesZero) {
  Worldd world;
  Body<double> ground{Shaped(HalfSpace<double>())};
  ground.fixed = true;
  world.add(ground);
  const BodyId box = world.add(unit_box(0.5));
  std::vector<EventKind> kinds;
  for (const double y : {0.52, 0.499, 0.501, 0.4999, 0.505, 0.52, 0.49}) {
    world.move(box, {{0, y, 0}, {}});
    world.update();
    for (const ContactEvent& e : world.events()) kinds.push_back(e.kind);
  }
  using enum EventKind;
  EXPECT_EQ(kinds, (std::vector{begin, stay, stay, stay, end, begin}));
}

TEST(World, PointsCarryTheirImpulsesWhileTheirFeaturesTouch) {
  Worldd world;
  world.add(unit_box(0));
  const BodyId upper = world.add(unit_box(0));
  const auto place = [&](double x, double y) {
    world.move(upper, {{x, y, 0.1}, {}});
    world.update();
    return world.contacts().points.size();
  };
  ASSERT_EQ(place(0.2, 0.999), 4u);
  std::map<std::uint32_t, Vec3d> impulses;
  for (auto& p : world.contacts().points) impulses[p.feature] = p.impulse = p.a * 10.0 + Vec3d{0, 100, 0};
  ASSERT_EQ(impulses.size(), 4u);
  ASSERT_EQ(place(0.21, 0.9985), 4u);
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, impulses.at(p.feature));
  ASSERT_EQ(place(0.21, 0.9985), 4u);  // nothing changed: all stays
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, impulses.at(p.feature));
  ASSERT_EQ(place(0.2, 3), 0u);
  ASSERT_EQ(place(0.2, 0.999), 4u);
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, Vec3d{});
}

TEST(World, LeavesItsArraysAsTheyAreWhereNothingChanged) {
  Worldd world;
  world.add({.shape = HalfSpace<double>(), .fixed = true});
  std::vector<BodyId> boxes;
  for (int i = 0; i < 5; ++i) {
    boxes.push_back(world.add(unit_box(0)));
    world.move(boxes.back(), {{0, 0.5 + 0.999 * i, 0}, {}});
  }
  world.update();
  auto& contacts = world.contacts();
  ASSERT_EQ(contacts.pairs.size(), 5u);
  ASSERT_EQ(contacts.points.size(), 20u);
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
  EXPECT_EQ(contacts.points.size(), 16u);
  for (const auto& p : contacts.points) EXPECT_EQ(p.impulse, p.a);
  EXPECT_EQ(world.events().back().kind, EventKind::end);
}

TEST(World, HandlesAreRefusedAfterRemoval) {
  Worldd world;
  const BodyId first = world.add(unit_box(0));
  world.remove(first);
  EXPECT_THROW(world.remove(first), InvalidValue);
  const BodyId second = world.add(unit_box(0));
  EXPECT_EQ(second.index, first.index);
  EXPECT_FALSE(world.bodies().contains(first));
  EXPECT_TRUE(world.bodies().contains(second));
  EXPECT_THROW(world.move(first, {}), InvalidValue);
  EXPECT_THROW(world.set_shape(first, Shaped(Sphere<double>(1.0))), InvalidValue);
  EXPECT_THROW(world.set_filter(first, {}), InvalidValue);
  EXPECT_THROW(world.bodies().body(first), InvalidValue);
  EXPECT_THROW(world.move(BodyId{}, {}), InvalidValue);
  EXPECT_THROW(world.move(second, {{std::nan(""), 0, 0}, {}}), InvalidValue);
  EXPECT_THROW(world.move(second, {{}, {0, 0, 0, 0}}), InvalidValue);
  EXPECT_THROW(world.move(second, {{1e60, 0, 0}, {}}), InvalidValue);
  EXPECT_THROW(world.move(second, {}, {0, HUGE_VAL, 0}, {}), InvalidValue);
  world.update();
  EXPECT_EQ(world.bodies().count(), 1u);
}

TEST(World, TheCallerHasTheLastWord) {
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

TEST(World, TriggersTellWithoutPoints) {
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
    if (e.a.index == 0) {
      ++in_zone;
      EXPECT_EQ(e.b.index, 1u);
      EXPECT_EQ(world.contacts().pairs[e.pair].manifold_count, 0u);
    }
  }
  EXPECT_EQ(in_zone, 1u);
}

TEST(World, AMarginOfItsOwn) {
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

/// The seam of two floors side by side is not felt: of boxes, of triangles, and of a box beside triangles.
TEST(World, NothingCatchesOnTheSeamOfFixedBodies) {
  const auto sheet = [](double from, double to) -> Shaped {
    const std::vector<Vec3d> points{{from, 0, -3}, {to, 0, -3}, {to, 0, 3}, {from, 0, 3}};
    return Mesh<double>(points, {{0, 2, 1}, {0, 3, 2}});
  };
  const Shaped slab(Box<double>({3, 1, 6}));
  const Placed<double> floors[][2] = {{{slab, {{-1.5, -0.5, 0}, {}}}, {slab, {{1.5, -0.5, 0}, {}}}},
                                      {{sheet(-3, 0), {}}, {sheet(0, 3), {}}},
                                      {{slab, {{-1.5, -0.5, 0}, {}}}, {sheet(0, 3), {}}}};
  Random random(5);
  for (const auto& floor : floors) {
    Worldd world;
    for (const Placed<double>& part : floor) {
      Body<double> body{part.shape, part.pose};
      body.fixed = true;
      world.add(body);
    }
    for (const Shaped& slider : {Shaped(Box<double>({1, 0.5, 1.5})), Shaped(Sphere<double>(0.25))}) {
      const BodyId id = world.add({slider});
      for (int i = 0; i < 300; ++i) {
        const auto yaw = static_cast<double>(testing::uniform(random, -3, 3));
        const auto depth = static_cast<double>(testing::uniform(random, 0.0005f, 0.02f));
        const double near = i % 2 == 0 ? 0.6 : 0.01;
        const auto x = static_cast<double>(testing::uniform(random, -1, 1)) * near + (i % 4 < 2 ? 0.0 : 0.5);
        world.move(id, {{x, 0.25 - depth, 0.3}, Quatd::from_axis_angle({0, 1, 0}, yaw)});
        world.update();
        ASSERT_FALSE(world.contacts().points.empty());
        for (const auto& m : world.contacts().manifolds)
          ASSERT_NEAR(std::abs(m.normal.y), 1, 1e-9) << slider.name() << " on " << floor[0].shape.name() << " at " << x
                                                     << " yaw " << yaw << " depth " << depth;
      }
      world.remove(id);
    }
  }
}

/// Of a body over the seam of two others what it has with one of them depends on the other, which may go, or be left
/// out.
TEST(World, WhatStandsOnTheGroundFeelsItChange) {
  const auto boxes = [](Worldd& world, bool both) {
    for (const double x : {-0.5, 0.5}) {
      if (x > 0 && !both) continue;
      world.add({.shape = Shaped(Box<double>({1, 1, 1})), .pose = {{x, -0.5, 0}, {}}, .fixed = true});
    }
  };
  // A cylinder over the seam, its rim a little below: the edge of the first alone would push it aside.
  const Body<double> log{.shape = Shaped(Cylinder<double>(0.3, 0.6)),
                         .pose = {{0.2, 0.25, 0}, Quatd::from_axis_angle({0, 0, 1}, 1.2)}};
  Worldd alone;
  boxes(alone, false);
  alone.add(log);
  alone.update();
  ASSERT_FALSE(alone.contacts().points.empty());
  EXPECT_LT(std::abs(alone.contacts().manifolds[0].normal.y), 0.999);
  for (const bool by_filter : {false, true}) {
    Worldd world;
    boxes(world, true);
    world.add(log);
    world.update();
    for (const auto& m : world.contacts().manifolds) EXPECT_NEAR(std::abs(m.normal.y), 1, 1e-9);
    const BodyId second = world.bodies().id(1);
    if (by_filter)
      world.set_filter(second, Filter{.category = 0, .mask = 0});
    else
      world.remove(second);
    world.update();
    ASSERT_EQ(world.contacts().points.size(), alone.contacts().points.size()) << by_filter;
    for (std::size_t i = 0; i < alone.contacts().points.size(); ++i)
      EXPECT_EQ(world.contacts().points[i].a, alone.contacts().points[i].a) << by_filter;
    for (std::size_t i = 0; i < alone.contacts().manifolds.size(); ++i)
      EXPECT_EQ(world.contacts().manifolds[i].normal, alone.contacts().manifolds[i].normal) << by_filter;
  }
}

TEST(World, ABodyDoesNotInheritTheImpulsesOfTheOneBefore) {
  Worldd world;
  world.add({.shape = Shaped(Box<double>({1, 1, 1})), .fixed = true});
  const Body<double> crate{.shape = Shaped(Box<double>({1, 1, 1})), .pose = {{0, 0.99, 0}, {}}};
  const BodyId first = world.add(crate);
  world.update();
  for (auto& p : world.contacts().points) p.impulse = {1, 2, 3};
  world.move(first, {{0, 0.985, 0}, {}});
  world.update();
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, (Vec3d{1, 2, 3}));
  world.remove(first);
  EXPECT_EQ(world.add(crate).index, first.index);
  world.update();
  ASSERT_FALSE(world.contacts().points.empty());
  for (const auto& p : world.contacts().points) EXPECT_EQ(p.impulse, Vec3d{});
}

/// A fixed body goes, and one that moves comes in its place: what was told of the seam between the two is forgotten.
TYPED_TEST(WorldOf, AnIndexThatWasFixedMayBeReused) {
  using T = TypeParam;
  const auto slab = [](T x) {
    Body<T> body{Box<T>({T(2), T(2), T(2)}), {{x, T(-1), T(0)}, {}}};
    body.fixed = true;
    return body;
  };
  const Body<T> box{Box<T>({T(0.6), T(0.6), T(0.6)}), {{T(-0.2), T(0.1), T(0)}, {}}};
  const Body<T> other{Box<T>({T(0.2), T(0.2), T(0.2)}), {{T(-0.55), T(0.1), T(0)}, {}}};
  World<T> kept, fresh;
  const BodyId left = kept.add(slab(T(-1)));
  kept.add(slab(T(1)));
  kept.add(box);
  kept.update();
  kept.remove(left);
  ASSERT_EQ(kept.add(other).index, left.index);
  kept.update();
  fresh.add(other);
  fresh.add(slab(T(1)));
  fresh.add(box);
  fresh.update();
  ASSERT_EQ(kept.contacts().manifolds.size(), fresh.contacts().manifolds.size());
  for (std::size_t i = 0; i < fresh.contacts().manifolds.size(); ++i)
    EXPECT_EQ(kept.contacts().manifolds[i].normal, fresh.contacts().manifolds[i].normal) << i;
}

/// Ground that is a half-space and a block leaves the margin to what stands on it, as a half-space alone does.
TYPED_TEST(WorldOf, AGroundWithoutBoundsHasNoMarginOfItsOwn) {
  using T = TypeParam;
  const Shape<T> ground = Compound<T>({{HalfSpace<T>(), {}}, {Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}}});
  World<T> world;
  Body<T> fixed{ground, {}};
  fixed.fixed = true;
  world.add(fixed);
  world.add({Box<T>({T(1), T(1), T(1)}), {{T(3), T(0.503), T(0)}, {}}});
  world.update();
  EXPECT_EQ(world.contacts().pairs.size(), 1u);
}

}  // namespace
}  // namespace graze
