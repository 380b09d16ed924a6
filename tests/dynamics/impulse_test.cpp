// A blow between two bodies: against closed forms, an independent solution by matrices, and what must stay.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "graze/impulse.hpp"

namespace graze::testing {
namespace {

template <class T>
StruckBody<T> ball(T mass, T radius, const Vec3<T>& center, const Vec3<T>& linear, const Vec3<T>& angular = {}) {
  return {{linear, angular, center}, inverse_mass(mass, inertia_of(Shape<T>(Sphere<T>(radius)), mass))};
}

template <class T>
class Impulse : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Impulse, Scalars);

TYPED_TEST(Impulse, BallsInLineGoOnAsTheLawOfImpactSays) {
  using T = TypeParam;
  const T m1(2), m2(3), v1(5), v2(-1), tiny = T(64) * std::numeric_limits<T>::epsilon();
  for (const T e : {T(0), T(0.5), T(1)}) {
    const auto r = response<T>({{1, 0, 0}, {1, 0, 0}, e, T(0.6)}, ball<T>(m1, 1, {}, {v1, 0, 0}),
                               ball<T>(m2, 1, {2, 0, 0}, {v2, 0, 0}));
    const T together = (m1 * v1 + m2 * v2) / (m1 + m2);
    EXPECT_NEAR(r.a.linear.x, together - e * m2 * (v1 - v2) / (m1 + m2), tiny);
    EXPECT_NEAR(r.b.linear.x, together + e * m1 * (v1 - v2) / (m1 + m2), tiny);
    EXPECT_NEAR(r.effective_mass, m1 * m2 / (m1 + m2), tiny);
    EXPECT_EQ(r.at_fault, AtFault::both);
  }
}

// A ball with back spin on the ground: friction stops the point of contact as soon as μ j >= 2/7 m |v_t|.
TYPED_TEST(Impulse, ASpinningBallRollsOrSlides) {
  using T = TypeParam;
  const T mass(3), radius(0.5), down(4), spin(6), tiny = T(64) * std::numeric_limits<T>::epsilon();
  const StruckBody<T> ground{{}, {}};
  const auto thrown = ball<T>(mass, radius, {0, radius, 0}, {0, -down, 0}, {0, 0, spin});
  const auto rolls = response<T>({{0, 0, 0}, {0, 1, 0}, T(0.5), T(0.6)}, ground, thrown);
  EXPECT_TRUE(rolls.holds());
  EXPECT_NEAR(rolls.normal_impulse, mass * down * T(1.5), T(8) * tiny);
  EXPECT_NEAR(rolls.b.linear.x, -spin * radius * T(2) / T(7), tiny);
  EXPECT_NEAR(rolls.b.angular.z, spin * T(2) / T(7), tiny);
  EXPECT_EQ(rolls.at_fault, AtFault::b);
  const auto slides = response<T>({{0, 0, 0}, {0, 1, 0}, T(0.5), T(0.01)}, ground, thrown);
  EXPECT_FALSE(slides.holds());
  EXPECT_NEAR(slides.b.linear.x, -T(0.01) * down * T(1.5), tiny);
  EXPECT_EQ(slides.a.linear, Vec3<T>{});
  EXPECT_EQ(slides.a.angular, Vec3<T>{});
}

// A rod hit at its end turns about the point a third of the way along it, which stays: the centre of percussion.
TYPED_TEST(Impulse, ARodHitAtItsEndTurnsAboutItsCenterOfPercussion) {
  using T = TypeParam;
  const T tiny = T(64) * std::numeric_limits<T>::epsilon();
  const T mass(2), length(3), inertia = mass * length * length / T(12);
  const StruckBody<T> rod{{}, inverse_mass(mass, Vec3<T>{inertia, inertia, inertia})};
  const StruckBody<T> wall{{{0, 0, 4}, {}, {0, 0, -1}}, {}};  // moves on into the rod
  const auto r = response<T>({{length / 2, 0, 0}, {0, 0, 1}, T(0), T(0)}, wall, rod);
  EXPECT_NEAR(r.effective_mass, mass / T(4), tiny);
  EXPECT_NEAR(velocity_at(r.b, Vec3<T>{length / 2, 0, 0}).z, T(4), T(4) * tiny);
  EXPECT_NEAR(velocity_at(r.b, Vec3<T>{-length / 6, 0, 0}).z, T(0), T(4) * tiny);
}

TYPED_TEST(Impulse, WhatPartsIsLeftAlone) {
  using T = TypeParam;
  for (const T speed : {T(0), T(1)}) {
    const auto a = ball<T>(1, 1, {}, {-speed, T(0.3), 0}, {1, 2, 3}), b = ball<T>(2, 1, {2, 0, 0}, {speed, 0, 0});
    const auto r = response<T>({{1, 0, 0}, {1, 0, 0}, T(1), T(0.6)}, a, b);
    EXPECT_EQ(r.normal_impulse, T(0));
    EXPECT_EQ(r.impulse, Vec3<T>{});
    EXPECT_EQ(r.a.linear, a.motion.linear);
    EXPECT_EQ(r.a.angular, a.motion.angular);
    EXPECT_EQ(r.b.linear, b.motion.linear);
    EXPECT_EQ(r.at_fault, AtFault::neither);
  }
}

/// A negative restitution, which would pull, gives no impulse at all.
TYPED_TEST(Impulse, NothingPulls) {
  using T = TypeParam;
  const auto r = response<T>({{1, 0, 0}, {1, 0, 0}, T(-3), T(0.6)}, ball<T>(1, 1, {}, {2, T(0.5), 0}),
                             ball<T>(2, 1, {2, 0, 0}, {}));
  EXPECT_EQ(r.normal_impulse, T(0));
  EXPECT_EQ(r.impulse, Vec3<T>{});
}

TYPED_TEST(Impulse, TwoImmovableBodiesGoOn) {
  using T = TypeParam;
  const auto r = response<T>({{}, {1, 0, 0}, T(1), T(0.6)}, {{{1, 0, 0}, {}, {}}, {}}, {{{-1, 0, 0}, {}, {}}, {}});
  EXPECT_EQ(r.impulse, Vec3<T>{});
  EXPECT_EQ(r.a.linear, (Vec3<T>{1, 0, 0}));
  EXPECT_TRUE(std::isinf(r.effective_mass));
}

/// Two bodies with masses and inertias over three decades that meet somewhere, from a seed.
struct Meeting {
  StruckContact<double> contact;
  StruckBody<double> a, b;
  double masses[2];
  Mat3d inertias[2];  ///< in world space
};

Meeting meeting(std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&](double size) { return Vec3d{unit(engine), unit(engine), unit(engine)} * size; };
  Meeting m;
  m.contact.point = vector(10);
  m.contact.normal = normalized(vector(1));
  m.contact.restitution = std::abs(unit(engine));
  m.contact.friction = std::abs(unit(engine));
  int i = 0;
  for (StruckBody<double>* body : {&m.a, &m.b}) {
    const double mass = std::pow(10, 1.5 * unit(engine));
    // Of three weights on the axes, so that the triangle inequality holds.
    const Vec3d w = abs(vector(mass)) + Vec3d{mass, mass, mass} * 1e-2;
    const Vec3d inertia{w.y + w.z, w.z + w.x, w.x + w.y};
    const Quatd turn = normalized(Quatd{unit(engine), unit(engine), unit(engine), unit(engine)});
    body->motion = {vector(5), vector(5), m.contact.point + vector(2)};
    body->mass = inverse_mass(mass, inertia, turn);
    const Mat3d r = rotation_matrix(turn);
    m.masses[i] = mass;
    m.inertias[i++] = r * Mat3d::diagonal(inertia) * transposed(r);
  }
  if (relative_velocity<double>({m.contact.point, m.contact.point}, m.contact.normal, m.a.motion, m.b.motion).normal >
      0)
    m.contact.normal = -m.contact.normal;
  return m;
}

