// Scenes of random bodies of the plane on random ground: they come to rest, nothing passes through anything, energy
// only falls.
//
// How many scenes: GRAZE_TEST_SCENES in the environment, else enough for a run of seconds; a thousand take half a
// minute.
#include <gtest/gtest.h>

#include <cmath>

#include "common/asked_number.hpp"
#include "dynamics/plane_random_scene.hpp"

namespace graze::plane::testing {
namespace {

using graze::testing::asked_number;

template <class T>
double energy_in(const StepReport<T>& report) {
  return static_cast<double>(report.kinetic_energy) + static_cast<double>(report.potential_energy);
}

template <class T>
void play_in_plane(unsigned seed) {
  constexpr double g = 10;
  SimulationSettings<T> settings;
  settings.gravity = {T(0), static_cast<T>(-g)};
  Simulation<T> s(settings);
  const RandomScene<T> scene(s, seed);
  double weight = 0;
  for (const BodyId body : scene.bodies()) weight += static_cast<double>(s.mass(body)) * g;
  // Nothing overlaps at the beginning and free bodies keep their energy exactly, so the sum may never be more than at
  // the beginning; in one of 3,000 scenes it was by nine hundred-thousandths. In between it rises by what rows that are
  // warm started give back of a blow in the step after it: in one of 1,000 scenes, 640, by what lifting all bodies by
  // 0.24 would take, where they are up to 1 across, in the others by less than 0.2.
  const double first = energy_in(s.report()), rise = 0.25 * weight;
  double lowest = first;
  bool asleep = false;
  for (int i = 0; i < 30 * 60 && !asleep; ++i) {
    s.step(T(1) / T(60));
    const StepReport<T> report = s.report();
    const double energy = energy_in(report);
    ASSERT_TRUE(std::isfinite(energy)) << seed;
    ASSERT_LE(energy, first * (1 + 1e-4)) << seed << ", step " << i;
    ASSERT_LE(energy, lowest + rise) << seed << ", step " << i;
    lowest = std::min(lowest, energy);
    // Deepest are bodies of which the front one stops while the other goes on. In one of 3,000 scenes, 1317, two
    // concave ones are so deep in each other that the way out is told the other way round, 0.96 for a step.
    ASSERT_LT(report.deepest, T(0.5)) << seed << ", step " << i;
    for (const BodyId body : scene.bodies()) {
      const Vec2<T> center = s.motion(body).center;
      ASSERT_LT(std::abs(center.x), scene.half) << seed << ", body " << body.index << ", step " << i;
      ASSERT_GT(center.y, scene.ground_at(center.x)) << seed << ", body " << body.index << ", step " << i;
    }
    asleep = report.awake == 0;
  }
  // At rest, if not asleep: what still stirs would not lift the bodies by a ten-thousandth of their size.
  EXPECT_LT(static_cast<double>(s.report().kinetic_energy), 1e-4 * weight) << seed;
}

/// Bodies over a valley of solid ground, which once pushed them out through its underside, and a bracket on a wall.
TEST(PlaneRandomScenes, SolidGroundPushesUpwards) {
  play_in_plane<double>(1139);
  play_in_plane<float>(464);
  play_in_plane<double>(821);
  play_in_plane<float>(1384);
}

/// A bracket whose base covers whole segments of a chain once rocked on it for ever.
TEST(PlaneRandomScenes, BracketsRestOnChains) {
  play_in_plane<float>(434);
  play_in_plane<float>(2270);
}

TEST(PlaneRandomScenes, ComeToRest) {
  const int scenes = asked_number("GRAZE_TEST_SCENES", 40);
  for (int i = 0; i < scenes; ++i) {
    SCOPED_TRACE(i);
    if (i % 2 == 0)
      play_in_plane<float>(static_cast<unsigned>(i));
    else
      play_in_plane<double>(static_cast<unsigned>(i));
  }
}

}  // namespace
}  // namespace graze::plane::testing
