// Solid polygons and chains against what follows from their outlines alone: areas, crossing numbers, the distance to
// the nearest edge, and the smooth floor that a chain is an approximation of.
#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>
#include <random>

#include "graze/plane/cast.hpp"
#include "graze/plane/query.hpp"
#include "plane/partition.hpp"

namespace graze::plane {
namespace {

using Points = std::vector<Vec2d>;

/// How many random poses, times a thousand on request.
int rounds(int few) { return std::getenv("GRAZE_TEST_SLIDING") ? 1000 * few : few; }

double doubled_area(const Points& p) {
  double area = 0;
  for (std::size_t i = 0; i < p.size(); ++i) area += cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
  return area;
}

/// A star-shaped outline, counter-clockwise, of random radii.
Points random_star(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.2, 1), step(0.2, 1);
  std::vector<double> angle(count);
  double sum = 0;
  for (double& a : angle) sum += a = step(random);
  Points out;
  double at = 0;
  for (const double a : angle) {
    const double r = radius(random);
    out.push_back({r * std::cos(at), r * std::sin(at)});
    at += a / sum * 2 * std::numbers::pi;
  }
  return out;
}

/// A comb with teeth of random heights: many reflex vertices in a row, many on one line.
Points comb(std::size_t teeth, std::mt19937& random) {
  std::uniform_real_distribution<double> height(1.5, 3);
  Points out{{0, 0}, {double(2 * teeth), 0}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = double(2 * i);
    const double h = height(random);
    out.push_back({x + 2, 1});
    out.push_back({x + 1.5, h});
    out.push_back({x + 0.5, h});
    out.push_back({x, 1});
  }
  return out;
}

/// Signed distance of a point to an outline: by its nearest edge and the parity of crossings.
double by_edges(const Points& outline, const Vec2d& p) {
  double nearest = 1e300;
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2d a = outline[i], b = outline[(i + 1) % outline.size()], e = b - a;
    const double t = std::clamp(dot(p - a, e) / dot(e, e), 0.0, 1.0);
    nearest = std::min(nearest, length(a + e * t - p));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside ? -nearest : nearest;
}

TEST(PlanePolygon, PiecesAreConvexAndCoverTheOutlineOnce) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const Points outline = round % 3 ? random_star(3 + random() % 40, random) : comb(1 + random() % 10, random);
    if (first_crossing(outline) >= 0) continue;
    const Shaped shape = Polygon<double>(outline);
    const Pieces<double>& pieces = shape.as<Polygon<double>>()->pieces();
    double area = 0, around = 0;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      const auto v = pieces.vertices(k);
      area += doubled_area({v.begin(), v.end()});
      for (std::size_t i = 0; i < v.size(); ++i) {
        ASSERT_GE(cross(v[(i + 1) % v.size()] - v[i], v[(i + 2) % v.size()] - v[(i + 1) % v.size()]), -1e-12);
        if (pieces.outline(k)[i].outer) around += length(v[(i + 1) % v.size()] - v[i]);
      }
    }
    double length_around = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
      length_around += length(outline[(i + 1) % outline.size()] - outline[i]);
    EXPECT_NEAR(area, doubled_area(outline), 1e-12 * area);
    EXPECT_NEAR(around, length_around, 1e-12 * length_around);
  }
}

TEST(PlanePolygon, PointsAreAsDeepAsTheOutlineIsFar) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> u(-1.2, 1.2);
  int inside = 0;
  for (int round = 0; round < 100; ++round) {
    Points outline = random_star(3 + random() % 30, random);
    if (round % 2) std::reverse(outline.begin(), outline.end());
    const Shaped shape = Polygon<double>(outline);
    for (int k = 0; k < 50; ++k) {
      const Vec2d p{u(random), u(random)};
      const double expected = by_edges(outline, p);
      const Closest<double> c = closest<double>(shape, {}, p);
      ASSERT_NEAR(c.distance, expected, 1e-12) << round;
      ASSERT_LE(length(c.point + c.normal * c.distance - p), 1e-12);
      ASSERT_NEAR(by_edges(outline, c.point), 0, 1e-12);
      ASSERT_EQ(overlap<double>(shape, {}, Circle<double>(0), {p, {}}), expected <= 0);
      inside += expected < 0;
    }
  }
  EXPECT_GT(inside, 500);
}