RC_GTEST_PROP(Impulse, MomentumAndAngularMomentumStay, (std::uint32_t seed)) {
  const Meeting m = meeting(seed);
  const auto r = response(m.contact, m.a, m.b);
  RC_ASSERT(r.normal_impulse >= 0.0);
  const auto both = [&](const Motion<double>& a, const Motion<double>& b) {
    return std::array{a.linear * m.masses[0] + b.linear * m.masses[1],
                      cross(a.center, a.linear) * m.masses[0] + m.inertias[0] * a.angular +
                          cross(b.center, b.linear) * m.masses[1] + m.inertias[1] * b.angular};
  };
  const auto before = both(m.a.motion, m.b.motion), after = both(r.a, r.b);
  const double size = (m.masses[0] + m.masses[1]) * (length(r.a.linear) + length(r.b.linear) + 10);
  RC_ASSERT(length(after[0] - before[0]) <= 1e-13 * size);
  RC_ASSERT(length(after[1] - before[1]) <= 1e-12 * size * 12);
}

RC_GTEST_PROP(Impulse, WithoutFrictionTheReboundIsTheRestitutionAndEnergyDoesNotGrow, (std::uint32_t seed)) {
  Meeting m = meeting(seed);
  m.contact.friction = 0;
  const auto r = response(m.contact, m.a, m.b);
  const auto after = relative_velocity<double>({m.contact.point, m.contact.point}, m.contact.normal, r.a, r.b);
  const double speed = length(r.approach.whole) + length(after.whole);
  RC_ASSERT(std::abs(after.normal + m.contact.restitution * r.approach.normal) <= 1e-12 * speed);
  const auto energy = [&](const Motion<double>& a, const Motion<double>& b) {
    return kinetic_energy(a, m.masses[0], m.inertias[0]) + kinetic_energy(b, m.masses[1], m.inertias[1]);
  };
  RC_ASSERT(energy(r.a, r.b) <= energy(m.a.motion, m.b.motion) * (1 + 1e-12));
}

