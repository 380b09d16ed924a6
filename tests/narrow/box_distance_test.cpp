// The distance of two boxes as axes and corners tell it: proven, right, and the same in lanes.
#include "narrow/pairs/box_box/distance.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "common/specimen.hpp"
#include "manifold_of.hpp"
#include "narrow/pairs/closed_form.hpp"

namespace graze::testing {
namespace {

struct PlacedPair {
  PlacedSpecimen a, b;
};

/// Turned about Y by some angle, or by eighths of a turn, and then tilted by no more than `tilt`.
Quatf upright(Random& random, float tilt) {
  const float angle = random() % 2 == 0 ? uniform(random, -3, 3) : static_cast<float>(random() % 8) * 0.39269908f;
  return {uniform(random, -tilt, tilt), std::sin(angle), uniform(random, -tilt, tilt), std::cos(angle)};
}

PlacedSpecimen random_box(Random& random) {
  return {random_specimen(Kind::box, 1, random), random_vector(random, 1.5f), random_rotation(random)};
}

PlacedPair any_boxes(Random& random) { return {random_box(random), random_box(random)}; }

/// One over the other, flush or nearly so, or beside it: beams that cross, stars, corners that meet.
PlacedPair stacked_boxes(Random& random) {
  const float tilt = random() % 2 == 0 ? 0 : std::pow(10.0f, uniform(random, -9, -2));
  PlacedPair pair{random_box(random), random_box(random)};
  pair.a.rotation = upright(random, tilt);
  pair.b.rotation = upright(random, tilt);
  const float flush = (pair.a.specimen.size[1] + pair.b.specimen.size[1]) / 2;
  pair.b.translation.y = pair.a.translation.y + (random() % 2 == 0 ? flush : uniform(random, -1, 1));
  return pair;
}

/// Sizes that are zero, tiny or equal, at half steps and eighths of a turn.
PlacedPair boxes_on_lattice(Random& random) {
  const auto box = [&] { return on_lattice(degenerate_specimen(Kind::box, 1, random), 1, random); };
  return {box(), box()};
}

PlacedPair capsule_and_box(Random& random) {
  PlacedPair pair = stacked_boxes(random);
  pair.a.specimen =
      random() % 2 == 0 ? random_specimen(Kind::capsule, 1, random) : degenerate_specimen(Kind::capsule, 1, random);
  if (random() % 2 == 0) pair.a.rotation = random_rotation(random);
  return pair;
}

PlacedBox<double> placed(const PlacedSpecimen& s) {
  const Shaped shape = build<double>(s.specimen);
  const Posed pose = pose_of<double>(s);
  if (const auto* capsule = shape.as<Capsule<double>>())
    return placed_box(rounded_core(*capsule, shape.rounding()), pose);
  return placed_box(rounded_core(*shape.as<Box<double>>(), shape.rounding()), pose);
}

/// How many of so many pairs are not proven. Of those that are, everything is right up to rounding.
int unproven(PlacedPair (*make)(Random&), int count, unsigned seed) {
  Random random(seed);
  int missing = 0;
  for (int i = 0; i < count; ++i) {
    const PlacedPair pair = make(random);
    const BoxDistance<double> found = box_distance(placed(pair.a), placed(pair.b));
    if (!found.proven) {
      ++missing;
      continue;
    }
    const reference::Placed a = reference_of(pair.a), b = reference_of(pair.b);
    const reference::Answer answer{found.at.distance, vector_of(found.at.normal), vector_of(found.at.a),
                                   vector_of(found.at.b)};
    const double coordinates = static_cast<double>(greatest(max_abs(pair.a.translation), max_abs(pair.b.translation))) +
                               static_cast<double>(reference::size(a, b));
    const auto why_not = reference::disprove(a, b, answer, 4 * box_rounding<double> * coordinates);
    EXPECT_FALSE(why_not) << *why_not << "\n" << describe(pair.a) << "\n" << describe(pair.b);
  }
  return missing;
}

TEST(BoxDistance, IsProvenAndRightForAnyBoxes) { EXPECT_EQ(unproven(any_boxes, 2000, 1), 0); }

TEST(BoxDistance, IsProvenAndRightForStackedBoxes) { EXPECT_EQ(unproven(stacked_boxes, 3000, 2), 0); }

TEST(BoxDistance, IsProvenAndRightForThinAndAlignedBoxes) { EXPECT_EQ(unproven(boxes_on_lattice, 2000, 3), 0); }

TEST(BoxDistance, IsProvenAndRightForCapsules) { EXPECT_EQ(unproven(capsule_and_box, 3000, 8), 0); }

// No corner of either lies over the other: the faces' rims cross.
TEST(BoxDistance, KnowsBeamsThatCross) {
  for (const double gap : {0.5, 0.0, -0.25}) {
    const PlacedBox<double> a{{4, 0.5, 0.5}, 0, {}}, b{{0.5, 0.5, 4}, 0, {{0, 1 + gap, 0}, {}}};
    const BoxDistance<double> found = box_distance(a, b);
    EXPECT_TRUE(found.proven);
    EXPECT_EQ(found.at.distance, gap);
    EXPECT_EQ(found.at.normal, (Vec3d{0, 1, 0}));
    EXPECT_EQ(found.at.a.y, 0.5);
  }
}

TEST(BoxDistance, SaysThatLengthsBeyondItsArithmeticAreNotProven) {
  for (const double size : {1e-80, 1e80}) {
    const PlacedBox<double> a{Vec3d{1, 2, 3} * size, 0, {}}, b{Vec3d{1, 1, 1} * size, 0, {Vec3d{3, 4, 5} * size, {}}};
    EXPECT_FALSE(box_distance(a, b).proven);
  }
}

template <int lanes>
void expect_bits_of_scalar(PlacedPair (*make)(Random&), unsigned seed) {
  using W = Wide<double, lanes>;
  Random random(seed);
  const auto set = [](Vec3<W>& to, int lane, const Vec3d& from) {
    for (std::size_t k = 0; k < 3; ++k) to[k].set(lane, from[k]);
  };
  const auto fill = [&](PlacedBox<W>& to, int lane, const PlacedBox<double>& from) {
    set(to.half, lane, from.half);
    set(to.pose.translation, lane, from.pose.translation);
    to.radius.set(lane, from.radius);
    const Quatd& q = from.pose.rotation;
    to.pose.rotation.x.set(lane, q.x);
    to.pose.rotation.y.set(lane, q.y);
    to.pose.rotation.z.set(lane, q.z);
    to.pose.rotation.w.set(lane, q.w);
  };
  for (int round = 0; round < 300; ++round) {
    PlacedBox<double> a[lanes], b[lanes];
    PlacedBox<W> wide_a, wide_b;
    for (int lane = 0; lane < lanes; ++lane) {
      const PlacedPair pair = make(random);
      fill(wide_a, lane, a[lane] = placed(pair.a));
      fill(wide_b, lane, b[lane] = placed(pair.b));
    }
    const BoxDistance<W> found = box_distance(wide_a, wide_b);
    for (int lane = 0; lane < lanes; ++lane) {
      const BoxDistance<double> alone = box_distance(a[lane], b[lane]);
      ASSERT_EQ(found.proven[lane], alone.proven);
      if (!alone.proven) continue;
      const auto of_lane = [&](const Vec3<W>& v) { return Vec3d{v.x[lane], v.y[lane], v.z[lane]}; };
      const double wide[] = {found.at.distance[lane]}, one[] = {alone.at.distance};
      ASSERT_EQ(std::memcmp(wide, one, sizeof one), 0);
      ASSERT_EQ(of_lane(found.at.normal), alone.at.normal);
      ASSERT_EQ(of_lane(found.at.a), alone.at.a);
      ASSERT_EQ(of_lane(found.at.b), alone.at.b);
    }
  }
}

TEST(BoxDistance, LanesGiveTheScalarsBits) {
  expect_bits_of_scalar<2>(any_boxes, 4);
  expect_bits_of_scalar<4>(stacked_boxes, 5);
  expect_bits_of_scalar<8>(boxes_on_lattice, 6);
  expect_bits_of_scalar<8>(stacked_boxes, 7);
}

}  // namespace
}  // namespace graze::testing
