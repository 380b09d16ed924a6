// Triangles against triangles: distances proven by a reference in extended precision, contacts against those of the
// general path, and both against each other, since distances, overlaps and contacts have to agree on what touches.
#include "narrow/pairs/triangle_triangle/pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/specimen.hpp"
#include "graze/batch.hpp"
#include "in_general.hpp"
#include "narrow/pair_table.hpp"
#include "narrow/pairs/triangle_triangle/contacts.hpp"
#include "reference/certificate.hpp"

namespace graze::testing {
namespace {

struct TrianglePair {
  Vec3f a[3], b[3];
  Vec3f at_b{};
  Quatf turn_a{}, turn_b{};

  template <class T>
  Triangle<T> shape_a(T scale = T(1)) const {
    return {converted<T>(a[0]) * scale, converted<T>(a[1]) * scale, converted<T>(a[2]) * scale};
  }
  template <class T>
  Triangle<T> shape_b(T scale = T(1)) const {
    return {converted<T>(b[0]) * scale, converted<T>(b[1]) * scale, converted<T>(b[2]) * scale};
  }
  template <class T>
  Pose<T> pose_a() const {
    return {{}, normalized(converted<T>(turn_a))};
  }
  template <class T>
  Pose<T> pose_b(T scale = T(1)) const {
    return {converted<T>(at_b) * scale, normalized(converted<T>(turn_b))};
  }
};

TrianglePair any_pair(Random& random) {
  TrianglePair p;
  for (Vec3f& v : p.a) v = random_vector(random, 1);
  for (Vec3f& v : p.b) v = random_vector(random, 1);
  p.at_b = random_vector(random, random() % 3 == 0 ? 3.0f : 0.6f);
  p.turn_a = random_rotation(random);
  p.turn_b = random_rotation(random);
  return p;
}

/// Corners at half steps: edges that are parallel, corners over edges and in one place, triangles of one plane.
TrianglePair pair_on_lattice(Random& random) {
  TrianglePair p;
  const auto step = [&] { return 0.5f * static_cast<float>(random() % 5); };
  const bool level = random() % 2 == 0;
  for (Vec3f& v : p.a) v = {step(), level ? 0 : step(), step()};
  for (Vec3f& v : p.b) v = {step(), level ? 0 : step(), step()};
  p.at_b = {step() - 1, level ? 0.5f * static_cast<float>(random() % 2) : 0, step() - 1};
  return p;
}

/// About in parallel planes, near each other.
TrianglePair level_pair(Random& random) {
  TrianglePair p = any_pair(random);
  for (Vec3f& v : p.a) v.y = 0;
  for (Vec3f& v : p.b) v.y = 0;
  const float tilt = random() % 2 == 0 ? 0 : std::pow(10.0f, uniform(random, -8, -1));
  p.turn_a = {};
  p.turn_b = {uniform(random, -tilt, tilt), 0, uniform(random, -tilt, tilt), 1};
  p.at_b.y = random() % 2 == 0 ? 0 : uniform(random, -1, 1) * std::pow(10.0f, uniform(random, -6, 0));
  return p;
}

/// Stacked: about in parallel planes, over each other, hardly apart or hardly in each other.
TrianglePair stacked_pair(Random& random) {
  TrianglePair p = level_pair(random);
  p.turn_b = {uniform(random, -0.003f, 0.003f), 0, uniform(random, -0.003f, 0.003f), 1};
  p.at_b = {uniform(random, -0.3f, 0.3f), uniform(random, -0.02f, 0.01f), uniform(random, -0.3f, 0.3f)};
  return p;
}

/// Of one mesh: a shared edge, or a shared corner.
TrianglePair neighbours(Random& random) {
  TrianglePair p = any_pair(random);
  p.at_b = {};
  p.turn_b = p.turn_a;
  p.b[0] = p.a[1];
  if (random() % 2 == 0) p.b[1] = p.a[0];
  return p;
}

/// An edge across an edge, a corner over a face or near a corner, closer and closer.
TrianglePair close_pair(Random& random) {
  TrianglePair p = any_pair(random);
  p.at_b = {};
  p.turn_b = p.turn_a;
  const Vec3f off = random_vector(random, std::pow(10.0f, uniform(random, -6, -1)));
  switch (random() % 3) {
  case 0: p.b[0] = p.a[0] + off; break;
  case 1: p.b[0] = (p.a[0] + p.a[1] + p.a[2]) / 3.0f + off; break;
  default: {
    const Vec3f along = random_vector(random, 1), middle = p.a[0] * 0.4f + p.a[1] * 0.6f;
    p.b[0] = middle + along;
    p.b[1] = middle - along * 0.7f + off;
  }
  }
  return p;
}

/// Moved along the line of their nearest points until they hardly touch or hardly do not.
TrianglePair touching_pair(Random& random) {
  TrianglePair p = any_pair(random);
  const Distance<double> d =
      distance<double>(p.shape_a<double>(), p.pose_a<double>(), p.shape_b<double>(), p.pose_b<double>());
  const auto gap = static_cast<double>(uniform(random, -0.01f, 0.02f));
  p.at_b += converted<float>(d.normal * (gap - d.distance));
  return p;
}

/// One a hundredth of the other; both away from their own origins.
TrianglePair unequal_pair(Random& random) {
  TrianglePair p = any_pair(random);
  const Vec3f away = random_vector(random, 50);
  p.turn_b = p.turn_a;
  p.at_b = random_vector(random, 0.5f);
  for (Vec3f& v : p.b) v = v * 0.01f + away;
  for (Vec3f& v : p.a) v += away;
  return p;
}

reference::Placed in_reference(const Triangle<double>& t, const Posed& pose) {
  const auto vector = [](const Vec3d& v) { return reference::Vector{v.x, v.y, v.z}; };
  const Quatd& q = pose.rotation;
  return reference::place(reference::polytope({vector(t.point(0)), vector(t.point(1)), vector(t.point(2))}),
                          vector(pose.translation), {q.x, q.y, q.z, q.w});
}

/// Without rounding.
PlacedTriangle<double> placed(const Triangle<double>& triangle, const Posed& pose) {
  return placed_triangle<double>({triangle, 0, pose});
}

/// How many of those that are no slivers are not known. Of what is known everything is right up to rounding.
int unknown(TrianglePair (*make)(Random&), int count, unsigned seed) {
  Random random(seed);
  int missing = 0;
  for (int i = 0; i < count; ++i) {
    const TrianglePair p = make(random);
    const Triangle<double> a = p.shape_a<double>(), b = p.shape_b<double>();
    const Posed pose_a = p.pose_a<double>(), pose_b = p.pose_b<double>();
    const auto found = special_distance<double>(Shaped(a), pose_a, Shaped(b), pose_b);
    if (!found) {
      const auto regular = [](const Triangle<double>& t) {
        return TriangleRegions<double>(TriangleCore<double>{{t.point(0), t.point(1), t.point(2)}}).regular();
      };
      missing += regular(a) && regular(b);
      continue;
    }
    const auto vector = [](const Vec3d& v) { return reference::Vector{v.x, v.y, v.z}; };
    const double reach = greatest(a.core_extent(), b.core_extent()) + max_abs(pose_b.translation);
    const reference::Answer answer{found->distance, vector(found->normal), vector(found->a), vector(found->b)};
    const auto why_not = reference::disprove(in_reference(a, pose_a), in_reference(b, pose_b), answer,
                                             detail::triangle_slack * box_rounding<double> * reach);
    EXPECT_FALSE(why_not) << *why_not << " of pair " << i;
  }
  return missing;
}

TEST(TriangleTriangle, IsProvenAndRight) {
  EXPECT_EQ(unknown(any_pair, 300, 1), 0);
  EXPECT_EQ(unknown(pair_on_lattice, 300, 2), 0);
  EXPECT_EQ(unknown(level_pair, 300, 3), 0);
  EXPECT_EQ(unknown(neighbours, 300, 4), 0);
  EXPECT_LE(unknown(close_pair, 300, 5), 3);  // rounding hides the direction of what is nearest
  EXPECT_EQ(unknown(unequal_pair, 300, 6), 0);
}

TEST(TriangleTriangle, LeavesSliversToTheGeneralPath) {
  const Triangle<double> whole({0, 0, 0}, {1, 0, 0}, {0, 0, 1}), sliver({0, 1, 0}, {1, 1, 0}, {2, 1.0005, 0}),
      segment({0, 1, 0}, {1, 1, 0}, {1, 1, 0}), point({0, 1, 0}, {0, 1, 0}, {0, 1, 0}),
      tiny({0, 0, 0}, {1e-30, 0, 0}, {0, 0, 1e-30});
  for (const auto& other : {sliver, segment, point, tiny}) {
    EXPECT_FALSE(special_distance<double>(Shaped(whole), {}, Shaped(other), {}));
    EXPECT_FALSE(special_overlap<double>(Shaped(other), {}, Shaped(whole), {}));
  }
  EXPECT_NEAR(distance<double>(whole, {}, sliver, {}).distance, 1, 1e-15);
  EXPECT_NEAR(distance<double>(point, {}, whole, {}).distance, 1, 1e-15);
  EXPECT_TRUE(overlap<double>(tiny, {}, whole, {}));
}

TEST(TriangleTriangle, KnowsWhatTouchesExactly) {
  const Triangle<double> floor({0, 0, 0}, {4, 0, 0}, {0, 0, 4});
  const auto apart = [&](const Triangle<double>& other) { return distance<double>(floor, {}, other, {}).distance; };
  EXPECT_EQ(apart({{1, 0, 1}, {2, 3, 1}, {1, 3, 2}}), 0);      // a corner on the face
  EXPECT_EQ(apart({{2, -1, -1}, {2, 1, 1}, {3, -1, -4}}), 0);  // an edge across an edge
  EXPECT_EQ(apart({{4, 0, 0}, {5, 1, 0}, {5, 1, 1}}), 0);      // corners
  EXPECT_EQ(apart({{1, 0, 1}, {2, 0, 1}, {1, 0, 2}}), 0);      // inside, in one plane
  EXPECT_EQ(apart({{4, 0, 0}, {0, 0, 4}, {4, 0, 4}}), 0);      // a shared edge
  EXPECT_EQ(apart({{5, 0, 0}, {5, 0, 4}, {9, 0, 0}}), 1);      // beside each other in one plane
  EXPECT_EQ(apart({{1, 2, 1}, {2, 2, 1}, {1, 2, 2}}), 2);
  EXPECT_EQ(apart({{-1, 0.5, 1}, {5, 0.5, 1}, {5, 0.5, 1.5}}), 0.5);  // edges that cross, in parallel planes
  EXPECT_NEAR(apart({{1, -1, 1}, {1, 3, 1}, {1.5, 3, 1.5}}), -1, 1e-15);
}

template <class T>
bool same_bits(const Distance<T>& a, const Distance<T>& b) {
  return std::memcmp(&a.distance, &b.distance, sizeof(T)) == 0 && a.normal == b.normal && a.a == b.a && a.b == b.b;
}

TEST(TriangleTriangle, GivesTheSameBitsInLanesAndAtEveryLevel) {
  Random random(7);
  std::vector<Triangle<double>> a, b;
  std::vector<Posed> at_a, at_b;
  for (int i = 0; i < 600; ++i) {
    const TrianglePair p = i % 4 == 0 ? any_pair(random) : i % 4 == 2 ? level_pair(random) : close_pair(random);
    a.push_back(p.shape_a<double>()), at_a.push_back(p.pose_a<double>());
    b.push_back(p.shape_b<double>()), at_b.push_back(p.pose_b<double>());
    const auto of_a = placed(a.back(), at_a.back()), of_b = placed(b.back(), at_b.back());
    const auto in_rows = triangle_distance<Packed<double, 3>>(of_a, of_b, 1e9);
    for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512}) {
      if (!isa_available(level)) continue;
      TriangleDistance<double> of_level;
      GRAZE_KERNEL(level, triangle_pair)(of_a, of_b, 1e9, of_level);
      ASSERT_TRUE(same_bits(in_rows.at, of_level.at));
      ASSERT_EQ(in_rows.proven, of_level.proven);
    }
  }
  std::vector<Distance<double>> found;
  distance(Batch<double>(Bodies<double>(std::span<const Triangle<double>>(a), std::span<const Posed>(at_a)),
                         Bodies<double>(std::span<const Triangle<double>>(b), std::span<const Posed>(at_b))),
           found);
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_TRUE(same_bits(found[i], distance<double>(a[i], at_a[i], b[i], at_b[i]))) << i;
}