/// The matrix of `v ↦ r × v`.
Mat3d cross_matrix(const Vec3d& r) { return {{{0, -r.z, r.y}, {r.z, 0, -r.x}, {-r.y, r.x, 0}}}; }

// The same blow by matrices: K is built from those of the cross products, and friction that holds is the impulse which
// ends the sliding and lies in the tangent plane, one system of three equations, by Cramer's rule.
RC_GTEST_PROP(Impulse, AgreesWithTheFormOfMatrices, (std::uint32_t seed)) {
  const Meeting m = meeting(seed);
  const Vec3d& n = m.contact.normal;
  Mat3d k = Mat3d::identity() * (1 / m.masses[0] + 1 / m.masses[1]);
  for (const auto* body : {&m.a, &m.b}) {
    const Mat3d r = cross_matrix(m.contact.point - body->motion.center);
    k = k - r * body->mass.inertia * r;
  }
  const auto v = relative_velocity<double>({m.contact.point, m.contact.point}, n, m.a.motion, m.b.motion);
  const double j = -(1 + m.contact.restitution) * v.normal / dot(n, k * n);
  const Vec3d left = v.whole + (k * n) * j;
  const Mat3d across = Mat3d::identity() - outer(n, n), system = across * k * across + outer(n, n);
  const Vec3d wanted = -(across * left);
  Vec3d p{};
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Vec3d, 3> c{system.column(0), system.column(1), system.column(2)};
    c[i] = wanted;
    p[i] = determinant(Mat3d::from_columns(c[0], c[1], c[2])) / determinant(system);
  }
  const double limit = m.contact.friction * j;
  const Vec3d friction = length(p) > limit ? p * (limit / length(p)) : p;
  const auto r = response(m.contact, m.a, m.b);
  RC_ASSERT(length(r.impulse - (n * j + friction)) <= 1e-10 * (j + length(p)));
}

RC_GTEST_PROP(Impulse, DoesNotDependOnWhichBodyIsA, (std::uint32_t seed)) {
  const Meeting m = meeting(seed);
  StruckContact<double> swapped = m.contact;
  swapped.normal = -swapped.normal;
  const auto r = response(m.contact, m.a, m.b), s = response(swapped, m.b, m.a);
  RC_ASSERT(length(r.impulse + s.impulse) <= 1e-10 * length(r.impulse));
  RC_ASSERT(length(r.a.linear - s.b.linear) <= 1e-10 * (length(r.a.linear) + length(r.impulse) / m.masses[0]));
}

