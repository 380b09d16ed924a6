// Bodies that bounce: corners that arrive one after the other in one step, and what ends a step just above the ground.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "dynamics/simulated.hpp"
#include "graze/free_motion.hpp"
#include "graze/impulse.hpp"
#include "graze/plane/simulation.hpp"

namespace graze::testing {
namespace {

Material<double> elastic() {
  Material<double> m;
  m.static_friction = m.dynamic_friction = 0;
  m.restitution = 1;
  return m;
}

/// The energy over that at rest on the floor, after so many seconds, as a part of what it was.
double kept(const Shape<double>& shape, double tilt, double resting_height, double step) {
  Simulation<double> s(settings<double>());
  add_floor(s, elastic());
  const Quatd turned = Quatd::from_axis_angle({0.6, 0, 0.8}, tilt);
  const BodyId body = s.add({shape, {{0, 3, 0}, turned}}, {}, elastic());
  const auto energy = [&] {
    const auto& r = s.report();
    return r.kinetic_energy + r.potential_energy - s.mass(body) * 10 * resting_height;
  };
  s.step(step);
  const double before = energy();
  for (int i = 0; i < static_cast<int>(4 / step); ++i) s.step(step);
  return energy() / before;
}

/// Within a few hundredths after some dozen blows: what came in a little too deep is pushed out.
TEST(Restitution, TiltedBodiesKeepTheirEnergy) {
  for (const double tilt : {0.01, 0.05, 0.2}) {
    EXPECT_NEAR(kept(Box<double>({1, 1, 1}), tilt, 0.5, 1.0 / 60), 1, 0.04) << tilt;
    EXPECT_NEAR(kept(Box<double>({0.4, 0.4, 0.4}), tilt, 0.2, 1.0 / 60), 1, 0.04) << tilt;
    EXPECT_NEAR(kept(Cylinder<double>(0.5, 1), tilt, 0.5, 1.0 / 60), 1, 0.04) << tilt;
    EXPECT_NEAR(kept(Capsule<double>(0.3, 1), tilt, 0.3, 1.0 / 60), 1, 0.04) << tilt;
  }
}

/// Large balls and boxes, which fall a small part of their size in a step: some end one within it of the floor.
TEST(Restitution, NothingIsBrakedBeforeItIsStruck) {
  for (const bool round : {true, false})
    for (int i = 0; i < 25; ++i) {
      const double height = 0.3 + 2.7 * i / 24;
      Simulation<double> s(settings<double>());
      add_floor(s, elastic());
      const Shape<double> shape = round ? Shape<double>(Sphere<double>(10)) : Box<double>({20, 20, 20});
      const BodyId body = s.add({shape, {{0, 10 + height, 0}, {}}}, {}, elastic());
      const double falls = std::sqrt(height / 5);
      double top = 0;
      for (double time = 0; time < 2.2 * falls; time += 1.0 / 60) {
        s.step(1.0 / 60);
        if (time > 1.2 * falls) top = std::max(top, s.poses()[body.index].translation.y - 10);
      }
      EXPECT_NEAR(top, height, 0.01 * height) << round << ", " << height;
    }
}

/// Two balls of one mass that meet somewhere within a step, without friction, however fast they spin: what they
/// exchange is along the line of their centres at that moment, by the root of |d + v t| = 2 r.
TEST(Restitution, SpinningBallsExchangeWhatIsAlongTheirCentres) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    const double r = 0.25;
    const Vec3d at{1.2 + 0.2 * any(random), 0.4 * any(random), 0.3 * any(random)},
        v{5 + 2 * any(random), any(random), 0};
    const double along = dot(at, v) / length_squared(v),
                 square = 4 * r * r - (length_squared(at) - along * along * length_squared(v));
    if (square < 0.01) continue;  // grazing: hardly an approach
    ++met;
    const double time = along - std::sqrt(square / length_squared(v));
    const Vec3d n = normalized(at - v * time), exchanged = n * dot(v, n);
    const Vec3d spins[] = {{8 * any(random), 8 * any(random), 8 * any(random)}, {0, 0, 10 * any(random)}};
    Simulation<double> s(settings<double>(0));
    const BodyId a = s.add({Sphere<double>(r), {}, v, spins[0]}, {}, elastic());
    const BodyId b = s.add({Sphere<double>(r), {at, {}}, {}, spins[1]}, {}, elastic());
    for (int k = 0; k < 40; ++k) s.step(1.0 / 60);
    EXPECT_LT(length(s.motion(a).linear - (v - exchanged)), 1e-9) << i;
    EXPECT_LT(length(s.motion(b).linear - exchanged), 1e-9) << i;
    EXPECT_LT(length(s.motion(a).angular - spins[0]), 1e-9) << i;
    EXPECT_LT(length(s.motion(b).angular - spins[1]), 1e-9) << i;
  }
  EXPECT_GT(met, 200);
}