template <class T>
bool alike(const Manifolds<T>& fast, const Manifolds<T>& slow, double allowed) {
  if (fast.size() != slow.size()) return false;
  if (fast.empty()) return true;
  if (length(fast[0].normal - slow[0].normal) > T(1e-4)) return false;
  const auto same = [&](const ContactPoint<T>& p, const ContactPoint<T>& q) {
    return std::abs(static_cast<double>(p.distance) - static_cast<double>(q.distance)) <= allowed &&
           length(converted<double>(p.a - q.a)) <= allowed && length(converted<double>(p.b - q.b)) <= allowed &&
           p.feature == q.feature;
  };
  return std::is_permutation(fast[0].points.begin(), fast[0].points.end(), slow[0].points.begin(), slow[0].points.end(),
                             same);
}

/// Distances, overlaps and contacts of one pair agree with each other; contacts with those of the general path.
template <class T>
void expect_agreement(TrianglePair (*make)(Random&), int count, unsigned seed, double near, int most_different) {
  Random random(seed);
  int touching = 0, different = 0;
  for (int i = 0; i < count; ++i) {
    static constexpr float scales[] = {1, 1e-4f, 1e-2f, 1e2f, 1e4f};
    const T scale(scales[i % 5]), margin = i % 3 == 0 ? T(0) : scale * T(0.02);
    const TrianglePair p = make(random);
    const Shape<T> a(p.shape_a<T>(scale), i % 7 == 0 ? scale * T(0.1) : T(0)), b(p.shape_b<T>(scale));
    const Pose<T> pose_a = p.pose_a<T>(), pose_b = p.pose_b<T>(scale);
    const Distance<T> d = distance(a, pose_a, b, pose_b);
    Manifolds<T> fast, slow;
    const bool touch = contacts(a, pose_a, b, pose_b, margin, fast);
    ASSERT_EQ(touch, d.distance <= T(0)) << i;
    ASSERT_EQ(touch, overlap(a, pose_a, b, pose_b)) << i;
    ASSERT_EQ(!fast.empty(), d.distance <= margin) << i;
    contacts_in_general(a, pose_a, b, pose_b, margin, slow);
    different += !alike(fast, slow, near * static_cast<double>(scale));
    touching += touch;
  }
  EXPECT_GT(touching, count / 50);
  EXPECT_LE(different, most_different);  // where another axis is as good, or another point as near, up to rounding
}

