// What is solved across lanes has the bits of what is solved alone, at every level of the instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

#include "dynamics/body_kernels.hpp"
#include "dynamics/contact_bundles.hpp"

namespace graze::testing {
namespace {

template <class Space>
struct KernelsOf;
template <template <class> class SpaceOfT, class Number>
struct KernelsOf<SpaceOfT<Number>> {
  using T = Number;
};

/// Random numbers in all members of structs of numbers.
template <class Space>
class RandomBodies {
 public:
  using T = typename KernelsOf<Space>::T;
  using Vec = typename Space::Vec;

  explicit RandomBodies(unsigned seed) : generator_(seed) {}

  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(generator_()) % end; }
  T number() { return T(std::uniform_real_distribution<double>(-1, 1)(generator_)); }
  template <class Struct>
  Struct numbers() {
    T all[sizeof(Struct) / sizeof(T)];
    for (T& x : all) x = number();
    Struct s;
    std::memcpy(static_cast<void*>(&s), all, sizeof s);
    return s;
  }
  RotationIn<Space> rotation() { return normalized(numbers<RotationIn<Space>>()); }

  /// Moves with what it was given where it cannot be pushed.
  SolverBody<T, Space> body(bool movable) {
    SolverBody<T, Space> b;
    // Of some that are at rest there are zeros of both signs.
    b.linear = b.linear_before = numbers<Vec>() * T(below(4) == 0 ? 0 : 1);
    b.angular = b.angular_before = numbers<typename Space::Turning>();
    b.first_center = numbers<Vec>();
    b.moved = numbers<Vec>() * T(0.01);
    b.center = b.first_center + b.moved;
    b.first_rotation = b.rotation = rotation();
    if (movable) b.mass = {T(1) + number() / T(2), in_world(positive(), b.rotation)};
    return b;
  }
  typename Rigid<Space>::PrincipalInertia positive() {
    return above_zero(numbers<typename Rigid<Space>::PrincipalInertia>());
  }
  SolverPoint<T, Space> point() {
    SolverPoint<T, Space> p;
    p.a = numbers<Vec>();
    p.distance = number() * T(0.01);
    p.b = p.a + numbers<Vec>() * T(0.01);
    if (below(3) != 0) p.impulse = numbers<Vec>();
    return p;
  }
  Touching<T, Space> touching() {
    Touching<T, Space> t;
    t.material.static_friction = T(0.5) + number() / T(2);
    t.material.dynamic_friction = t.material.static_friction * T(0.9);
    if (below(4) == 0) t.material.rolling_friction = T(0.1);
    if (below(4) == 0) t.belt = numbers<Vec>();
    t.size = T(1);
    return t;
  }
  Vec direction() {
    const Vec v = numbers<Vec>();
    return below(3) == 0 ? first_axis(v) : normalized(v);
  }

 private:
  /// Along the first axis, with zeros of the signs of the others.
  static Vec3<T> first_axis(const Vec3<T>& v) { return {T(1), v.y * T(0), v.z * T(0)}; }
  static plane::Vec2<T> first_axis(const plane::Vec2<T>& v) { return {T(1), v.y * T(0)}; }
  static Vec3<T> above_zero(const Vec3<T>& v) { return abs(v) + Vec3<T>{T(0.5), T(0.5), T(0.5)}; }
  static T above_zero(T v) { return std::abs(v) + T(0.5); }

  std::mt19937 generator_;
};

std::vector<Isa> levels() {
  std::vector<Isa> all;
  for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512})
    if (isa_available(level)) all.push_back(level);
  return all;
}

/// Contacts of which no two share a body that can be pushed, some of several manifolds, and some on a floor.
template <class Space>
struct ContactScene {
  using T = typename KernelsOf<Space>::T;

