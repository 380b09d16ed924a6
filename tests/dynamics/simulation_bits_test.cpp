// The bits of simulations: the same on any threads, after `restore`, in another size; and their hash.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "common/executors.hpp"
#include "dynamics/simulated.hpp"
#include "graze/state_bytes.hpp"

namespace graze::testing {
namespace {

template <class T>
class SimulationBits : public ::testing::Test {};
using ScalarsOfBits = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SimulationBits, ScalarsOfBits);

TYPED_TEST(SimulationBits, SameOnAnyThreads) {
  using T = TypeParam;
  const auto run = [](Executor* executor) {
    Simulation<T> s(settings<T>(T(10), true), executor);
    add_heap(s, 5, 60);
    return poses_after(s, 100);
  };
  const auto serial = run(nullptr);
  ThreadExecutor threads(4);
  BusyExecutor busy(true);
  EXPECT_EQ(run(&threads), serial);
  EXPECT_EQ(run(&busy), serial);
}

TYPED_TEST(SimulationBits, SameAfterRestore) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  add_heap(s, 6, 40);
  poses_after(s, 60);
  const State<T> state = s.save();
  const auto once = poses_after(s, 60);
  s.restore(state);
  EXPECT_EQ(poses_after(s, 60), once);
  poses_after(s, 20);
  s.restore(state);
  EXPECT_EQ(poses_after(s, 60), once);
}

/// What had begun does not begin again: also where bodies that jump lightly are apart, but within their margin.
TYPED_TEST(SimulationBits, EventsGoOnAfterRestore) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_heap(s, 8, 40);
  Body<T> gate{Box<T>({T(3), T(3), T(3)}), {{T(0), T(2), T(0)}, {}}};
  gate.trigger = true;
  s.add(gate);
  const auto events_of = [&] {
    std::vector<std::array<std::uint32_t, 6>> told;
    for (int i = 0; i < 30; ++i) {
      s.step(T(dt));
      for (const ContactEvent& e : s.world().events())
        told.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(e.kind), e.trigger ? 1u : 0u,
                        e.a.index, e.b.index, e.pair});
    }
    return told;
  };
  for (int start = 0; start < 6; ++start) {
    poses_after(s, 20);
    const State<T> state = s.save();
    const auto once = events_of();
    s.restore(state);
    EXPECT_EQ(events_of(), once) << start;
    // Another simulation's bodies touched nothing yet.
    Simulation<T> twin(settings<T>());
    add_heap(twin, 8, 40);
    twin.add(gate);
    twin.restore(state);
    twin.step(T(dt));
    for (const ContactEvent& e : twin.world().events())
      if (e.kind == EventKind::begin) {
        const std::array<std::uint32_t, 6> key{0, 0, e.trigger ? 1u : 0u, e.a.index, e.b.index, e.pair};
        EXPECT_NE(std::find(once.begin(), once.end(), key), once.end()) << e.a.index << " " << e.b.index;
      }
  }
}

/// The contacts of a body that was removed since the last step end in the next one, also of a state that was saved
/// between the two, and of one that was saved right after going back to that.
TYPED_TEST(SimulationBits, WhatARemovedBodyTouchedEndsAfterRestore) {
  using T = TypeParam;
  Simulation<T> s(settings<T>());
  add_heap(s, 8, 20);
  poses_after(s, 100);
  ASSERT_FALSE(s.world().contacts().pairs.empty());
  const BodyId removed = s.world().bodies().id(s.world().contacts().pairs.front().b);
  const auto ends_of = [](Simulation<T>& of, BodyId body) {
    of.step(T(dt));
    const auto events = of.world().events();
    return std::count_if(events.begin(), events.end(), [&](const ContactEvent& e) {
      return e.kind == EventKind::end && (e.a == body || e.b == body);
    });
  };
  s.remove(removed);
  const BodyId another = s.add({Sphere<T>(T(0.5)), {{T(0), T(60), T(0)}, {}}});
  EXPECT_EQ(another.index, removed.index);
  const State<T> state = s.save();
  const auto once = ends_of(s, removed);
  EXPECT_GT(once, 0);
  EXPECT_EQ(ends_of(s, removed), 0);
  s.restore(state);
  for (const ContactEvent& e : s.world().events())
    EXPECT_TRUE(e.kind == EventKind::end || e.pair < s.world().contacts().pairs.size());
  const State<T> again = s.save();
  EXPECT_EQ(ends_of(s, removed), once);
  s.restore(read_state<T>(state_bytes(again)));
  EXPECT_EQ(ends_of(s, removed), once);
  EXPECT_EQ(ends_of(s, removed), 0);
}