/// Points and discs on a cut are as deep as beside it.
TEST(PlanePolygon, CutsAreInside) {
  const std::vector<Vec2<double>> corners{{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}};
  const Shape<double> l = Polygon<double>(corners), disc = Circle<double>(0.01);
  for (int i = -9; i < 0; ++i) {
    const Vec2<double> on{0.1 * i, 0.1 * i}, beside{0.1 * i, 0.1 * i + 1e-9};
    EXPECT_NEAR(closest(l, {}, on).distance, closest(l, {}, beside).distance, 1e-8) << i;
    EXPECT_NEAR(distance(l, {}, disc, {on, {}}).distance, distance(l, {}, disc, {beside, {}}).distance, 1e-8) << i;
  }
  EXPECT_EQ(closest(l, {}, {0, 0}).distance, 0);  // the corner itself lies on the outline
}

/// A chain is a line: from a polygon in one piece it is as far as from that piece as a convex polygon.
TEST(PlanePolygon, ChainsAreLines) {
  const std::vector<Vec2<double>> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const Shape<double> polygon = Polygon<double>(square), convex = ConvexPolygon<double>(square);
  for (int i = 0; i < 40; ++i) {
    const Shape<double> chain = Chain<double>(std::vector<Vec2<double>>{{0, -1}, {3, -0.5}, {0, 2}});
    const Pose2<double> pose{{-0.1 * i, 0.05 * i}, Rot2<double>::from_angle(0.3 * i)};
    const Distance<double> d = distance(polygon, {}, chain, pose), expected = distance(convex, {}, chain, pose);
    EXPECT_NEAR(d.distance, expected.distance, 1e-12) << i;
    EXPECT_NEAR(dot(d.normal, expected.normal), 1, 1e-9) << i;
  }
}