TEST(TriangleTriangle, AgreesWithItselfAndInGeneral) {
  expect_agreement<double>(any_pair, 2000, 11, 1e-11, 0);
  expect_agreement<float>(any_pair, 2000, 12, 2e-6, 0);
  expect_agreement<double>(touching_pair, 2000, 18, 1e-9, 0);
  expect_agreement<float>(touching_pair, 2000, 19, 1e-5, 0);
  expect_agreement<double>(level_pair, 1000, 13, 1e-6, 20);
  expect_agreement<double>(stacked_pair, 1000, 16, 1e-9, 20);
  expect_agreement<float>(stacked_pair, 1000, 17, 1e-5, 20);
  expect_agreement<double>(neighbours, 1000, 14, 1e-9, 500);  // what share an edge touch along many axes
  expect_agreement<double>(pair_on_lattice, 1000, 15, 1e-9, 500);
}

ConvexHull<double> hull_of(const Triangle<double>& t) {
  return ConvexHull<double>(std::vector<Vec3d>{t.point(0), t.point(1), t.point(2)});
}

/// How far the points of a manifold are off the two triangles.
double off_surfaces(const Manifolds<double>& found, const TrianglePair& p) {
  double most = 0;
  for (const auto& manifold : found)
    for (const ContactPoint<double>& point : manifold.points)
      most = std::max({most, closest<double>(p.shape_a<double>(), p.pose_a<double>(), point.a).distance,
                       closest<double>(p.shape_b<double>(), p.pose_b<double>(), point.b).distance});
  return most;
}