/// A simulation of the same bodies and joints goes on from a state, though the one that saved it is gone.
TYPED_TEST(SimulationBits, SameInATwin) {
  using T = TypeParam;
  const auto build = [](Simulation<T>& s, T gap, T size, std::uint32_t to = 39) {
    add_heap(s, 6, 40, size);
    const BodyId top = s.world().bodies().id(40), next = s.world().bodies().id(to);
    s.add(distance_joint<T>(top, {{T(0), gap, T(0)}, {}}, next, {}, T(0), T(0)));
  };
  State<T> state;
  std::vector<Pose<T>> once;
  {
    Simulation<T> s(settings<T>(T(10), true));
    build(s, T(1), T(1));
    poses_after(s, 60);
    state = s.save();
    once = poses_after(s, 60);
  }
  Simulation<T> twin(settings<T>(T(10), true));
  build(twin, T(1), T(1));
  poses_after(twin, 7);
  twin.restore(state);
  EXPECT_EQ(poses_after(twin, 60), once);

  // The state has the frames and limits of joints, as they may be set while a simulation runs, but not their bodies.
  Simulation<T> joined_longer(settings<T>(T(10), true));
  build(joined_longer, T(1.5), T(1));
  joined_longer.restore(state);
  EXPECT_EQ(poses_after(joined_longer, 60), once);
  Simulation<T> joined_otherwise(settings<T>(T(10), true));
  build(joined_otherwise, T(1), T(1), 38);
  const std::uint64_t before = joined_otherwise.state_hash();
  EXPECT_THROW(joined_otherwise.restore(state), InvalidValue);
  EXPECT_EQ(joined_otherwise.state_hash(), before);
  Simulation<T> of_other_sizes(settings<T>(T(10), true));
  build(of_other_sizes, T(1), T(2));
  EXPECT_THROW(of_other_sizes.restore(state), InvalidValue);
}

/// The hash of a state is that of every run that is the same, and of no other.
TYPED_TEST(SimulationBits, StatesHaveHashes) {
  using T = TypeParam;
  const auto run = [](Executor* executor, T nudge) {
    Simulation<T> s(settings<T>(T(10), true), executor);
    add_heap(s, 7, 40);
    poses_after(s, 30);
    const BodyId last = s.world().bodies().id(40);
    s.set_velocity(last, {{nudge, T(0), T(0)}, {}});
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 5; ++i) {
      s.step(T(dt));
      hashes.push_back(s.state_hash());
    }
    return hashes;
  };
  const auto hashes = run(nullptr, T(0));
  ThreadExecutor threads(3);
  EXPECT_EQ(run(&threads, T(0)), hashes);
  const auto others = run(nullptr, std::numeric_limits<T>::epsilon());
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    EXPECT_NE(others[i], hashes[i]) << i;
    if (i > 0) {
      EXPECT_NE(hashes[i], hashes[i - 1]) << i;
    }
  }
  Simulation<T> s(settings<T>(T(10), true));
  add_heap(s, 7, 40);
  poses_after(s, 30);
  const State<T> state = s.save();
  const std::uint64_t before = s.state_hash();
  poses_after(s, 10);
  s.restore(state);
  EXPECT_EQ(s.state_hash(), before);
}

/// The hash changes with all that the next step depends on, though nothing moves yet.
TYPED_TEST(SimulationBits, HashesHoldAllThatTheNextStepDependsOn) {
  using T = TypeParam;
  Simulation<T> s(settings<T>(T(10), true));
  add_floor(s);
  const BodyId box = s.add({Box<T>({T(1), T(1), T(1)}), {{T(0), T(0.5), T(0)}, {}}});
  Dynamics<T> kinematic;
  kinematic.kinematic = true;
  const BodyId fan = s.add({Sphere<T>(T(1)), {{T(9), T(9), T(9)}, {}}}, kinematic);
  poses_after(s, 120);
  ASSERT_TRUE(s.asleep(box));
  std::uint64_t last = s.state_hash();
  poses_after(s, 1);
  EXPECT_EQ(s.state_hash(), last) << "nothing changed";
  const auto changes = [&](const char* what) {
    const std::uint64_t now = s.state_hash();
    EXPECT_NE(now, last) << what;
    last = now;
  };
  s.step(T(2 * dt));
  changes("a longer step");
  s.set_material(box, {T(0.25)});
  changes("friction");
  Material<T> belt{T(0.25)};
  belt.surface_velocity = {T(1), T(0), T(0)};
  s.set_material(box, belt);
  changes("a surface's velocity");
  s.set_gravity({T(0), T(-5), T(0)});
  changes("gravity");
  s.move_to(fan, {{T(9), T(9), T(9)}, normalized(Quat<T>{T(0), T(0.125), T(0), T(1)})}, T(dt));
  changes("a kinematic's spin");
  Simulation<T> still_asking(settings<T>(T(10), true)), never_asleep(settings<T>(T(10), false));
  EXPECT_NE(still_asking.state_hash(), never_asleep.state_hash());
}

TYPED_TEST(SimulationBits, SameInAnotherSize) {
  using T = TypeParam;
  const auto run = [](T scale, T step) {
    Simulation<T> s(settings<T>(T(10), true));
    add_heap(s, 7, 20, scale);
    auto poses = poses_after(s, 150, step);
    for (Pose<T>& p : poses) p.translation = p.translation / scale;
    return poses;
  };
  EXPECT_EQ(run(T(4), T(2 * dt)), run(T(1), T(dt)));
}

}  // namespace
}  // namespace graze::testing
