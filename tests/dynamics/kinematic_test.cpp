// Kinematic bodies, which push and are not pushed: what they are pairs of.
#include <gtest/gtest.h>

#include <limits>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"

namespace graze::testing {
namespace {

template <class Space>
struct KinematicScene;
template <class T>
struct KinematicScene<Space<T>> {
  static Shape<T> block() { return Box<T>({T(2), T(2), T(2)}); }
};
template <class T>
struct KinematicScene<plane::Space<T>> {
  static plane::Shape<T> block() { return plane::Box<T>({T(2), T(2)}); }
};

template <class Space>
class Kinematic : public ::testing::Test {};
using SpacesOfKinematic = ::testing::Types<Space<float>, Space<double>, plane::Space<float>, plane::Space<double>>;
TYPED_TEST_SUITE(Kinematic, SpacesOfKinematic);

template <class Space>
struct Blocks {
  using T = decltype(typename Space::Vec{}.x);
  using Dynamics = typename Rigid<Space>::Dynamics;

  /// Adds a block at a place on the axis of x; one that is `kinematic` keeps its speed.
  BodyId add(T x, bool fixed, const Dynamics& dynamics = {}, T speed = T(0), bool trigger = false) {
    Body<T, Space> body{KinematicScene<Space>::block()};
    body.pose.translation.x = x;
    body.linear.x = speed;
    body.fixed = fixed;
    body.trigger = trigger;
    return simulation.add(body, dynamics);
  }
  static Dynamics kinematic() {
    Dynamics d;
    d.kinematic = true;
    return d;
  }
  void step() { simulation.step(T(1) / T(64)); }

  Simulation<T, Space> simulation{weightless()};

 private:
  static SimulationSettings<T, Space> weightless() {
    SimulationSettings<T, Space> settings;
    settings.gravity = {};
    return settings;
  }
};

/// Of two bodies that nothing pushes a contact is of no use: the world has none, and no depth is reported.
TYPED_TEST(Kinematic, NoPairOfBodiesThatNothingPushes) {
  using B = Blocks<TypeParam>;
  using T = typename B::T;
  B b;
  b.add(T(0), true);
  const BodyId lift = b.add(T(0.5), false, B::kinematic(), T(1));
  b.add(T(1), false, B::kinematic());
  auto endless = typename B::Dynamics{};
  endless.mass = std::numeric_limits<T>::infinity();
  b.add(T(-0.5), false, endless);
  for (int i = 0; i < 64; ++i) {
    b.step();
    EXPECT_TRUE(b.simulation.world().contacts().pairs.empty());
    EXPECT_TRUE(b.simulation.world().events().empty());
    EXPECT_EQ(b.simulation.report().deepest, T(0));
  }
  EXPECT_NEAR(b.simulation.poses()[lift.index].translation.x, T(1.5), T(1e-5));
}

/// What has a mass meets all of them, and goes on doing so when the others come and go.
TYPED_TEST(Kinematic, PushWhatHasAMass) {
  using B = Blocks<TypeParam>;
  using T = typename B::T;
  B b;
  const BodyId wall = b.add(T(0), true), lift = b.add(T(1), false, B::kinematic()), crate = b.add(T(2.5), false);
  const auto meets = [&](BodyId other) {
    for (const ContactPair<T>& pair : b.simulation.world().contacts().pairs)
      if (pair.a == other.index || pair.b == other.index) return true;
    return false;
  };
  b.step();
  EXPECT_TRUE(meets(crate) && meets(lift));
  EXPECT_FALSE(meets(wall));
  b.simulation.remove(lift);
  b.simulation.set_pose(crate, [] {
    typename TypeParam::Pose at{};
    at.translation.x = T(1.5);
    return at;
  }());
  b.step();
  EXPECT_TRUE(meets(crate) && meets(wall));
}

/// Triggers tell what is in them, whoever moves.
TYPED_TEST(Kinematic, TriggersSeeThem) {
  using B = Blocks<TypeParam>;
  using T = typename B::T;
  B b;
  const BodyId gate = b.add(T(0), true, {}, T(0), true), lift = b.add(T(-4), false, B::kinematic(), T(4));
  b.add(T(0), true);
  int begun = 0, ended = 0;
  for (int i = 0; i < 2 * 64 + 8; ++i) {
    b.step();
    for (const ContactEvent& event : b.simulation.world().events()) {
      EXPECT_TRUE(event.trigger && event.a == gate && event.b == lift);
      begun += event.kind == EventKind::begin;
      ended += event.kind == EventKind::end;
    }
  }
  EXPECT_EQ(begun, 1);
  EXPECT_EQ(ended, 1);
}

/// A fast one passes through what nothing pushes either, without a cast: nothing is held back.
TYPED_TEST(Kinematic, FastOnesPassThroughWhatIsFixed) {
  using B = Blocks<TypeParam>;
  using T = typename B::T;
  B b;
  b.add(T(0), true);
  const BodyId fast = b.add(T(-4), false, B::kinematic(), T(512));
  b.step();
  EXPECT_NEAR(b.simulation.poses()[fast.index].translation.x, T(4), T(1e-4));
  EXPECT_TRUE(b.simulation.world().impacts().empty());
}

}  // namespace
}  // namespace graze::testing