bool alike_but_names(const Manifolds<double>& one, const Manifolds<double>& other) {
  if (one.size() != other.size()) return false;
  return one.empty() || (length(one[0].normal - other[0].normal) <= 1e-6 &&
                         std::is_permutation(one[0].points.begin(), one[0].points.end(), other[0].points.begin(),
                                             other[0].points.end(), [](const auto& p, const auto& q) {
                                               return length(p.a - q.a) <= 1e-6 && length(p.b - q.b) <= 1e-6;
                                             }));
}

// Along the normal of a face, preferred to that of the nearest points, the other triangle may show a vertex where it
// showed an edge before, and then there is nothing to clip.
TEST(TriangleTriangle, ClipsNothingByAVertex) {
  const Triangle<double> a({-0.24, -0.59, 0.47}, {0.31, 0.52, 0.13}, {0.3, -0.02, 0.43}),
      b({0.66, 0.41, -0.66}, {0.26, 0.53, 0.16}, {1.31, 0.34, -0.48});
  Manifolds<double> found;
  contacts<double>(a, {}, b, {}, 0.03, found);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].points.size(), 1u);
  EXPECT_LE(length(found[0].points[0].a - a.point(1)), 1e-15);
  EXPECT_NEAR(found[0].points[0].distance, 0.00106, 1e-6);
}