TEST(PlanePolygon, RefusesOutlinesThatCrossAndNamesTheVertex) {
  const auto refused = [](const Points& points) {
    try {
      const Polygon<double> made(points);
      return std::string("made");
    } catch (const InvalidValue& e) {
      return e.path();
    }
  };
  EXPECT_EQ(refused({{0, 0}, {1, 0}}), "points");
  EXPECT_EQ(refused({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), "made");
  EXPECT_EQ(refused({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), "points[0]");          // a bow tie
  EXPECT_EQ(refused({{0, 0}, {2, 0}, {2, 0}, {0, 2}}), "points[2]");          // twice the same
  EXPECT_EQ(refused({{0, 0}, {2, 0}, {0, 2}, {0, 0}}), "points[3]");          // the first again
  EXPECT_EQ(refused({{0, 0}, {2, 0}, {1, 0}, {0, 2}}), "points[0]");          // back on itself
  EXPECT_EQ(refused({{0, 0}, {1, 0}, {2, 0}}), "points[1]");                  // no inside
  EXPECT_EQ(refused({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), "points[0]");  // touches itself at a vertex
  EXPECT_EQ(refused({{0, 0}, {1, std::nan("")}, {2, 0}}), "points[1][1]");
  EXPECT_EQ(refused({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}), "made");  // a vertex on a straight line
}

// Cuts of a polygon are not felt: a convex outline, cut or not, and an L as its two boxes where only one is near.
TEST(PlanePolygon, ContactsAreThoseOfTheOutline) {
  const Shaped l = Polygon<double>(Points{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}});
  const Shaped box = Box<double>({0.5, 0.5});
  for (double x = 1.3; x < 3.7; x += 0.01)
    for (const double depth : {1e-9, 1e-3, 0.05}) {
      Manifolds<double> m;
      EXPECT_TRUE(contacts<double>(l, {}, box, {{x, 1.25 - depth}, {}}, 0, m));
      ASSERT_EQ(m.size(), 1u) << x;
      ASSERT_EQ(m[0].points.size(), 2u) << x;
      EXPECT_EQ(m[0].normal.y, 1) << x;
      for (const auto& p : m[0].points) EXPECT_NEAR(p.distance, -depth, 1e-15);
    }
  // The way out of the corner's middle is the outer side, whichever piece has it.
  EXPECT_NEAR(closest<double>(l, {}, {0.4, 0.9}).distance, -0.4, 1e-15);
  EXPECT_NEAR((distance<double>(l, {}, Circle<double>(0.1), {{0.3, 2}, {}}).distance), -0.4, 1e-12);
}

/// Hills and a valley on a solid whose underside is far below: what comes in over the valley is pushed out by the
/// slopes, whichever pieces it lies in, and is as deep as they say. Its own corners may be cut too.
TEST(PlanePolygon, ValleysPushOutBySlopesAndNotByTheUnderside) {
  const Shaped ground = Polygon<double>(Points{{-3, -9}, {3, -9}, {3, 0}, {1, 0.5}, {0, 0}, {-1, 0.5}, {-3, 0}});
  const Shaped bracket = Polygon<double>(
      Points{{-0.5, -0.4}, {0.5, -0.4}, {0.5, 0.4}, {0.3, 0.4}, {0.3, -0.2}, {-0.3, -0.2}, {-0.3, 0.4}, {-0.5, 0.4}});
  for (const Shaped& body : {Shaped(Box<double>({0.6, 0.6})), Shaped(Circle<double>(0.3)), bracket})
    for (double x = -2; x <= 2; x += 0.0625)
      for (double angle = 0; angle < 6; angle += 0.25) {
        const Rot2d turned = Rot2d::from_angle(angle);
        double low = -1, high = 3;  // of the height at which the two touch
        while (high - low > 1e-9) {
          const double middle = (low + high) / 2;
          (overlap<double>(ground, {}, body, {{x, middle}, turned}) ? low : high) = middle;
        }
        const double pushed = 0.02;
        const Pose2d pose{{x, low - pushed}, turned};
        Manifolds<double> manifolds;
        ASSERT_TRUE(contacts<double>(ground, {}, body, pose, 0, manifolds));
        ASSERT_FALSE(manifolds.empty()) << x << ", " << angle;
        for (const Manifold<double>& m : manifolds) {
          EXPECT_GT(m.normal.y, 0) << x << ", " << angle;
          for (const ContactPoint<double>& p : m.points) EXPECT_GE(p.distance, -pushed * 1.0001) << x << ", " << angle;
        }
        // An upper bound: a piece is left by the slopes that bound it, which may be the longer way.
        EXPECT_GE(distance<double>(ground, {}, body, pose).distance, -pushed * 1.5) << x << ", " << angle;
      }
}

/// A bracket on a tall wall meets it at its base, not at the far end of the line that the base lies on.
TEST(PlanePolygon, AnEdgeBesideAPieceGivesNoContactOfItsOwn) {
  const Shaped bracket = Polygon<double>(
      Points{{-0.5, -0.4}, {0.5, -0.4}, {0.5, 0.4}, {0.3, 0.4}, {0.3, -0.2}, {-0.3, -0.2}, {-0.3, 0.4}, {-0.5, 0.4}});
  const Shaped wall = Box<double>({1, 80});
  for (const double lean : {-0.02, -0.01, -0.001, 0.001, 0.01, 0.02}) {
    const Rot2d turned = Rot2d::from_angle(-1.5707963267948966 + lean);
    Manifolds<double> manifolds;
    contacts<double>(wall, {}, bracket, {{0.88, 0}, turned}, 0, manifolds);
    ASSERT_FALSE(manifolds.empty()) << lean;
    for (const Manifold<double>& m : manifolds)
      for (const ContactPoint<double>& p : m.points) {
        EXPECT_LT(std::abs(p.a.y), 1) << lean;
        EXPECT_GT(p.distance, -0.05) << lean;
      }
  }
}

template <class T>
class PlaneChains : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneChains, Scalars);

template <class T>
std::vector<Shape<T>> sliders() {
  return {Box<T>({T(1), T(1)}), Circle<T>(T(0.5)), Capsule<T>(T(0.5), T(0.25)),
          Shape<T>(Box<T>({T(0.6), T(0.6)}), T(0.2)),
          ConvexPolygon<T>(std::vector<Vec2<T>>{{T(-0.5), T(-0.5)}, {T(0.5), T(-0.5)}, {T(0), T(0.5)}})};
}

// A straight floor of many segments is one floor, from both sides and to both: upright normals, the depth of a floor,
// and never more than one manifold.
TYPED_TEST(PlaneChains, StraightSeamsAreNotFelt) {
  using T = TypeParam;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  for (int round = 0; round < rounds(100); ++round) {
    std::vector<Vec2<T>> points;
    double x = -3;
    while (x < 3) {
      points.push_back({static_cast<T>(x), T(0)});
      x += 0.05 + u(random);
    }
    if (round % 2) std::reverse(points.begin(), points.end());
    // Seen from above the floor's front is its left where it runs to the right.
    const ChainSides sides = round % 2 && round % 3 ? ChainSides::one : ChainSides::both;
    const Shape<T> floor = Chain<T>(points, false, sides);
    for (const Shape<T>& body : sliders<T>()) {
      const double depth = u(random) < 0.3 ? 0 : std::pow(10, -1 - 6 * u(random));
      // At random and with a side right over a seam.
      const double at =
          random() % 3 ? 3 * u(random) - 1.5 : double(points[points.size() / 2].x) + (random() % 2 ? 0.5 : -0.5);
      const bool below = sides == ChainSides::both && random() % 2 && body.name() != std::string("convex");
      const double height = (0.5 - depth) * (below ? -1 : 1);
      Manifolds<T> m;
      contacts<T>(floor, {}, body, {{static_cast<T>(at), static_cast<T>(height)}, {}}, T(0.01), m);
      ASSERT_EQ(m.size(), 1u) << body.name() << " at " << at << " deep " << depth << " round " << round;
      EXPECT_NEAR(double(m[0].normal.x), 0, 2 * double(std::numeric_limits<T>::epsilon())) << body.name();
      EXPECT_EQ(m[0].normal.y, below ? T(-1) : T(1)) << body.name();
      EXPECT_EQ(m[0].points.size(), body.template as<Circle<T>>() || body.template as<Capsule<T>>() ? 1u : 2u)
          << body.name() << " at " << at << " deep " << depth << " round " << round;
      for (const auto& p : m[0].points) EXPECT_NEAR(double(p.distance), -depth, 1e-6) << body.name();
      Manifolds<T> back;
      contacts<T>(body, {{static_cast<T>(at), static_cast<T>(height)}, {}}, floor, {}, T(0.01), back);
      ASSERT_EQ(back.size(), 1u);
      EXPECT_EQ(back[0].normal.y, -m[0].normal.y);
    }
  }
}

// Over hills and through valleys of many segments, at a small depth: a normal is never steeper than the steepest
// segment beneath the body, and never against the way it slides more than those.
TYPED_TEST(PlaneChains, HillsAndValleysGiveNormalsOfTheirOwn) {
  using T = TypeParam;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> u(0, 1);
  const auto height = [](double x) { return 0.2 * std::sin(x); };
  std::vector<Vec2<T>> points;
  for (double x = 12; x > -12; x -= 0.17) points.push_back({static_cast<T>(x), static_cast<T>(height(x))});
  const Shape<T> chain = Chain<T>(points, false, ChainSides::both);
  for (int round = 0; round < rounds(500); ++round)
    for (const Shape<T>& body : sliders<T>()) {
      const double x = 16 * u(random) - 8, angle = 2 * std::numbers::pi * u(random);
      const Rot2<T> turn = Rot2<T>::from_angle(static_cast<T>(angle));
      // Lowered until it is 1e-3 deep.
      double low = -1, high = 3;
      for (int i = 0; i < 40; ++i) {
        const double y = (low + high) / 2;
        const bool touches = overlap<T>(chain, {}, body, {{static_cast<T>(x), static_cast<T>(y)}, turn});
        (touches ? low : high) = y;
      }
      const Pose2<T> pose{{static_cast<T>(x), static_cast<T>(high - 1e-3)}, turn};
      Manifolds<T> m;
      contacts<T>(chain, {}, body, pose, T(0), m);
      ASSERT_FALSE(m.empty()) << body.name() << " at " << x;
      for (const auto& manifold : m) {
        // The slope is at most 0.2, and the depth at most that of the fall.
        EXPECT_GE(double(manifold.normal.y), 1 / std::hypot(1, 0.2) - 1e-4)
            << body.name() << " at " << x << " " << angle;
        for (const auto& p : manifold.points) EXPECT_GE(double(p.distance), -1.1e-3) << body.name() << " at " << x;
      }
    }
}

// A point at the outline lies, by rounding, in one of the pieces that meet there, in several, or in none: it is no
// deeper for that.
TYPED_TEST(PlaneChains, APointAtTheOutlineOfASolidPolygonHasNoDepth) {
  using T = TypeParam;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Points> outlines = {{{4, -11}, {3, 0}, {0, 0}, {14, 99}, {-3, 3}}};
  for (int i = 0; i < rounds(20); ++i) outlines.push_back(random_star(9, random));
  for (const Points& outline : outlines) {
    std::vector<Vec2<T>> points;
    double size = 0;
    for (const Vec2d& p : outline) points.push_back(plane::converted<T>(p)), size = std::max(size, length(p));
    const Pose2<T> pose{{T(5), T(7)}, Rot2<T>::from_angle(T(0.9))};
    const double off = 16 * double(std::numeric_limits<T>::epsilon()) * (size + 9);
    for (const T rounding : {T(0), T(0.25)})
      for (std::size_t i = 0; i < points.size(); ++i)
        for (int k = 0; k < 40; ++k) {
          const Vec2d a = plane::converted<double>(points[i]),
                      b = plane::converted<double>(points[(i + 1) % points.size()]);
          const Vec2d at = a + (b - a) * (k % 2 ? 0 : (1 + u(random)) / 2) + Vec2d{u(random), u(random)} * (off / 16);
          const Vec2<T> point = transform(pose, plane::converted<T>(at));
          const Closest<T> found = closest(Shape<T>(Polygon<T>(points), rounding), pose, point);
          // A rounding ends further out, except that a reflex corner is filled: there it is deeper than by its radius.
          EXPECT_LE(double(found.distance), off - double(rounding)) << outline.size() << ' ' << i << ' ' << k;
          if (rounding == T(0)) {
            EXPECT_GE(double(found.distance), -off) << outline.size() << ' ' << i << ' ' << k;
            EXPECT_LE(double(length(found.point - point)), off);
          }
          EXPECT_LE(double(length((point - found.point) - found.normal * found.distance)), off);
        }
  }
}

// The normal of a curved shape is searched for and not exact, and the search names an edge by its nearer end, which may
// be a reflex vertex: no contact is lost for that, and the deepest is as far as the shapes are.
TYPED_TEST(PlaneChains, CurvedShapesKeepTheirContacts) {
  using T = TypeParam;
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(-1.6, 1.6);
  const std::vector<Shape<T>> curved = {Capsule<T>(T(0.5), T(0.2), T(0.3)), Capsule<T>(T(0.4), T(0.3), T(0)),
                                        Ellipse<T>({T(0.5), T(0.3)}), Shape<T>(Ellipse<T>({T(0.1), T(0.4)}), T(0.1))};
  int near = 0;
  for (int round = 0; round < rounds(60); ++round) {
    std::vector<Vec2<T>> points;
    for (const Vec2d& p : random_star(9, random)) points.push_back(plane::converted<T>(p));
    for (const Shape<T>& outlined : {Shape<T>(Polygon<T>(points)), Shape<T>(Chain<T>(points, true))})
      for (int k = 0; k < 40; ++k) {
        const Shape<T>& body = curved[static_cast<std::size_t>(k) % curved.size()];
        const Pose2<T> pose{{static_cast<T>(u(random)), static_cast<T>(u(random))},
                            Rot2<T>::from_angle(static_cast<T>(2 * u(random)))};
        const T apart = distance<T>(outlined, {}, body, pose).distance, margin = T(0.1);
        if (!(apart > 0 && apart < T(0.99) * margin)) continue;
        ++near;
        Manifolds<T> there, back;
        EXPECT_FALSE(contacts<T>(outlined, {}, body, pose, margin, there));
        EXPECT_FALSE(contacts<T>(body, pose, outlined, {}, margin, back));
        for (const Manifolds<T>& found : {there, back}) {
          ASSERT_FALSE(found.empty()) << outlined.name() << " " << body.name() << " round " << round << " " << k;
          T least = margin;
          for (const auto& manifold : found)
            for (const auto& point : manifold.points) least = std::min(least, point.distance);
          EXPECT_NEAR(double(least), double(apart), 100 * double(tolerance<T>)) << body.name();
        }
      }
  }
  EXPECT_GT(near, 200);
}

// Lines that cross, and ends that reach through a corner, leave no normal that belongs to an outline. Something pushes
// them apart all the same.
TYPED_TEST(PlaneChains, WhatOverlapsHasContacts) {
  using T = TypeParam;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto pose = [&] {
    return Pose2<T>{{static_cast<T>(u(random)), static_cast<T>(u(random))},
                    Rot2<T>::from_angle(static_cast<T>(3.2 * u(random)))};
  };
  int touching = 0, lines = 0;
  for (int round = 0; round < rounds(1500); ++round) {
    std::vector<Vec2<T>> star, line;
    for (const Vec2d& p : random_star(7, random)) star.push_back(plane::converted<T>(p));
    for (int i = 0; i < 2 + round % 5; ++i) line.push_back({static_cast<T>(u(random)), static_cast<T>(u(random))});
    const Shape<T> open = Chain<T>(line), ring = Chain<T>(star, true), solid = Polygon<T>(star);
    const Shape<T> convex = round % 2 ? Shape<T>(Box<T>({T(0.7), T(0.3)})) : Shape<T>(Ellipse<T>({T(0.5), T(0.3)}));
    const Shape<T> kinds[] = {open, ring, solid, convex, Compound<T>({{open, pose()}, {solid, pose()}})};
    for (const Shape<T>& a : kinds)
      for (const Shape<T>& b : kinds) {
        const Pose2<T> at_a = pose(), at_b = pose();
        if (!overlap<T>(a, at_a, b, at_b)) continue;
        ++touching;
        Manifolds<T> there, back;
        EXPECT_TRUE(contacts<T>(a, at_a, b, at_b, T(0), there));
        EXPECT_TRUE(contacts<T>(b, at_b, a, at_a, T(0), back));
        ASSERT_FALSE(there.empty()) << a.name() << " and " << b.name() << ", round " << round;
        ASSERT_EQ(there.empty(), back.empty()) << a.name() << " and " << b.name() << ", round " << round;
        for (const auto& manifold : there) ASSERT_FALSE(manifold.points.empty());
        if (a.template as<Chain<T>>() && b.template as<Chain<T>>()) ++lines;
      }
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(lines, 100);
}

// Two lines that cross are pushed apart along the shortest way, to the end of one of them.
TEST(PlaneChain, LinesThatCrossArePushedToTheNearestEnd) {
  const Shaped a = Chain<double>(Points{{-2, 0}, {2, 0}}), b = Chain<double>(Points{{0, -0.25}, {0, 1}});
  Manifolds<double> m;
  ASSERT_TRUE(contacts<double>(a, {}, b, {}, 0, m));
  ASSERT_EQ(m.size(), 1u);
  ASSERT_EQ(m[0].points.size(), 1u);
  EXPECT_DOUBLE_EQ(m[0].points[0].distance, -0.25);
  EXPECT_DOUBLE_EQ(m[0].normal.y, 1);
}

TEST(PlaneChain, SidesAreKept) {
  const Points square{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  const Shaped outward = Chain<double>(square, true, ChainSides::one), both = Chain<double>(square, true);
  const Shaped box = Box<double>({1, 1});
  const auto normals = [&](const Shaped& chain, const Vec2d& at) {
    Manifolds<double> m;
    contacts<double>(chain, {}, box, {at, {}}, 0, m);
    return m;
  };
  EXPECT_TRUE(normals(outward, {0, -1.6}).empty());
  ASSERT_EQ(normals(outward, {0, -2.4}).size(), 1u);
  EXPECT_EQ(normals(outward, {0, -2.4})[0].normal.y, -1);
  ASSERT_EQ(normals(both, {0, -1.6}).size(), 1u);
  EXPECT_EQ(normals(both, {0, -1.6})[0].normal.y, 1);
  EXPECT_EQ(normals(both, {0, -2.4})[0].normal.y, -1);
  // In the corner of the inside both sides hold it.
  EXPECT_EQ(normals(both, {-1.6, -1.6}).size(), 2u);
}

TEST(PlaneChain, RaysAndCastsMeetItsSegments) {
  const Shaped chain = Chain<double>(Points{{-2, 0}, {0, 1}, {2, 0}});
  const auto hit = raycast<double>(chain, {}, {{1, 3}, {0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 2.5, 1e-15);
  EXPECT_EQ(hit->piece, 1u);
  const auto fall = cast<double>(chain, {}, {}, Circle<double>(0.5), {{0, 4}, {}}, {{0, -1}, 0}, 10);
  ASSERT_TRUE(fall);
  EXPECT_NEAR(fall->t, 2.5, 1e-9);
  const Aabb2<double> box = bounds<double>(chain, {});
  EXPECT_NEAR(box.upper.y, 1, 1e-14);
  EXPECT_NEAR(box.lower.x, -2, 1e-14);
}

TEST(PlaneChain, RefusesPointsUponEachOther) {
  EXPECT_THROW(Chain<double>(Points{{0, 0}}), InvalidValue);
  EXPECT_THROW(Chain<double>(Points{{0, 0}, {0, 0}}), InvalidValue);
  EXPECT_THROW(Chain<double>(Points{{0, 0}, {1, 0}, {0, 0}}, true), InvalidValue);
}

}  // namespace
}  // namespace graze::plane
