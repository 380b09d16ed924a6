// Events against what touched in each of two updates, by hand and by a set of pairs.
#include "graze/world/events.hpp"

#include <gtest/gtest.h>

#include <map>

#include "common/specimen.hpp"

namespace graze {
namespace {

struct Event {
  EventKind kind;
  bool trigger;
  BodyId a, b;
  std::uint32_t pair;

  friend bool operator==(const Event&, const Event&) = default;
};

std::vector<Event> events_of(const EventTracker& tracker) {
  std::vector<Event> events;
  for (const ContactEvent& e : tracker.events()) events.push_back({e.kind, e.trigger, e.a, e.b, e.pair});
  return events;
}

struct Row {
  BodyArrays<double> bodies;
  EventTracker tracker;

  explicit Row(std::size_t count, std::size_t triggers_from = ~std::size_t{0}) {
    for (std::size_t i = 0; i < count; ++i) add(i >= triggers_from);
  }
  BodyId add(bool trigger = false) { return bodies.add({.shape = Sphere<double>(1.0), .trigger = trigger}); }
  std::vector<Event> update(const std::vector<ContactPair<double>>& pairs) {
    tracker.update<double>(bodies, pairs);
    return events_of(tracker);
  }
};

TEST(Events, BeginStayAndEnd) {
  Row world(4, 3);
  EXPECT_EQ(
      world.update({{0, 1, true, 0, 0}, {1, 3, true, 0, 0}}),
      (std::vector<Event>{{EventKind::begin, false, {0, 0}, {1, 0}, 0}, {EventKind::begin, true, {1, 0}, {3, 0}, 1}}));
  // Within the margin only: those that touched stay, others have not begun.
  EXPECT_EQ(
      world.update({{0, 1, false, 0, 0}, {0, 2, false, 0, 0}, {1, 3, true, 0, 0}}),
      (std::vector<Event>{{EventKind::stay, false, {0, 0}, {1, 0}, 0}, {EventKind::stay, true, {1, 0}, {3, 0}, 2}}));
  EXPECT_EQ(world.update({{0, 2, true, 0, 0}}),
            (std::vector<Event>{{EventKind::end, false, {0, 0}, {1, 0}, ContactEvent::no_pair},
                                {EventKind::begin, false, {0, 0}, {2, 0}, 0},
                                {EventKind::end, true, {1, 0}, {3, 0}, ContactEvent::no_pair}}));
  // What ended is not told twice.
  EXPECT_EQ(world.update({{0, 2, true, 0, 0}}), (std::vector<Event>{{EventKind::stay, false, {0, 0}, {2, 0}, 0}}));
}

TEST(Events, AnotherBodyAtTheSameIndexEndsAndBegins) {
  Row world(2);
  world.update({{0, 1, true, 0, 0}});
  world.bodies.remove({1, 0});
  ASSERT_EQ(world.add().generation, 1u);
  EXPECT_EQ(world.update({{0, 1, true, 0, 0}}),
            (std::vector<Event>{{EventKind::end, false, {0, 0}, {1, 0}, ContactEvent::no_pair},
                                {EventKind::begin, false, {0, 0}, {1, 1}, 0}}));
}

/// Pairs that touch, are near or are gone at random, against what is said of each pair by itself.
TEST(Events, OfManyPairsAreThoseOfEachPair) {
  testing::Random random(5);
  Row world(30, 25);
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> touching;
  for (int frame = 0; frame < 50; ++frame) {
    std::vector<ContactPair<double>> pairs;
    std::vector<Event> expected;
    for (std::uint32_t a = 0; a < 30; ++a)
      for (std::uint32_t b = a + 1; b < 30; ++b) {
        const std::size_t dice = random() % 4;
        bool& touches = touching[{a, b}];
        const bool touched = touches;
        if (dice < 2) pairs.push_back({a, b, dice == 0, 0, 0});
        touches = dice == 0 || (dice == 1 && touched);
        const auto place = static_cast<std::uint32_t>(pairs.size() - 1);
        if (touches)
          expected.push_back({touched ? EventKind::stay : EventKind::begin, b >= 25, {a, 0}, {b, 0}, place});
        else if (touched)
          expected.push_back({EventKind::end, b >= 25, {a, 0}, {b, 0}, ContactEvent::no_pair});
      }
    ASSERT_EQ(world.update(pairs), expected) << frame;
  }
}

}  // namespace
}  // namespace graze