TEST(TriangleTriangle, PutsPointsOnBothWhereTheyNearlyTouch) {
  Random random(61);
  int off = 0, different = 0;
  for (int i = 0; i < 20000; ++i) {
    const TrianglePair p = touching_pair(random);
    const Triangle<double> of_a = p.shape_a<double>(), of_b = p.shape_b<double>();
    Manifolds<double> of_triangles, as_hulls;
    contacts<double>(of_a, p.pose_a<double>(), of_b, p.pose_b<double>(), 0.02, of_triangles);
    contacts<double>(hull_of(of_a), p.pose_a<double>(), hull_of(of_b), p.pose_b<double>(), 0.02, as_hulls);
    off += off_surfaces(of_triangles, p) > 1e-10;
    different += !alike_but_names(of_triangles, as_hulls);
  }
  EXPECT_EQ(off, 0);
  EXPECT_EQ(different, 0);
}

/// The points that a level finds of a pair; of those that touch, how many it does not know.
struct PointsAlone {
  TriangleDistance<double> found;
  TriangleAxes<double> axes;
  ContactSlots<double> points;

  PointsAlone(Isa level, const TrianglePair& p, double margin) {
    points.filled = 0;
    const auto a = placed(p.shape_a<double>(), p.pose_a<double>()), b = placed(p.shape_b<double>(), p.pose_b<double>());
    GRAZE_KERNEL(level, triangle_pair_contact)
    (a, b, margin, margin, answer_rounding<double>(), found, axes, points);
  }
};

int points_unknown(TrianglePair (*make)(Random&), int count, unsigned seed) {
  Random random(seed);
  int missing = 0, touching = 0;
  for (int i = 0; i < count; ++i) {
    const TrianglePair p = make(random);
    const PointsAlone alone(Isa::baseline, p, 0.02);
    const bool touches = alone.found.proven && alone.found.at.distance <= 0.02;
    touching += touches;
    missing += touches && alone.points.known == 0;
    for (const Isa level : {Isa::avx2, Isa::avx512}) {
      if (!isa_available(level)) continue;
      const PointsAlone other(level, p, 0.02);
      EXPECT_EQ(other.points.known, alone.points.known);
      if (alone.points.known == 0) continue;
      EXPECT_EQ(other.points.filled, alone.points.filled);
      EXPECT_EQ(other.points.normal, alone.points.normal);
      for (auto filled = static_cast<unsigned>(alone.points.filled); filled != 0; filled &= filled - 1) {
        const ContactSlot<double> q = alone.points.slot(static_cast<std::size_t>(__builtin_ctz(filled))),
                                  r = other.points.slot(static_cast<std::size_t>(__builtin_ctz(filled)));
        EXPECT_TRUE(q.a == r.a && q.b == r.b && q.distance == r.distance && q.part_a == r.part_a &&
                    q.part_b == r.part_b);
      }
    }
  }
  EXPECT_GT(touching, count / 10);
  return missing;
}

TEST(TriangleTriangle, FindsPointsItselfAtEveryLevel) {
  EXPECT_LE(points_unknown(any_pair, 1000, 31), 3);
  EXPECT_LE(points_unknown(touching_pair, 3000, 36), 450);  // faces that miss what is nearest
  EXPECT_LE(points_unknown(stacked_pair, 1000, 32), 10);
  EXPECT_LE(points_unknown(level_pair, 1000, 33), 20);
  EXPECT_LE(points_unknown(neighbours, 500, 34), 30);  // edges that run along each other
  EXPECT_LE(points_unknown(pair_on_lattice, 1000, 35), 5);
}

