// Every pair of shapes against the independent reference: separated, near touching, shallow and deep; in both scalars;
// at sizes from 1e-4 to 1e4; far from the origin; swapped, moved and turned.
//
// How many pairs a kind: GRAZE_TEST_PAIRS in the environment, else enough for a run of seconds. The search for a
// shorter way out of an overlap costs milliseconds, so it is made for one overlapping pair in `search_every`.
#include "common/asked_number.hpp"
#include "common/specimen.hpp"
#include "manifold_of.hpp"

namespace graze::testing {
namespace {

using reference::Real;

int pairs_to_test() { return asked_number("GRAZE_TEST_PAIRS", 400); }
int search_every() { return asked_number("GRAZE_TEST_SEARCH_EVERY", 50); }

/// What the issue of the field asks for, relative to the pair's size.
template <class T>
Real tolerance_of(Kind a, Kind b, bool overlapping) {
  if (std::is_same_v<T, float>) return 2e-5L;
  return overlapping && (curved(a) || curved(b)) ? 1e-6L : 1e-9L;
}

template <class T>
reference::Answer answer_of(const Distance<T>& d) {
  // A float normal is as long as floats let it be; the reference wants unit ones.
  return {d.distance, reference::normalized(vector_of(converted<double>(d.normal))), vector_of(converted<double>(d.a)),
          vector_of(converted<double>(d.b))};
}

template <class T>
Distance<T> ask(const PlacedSpecimen& a, const PlacedSpecimen& b) {
  return distance(build<T>(a.specimen), pose_of<T>(a), build<T>(b.specimen), pose_of<T>(b));
}

/// A pair at a distance that suits the round: apart, near, shallow, deep.
std::pair<PlacedSpecimen, PlacedSpecimen> random_pair(Kind ka, Kind kb, float scale, Random& random, int round) {
  static constexpr float spread[] = {2.5f, 1, 0.6f, 0.2f};
  const float reach = scale * spread[round % 4];
  return {{random_specimen(ka, scale, random), random_vector(random, scale), random_rotation(random)},
          {random_specimen(kb, scale, random), random_vector(random, reach), random_rotation(random)}};
}

class EveryPair : public ::testing::TestWithParam<std::pair<Kind, Kind>> {
 protected:
  Random random{
      static_cast<std::uint64_t>(static_cast<int>(GetParam().first) * 100 + static_cast<int>(GetParam().second))};

