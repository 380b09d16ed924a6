// Bad input of simulations, in space and in the plane: it is refused, what is wrong is named, and nothing changes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "graze/plane/simulation.hpp"
#include "graze/simulation.hpp"

namespace graze::testing {
namespace {

template <class SpaceT>
struct BadInputIn;

template <class Number>
struct BadInputIn<Space<Number>> {
  using T = Number;
  using Ball = Sphere<T>;
  using Ground = HalfSpace<T>;
  static constexpr Vec3<T> zero{};
  static constexpr Quat<T> no_rotation{T(0), T(0), T(0), T(0)};
  static Vec3<T> vector(T x) { return {x, T(0), T(0)}; }
  static Vec3<T> turning(T x) { return {T(0), T(0), x}; }
  static void set_inertia(Dynamics<T>& d, T inertia) { d.inertia_diagonal = Vec3<T>{inertia, inertia, inertia}; }
};

template <class Number>
struct BadInputIn<plane::Space<Number>> {
  using T = Number;
  using Ball = plane::Circle<T>;
  using Ground = plane::HalfPlane<T>;
  static constexpr plane::Vec2<T> zero{};
  static constexpr plane::Rot2<T> no_rotation{T(0), T(0)};
  static plane::Vec2<T> vector(T x) { return {x, T(0)}; }
  static T turning(T x) { return x; }
  static void set_inertia(plane::Dynamics<T>& d, T inertia) { d.inertia = inertia; }
};

/// A ball on the ground and one beside it, joined to the first.
template <class SpaceT>
class BadInput : public ::testing::Test {
 protected:
  using In = BadInputIn<SpaceT>;
  using T = typename In::T;
  using Dynamics = typename Rigid<SpaceT>::Dynamics;
  using Material = graze::Material<T, typename SpaceT::Vec>;
  using Pose = typename SpaceT::Pose;
  static constexpr T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
  static constexpr T step = T(1) / T(64);

  BadInput() {
    Body<T, SpaceT> ground{typename In::Ground()};
    ground.fixed = true;
    simulation.add(ground);
    first = add_ball(T(0));
    second = add_ball(T(3));
    between = simulation.add(joint());
    for (int i = 0; i < 8; ++i) simulation.step(step);
  }

  BodyId add_ball(T x, const Dynamics& dynamics = {}) {
    Body<T, SpaceT> ball{typename In::Ball(T(1))};
    ball.pose.translation = In::vector(x);
    ball.pose.translation.y = T(1);
    return simulation.add(ball, dynamics);
  }
  /// A rope that is not taut.
  Joint<T, SpaceT> joint() const { return distance_joint(first, Pose{}, second, Pose{}, T(0), T(9)); }

  /// What throws names `path` and leaves all bits, bodies and joints.
  template <class Call>
  void refuses(const std::string& path, const Call& call) {
    const std::uint64_t before = simulation.state_hash();
    const std::size_t bodies = simulation.world().bodies().count(), joints = simulation.joints().size();
    try {
      call();
      ADD_FAILURE() << "taken: " << path;
    } catch (const InvalidValue& e) {
      EXPECT_TRUE(e.path().starts_with(path)) << e.what();
    }
    EXPECT_EQ(simulation.state_hash(), before) << path;
    EXPECT_EQ(simulation.world().bodies().count(), bodies) << path;
    EXPECT_EQ(simulation.joints().size(), joints) << path;
  }

