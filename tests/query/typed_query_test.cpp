// Questions about shapes whose kinds the compiler knows: to the last bit what the shapes are answered as `Shape`s.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>

#include "common/specimen.hpp"
#include "graze/query.hpp"
#include "graze/typed_query.hpp"

namespace graze::testing::typed_query {
namespace {

template <class T>
bool same_bits(T a, T b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
template <class T>
bool same_bits(const Vec3<T>& a, const Vec3<T>& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}
template <class T>
bool same_bits(const Distance<T>& a, const Distance<T>& b) {
  return same_bits(a.distance, b.distance) && same_bits(a.normal, b.normal) && same_bits(a.a, b.a) &&
         same_bits(a.b, b.b) && a.status == b.status && same_bits(a.error, b.error);
}
template <class T>
bool same_bits(const ContactPoint<T>& a, const ContactPoint<T>& b) {
  return same_bits(a.a, b.a) && same_bits(a.b, b.b) && same_bits(a.distance, b.distance) && a.feature == b.feature &&
         same_bits(a.weight, b.weight);
}
template <class T, std::size_t N>
bool same_bits(const FixedManifold<T, N>& a, const Manifold<T>& b) {
  if (a.points.size() != b.points.size()) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    if (!same_bits(a.points[i], b.points[i])) return false;
  return same_bits(a.normal, b.normal) && a.status == b.status && same_bits(a.error, b.error);
}

/// A shape of the kind as the user of typed queries has it.
template <template <class> class C>
struct Made;
template <>
struct Made<Sphere> {
  static constexpr Kind kinds[] = {Kind::sphere};
};
template <>
struct Made<Capsule> {
  static constexpr Kind kinds[] = {Kind::capsule, Kind::capsule, Kind::capsule, Kind::tapered_capsule};
};
template <>
struct Made<Box> {
  static constexpr Kind kinds[] = {Kind::box};
};
template <>
struct Made<Triangle> {
  static constexpr Kind kinds[] = {Kind::triangle};
};

template <template <class> class C, class T>
struct Posture {
  C<T> shape;
  Pose<T> pose;
};

/// How the shapes of a pair are made: at random; of equal, thin and flat shapes in half steps and quarter turns; and
/// turned from there by less than a face leans.
enum class Way { random, lattice, leaning };

template <template <class> class C, class T>
Posture<C, T> make(Way way, Random& random) {
  const auto& kinds = Made<C>::kinds;
  const Kind kind = kinds[random() % std::size(kinds)];
  Specimen specimen = way == Way::random ? random_specimen(kind, 1, random) : degenerate_specimen(kind, 1, random);
  specimen.margin = 0;
  PlacedSpecimen placed{specimen, random_vector(random, 0.8f), random_rotation(random)};
  if (way != Way::random) placed = on_lattice(specimen, 1, random);
  Pose<T> pose = pose_of<T>(placed);
  if (way == Way::leaning) {
    const Vec3f turn = random_vector(random, random() % 2 == 0 ? 1e-3f : 1e-6f);
    pose.rotation = pose.rotation * Quat<T>{T(turn.x), T(turn.y), T(turn.z), T(1)};
    pose.translation = pose.translation + converted<T>(random_vector(random, 1e-2f));
  }
  const Shape<T> shape = build<T>(specimen);
  const C<T>& concrete = *shape.template as<C<T>>();
  if constexpr (std::is_same_v<C<T>, Sphere<T>>)
    if (random() % 2 == 0) return {Sphere<T>(concrete.radius(), converted<T>(random_vector(random, 0.5f))), pose};
  return {concrete, pose};
}

/// What was asked about, so that no kind of answer goes untested.
struct Tally {
  std::size_t asked = 0, overlapping = 0, points[9] = {};
};

template <template <class> class A, template <class> class B, class T>
::testing::AssertionResult as_shapes(Random& random, Tally& tally) {
  const Way way = static_cast<Way>(random() % 3);
  const auto a = make<A, T>(way, random);
  const auto b = make<B, T>(way, random);
  const Shape<T> shape_a = a.shape, shape_b = b.shape;
  const T margins[] = {T(0), T(0.02), T(0.5), T(10)};
  const T margin = margins[random() % 4];
  const auto what = [&](const char* query) {
    return ::testing::AssertionFailure() << query << " of " << shape_a.name() << " and " << shape_b.name()
                                         << (sizeof(T) == 4 ? " in float" : " in double") << ", pair " << tally.asked;
  };
  tally.asked += 1;
  const bool touch = overlap(shape_a, a.pose, shape_b, b.pose);
  if (overlap(a.shape, a.pose, b.shape, b.pose) != touch) return what("overlap");
  if (!same_bits(distance(a.shape, a.pose, b.shape, b.pose), distance(shape_a, a.pose, shape_b, b.pose)))
    return what("distance");

  Manifolds<T> manifolds;
  const bool deep = contacts(shape_a, a.pose, shape_b, b.pose, margin, manifolds);
  const auto found = contacts(a.shape, a.pose, b.shape, b.pose, margin);
  static_assert(std::is_same_v<decltype(found), const FixedManifold<T, most_contacts<A, B>>>);
  static_assert(most_contacts<A, B> == most_contacts<B, A>);
  if (found.overlap != deep) return what("overlap by contacts");
  if (found.points.empty() != manifolds.empty()) return what("whether there are contacts");
  if (!manifolds.empty() && (manifolds.size() != 1 || !same_bits(found, manifolds[0]))) return what("contacts");
  tally.overlapping += touch;
  tally.points[found.points.size()] += 1;
  return ::testing::AssertionSuccess();
}

/// Calls `f` with the kinds of each pair in both orders as its templates' arguments.
template <class F>
void each_pair(const F& f) {
  f.template operator()<Sphere, Sphere>();
  f.template operator()<Sphere, Capsule>();
  f.template operator()<Sphere, Box>();
  f.template operator()<Sphere, Triangle>();
  f.template operator()<Capsule, Sphere>();
  f.template operator()<Capsule, Capsule>();
  f.template operator()<Capsule, Box>();
  f.template operator()<Capsule, Triangle>();
  f.template operator()<Box, Sphere>();
  f.template operator()<Box, Capsule>();
  f.template operator()<Box, Box>();
  f.template operator()<Triangle, Sphere>();
  f.template operator()<Triangle, Capsule>();
}

RC_GTEST_PROP(TypedQuery, AnswersWithTheBitsOfShapes, (std::uint64_t seed)) {
  Random random(seed);
  each_pair([&]<template <class> class A, template <class> class B>() {
    Tally tally;
    for (int i = 0; i < 20; ++i) {
      const auto in_float = as_shapes<A, B, float>(random, tally), in_double = as_shapes<A, B, double>(random, tally);
      if (!in_float) RC_FAIL(in_float.message());
      if (!in_double) RC_FAIL(in_double.message());
    }
  });
}

TEST(TypedQuery, IsTestedOnPairsThatTouchInAnyNumberOfPoints) {
  Random random(7);
  each_pair([&]<template <class> class A, template <class> class B>() {
    Tally tally;
    for (int i = 0; i < 2000; ++i) ASSERT_TRUE((as_shapes<A, B, float>(random, tally)));
    EXPECT_GT(tally.overlapping, tally.asked / 10);
    EXPECT_LT(tally.overlapping, tally.asked * 9 / 10);
    for (std::size_t count = 0; count <= most_contacts<A, B>; ++count)
      EXPECT_GT(tally.points[count], 0u) << A<float>::name << ", " << B<float>::name << ", " << count << " points";
  });
}

/// Shapes in a `Shape` are asked by the general entry, and kinds without typed queries have none.
static_assert(TypedPair<Box, Sphere> && TypedPair<Triangle, Capsule>);
static_assert(!TypedPair<Triangle, Triangle> && !TypedPair<Cylinder, Sphere> && !TypedPair<Shape, Shape>);

}  // namespace
}  // namespace graze::testing::typed_query