/// Discs of the plane on a floor and each other, without friction: no spin comes of it.
TEST(Restitution, DiscsThatBounceAskewDoNotSpin) {
  plane::Simulation<double> s(plane::SimulationSettings<double>{});
  plane::Material<double> smooth;
  smooth.static_friction = smooth.dynamic_friction = 0;
  smooth.restitution = 1;
  plane::Body<double> floor{plane::HalfPlane<double>(), {}};
  floor.fixed = true;
  s.add(floor, {}, smooth);
  std::vector<BodyId> discs;
  for (int i = 0; i < 8; ++i)
    discs.push_back(
        s.add({plane::Circle<double>(0.25), {{0.6 * i, 1.0 + 0.13 * i}, {}}, {4.0 - i, -1.0 * i}}, {}, smooth));
  for (int i = 0; i < 300; ++i) s.step(1.0 / 60);
  for (const BodyId disc : discs) EXPECT_NEAR(s.motion(disc).angular, 0, 1e-9) << disc.index;
}

/// A box that comes down on a corner, turning: one blow with friction, as the closed form of one contact has it.
TEST(Restitution, ABlowOnACornerIsTheResponse) {
  Material<double> rough;
  rough.static_friction = rough.dynamic_friction = 0.3;
  rough.restitution = 0.5;
  std::mt19937 random(3);
  const auto number = [&] { return static_cast<double>(random() % 1024) / 512 - 1; };
  for (int k = 0; k < 40; ++k) {
    SimulationSettings<double> free = settings<double>(0);
    Simulation<double> s(free);
    add_floor(s, rough);
    const Quatd turned = normalized(Quatd{0.4 + 0.1 * number(), 0.2 * number(), 0.3 + 0.1 * number(), 0.8});
    const Vec3d half{0.5, 0.3, 0.4};
    double lowest = 0;
    Vec3d corner{};
    for (int i = 0; i < 8; ++i) {
      const Vec3d c = rotate(turned, {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
      if (c.y < lowest) lowest = c.y, corner = c;
    }
    const Vec3d linear{number(), -3, number()}, angular{number(), number(), number()};
    const BodyId box = s.add({Box<double>(half * 2.0), {{0, -lowest, 0}, turned}, linear, angular}, {}, rough);
    const double mass = s.mass(box);
    const Vec3d moments =
        Vec3d{half.y * half.y + half.z * half.z, half.x * half.x + half.z * half.z, half.x * half.x + half.y * half.y} *
        (mass / 3);
    const StruckBody<double> ground{}, falling{{linear, angular, {0, -lowest, 0}}, inverse_mass(mass, moments, turned)};
    const Response<double> expected = response({corner + Vec3d{0, -lowest, 0}, {0, 1, 0}, 0.5, 0.3}, ground, falling);
    s.step(1e-4);
    EXPECT_LT(length(s.motion(box).linear - expected.b.linear), 5e-3) << k;
    EXPECT_LT(length(s.motion(box).angular - expected.b.angular), 2e-2) << k;
  }
}

}  // namespace
}  // namespace graze::testing
