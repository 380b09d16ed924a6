// Contacts whose depth is not proven say so: of convex pairs, of pieces of composites, joined or not.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/query.hpp"

namespace graze::testing {
namespace {

template <class T>
class BoundedContacts : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(BoundedContacts, Scalars);

/// A body of revolution about a small other one, nearly concentric: what leaves a search for the depth little to hold
/// on to. The first stands at the origin, so that a composite rounds nothing that places it.
std::pair<PlacedSpecimen, PlacedSpecimen> sphere_capsule_pair(Random& random) {
  static constexpr Kind kinds[] = {Kind::tapered_capsule, Kind::cylinder, Kind::cone, Kind::truncated_cone};
  const bool small_first = random() % 2 == 0;
  PlacedSpecimen a{random_specimen(kinds[random() % 4], small_first ? 1e-3f : 1.0f, random), {}, {}},
      b{random_specimen(kinds[random() % 4], small_first ? 1.0f : 1e-3f, random), random_vector(random, 1e-8f), {}};
  if (random() % 2 == 0) b.rotation = random_rotation(random);
  return {a, b};
}

/// How sure of their depths several manifolds are together.
template <class T>
T error_of(const Manifolds<T>& manifolds) {
  T error(0);
  for (const Manifold<T>& m : manifolds) {
    EXPECT_EQ(m.status == Status::bounded, m.error > T(0));
    error = greatest(error, m.error);
  }
  return error;
}

TYPED_TEST(BoundedContacts, AreSoWhereTheDistanceIs) {
  using T = TypeParam;
  Random random(1);
  int bounded = 0, proven = 0;
  for (int i = 0; i < 500; ++i) {
    const auto [a, b] = sphere_capsule_pair(random);
    const Shape<T> of_a = build<T>(a.specimen), of_b = build<T>(b.specimen);
    const Pose<T> at_a = pose_of<T>(a), at_b = pose_of<T>(b);
    const Pose<T> origin{};
    const Shape<T> alone = Compound<T>({Placed<T>{of_a, at_a}}),
                   twice = Compound<T>({Placed<T>{of_a, at_a}, Placed<T>{of_a, at_a}});
    for (const bool swapped : {false, true}) {
      const Distance<T> d = swapped ? distance(of_b, at_b, of_a, at_a) : distance(of_a, at_a, of_b, at_b);
      Manifolds<T> found;
      swapped ? contacts(of_b, at_b, of_a, at_a, T(0), found) : contacts(of_a, at_a, of_b, at_b, T(0), found);
      ASSERT_EQ(found.size(), 1u);
      (d.status == Status::bounded ? bounded : proven) += 1;
      // Two of a kind are asked both ways round for their distance, and the surer answer counts.
      if (of_a.index() != of_b.index()) {
        EXPECT_EQ(found[0].status, d.status) << describe(a) << "\n" << describe(b);
        EXPECT_EQ(found[0].error, d.status == Status::bounded ? d.error : T(0));
      }
      // Pieces of composites are as sure as they are alone, and a manifold that several make as the least sure.
      for (const Shape<T>& whole : {alone, twice}) {
        Manifolds<T> of_pieces;
        EXPECT_TRUE(swapped ? contacts(of_b, at_b, whole, origin, T(0), of_pieces)
                            : contacts(whole, origin, of_b, at_b, T(0), of_pieces));
        EXPECT_EQ(error_of(of_pieces), error_of(found)) << describe(a) << "\n" << describe(b);
      }
    }
  }
  EXPECT_GE(bounded, 20);
  EXPECT_GE(proven, 100);
}

// Boxes and balls are proven, and what joins their manifolds leaves it so.
TYPED_TEST(BoundedContacts, AreNoneOfPiecesThatAreProven) {
  using T = TypeParam;
  const Shape<T> box = Box<T>({T(1), T(1), T(1)});
  const Shape<T> row = Compound<T>({Placed<T>{box, {}}, Placed<T>{box, {{T(1), T(0), T(0)}, {}}}});
  for (const Shape<T>& body : {box, row, Shape<T>(Sphere<T>(T(0.5)))}) {
    Manifolds<T> found;
    EXPECT_TRUE(contacts(row, Pose<T>{}, body, Pose<T>{{T(0.5), T(0.95), T(0)}, {}}, T(0.1), found));
    ASSERT_FALSE(found.empty());
    for (const Manifold<T>& m : found) EXPECT_EQ(m.status, Status::converged);
  }
}

}  // namespace
}  // namespace graze::testing
