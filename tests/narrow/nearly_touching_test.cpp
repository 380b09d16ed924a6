// Pairs that are 1e-9 to 1e-5 of their size apart or deep, where rounding is a large part of the answer: the gap along
// the normal is the distance that is claimed, the points lie on the shapes, and moving and turning both does not change
// the normal.
//
// How many pairs of kinds: GRAZE_TEST_PAIRS in the environment, else enough for a run of seconds.
#include <cmath>

#include "common/asked_number.hpp"
#include "common/specimen.hpp"
#include "manifold_of.hpp"

namespace graze::testing {
namespace {

using reference::Real;

double number(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }
double number(Random& random, double low, double high) { return low + (high - low) * number(random); }

Vec3d vector(Random& random, double reach) {
  const double x = number(random, -reach, reach), y = number(random, -reach, reach);
  return {x, y, number(random, -reach, reach)};
}

struct Pair {
  Specimen specimen_a, specimen_b;
  Shaped a, b;
  Posed pose_a, pose_b;

  Distance<double> ask() const { return distance(a, pose_a, b, pose_b); }
};

reference::Placed placed(const Specimen& specimen, const Posed& pose) {
  const Quatd& q = pose.rotation;
  return reference::place(reference_of({specimen, {}, {}}).shape, vector_of(pose.translation), {q.x, q.y, q.z, q.w});
}

/// Cores or whole shapes that nearly touch: one pair in four is rounded.
Pair nearly_touching(Kind ka, Kind kb, Random& random) {
  Specimen sa = random_specimen(ka, 1, random), sb = random_specimen(kb, 1, random);
  const bool rounded = random() % 4 == 0;
  if (!rounded) sa.margin = sb.margin = 0;
  Pair p{sa,
         sb,
         build<double>(sa),
         build<double>(sb),
         {{}, normalized(converted<double>(random_rotation(random)))},
         {vector(random, 1.5), normalized(converted<double>(random_rotation(random)))}};
  const Distance<double> far = p.ask();
  const auto size = static_cast<double>(reference::size(placed(sa, p.pose_a), placed(sb, p.pose_b)));
  double gap = size * std::pow(10, number(random, -9, -5)) * (random() % 2 ? 1 : -1);
  if (rounded && random() % 2) gap -= static_cast<double>(sa.margin) + static_cast<double>(sb.margin);
  p.pose_b.translation -= far.normal * (far.distance - gap);
  return p;
}

Pair moved(Pair p, Random& random) {
  const Posed motion{vector(random, 3), normalized(converted<double>(random_rotation(random)))};
  for (Posed* pose : {&p.pose_a, &p.pose_b})
    *pose = {transform(motion, pose->translation), motion.rotation * pose->rotation};
  return p;
}

/// What is claimed is seen along the normal that is claimed.
void expect_proven(const Pair& p, const Distance<double>& d) {
  const reference::Placed a = placed(p.specimen_a, p.pose_a), b = placed(p.specimen_b, p.pose_b);
  const Real allowed = 1e-10L * reference::size(a, b);
  const Real along = reference::separation(a, b, reference::normalized(vector_of(d.normal)));
  const Real error = d.status == Status::converged ? allowed : allowed + d.error;
  EXPECT_LE(std::abs(along - d.distance), error) << "distance " << d.distance;
  if (d.distance <= 0) return;
  EXPECT_LE(reference::outside_distance(a, vector_of(d.a)), allowed) << "distance " << d.distance;
  EXPECT_LE(reference::outside_distance(b, vector_of(d.b)), allowed) << "distance " << d.distance;
}

class NearlyTouching : public ::testing::TestWithParam<int> {};

TEST_P(NearlyTouching, TheGapAlongTheNormalIsTheDistance) {
  const Kind ka = static_cast<Kind>(GetParam());
  for (int k = GetParam(); k < kind_count; ++k) {
    const Kind kb = static_cast<Kind>(k);
    Random random{static_cast<std::uint64_t>(GetParam() * 100 + k)};
    for (int i = 0; i < asked_number("GRAZE_TEST_PAIRS", 60); ++i) {
      SCOPED_TRACE(std::string(name_of(ka)) + " " + name_of(kb) + " " + std::to_string(i));
      const Pair pair = nearly_touching(ka, kb, random), there = moved(pair, random);
      const Distance<double> here = pair.ask(), again = there.ask();
      expect_proven(pair, here);
      expect_proven(there, again);
      EXPECT_EQ(overlap(pair.a, pair.pose_a, pair.b, pair.pose_b), here.distance <= 0);
      if (here.distance <= 0) continue;
      // Of shapes that are apart the normal is one, and roundings of 1e-16 turn it by little at a gap of 1e-9.
      EXPECT_EQ(here.status, Status::converged);
      const Quatd turned = there.pose_a.rotation * conjugate(pair.pose_a.rotation);
      EXPECT_LE(length(rotate(turned, here.normal) - again.normal), 2e-3) << "distance " << here.distance;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, NearlyTouching, ::testing::Range(0, bounded_kinds),
                         [](const auto& info) { return std::string(name_of(static_cast<Kind>(info.param))); });

/// The reference shares nothing with the closed form: the distance is a search over all directions there.
TEST(ClosestInTaperedCapsule, IsExactInsideAndOut) {
  Random random(12);
  for (int i = 0; i < 400; ++i) {
    Specimen s = random_specimen(Kind::tapered_capsule, 1, random);
    if (i % 5 == 0) s.size[2] = s.size[1] + (i % 2 ? 1e-6f : -1e-3f);  // all but even
    if (i % 7 == 0) s.size[0] *= 0.1f;                                 // one ball may hold the other
    const Posed pose{vector(random, 1), normalized(converted<double>(random_rotation(random)))};
    const double reach = static_cast<double>(s.size[0] + s.size[1] + s.size[2]) / 2;
    Vec3d local = vector(random, i % 2 ? reach : reach / 4);
    if (i % 3 == 0) local.x = local.z = 0;
    const Vec3d p = transform(pose, local);
    const Closest<double> found = closest(build<double>(s), pose, p);
    const reference::Placed shape = placed(s, pose), point = reference::place(reference::point(), vector_of(p));
    SCOPED_TRACE(describe({s, converted<float>(pose.translation), {}}));
    EXPECT_EQ(found.status, Status::converged);
    EXPECT_EQ(found.error, 0);
    EXPECT_NEAR(found.distance, static_cast<double>(reference::signed_distance(shape, point).distance),
                1e-14 * (1 + reach));
    EXPECT_LE(length(p - found.point - found.normal * found.distance), 1e-14 * (1 + reach));
    EXPECT_NEAR(length(found.normal), 1, 1e-15 * 8);
    EXPECT_LE(reference::outside_distance(shape, vector_of(found.point)), 1e-14L * (1 + reach));
  }
}

TEST(Closest, ABoundedAnswerSaysByHowMuch) {
  // A point at the centre of an ellipsoid that is nearly a ball: many directions are about as good.
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Specimen s = random_specimen(static_cast<Kind>(i % bounded_kinds), 1, random);
    const Vec3d p = vector(random, 0.3);
    const Shaped shape = build<double>(s), point = Sphere<double>(0);
    const Closest<double> c = closest(shape, {}, p);
    const Distance<double> d = distance(shape, {}, point, {p, {}});
    EXPECT_EQ(c.error, d.error);
    EXPECT_EQ(c.status, d.status);
  }
}

}  // namespace
}  // namespace graze::testing