  explicit ContactScene(unsigned seed) {
    RandomBodies<Space> random(seed);
    bodies.push_back(random.body(false));
    movable.push_back(0);
    const std::uint32_t count = 1 + random.below(40);
    manifolds.reserve(4 * count);
    for (std::uint32_t i = 0; i < count; ++i) {
      for (int k = 0; k < 2; ++k) {
        bodies.push_back(random.body(true));
        movable.push_back(1);
      }
      const auto last = static_cast<std::uint32_t>(bodies.size() - 1);
      const std::uint32_t other = random.below(3) == 0 ? 0 : last - 1;
      touching.push_back(random.below(2) == 0 ? TouchingBodies<T, Space>{last, other, random.touching()}
                                              : TouchingBodies<T, Space>{other, last, random.touching()});
      const std::uint32_t several = random.below(4) == 0 ? 1 + random.below(3) : 1;
      first.push_back(manifolds.size());
      for (std::uint32_t k = 0; k < several; ++k) {
        ContactManifold<T, Space> m{};
        m.normal = random.direction();
        m.first_point = static_cast<std::uint32_t>(points.size());
        m.point_count = 1 + random.below(5);
        for (std::uint32_t p = 0; p < m.point_count; ++p) points.push_back(random.point());
        manifolds.push_back(m);
      }
    }
    first.push_back(manifolds.size());
  }

  /// Two sub-steps of the contacts from `begin` to `end`, in bundles.
  void solve(Isa level, std::size_t begin, std::size_t end) {
    ContactBundles<T, Space> bundles(level);
    bundles.clear();
    for (std::size_t i = begin; i < end; ++i)
      bundles.add(touching[i], std::span(manifolds).subspan(first[i], first[i + 1] - first[i]));
    bundles.build(movable);
    ASSERT_EQ(bundles.colors().size(), 1u);
    const ContactStep<T> step = contact_step(SubStep<T>{T(0.01), T(100), T(0.02), false}, T(10), T(0.02), 2);
    const auto each = [&](const auto& f) {
      for (std::size_t chunk = 0; chunk < bundles.chunk_count(); ++chunk)
        for (const auto& bundle : bundles.bundles_of(chunk)) f(bundles.kernels_of(bundle), bundle);
    };
    each([&](const auto& k, const auto& b) {
      k.prepare(b, bodies.data(), points.data(), T(0.01), WarmStart<T>{T(0.5), T(0.5), T(0)});
    });
    for (int i = 0; i < 2; ++i) {
      each([&](const auto& k, const auto& b) { k.warm_start(b, bodies.data()); });
      each([&](const auto& k, const auto& b) { k.solve(b, bodies.data(), step, true); });
      each([&](const auto& k, const auto& b) { k.solve(b, bodies.data(), step, false); });
    }
    each([&](const auto& k, const auto& b) { fastest = greatest(fastest, k.approach(b, bodies.data())); });
    each([&](const auto& k, const auto& b) { k.store(b, T(2), points.data()); });
  }

  std::vector<SolverBody<T, Space>> bodies;
  std::vector<std::uint8_t> movable;
  std::vector<TouchingBodies<T, Space>> touching;
  std::vector<std::size_t> first;  ///< manifolds of each contact
  std::vector<ContactManifold<T, Space>> manifolds;
  std::vector<SolverPoint<T, Space>> points;
  T fastest{};
};

template <class Struct>
bool same_bits(const Struct& a, const Struct& b) {
  return std::memcmp(static_cast<const void*>(&a), static_cast<const void*>(&b), sizeof a) == 0;
}

template <class Space>
class DynamicsKernels : public ::testing::Test {};
using Spaces = ::testing::Types<Space<float>, Space<double>, plane::Space<float>, plane::Space<double>>;
TYPED_TEST_SUITE(DynamicsKernels, Spaces);

