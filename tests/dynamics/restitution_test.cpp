// Bodies that bounce: corners that arrive one after the other in one step, and what ends a step just above the ground.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/simulated.hpp"

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

}  // namespace
}  // namespace graze::testing