TEST(InverseMass, InfinityIsImmovable) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(inverse_mass(infinity, Vec3d{1, 2, 3}).movable());
  EXPECT_EQ(inverse_mass(infinity, Vec3d{1, 2, 3}).inertia.row[1], Vec3d{});
  const auto stiff = inverse_mass(2.0, Vec3d{infinity, 4, infinity});
  EXPECT_EQ(stiff.mass, 0.5);
  EXPECT_EQ(stiff.inertia.row[0], Vec3d{});
  EXPECT_EQ(stiff.inertia.row[1], (Vec3d{0, 0.25, 0}));
}

TEST(InverseMass, ATensorAndItsDiagonalAgree) {
  const Quatd turn = normalized(Quatd{0.1, -0.4, 0.3, 0.8});
  for (const double scale : {1e-100, 1.0, 1e100}) {
    const auto by_diagonal = inverse_mass(1.0, Vec3d{2, 3, 4} * scale, turn);
    const auto by_tensor = inverse_mass(1.0, Mat3d::diagonal(Vec3d{2, 3, 4} * scale), turn);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LE(length(by_diagonal.inertia.row[i] - by_tensor.inertia.row[i]) * scale, 1e-15);
  }
}

TEST(InverseMass, WhatIsNoneIsNamed) {
  const auto path_of = [](auto&& f) -> std::string {
    try {
      f();
    } catch (const InvalidValue& e) {
      return e.path();
    }
    return "accepted";
  };
  const double nan = std::nan("");
  for (const double mass : {0.0, -1.0, nan, 1e-320})
    EXPECT_EQ(path_of([&] { inverse_mass(mass, Vec3d{1, 1, 1}); }), "mass") << mass;
  EXPECT_EQ(path_of([] { inverse_mass(1.0, Vec3d{1, 0, 1}); }), "inertia[1]");
  EXPECT_EQ(path_of([&] { inverse_mass(1.0, Vec3d{1, 1, nan}); }), "inertia[2]");
  EXPECT_EQ(path_of([] { inverse_mass(1.0, Vec3d{1, 1, 3}); }), "inertia[2]");
  EXPECT_EQ(path_of([] { inverse_mass(1.0f, Vec3f{3, 1, 1}); }), "inertia[0]");
  EXPECT_EQ(path_of([] { inverse_mass(1.0, Mat3d::diagonal({1, 1, -1})); }), "inertia");
  EXPECT_EQ(path_of([] { inverse_mass(1.0, Mat3d{}); }), "inertia");
  EXPECT_EQ(path_of([] { inverse_mass(1.0, Mat3d::diagonal({1, 3, 1})); }), "inertia");
  Mat3d lopsided = Mat3d::diagonal({2, 2, 2});
  lopsided.row[0].y = 1e-9;
  EXPECT_EQ(path_of([&] { inverse_mass(1.0, lopsided); }), "accepted");
  lopsided.row[0].y = 1;
  EXPECT_EQ(path_of([&] { inverse_mass(1.0, lopsided); }), "inertia");
  // A flat plate reaches the limit of the triangle inequality, turned or not, in any unit; beyond it there is no body.
  const Mat3d turn = rotation_matrix(normalized(Quatd{0.3, -0.2, 0.5, 0.8}));
  const auto turned = [&](const Vec3d& moments) { return turn * Mat3d::diagonal(moments) * transposed(turn); };
  for (const double scale : {1e-9, 1.0, 1e9}) {
    EXPECT_EQ(path_of([&] { inverse_mass(1.0, turned(Vec3d{3, 1, 2} * scale)); }), "accepted");
    EXPECT_EQ(path_of([&] { inverse_mass(1.0, turned(Vec3d{3.001, 1, 2} * scale)); }), "inertia");
    EXPECT_EQ(path_of([&] { inverse_mass(1.0, Vec3d{3, 1, 2} * scale); }), "accepted");
  }
  EXPECT_EQ(path_of([] { inertia_of(Shaped(Rectangle<double>(1, 1)), 1.0); }), "shape");
}

}  // namespace
}  // namespace graze::testing
