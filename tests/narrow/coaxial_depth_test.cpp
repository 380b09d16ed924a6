// Depths of bodies of revolution about one axis, against the same in extended precision.
#include <gtest/gtest.h>

#include <cmath>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

using Long = long double;

/// The hull of two discs or of two balls about Y, whose extent along a direction of its half-plane is known.
struct Revolved {
  Long half_height, disc[2], ball;

  Long reach(Long across, Long along) const {
    return std::max(disc[0] * across - half_height * along, disc[1] * across + half_height * along) + ball;
  }
};

/// The least depth: along the axis or along the normal of the side of either, `rise` apart along the axis.
Long least_depth(const Revolved& a, const Revolved& b, Long rise, bool upside_down) {
  const Long toward = upside_down ? -1 : 1;
  Long least = std::numeric_limits<Long>::infinity();
  const auto consider = [&](Long across, Long along) {
    least = std::min(least, a.reach(across, along) + b.reach(across, -along * toward) - along * rise);
  };
  consider(0, 1);
  consider(0, -1);
  const auto consider_side = [&](const Revolved& of, Long sign) {
    const Long taper = of.disc[0] - of.disc[1], height = 2 * of.half_height;
    const Long slant = std::sqrt(height * height + taper * taper);
    if (slant > 0) consider(height / slant, sign * taper / slant);
  };
  consider_side(a, 1);
  consider_side(b, -toward);
  return least;
}

// Capsules, cylinders and cones against cones that may be as flat as a millionth of their radius: what is not proven
// says how far off it may be, and is no further.
TEST(CoaxialDepth, BoundsHoldForFlatCones) {
  Random random(1);
  const auto within = [&](float low, float high) { return static_cast<double>(uniform(random, low, high)); };
  std::size_t bounded = 0;
  for (int i = 0; i < 10000; ++i) {
    const double size = std::pow(10, within(-2, 2)), height = within(0, 1) * size, radius = within(0.05f, 1) * size;
    const double flat = std::pow(10, within(-6, 0)) * size, bottom = within(0, 1) * size;
    const double top = random() % 2 == 0 ? 0 : within(0, 1) * size, rise = within(-0.6f, 0.6f) * height;
    const double narrow = radius * within(0, 1);
    const bool upside_down = random() % 2 == 0;
    const auto kind = random() % 3;
    const Shaped a = kind == 0   ? Shaped(Capsule<double>(height, radius))
                     : kind == 1 ? Shaped(Cylinder<double>(height, radius))
                                 : Shaped(Cylinder<double>(height, radius, narrow));
    const Cylinder<double> cone(flat, bottom, top);
    const Long half = static_cast<Long>(height / 2);
    const Revolved of_a =
        kind == 0 ? Revolved{half, {0, 0}, radius} : Revolved{half, {radius, kind == 1 ? radius : narrow}, 0};
    const Revolved of_b{cone.half_height(), {bottom, top}, 0};
    const Long depth = least_depth(of_a, of_b, rise, upside_down);
    if (depth <= 0) continue;
    const Posed pose{{0, rise, 0}, upside_down ? Quatd{1, 0, 0, 0} : Quatd{}};
    const Distance<double> d = distance<double>(a, {}, cone, pose);
    const auto error = static_cast<double>(std::abs(depth + d.distance));
    bounded += d.status == Status::bounded;
    ASSERT_LE(error, d.status == Status::bounded ? d.error : tolerance<double> * size) << i;
  }
  EXPECT_GT(bounded, 50u);
}

}  // namespace
}  // namespace graze::testing