TYPED_TEST(DynamicsKernels, ContactsHaveTheBitsOfEachAlone) {
  std::size_t pushed = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    ContactScene<TypeParam> alone(seed);
    const ContactScene<TypeParam> before = alone;
    for (std::size_t i = 0; i < alone.touching.size(); ++i) alone.solve(Isa::baseline, i, i + 1);
    EXPECT_TRUE(same_bits(alone.bodies[0], before.bodies[0]));
    for (std::size_t i = 1; i < alone.bodies.size(); ++i)
      pushed += same_bits(alone.bodies[i].linear, before.bodies[i].linear) ? 0 : 1;
    for (const Isa level : levels()) {
      ContactScene<TypeParam> together(seed);
      together.solve(level, 0, together.touching.size());
      EXPECT_EQ(together.fastest, alone.fastest);
      for (std::size_t i = 0; i < alone.bodies.size(); ++i) {
        const auto &a = alone.bodies[i], &b = together.bodies[i];
        ASSERT_TRUE(same_bits(a.linear, b.linear) && same_bits(a.angular, b.angular)) << seed << ", " << i;
        ASSERT_TRUE(same_bits(a.pressure, b.pressure)) << seed << ", " << i;
      }
      for (std::size_t i = 0; i < alone.points.size(); ++i)
        ASSERT_EQ(alone.points[i].impulse, together.points[i].impulse) << seed << ", " << i;
    }
  }
  EXPECT_GT(pushed, 1000u);
}

/// Bodies in a block, and each in one of its own; some spin so fast that they take several steps of rotation.
TYPED_TEST(DynamicsKernels, BodiesHaveTheBitsOfEachAlone) {
  using T = typename KernelsOf<TypeParam>::T;
  using State = IslandBody<T, TypeParam>;
  using Body = SolverBody<T, TypeParam>;
  RandomBodies<TypeParam> random(5);
  const std::size_t count = 37;
  std::vector<State> states(count);
  std::vector<Body> bodies;
  for (State& s : states) {
    const Body& b = bodies.emplace_back(random.body(true));
    s.free.center = b.center;
    s.free.rotation = b.rotation;
    s.free.linear = b.linear;
    s.free.inverse_inertia = random.positive();
    s.free.angular_momentum =
        random.template numbers<typename TypeParam::Turning>() * (random.below(3) == 0 ? T(30) : T(1));
    s.world_inertia = in_world(random.positive(), b.rotation);
    s.influences.acceleration = random.template numbers<typename TypeParam::Vec>();
    s.influences.angular_damping = T(0.1);
    s.influences.share = random.below(3) == 0 ? T(0.5) : T(1);
  }
  const SubStep<T> time{T(0.01), T(100), T(0.02), false};
  const auto play = [&](Isa level, std::size_t block) {
    auto s = states;
    auto b = bodies;
    const auto& kernels = GRAZE_KERNEL(level, body_kernels)().template of<T, TypeParam>();
    for (std::size_t i = 0; i < count; i += block) {
      const BodyBlock<T, TypeParam> bodies_here{&s[i], &b[i], std::min(block, count - i)};
      kernels.begin(bodies_here, time);
      for (std::size_t k = i; k < i + bodies_here.count; ++k) {
        // What rows may do.
        b[k].angular += bodies[k].linear_before.x > T(0) ? bodies[k].angular : typename TypeParam::Turning{};
        b[k].pressure.kind = T(k % 3);
        b[k].pressure.normal = normalized(bodies[k].first_center);
      }
      kernels.move(bodies_here, time);
      for (std::size_t k = i; k < i + bodies_here.count; ++k) b[k].linear += bodies[k].linear;
      kernels.end(bodies_here);
    }
    return std::pair(s, b);
  };
  const auto [expected_states, expected] = play(Isa::baseline, 1);
  for (const Isa level : levels()) {
    for (const std::size_t block : {std::size_t{1}, std::size_t{5}, count}) {
      const auto [s, b] = play(level, block);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(same_bits(expected_states[i].free, s[i].free)) << block << ", " << i;
        ASSERT_TRUE(same_bits(expected[i].moved, b[i].moved) && same_bits(expected[i].turned, b[i].turned)) << i;
        ASSERT_TRUE(same_bits(expected[i].angular, b[i].angular)) << i;
      }
    }
  }
}

}  // namespace
}  // namespace graze::testing
