// Scenes of random bodies on random ground: they come to rest, nothing passes through anything, energy only falls.
//
// How many scenes: GRAZE_TEST_SCENES in the environment, else enough for a run of seconds; a thousand take half a
// minute. Bodies that move are convex, made of convex pieces, or closed meshes with an inside: meshes without one are
// surfaces, and two surfaces that cross push each other both ways.
#include <gtest/gtest.h>

#include <cmath>

#include "common/asked_number.hpp"
#include "dynamics/random_scene.hpp"
#include "graze/raycast.hpp"

namespace graze::testing {
namespace {

constexpr double g = 10;

template <class T>
double energy_of(const StepReport<T>& report) {
  return static_cast<double>(report.kinetic_energy) + static_cast<double>(report.potential_energy);
}

/// Grounds face up everywhere, so that what is below one has it above.
template <class T>
bool is_below_ground(const RandomScene<T>& scene, const Vec3<T>& point) {
  Ray<T> up;
  up.origin = point;
  up.direction = {T(0), T(1), T(0)};
  return raycast(scene.ground(), Pose<T>{}, up).has_value();
}

template <class T>
void play(unsigned seed, bool meshes) {
  SimulationSettings<T> settings;
  settings.gravity = {T(0), static_cast<T>(-g), T(0)};
  Simulation<T> s(settings);
  const RandomScene<T> scene(s, seed, meshes);
  double weight = 0;
  for (const BodyId body : scene.bodies()) weight += static_cast<double>(s.mass(body)) * g;
  // Nothing overlaps at the beginning, so nothing is pushed out that did not fall in before, and every blow and all
  // friction take energy: the sum may never be more than at the beginning, but for the ten-thousandth by which the
  // energy of a free turning swings with its angular momentum exact (`free_motion.hpp`). Nor may it rise in between but
  // for what rows that are warm started give back of a blow in the step after it, most where something heavy falls on
  // something light: in a thousand scenes never as much as lifting all bodies by a seventh of the largest one's size
  // would take.
  const double first = energy_of(s.report()), rise = 0.15 * weight;
  double lowest = first;
  bool asleep = false;
  // A minute, for what leans on something else may creep and tip late.
  for (int i = 0; i < 60 * 60 && !asleep; ++i) {
    s.step(T(1) / T(60));
    const StepReport<T> report = s.report();
    const double energy = energy_of(report);
    ASSERT_TRUE(std::isfinite(energy)) << seed;
    ASSERT_LE(energy, first * (1 + 1e-4)) << seed << ", step " << i;
    ASSERT_LE(energy, lowest + rise) << seed << ", step " << i;
    lowest = std::min(lowest, energy);
    // What is deeper than half of a body is on its way through.
    ASSERT_LT(report.deepest, T(0.5)) << seed << ", step " << i;
    for (const BodyId body : scene.bodies()) {
      const Vec3<T> center = s.motion(body).center;
      ASSERT_FALSE(is_below_ground(scene, center)) << seed << ", body " << body.index << ", step " << i;
      ASSERT_LT(std::max(std::abs(center.x), std::abs(center.z)), scene.half) << seed << ", body " << body.index;
    }
    asleep = report.awake == 0;
  }
  // At rest, if not asleep: what still stirs would not lift the bodies by a ten-thousandth of their size.
  EXPECT_LT(static_cast<double>(s.report().kinetic_energy), 1e-4 * weight) << seed;
}

/// Even scenes in float, odd ones in double.
void play_either(unsigned seed, bool meshes = false) {
  SCOPED_TRACE(seed);
  if (seed % 2 == 0)
    play<float>(seed, meshes);
  else
    play<double>(seed, meshes);
}

/// Bodies with a rim that slid and fell into valleys of the ground, and once fell through.
TEST(RandomScenes, RimsInValleysDoNotFallThrough) {
  for (const unsigned seed : {1371u, 3412u, 3450u}) play_either(seed);
}

/// A cone that came down flat beside the corner that it touched, once pushed out below; and a body that was carried up
/// by the one it met, at no cost of its speed.
TEST(RandomScenes, BodiesThatTouchDoNotSinkNorRiseForNothing) {
  for (const unsigned seed : {2099u, 3458u}) play_either(seed);
}

TEST(RandomScenes, ComeToRest) {
  const int scenes = asked_number("GRAZE_TEST_SCENES", 40);
  for (int i = 0; i < scenes; ++i) play_either(static_cast<unsigned>(i));
}

/// Wedges that met in the air, edge to edge, and once hung there: continuous collision held them back in every step,
/// and no contact pushed them.
TEST(RandomScenes, WedgesThatMeetInTheAirFallOn) { play_either(847, true); }

/// Random scenes with closed meshes among the bodies that fall, in a quarter as many scenes, which take longer.
TEST(RandomScenes, MeshesComeToRest) {
  const int scenes = asked_number("GRAZE_TEST_SCENES", 40) / 4;
  for (int i = 0; i < scenes; ++i) play_either(static_cast<unsigned>(i), true);
}

}  // namespace
}  // namespace graze::testing