/// A batch's contacts are those of its pairs alone, to the bit and in their order.
template <class T>
void expect_batch_as_alone(TrianglePair (*make)(Random&), std::size_t count, unsigned seed, T margin) {
  Random random(seed);
  std::vector<Triangle<T>> a, b;
  std::vector<Pose<T>> at_a, at_b;
  for (std::size_t i = 0; i < count; ++i) {
    const TrianglePair p = make(random);
    const T scale = i % 5 == 4 ? T(1e-3) : T(1);
    a.push_back(p.shape_a<T>(scale)), at_a.push_back(p.pose_a<T>());
    b.push_back(p.shape_b<T>(scale)), at_b.push_back(p.pose_b<T>(scale));
  }
  BatchContacts<T> found;
  contacts(Batch<T>(Bodies<T>(std::span<const Triangle<T>>(a), std::span<const Pose<T>>(at_a)),
                    Bodies<T>(std::span<const Triangle<T>>(b), std::span<const Pose<T>>(at_b))),
           margin, found);
  for (std::size_t i = 0; i < count; ++i) {
    Manifolds<T> alone;
    const bool overlap = contacts<T>(a[i], at_a[i], b[i], at_b[i], margin, alone);
    const auto& pair = found.pairs[i];
    ASSERT_EQ(pair.overlap, overlap) << i;
    ASSERT_EQ(pair.manifold_count, alone.size()) << i;
    if (alone.empty()) continue;
    const auto& manifold = found.manifolds[pair.first_manifold];
    ASSERT_EQ(manifold.normal, alone[0].normal) << i;
    ASSERT_EQ(manifold.point_count, alone[0].points.size()) << i;
    for (std::size_t k = 0; k < manifold.point_count; ++k) {
      const ContactPoint<T>&p = found.points[manifold.first_point + k], &q = alone[0].points[k];
      ASSERT_TRUE(p.a == q.a && p.b == q.b && p.distance == q.distance && p.feature == q.feature &&
                  p.weight == q.weight)
          << i;
    }
  }
}

TEST(TriangleTriangle, GivesTheSameContactsInLanes) {
  unsigned seed = 41;
  for (const auto make :
       {any_pair, touching_pair, stacked_pair, level_pair, neighbours, pair_on_lattice, close_pair, unequal_pair}) {
    for (const std::size_t count : {1, 3, 9, 21, 600}) {
      expect_batch_as_alone<float>(make, count, ++seed, 0.02f);
      expect_batch_as_alone<double>(make, count, ++seed, 0.02);
    }
    expect_batch_as_alone<float>(make, 300, ++seed, 0);
    expect_batch_as_alone<double>(make, 300, ++seed, 0.5);
  }
}

/// A pair swapped, moved, turned and rescaled is the same pair.
TEST(TriangleTriangle, DoesNotMindHowThePairIsSeen) {
  Random random(21);
  for (int i = 0; i < 1000; ++i) {
    const TrianglePair p = i % 2 == 0 ? any_pair(random) : close_pair(random);
    const Shape<double> a(p.shape_a<double>()), b(p.shape_b<double>());
    const Posed pose_a = p.pose_a<double>(), pose_b = p.pose_b<double>();
    const Posed elsewhere{converted<double>(random_vector(random, 100)),
                          normalized(converted<double>(random_rotation(random)))};
    const Distance<double> d = distance(a, pose_a, b, pose_b), swapped = distance(b, pose_b, a, pose_a),
                           moved = distance(a, compose(elsewhere, pose_a), b, compose(elsewhere, pose_b)),
                           doubled = distance<double>(p.shape_a(2.0), pose_a, p.shape_b(2.0), p.pose_b(2.0));
    ASSERT_NEAR(swapped.distance, d.distance, 1e-14);
    ASSERT_NEAR(moved.distance, d.distance, 1e-12);
    ASSERT_EQ(doubled.distance, 2 * d.distance);
    ASSERT_EQ(doubled.normal, d.normal);
  }
}

}  // namespace
}  // namespace graze::testing