  Simulation<T, SpaceT> simulation;
  BodyId first, second;
  JointId between;
};
using SpacesOfBadInput = ::testing::Types<Space<float>, Space<double>, plane::Space<float>, plane::Space<double>>;
TYPED_TEST_SUITE(BadInput, SpacesOfBadInput);

TYPED_TEST(BadInput, Steps) {
  using T = typename TestFixture::T;
  for (const T dt : {T(0), T(-1), this->nan, T(3.2e7), this->infinity})
    this->refuses("dt", [&] { this->simulation.step(dt); });
}

TYPED_TEST(BadInput, MassesAndInertias) {
  using T = typename TestFixture::T;
  using Dynamics = typename TestFixture::Dynamics;
  const auto refused = [&](const std::string& path, const auto& change) {
    Dynamics d;
    change(d);
    this->refuses(path, [&] { this->add_ball(T(20), d); });
  };
  for (const T bad : {T(0), T(-1), this->nan}) {
    refused("mass", [&](Dynamics& d) { d.mass = bad; });
    refused("density", [&](Dynamics& d) { d.density = bad; });
    refused("inertia", [&](Dynamics& d) { TestFixture::In::set_inertia(d, bad); });
  }
  for (const T bad : {this->nan, this->infinity}) {
    refused("center_of_mass", [&](Dynamics& d) { d.center_of_mass = TestFixture::In::vector(bad); });
    refused("gravity_factor", [&](Dynamics& d) { d.gravity_factor = bad; });
    refused("linear_damping", [&](Dynamics& d) { d.linear_damping = bad; });
    refused("angular_damping", [&](Dynamics& d) { d.angular_damping = bad; });
  }
  refused("linear_damping", [](Dynamics& d) { d.linear_damping = T(-1); });
  refused("angular_damping", [](Dynamics& d) { d.angular_damping = T(-1); });
  if constexpr (requires(Dynamics d) { d.inertia_diagonal; }) {
    refused("inertia_diagonal[2]", [](Dynamics& d) { d.inertia_diagonal = Vec3<T>{T(1), T(1), T(3)}; });
    refused("inertia_orientation", [](Dynamics& d) { d.inertia_orientation = {T(0), T(0), T(0), T(0)}; });
  }
  this->refuses("shape", [&] { this->simulation.add({typename TestFixture::In::Ground()}); });
}

/// A mass that its shape and density make too large for a number is not taken for an infinite one.
TYPED_TEST(BadInput, MassesBeyondTheNumbers) {
  using T = typename TestFixture::T;
  typename TestFixture::Dynamics d;
  d.density = std::numeric_limits<T>::max();
  this->refuses("mass of the shape", [&] { this->add_ball(T(20), d); });
  d.density = std::numeric_limits<T>::max() / T(1024);
  Body<T, TypeParam> ball{typename TestFixture::In::Ball(T(100))};
  d.mass = std::numeric_limits<T>::max() / T(1024);
  this->refuses("inertia of the shape", [&] { this->simulation.add(ball, d); });
}

TYPED_TEST(BadInput, Materials) {
  using T = typename TestFixture::T;
  using Material = typename TestFixture::Material;
  const auto refused = [&](const std::string& path, const auto& change) {
    Material m;
    change(m);
    this->refuses(path, [&] { this->simulation.add({typename TestFixture::In::Ball(T(1))}, {}, m); });
    this->refuses(path, [&] { this->simulation.set_material(this->first, m); });
  };
  for (const T bad : {T(-1), this->nan, this->infinity}) {
    refused("static_friction", [&](Material& m) { m.static_friction = bad; });
    refused("dynamic_friction", [&](Material& m) { m.dynamic_friction = bad; });
    refused("rolling_friction", [&](Material& m) { m.rolling_friction = bad; });
    refused("restitution", [&](Material& m) { m.restitution = bad; });
  }
  refused("restitution", [](Material& m) { m.restitution = T(2); });
  refused("friction_combine", [](Material& m) { m.friction_combine = static_cast<Combine>(9); });
  refused("restitution_combine", [](Material& m) { m.restitution_combine = static_cast<Combine>(9); });
  refused("surface_velocity", [&](Material& m) { m.surface_velocity = TestFixture::In::vector(this->nan); });
}

TYPED_TEST(BadInput, VelocitiesPosesAndForces) {
  using T = typename TestFixture::T;
  using In = typename TestFixture::In;
  auto& s = this->simulation;
  const BodyId id = this->first;
  for (const T bad : {this->nan, this->infinity}) {
    this->refuses("linear", [&] { s.add({typename In::Ball(T(1)), {}, In::vector(bad)}); });
    this->refuses("angular", [&] { s.add({typename In::Ball(T(1)), {}, {}, In::turning(bad)}); });
    this->refuses("linear", [&] { s.set_velocity(id, {In::vector(bad), {}}); });
    this->refuses("angular", [&] { s.set_velocity(id, {{}, In::turning(bad)}); });
    this->refuses("impulse", [&] { s.apply_impulse(id, In::vector(bad), In::zero); });
    this->refuses("point", [&] { s.apply_impulse(id, In::zero, In::vector(bad)); });
    this->refuses("impulse", [&] { s.apply_angular_impulse(id, In::turning(bad)); });
    this->refuses("force", [&] { s.apply_force(id, In::vector(bad)); });
    this->refuses("torque", [&] { s.apply_torque(id, In::turning(bad)); });
    this->refuses("", [&] { s.set_pose(id, {In::vector(bad), {}}); });
    this->refuses("", [&] { s.move_to(id, {In::vector(bad), {}}, this->step); });
    this->refuses("gravity", [&] { s.set_gravity(In::vector(bad)); });
  }
  this->refuses("", [&] { s.set_pose(id, {In::zero, In::no_rotation}); });
  this->refuses("", [&] { s.move_to(id, {In::zero, In::no_rotation}, this->step); });
  for (const T dt : {T(0), T(-1), this->nan, this->infinity}) this->refuses("dt", [&] { s.move_to(id, {}, dt); });
  this->refuses("body", [&] { s.move_to(id, {}, this->step); });
}

/// A bound that is no number beside one that bounds nothing is no bound left out.
TYPED_TEST(BadInput, BoundsOfSlidersThatAreNoNumbers) {
  using T = typename TestFixture::T;
  const auto slider = [&](T min, T max) {
    return slider_joint(this->first, typename TestFixture::Pose{}, this->second, typename TestFixture::Pose{}, min,
                        max);
  };
  this->refuses("joint.limits[2].min", [&] { this->simulation.add(slider(this->nan, this->infinity)); });
  this->refuses("joint.limits[2].max", [&] { this->simulation.add(slider(-this->infinity, this->nan)); });
  this->refuses("joint.limits[2].min", [&] { this->simulation.add(slider(this->nan, this->nan)); });
}

TYPED_TEST(BadInput, WhatIsGone) {
  using In = typename TestFixture::In;
  auto& s = this->simulation;
  const BodyId gone = this->second;
  const auto state = s.save();
  auto joint = this->joint();
  s.remove(gone);
  EXPECT_TRUE(s.joints().empty());  // it went with the body
  this->refuses("joint", [&] { s.remove(this->between); });
  this->refuses("joint", [&] { s.joint(this->between); });
  this->refuses("joint", [&] { s.joint_impulses(this->between); });
  this->refuses("body", [&] { s.add(joint); });
  std::swap(joint.a, joint.b);
  this->refuses("body", [&] { s.add(joint); });
  joint.a = joint.b = this->first;
  this->refuses("b", [&] { s.add(joint); });
  this->refuses("state", [&] { s.restore(state); });
  this->refuses("state", [&] { s.restore({}); });
  // The place of the body has another, which the old handle does not reach.
  EXPECT_EQ(this->add_ball(20).index, gone.index);
  for (const BodyId id : {gone, BodyId{}}) {
    this->refuses("body", [&] { s.remove(id); });
    this->refuses("body", [&] { s.motion(id); });
    this->refuses("body", [&] { s.mass(id); });
    this->refuses("body", [&] { s.asleep(id); });
    this->refuses("body", [&] { s.sub_steps(id); });
    this->refuses("body", [&] { s.wake(id); });
    this->refuses("body", [&] { s.set_pose(id, {}); });
    this->refuses("body", [&] { s.set_velocity(id, {}); });
    this->refuses("body", [&] { s.apply_force(id, In::zero); });
    this->refuses("body", [&] { s.apply_impulse(id, In::zero, In::zero); });
    this->refuses("body", [&] { s.set_material(id, {}); });
    this->refuses("body", [&] { s.set_materials(id, {}, {}); });
  }
  // One wording, whatever is missing: its handle is named.
  const auto words = [&](const auto& call) {
    try {
      call();
    } catch (const InvalidValue& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string handle = std::to_string(gone.index) + " of generation " + std::to_string(gone.generation);
  EXPECT_EQ(words([&] { s.wake(gone); }),
            "body: expected a body of the simulation, got " + handle + ", which is not there");
  World<typename TestFixture::T, TypeParam> world;
  EXPECT_EQ(words([&] { world.remove(gone); }),
            "body: expected a body of the world, got " + handle + ", which is not there");
  EXPECT_EQ(words([&] {
              s.remove(JointId{7, 2});
            }),
            "joint: expected a joint of the simulation, got 7 of generation 2, which is not there");
}

TYPED_TEST(BadInput, Settings) {
  using T = typename TestFixture::T;
  const auto refused = [&](const std::string& path, const auto& change) {
    SimulationSettings<T, TypeParam> settings;
    change(settings);
    this->refuses(path, [&] { Simulation<T, TypeParam>{settings}; });
  };
  for (const int bad : {-1, 0, 3, 2048}) {
    refused("sub_steps", [&](auto& s) { s.sub_steps = bad; });
    refused("most_sub_steps", [&](auto& s) { s.most_sub_steps = bad; });
  }
  refused("most_sub_steps", [](auto& s) { s.most_sub_steps = 2; });
  for (const T bad : {T(0), T(-1), this->nan, this->infinity})
    refused("longest_step", [&](auto& s) { s.longest_step = bad; });
  refused("gravity", [&](auto& s) { s.gravity = TestFixture::In::vector(this->nan); });
}

/// What allowed blows throw beyond all numbers stays in them, and what it touches and is tied to does, too.
TYPED_TEST(BadInput, BlowsBeyondTheNumbers) {
  using T = typename TestFixture::T;
  using In = typename TestFixture::In;
  auto& s = this->simulation;
  typename TestFixture::Dynamics light;
  light.mass = T(4);
  const BodyId thrown = this->add_ball(T(1), light);
  int taken = 0;
  const T large = largest_magnitude<T>;
  for (int i = 0; i < 12; ++i) {
    typename TypeParam::Vec impulse = In::vector(i % 2 == 0 ? large : -large), point{};
    impulse.y = i % 3 == 0 ? -large : large;
    point.y = large / T(2);
    const std::uint64_t before = s.state_hash();
    try {
      s.apply_impulse(thrown, impulse, i % 3 == 0 ? s.motion(thrown).center : point);
      ++taken;
      if (i % 4 == 3) s.apply_angular_impulse(this->first, In::turning(large));
    } catch (const InvalidValue&) {
      if (i % 4 != 3) {
        EXPECT_EQ(s.state_hash(), before) << i;
      }
    }
    EXPECT_NO_THROW(s.step(this->step)) << i;
    for (const auto& pose : s.poses()) EXPECT_TRUE(max_abs(pose.translation) <= large) << i;
    EXPECT_TRUE(std::isfinite(max_abs(s.motion(this->first).linear))) << i;
    EXPECT_TRUE(std::isfinite(max_abs(s.motion(this->second).linear))) << i;
  }
  EXPECT_GE(taken, 4);
}

/// Impulses and ways that would make a body faster than numbers tell are refused.
TYPED_TEST(BadInput, SpeedsBeyondTheNumbers) {
  using T = typename TestFixture::T;
  using In = typename TestFixture::In;
  typename TestFixture::Dynamics light, kinematic;
  light.mass = std::numeric_limits<T>::min() * T(1024);
  kinematic.kinematic = true;
  const BodyId feather = this->add_ball(T(1), light), lift = this->add_ball(T(9), kinematic);
  auto& s = this->simulation;
  const T large = largest_magnitude<T>;
  this->refuses("velocity", [&] { s.apply_impulse(feather, In::vector(large), In::zero); });
  this->refuses("angular", [&] { s.apply_angular_impulse(feather, In::turning(large)); });
  this->refuses("velocity", [&] { s.move_to(lift, {In::vector(T(1)), {}}, std::numeric_limits<T>::denorm_min()); });
}

}  // namespace
}  // namespace graze::testing
