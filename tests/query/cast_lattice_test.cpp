// Casts of flat, thin, equal and aligned shapes on a lattice of poses and velocities: everything that is degenerate at
// once. The library's own distance judges, which has tests of its own.
#include <gtest/gtest.h>

#include <cmath>

#include "common/specimen.hpp"
#include "graze/cast.hpp"

namespace graze::testing {
namespace {

template <class T>
struct Thrown {
  Shape<T> shape;
  Pose<T> pose;
  Velocity<T> velocity;
};

template <class T>
Thrown<T> made(const PlacedSpecimen& placed, const Velocity<float>& v) {
  return {build<T>(placed.specimen), pose_of<T>(placed), {converted<T>(v.linear), converted<T>(v.angular)}};
}

double distance_at(const Thrown<double>& a, const Thrown<double>& b, double t) {
  return distance(a.shape, pose_at(a.pose, a.velocity, t), b.shape, pose_at(b.pose, b.velocity, t)).distance;
}

template <class T>
void check_lattice(float scale, int count) {
  Random random(11);
  const auto step = [&] { return static_cast<float>(static_cast<int>(random() % 5) - 2); };
  const auto kind = [&] { return static_cast<Kind>(random() % kind_count); };
  const auto quarter_turns = [&] { return Vec3f{step(), step(), step()} * 1.57079633f; };
  int hits = 0, misses = 0, unknown = 0;
  for (int i = 0; i < count; ++i) {
    const auto pa = on_lattice(degenerate_specimen(kind(), scale, random), scale, random);
    const auto pb = on_lattice(degenerate_specimen(kind(), scale, random), scale, random);
    Velocity<float> va{}, vb{Vec3f{step(), step(), step()} * scale, {}};
    if (i % 2 == 0 && pa.specimen.kind != Kind::half_space) va.angular = quarter_turns();
    if (i % 2 == 0 && pb.specimen.kind != Kind::half_space) vb.angular = quarter_turns();
    const auto a = made<T>(pa, va), b = made<T>(pb, vb);
    const auto in_a = made<double>(pa, va), in_b = made<double>(pb, vb);
    const auto hit = cast(a.shape, a.pose, a.velocity, b.shape, b.pose, b.velocity, T(1));
    const std::string text = describe(pa) + "\n" + describe(pb);
    if (hit && hit->status != Status::converged) {
      unknown += hit->status == Status::bounded;  // half-spaces that overlap without a depth are another matter
      continue;
    }
    // The shapes and the lattice reach six units at most.
    const double tolerance = 6.0 * static_cast<double>(scale) * (std::is_same_v<T, float> ? 1e-5 : 2e-9);
    if (hit) {
      ++hits;
      EXPECT_NEAR(length(hit->normal), T(1), T(1e-6)) << text;
      EXPECT_LE(distance_at(in_a, in_b, static_cast<double>(hit->t)), tolerance) << text;
      if (hit->t > T(0)) {
        EXPECT_GE(distance_at(in_a, in_b, static_cast<double>(hit->t)), -tolerance) << text;
      }
    } else {
      ++misses;
    }
    const double until = hit ? static_cast<double>(hit->t) : 1;
    for (int k = 0; k < 12 && until > 0; ++k)
      EXPECT_GE(distance_at(in_a, in_b, until * k / 12), -tolerance / 10) << "before " << until << "\n" << text;
    // Ignoring what separates takes no longer than it should, and never finds an earlier hit.
    const auto sliding = cast(a.shape, a.pose, a.velocity, b.shape, b.pose, b.velocity, T(1), {Separating::ignored});
    if (sliding && sliding->status == Status::converged) {
      ASSERT_TRUE(hit) << text;
      EXPECT_GE(sliding->t, hit->t) << text;
    }
  }
  EXPECT_GT(hits, count / 4);
  EXPECT_GT(misses, count / 4);
  EXPECT_LE(unknown, 1);  // a hair's breadth that no number of steps resolves
}

TEST(CastLattice, InDouble) { check_lattice<double>(1, 2000); }
TEST(CastLattice, InFloat) { check_lattice<float>(1, 2000); }
TEST(CastLattice, Small) { check_lattice<double>(1e-4f, 1000); }
TEST(CastLattice, Large) { check_lattice<double>(1e4f, 1000); }

}  // namespace
}  // namespace graze::testing