  template <class T>
  void check_against_reference(float scale) {
    const auto [ka, kb] = GetParam();
    int overlapping = 0, unproven = 0;
    for (int i = 0; i < pairs_to_test(); ++i) {
      auto [a, b] = random_pair(ka, kb, scale, random, i);
      const reference::Placed ra = reference_of(a), rb = reference_of(b);
      const Distance<T> d = ask<T>(a, b);
      unproven += d.status != Status::converged;
      const bool touch = d.distance <= T(0);
      const Real allowed = tolerance_of<T>(ka, kb, touch) * reference::size(ra, rb);
      const bool search = touch && overlapping++ % search_every() == 0;
      const auto wrong = reference::disprove(ra, rb, answer_of(d), allowed, search);
      ASSERT_FALSE(wrong) << *wrong << "\n" << describe(a) << "\n" << describe(b);
      if (std::abs(static_cast<Real>(d.distance)) > allowed) {
        ASSERT_EQ(overlap(build<T>(a.specimen), pose_of<T>(a), build<T>(b.specimen), pose_of<T>(b)), touch);
      }
    }
    // Nearly round shapes, nearly concentric, have too many directions of about the same depth for a proof.
    EXPECT_LE(unproven, pairs_to_test() / 50);
    if (kb != Kind::half_space && ka != Kind::segment) {
      EXPECT_GT(overlapping, pairs_to_test() / 50);
    }
  }
};

TEST_P(EveryPair, DoubleAgreesWithTheReference) { check_against_reference<double>(1); }
TEST_P(EveryPair, FloatAgreesWithTheReference) { check_against_reference<float>(1); }

TEST_P(EveryPair, IsScaleFree) {
  const auto [ka, kb] = GetParam();
  for (const float scale : {1e-4f, 1e-2f, 1e2f, 1e4f})
    for (int i = 0; i < 40; ++i) {
      const auto [a, b] = random_pair(ka, kb, scale, random, i);
      const reference::Placed ra = reference_of(a), rb = reference_of(b);
      const Distance<double> d = ask<double>(a, b);
      const Distance<float> f = ask<float>(a, b);
      const bool touch = d.distance <= 0;
      const Real size = reference::size(ra, rb);
      auto wrong = reference::disprove(ra, rb, answer_of(d), tolerance_of<double>(ka, kb, touch) * size, false);
      ASSERT_FALSE(wrong) << *wrong << "\n" << describe(a) << "\n" << describe(b);
      wrong = reference::disprove(ra, rb, answer_of(f), tolerance_of<float>(ka, kb, touch) * size, false);
      ASSERT_FALSE(wrong) << *wrong << "\n" << describe(a) << "\n" << describe(b);
    }
}

// What moves with the whole scene is lost to no rounding but that of the coordinates themselves: offsets of 1e4 sizes
// that floats hold exactly change no distance.
TEST_P(EveryPair, IsTheSameFarFromTheOrigin) {
  const auto [ka, kb] = GetParam();
  for (int i = 0; i < 40; ++i) {
    auto [a, b] = random_pair(ka, kb, 1, random, i);
    // On a grid of 1/64, so that adding 2^13 is exact in float.
    for (Vec3f* t : {&a.translation, &b.translation})
      for (std::size_t k = 0; k < 3; ++k) (*t)[k] = std::round((*t)[k] * 64) / 64;
    PlacedSpecimen far_a = a, far_b = b;
    for (Vec3f* t : {&far_a.translation, &far_b.translation}) *t += Vec3f{8192, -8192, 4096};
    const Distance<double> d = ask<double>(a, b);
    const double size = static_cast<double>(reference::size(reference_of(a), reference_of(b)));
    EXPECT_EQ(ask<double>(far_a, far_b).distance, d.distance) << describe(a) << "\n" << describe(b);
    EXPECT_EQ(ask<float>(far_a, far_b).distance, ask<float>(a, b).distance) << describe(a) << "\n" << describe(b);
    EXPECT_NEAR(static_cast<double>(ask<float>(far_a, far_b).distance), d.distance, 2e-5 * size);
  }
}

TEST_P(EveryPair, SwappingAndTurningTheSceneChangesNothing) {
  const auto [ka, kb] = GetParam();
  for (int i = 0; i < 40; ++i) {
    const auto [a, b] = random_pair(ka, kb, 1, random, i);
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    const Posed pa = pose_of<double>(a), pb = pose_of<double>(b);
    const Distance<double> d = distance(sa, pa, sb, pb), swapped = distance(sb, pb, sa, pa);
    const double allowed = 1e-9 * static_cast<double>(reference::size(reference_of(a), reference_of(b)));
    EXPECT_NEAR(swapped.distance, d.distance, allowed);

    const Posed turn{converted<double>(random_vector(random, 3)),
                     normalized(converted<double>(random_rotation(random)))};
    const Distance<double> turned = distance(sa, compose(turn, pa), sb, compose(turn, pb));
    EXPECT_NEAR(turned.distance, d.distance, 2 * allowed) << describe(a) << "\n" << describe(b);
  }
}

// Zero sizes, slivers of 1e4 to 1, parallel, identical, concentric and exactly touching shapes. An answer may say that
// it is not proven; it must then be right within the error that it states.
TEST_P(EveryPair, DegenerateShapesOnALattice) {
  const auto [ka, kb] = GetParam();
  int unproven = 0;
  for (int i = 0; i < pairs_to_test(); ++i) {
    const PlacedSpecimen a = on_lattice(degenerate_specimen(ka, 1, random), 1, random);
    PlacedSpecimen b = on_lattice(degenerate_specimen(kb, 1, random), 1, random);
    if (ka == kb && i % 8 == 0) b.specimen = a.specimen;
    if (i % 16 == 0) b.translation = a.translation;
    const reference::Placed ra = reference_of(a), rb = reference_of(b);
    const Distance<double> d = ask<double>(a, b);
    const float reach = max_abs(a.translation - b.translation) + a.specimen.margin + b.specimen.margin;
    const Real size = std::max(reference::size(ra, rb), static_cast<Real>(reach));
    if (!(size > 0)) continue;  // a point in the surface of a half-space: every length is zero
    const Real allowed = std::max(1e-6L * size, static_cast<Real>(d.error));
    const auto wrong = reference::disprove(ra, rb, answer_of(d), allowed, i % search_every() == 0);
    unproven += d.status != Status::converged;
    ASSERT_FALSE(wrong) << *wrong << "\n" << describe(a) << "\n" << describe(b);
    const Distance<float> f = ask<float>(a, b);
    const double stated = std::max(static_cast<double>(2e-5L * size), d.error + static_cast<double>(f.error));
    EXPECT_NEAR(static_cast<double>(f.distance), d.distance, stated) << describe(a) << "\n" << describe(b);
  }
  EXPECT_LE(unproven, pairs_to_test() / 12);
}

std::vector<std::pair<Kind, Kind>> all_pairs() {
  std::vector<std::pair<Kind, Kind>> pairs;
  for (int i = 0; i < bounded_kinds; ++i)
    for (int j = i; j < kind_count; ++j) pairs.push_back({static_cast<Kind>(i), static_cast<Kind>(j)});
  return pairs;
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryPair, ::testing::ValuesIn(all_pairs()), [](const auto& info) {
  return std::string(name_of(info.param.first)) + "_" + name_of(info.param.second);
});

}  // namespace
}  // namespace graze::testing
