// Contact manifolds: every point on both surfaces, the whole area spanned, steady from frame to frame.
#include <algorithm>
#include <set>

#include "common/specimen.hpp"
#include "manifold_of.hpp"
#include "narrow/pair_table.hpp"

namespace graze::testing {
namespace {

using reference::Real;

/// Area of the points' hull across the normal, by the shoelace formula in order of angle about their middle.
double area_of(const Manifold<double>& m) {
  const Vec3d u = any_perpendicular(m.normal), v = cross(m.normal, u);
  Vec3d middle;
  for (const auto& p : m.points) middle += p.a / static_cast<double>(m.points.size());
  std::vector<std::array<double, 3>> around;
  for (const auto& p : m.points) {
    const double x = dot(p.a - middle, u), y = dot(p.a - middle, v);
    around.push_back({std::atan2(y, x), x, y});
  }
  std::sort(around.begin(), around.end());
  double twice = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto &p = around[i], &q = around[(i + 1) % around.size()];
    twice += p[1] * q[2] - q[1] * p[2];
  }
  return twice / 2;
}

TEST(Manifold, StackedBoxesTouchInFourCorners) {
  const Shaped box = Box<double>({2, 2, 2});
  const Manifold<double> m = only_manifold(box, at(0, 0, 0), box, at(0.5, 1.99, 0));
  EXPECT_EQ(m.normal, (Vec3d{0, 1, 0}));
  ASSERT_EQ(m.points.size(), 4u);
  EXPECT_NEAR(area_of(m), 1.5 * 2, 1e-12);
  for (const auto& p : m.points) EXPECT_NEAR(p.distance, -0.01, 1e-12);
}

TEST(Manifold, TurnedBoxesTouchInEightPoints) {
  const Shaped box = Box<double>({2, 2, 2});
  const Posed turned{{0, 2, 0}, Quatd::from_axis_angle({0, 1, 0}, std::acos(-1) / 4)};
  const Manifold<double> m = only_manifold(box, {}, box, turned);
  ASSERT_EQ(m.points.size(), 8u);
  EXPECT_NEAR(area_of(m), 8 * (std::sqrt(2) - 1), 1e-9);  // a regular octagon about a circle of radius 1
}

TEST(Manifold, CapsulesAndCylindersLieOnTwoPointsAndStandOnFour) {
  const Shaped floor = Box<double>({20, 2, 20});
  const Quatd lying = Quatd::from_axis_angle({0, 0, 1}, std::acos(-1) / 2);
  EXPECT_EQ(only_manifold(floor, {}, Capsule<double>(2, 0.5), {{0, 1.5, 0}, lying}).points.size(), 2u);
  EXPECT_EQ(only_manifold(floor, {}, Cylinder<double>(2, 0.5), {{0, 1.5, 0}, lying}).points.size(), 2u);
  EXPECT_GE(only_manifold(floor, {}, Cylinder<double>(2, 0.5), at(0, 2, 0)).points.size(), 4u);
  EXPECT_GE(only_manifold(floor, {}, Cylinder<double>(2, 0.5, 0.2), at(0, 2, 0)).points.size(), 4u);
  EXPECT_EQ(only_manifold(floor, {}, Cylinder<double>(2, 0.5, 0), {{0, 2, 0}, {1, 0, 0, 0}}).points.size(), 1u);
  EXPECT_EQ(only_manifold(floor, {}, Ellipsoid<double>({1, 0.5, 0.7}), at(0, 1.5, 0)).points.size(), 1u);
  EXPECT_EQ(only_manifold(Capsule<double>(2, 0.5), {}, Capsule<double>(2, 0.5), at(1, 0.5, 0)).points.size(), 2u);
}

TEST(Manifold, CrossingEdgesTouchInOnePoint) {
  const Shaped box = Box<double>({2, 2, 2});
  const Quatd tilt_x = Quatd::from_axis_angle({1, 0, 0}, std::acos(-1) / 4);
  const Quatd tilt_z = Quatd::from_axis_angle({0, 0, 1}, std::acos(-1) / 4);
  const Manifold<double> m = only_manifold(box, {{0, 0, 0}, tilt_x}, box, {{0, 2 * std::sqrt(2) - 0.01, 0}, tilt_z});
  ASSERT_EQ(m.points.size(), 1u);
  EXPECT_NEAR(m.normal.y, 1, 1e-9);
  EXPECT_NEAR(m.points[0].distance, -0.01, 1e-9);
}

// For random pairs of all kinds: points within the margin, on both shapes, apart along the normal; the deepest is as
// deep as the shapes are, up to the preference for faces.
TEST(Manifold, PointsLieOnBothShapesWhateverThePair) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const auto ka = static_cast<Kind>(random() % bounded_kinds), kb = static_cast<Kind>(random() % kind_count);
    const PlacedSpecimen a{random_specimen(ka, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    PlacedSpecimen b{random_specimen(kb, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    if (i % 2 == 0) b.rotation = a.rotation;  // faces face each other
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    Manifolds<double> manifolds;
    const double margin = 0.05;
    const bool touch = contacts(sa, pose_of<double>(a), sb, pose_of<double>(b), margin, manifolds);
    const Distance<double> d = distance(sa, pose_of<double>(a), sb, pose_of<double>(b));
    ASSERT_EQ(touch, d.distance <= 0);
    ASSERT_EQ(manifolds.empty(), d.distance > margin);
    const reference::Placed ra = reference_of(a), rb = reference_of(b);
    for (const auto& m : manifolds) {
      EXPECT_NEAR(length(m.normal), 1, 1e-12);
      double least = 1;
      for (const auto& p : m.points) {
        EXPECT_LE(p.distance, margin);
        EXPECT_LT(length(p.b - p.a - m.normal * p.distance), 1e-12);
        EXPECT_LT(reference::outside_distance(ra, vector_of(p.a)), 2e-6L) << describe(a) << "\n" << describe(b);
        EXPECT_LT(reference::outside_distance(rb, vector_of(p.b)), 2e-6L) << describe(a) << "\n" << describe(b);
        least = std::min(least, p.distance);
      }
      EXPECT_NEAR(least, d.distance, 0.02) << describe(a) << "\n" << describe(b);
    }
  }
}

// The bound that `contacts` states, over pairs of all kinds, those with faces about parallel among them. (A margin for
// contacts is a hundredth of the smaller shape.)
TEST(Manifold, TheDeepestPointIsAsDeepAsTheDistanceUpToATwoHundredth) {
  Random random(16);
  for (int i = 0; i < 40000; ++i) {
    const auto ka = static_cast<Kind>(random() % bounded_kinds), kb = static_cast<Kind>(random() % kind_count);
    const PlacedSpecimen a{random_specimen(ka, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    PlacedSpecimen b{random_specimen(kb, 1, random), random_vector(random, 0.5f), random_rotation(random)};
    if (i % 2 == 0) {
      const Vec3f tilt = random_vector(random, 0.02f);
      b.rotation = normalized(a.rotation * Quatf{tilt.x, tilt.y, tilt.z, 1});
    }
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    Manifolds<double> manifolds;
    contacts(sa, pose_of<double>(a), sb, pose_of<double>(b), 0.05, manifolds);
    if (manifolds.empty()) continue;
    double deepest = 1;
    for (const auto& p : manifolds.at(0).points) deepest = std::min(deepest, p.distance);
    const double truth = distance(sa, pose_of<double>(a), sb, pose_of<double>(b)).distance;
    EXPECT_LE(std::abs(deepest - truth), contact_margin(sa, sb) / 2 + 1e-9) << deepest << " " << truth << "\n"
                                                                            << describe(a) << "\n"
                                                                            << describe(b);
  }
}

TEST(Manifold, SwappingTheShapesMirrorsPointsAndFeatures) {
  Random random(8);
  const Shaped box = Box<double>({1, 0.6, 0.8}), can = Cylinder<double>(0.8, 0.4);
  for (int i = 0; i < 500; ++i) {
    const Posed pa{converted<double>(random_vector(random, 0.5f)),
                   normalized(converted<double>(random_rotation(random)))};
    const Posed pb{converted<double>(random_vector(random, 0.5f)),
                   normalized(converted<double>(random_rotation(random)))};
    const Manifold<double> m = only_manifold(box, pa, can, pb, 0.01), w = only_manifold(can, pb, box, pa, 0.01);
    ASSERT_EQ(m.points.size(), w.points.size());
    if (m.points.empty()) continue;
    EXPECT_LT(length(m.normal + w.normal), 2e-5);  // half the digits of the depth
    std::multiset<std::uint32_t> features, mirrored;
    for (const auto& p : m.points) features.insert(p.feature);
    for (const auto& p : w.points) mirrored.insert((p.feature << 16) | (p.feature >> 16));
    EXPECT_EQ(features, mirrored);
  }
}

// The true area that two faces share, the slow way: all corners of one inside the other and all crossings of edges.
double shared_area(const std::vector<std::array<double, 2>>& p, const std::vector<std::array<double, 2>>& q) {
  using Point = std::array<double, 2>;
  const auto turn = [](const Point& o, const Point& u, const Point& v) {
    return (u[0] - o[0]) * (v[1] - o[1]) - (u[1] - o[1]) * (v[0] - o[0]);
  };
  const auto inside = [&](const Point& x, const std::vector<Point>& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      if (turn(polygon[i], polygon[(i + 1) % polygon.size()], x) < 0) return false;
    return true;
  };
  std::vector<Point> corners;
  for (const Point& x : p)
    if (inside(x, q)) corners.push_back(x);
  for (const Point& x : q)
    if (inside(x, p)) corners.push_back(x);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Point &a = p[i], &b = p[(i + 1) % p.size()], &c = q[j], &d = q[(j + 1) % q.size()];
      const double ta = turn(c, d, a), tb = turn(c, d, b), tc = turn(a, b, c), td = turn(a, b, d);
      if (ta * tb < 0 && tc * td < 0)
        corners.push_back({a[0] + (b[0] - a[0]) * ta / (ta - tb), a[1] + (b[1] - a[1]) * ta / (ta - tb)});
    }
  Point middle{};
  const auto count = static_cast<double>(corners.size());
  for (const Point& x : corners) middle = {middle[0] + x[0] / count, middle[1] + x[1] / count};
  std::sort(corners.begin(), corners.end(), [&](const Point& x, const Point& y) {
    return std::atan2(x[1] - middle[1], x[0] - middle[0]) < std::atan2(y[1] - middle[1], y[0] - middle[0]);
  });
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) twice += turn(middle, corners[i], corners[(i + 1) % corners.size()]);
  return twice / 2;
}

TEST(Manifold, PointsCoverWhatTheFacesShare) {
  Random random(10);
  for (int i = 0; i < 3000; ++i) {
    const Vec3d size_a = converted<double>(abs(random_vector(random, 1))) + Vec3d{0.05, 0.05, 0.05};
    const Vec3d size_b = converted<double>(abs(random_vector(random, 1))) + Vec3d{0.05, 0.05, 0.05};
    const double yaw = static_cast<double>(i % 3 == 0 ? uniform(random, -0.01f, 0.01f) : uniform(random, -4, 4));
    const double tilt = static_cast<double>(uniform(random, -0.002f, 0.002f));
    const Posed pose{{static_cast<double>(uniform(random, -1, 1)) * (size_a.x + size_b.x) * 0.3,
                      (size_a.y + size_b.y) / 2 - 0.01, static_cast<double>(uniform(random, -1, 1)) * size_a.z * 0.3},
                     Quatd::from_axis_angle({1, 0, 0}, tilt) * Quatd::from_axis_angle({0, 1, 0}, yaw)};
    const Manifold<double> m = only_manifold(Box<double>(size_a), {}, Box<double>(size_b), pose, 0.05);
    const auto face = [](const Vec3d& size, const Posed& where) {
      std::vector<std::array<double, 2>> corners;
      for (const auto& [x, z] : {std::pair{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}) {
        const Vec3d p = transform(where, Vec3d{x * size.x / 2, -size.y / 2, z * size.z / 2});
        corners.push_back({p.x, -p.z});
      }
      return corners;
    };
    const double truth = shared_area(face(size_a, {}), face(size_b, pose));
    if (m.points.empty() || std::abs(m.normal.y) < 0.99) continue;  // another side is less deep
    EXPECT_GE(area_of(m), 0.95 * truth) << i;
    EXPECT_LE(area_of(m), 1.001 * truth + 1e-12) << i;
  }
}

TEST(Manifold, DegenerateBoxesHaveOneWheneverTheyOverlap) {
  Random random(12);
  for (int i = 0; i < 20000; ++i) {
    const Kind kind = i % 3 == 0 ? Kind::triangle : Kind::box;
    const PlacedSpecimen a = on_lattice(degenerate_specimen(Kind::box, 1, random), 1, random);
    PlacedSpecimen b = on_lattice(degenerate_specimen(kind, 1, random), 1, random);
    if (i % 5 == 0 && kind == Kind::box) b = a;     // identical
    if (i % 7 == 0) b.translation = a.translation;  // nested
    if (i % 11 == 0)
      for (float& size : b.specimen.size) size *= 1e-4f;
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    Manifolds<double> manifolds;
    const bool touch = contacts(sa, pose_of<double>(a), sb, pose_of<double>(b), 0.0, manifolds);
    EXPECT_EQ(touch, !manifolds.empty()) << describe(a) << "\n" << describe(b);
    EXPECT_EQ(touch, overlap(sa, pose_of<double>(a), sb, pose_of<double>(b))) << describe(a) << "\n" << describe(b);
    for (const auto& m : manifolds) {
      EXPECT_NEAR(length(m.normal), 1, 1e-12);
      for (const auto& p : m.points) EXPECT_TRUE(std::isfinite(length(p.a) + length(p.b) + p.distance));
    }
  }
}

TEST(Manifold, MovingTheSceneMovesThePoints) {
  Random random(13);
  for (int i = 0; i < 2000; ++i) {
    const PlacedSpecimen a{random_specimen(Kind::box, 1, random), random_vector(random, 0.4f), random_rotation(random)};
    PlacedSpecimen b{random_specimen(i % 2 ? Kind::hull : Kind::box, 1, random), random_vector(random, 0.4f),
                     random_rotation(random)};
    const Shaped sa = build<double>(a.specimen), sb = build<double>(b.specimen);
    const Posed move{converted<double>(random_vector(random, 10)),
                     normalized(converted<double>(random_rotation(random)))};
    const Manifold<double> m = only_manifold(sa, pose_of<double>(a), sb, pose_of<double>(b));
    const Manifold<double> w =
        only_manifold(sa, compose(move, pose_of<double>(a)), sb, compose(move, pose_of<double>(b)));
    ASSERT_EQ(m.points.size(), w.points.size());
    if (m.points.empty()) continue;
    EXPECT_LT(length(rotate(move.rotation, m.normal) - w.normal), 1e-9);
    for (const auto& p : m.points) {
      double nearest = 1;
      for (const auto& q : w.points)
        if (q.feature == p.feature) nearest = std::min(nearest, length(transform(move, p.a) - q.a));
      EXPECT_LT(nearest, 1e-9);
    }
  }
}

// A box of 1 m rests on another, tilted up to 5 mrad, about 1 mm deep, its pose drawn anew in each frame: the manifold
// of a stack must not flicker, whether the boxes are aligned, shifted or turned.
TEST(Manifold, RestingBoxesDoNotFlicker) {
  const Shaped box = Box<double>({1, 1, 1});
  const double margin = contact_margin(box, box);
  for (const double shift : {0.0, 0.1, 0.3})
    for (const double yaw : {0.0, 0.3, std::acos(-1) / 4}) {
      Random random(9);
      std::size_t count = 0;
      std::set<std::uint32_t> features;
      bool face = true;
      int kinds = 0, counts = 0, ids = 0;
      for (int i = 0; i < 10000; ++i) {
        const Vec3d tilt = converted<double>(random_vector(random, 0.005f));
        const Posed pose{{shift + static_cast<double>(uniform(random, -0.001f, 0.001f)),
                          0.999 + static_cast<double>(uniform(random, -0.0005f, 0.0005f)), shift / 2},
                         normalized(Quatd{tilt.x / 2, tilt.y / 2, tilt.z / 2, 1}) *
                             Quatd::from_axis_angle({0, 1, 0}, yaw)};
        const Manifold<double> m = only_manifold(box, {}, box, pose, margin);
        std::set<std::uint32_t> now;
        for (const auto& p : m.points) now.insert(p.feature);
        EXPECT_EQ(now.size(), m.points.size());  // each point has a name of its own
        const Vec3d up = rotate(pose.rotation, Vec3d{0, 1, 0});
        const bool is_face = std::min(length(m.normal - up), length(m.normal - Vec3d{0, 1, 0})) < 1e-9;
        if (i > 0) {
          kinds += face != is_face;
          counts += count != m.points.size();
          ids += count == m.points.size() && features != now;
        }
        face = is_face;
        count = m.points.size();
        features = now;
      }
      EXPECT_EQ(kinds, 0);
      EXPECT_LT(counts, 100) << "shift " << shift << " yaw " << yaw;
      EXPECT_EQ(ids, 0);
    }
}

}  // namespace
}  // namespace graze::testing
