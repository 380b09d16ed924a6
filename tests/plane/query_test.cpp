#include <gtest/gtest.h>

#include "plane/figures.hpp"
#include "plane/orientation.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneQueries : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneQueries, Scalars);

template <class T, class F>
void for_random_pairs(int rounds, const F& f) {
  std::mt19937 random(7);
  for (const double scale : {1e-4, 1.0, 1e5})
    for (int round = 0; round < rounds; ++round)
      for (int i = 0; i < figure_kinds; ++i)
        for (int j = 0; j < figure_kinds; ++j) {
          const Figure<T> a = random_figure<T>(i, scale, random), b = random_figure<T>(j, scale, random);
          const Pose2<T> pose_a = random_pose<T>(scale / 2, random), pose_b = random_pose<T>(scale / 2, random);
          f(a, pose_a, b, pose_b, double(std::max(extent(a.shape), extent(b.shape))), scale);
        }
}

template <class T>
Wide gap_between(const Vec2<T>& a, const Vec2<T>& b) {
  return std::hypot(Wide(a.x) - Wide(b.x), Wide(a.y) - Wide(b.y));
}

TYPED_TEST(PlaneQueries, DistanceIsTheLargestGapOverAllDirections) {
  using T = TypeParam;
  for_random_pairs<T>(2, [](const auto& a, const auto& pose_a, const auto& b, const auto& pose_b, double size,
                            double scale) {
    const Distance<T> d = distance(a.shape, pose_a, b.shape, pose_b);
    const double expected = double(swept_distance(a, pose_a, b, pose_b));
    const double allowed = double(tolerance<T>) * size + double(d.error);
    const std::string pair = std::string(a.shape.name()) + " and " + b.shape.name() + " of " + std::to_string(scale);
    ASSERT_NEAR(double(d.distance), expected, allowed) << pair;
    if (std::abs(expected) > allowed) {
      ASSERT_EQ(overlap(a.shape, pose_a, b.shape, pose_b), expected <= 0) << pair;
    }
    // b - a = distance * normal, and moving B by -distance * normal makes the shapes touch.
    const double rounding = 16 * double(std::numeric_limits<T>::epsilon()) * scale * 3;
    ASSERT_LE(double(gap_between(d.b, d.a + d.normal * d.distance)), 4 * allowed + rounding) << pair;
    const Pose2<T> moved{pose_b.translation - d.normal * d.distance, pose_b.rotation};
    ASSERT_NEAR(double(swept_distance(a, pose_a, b, moved)), 0, 4 * allowed + rounding) << pair;
    const Distance<T> back = distance(b.shape, pose_b, a.shape, pose_a);
    ASSERT_NEAR(double(back.distance), double(d.distance), 2 * allowed) << pair;
  });
}

TYPED_TEST(PlaneQueries, ContactsHoldTheDeepestPointAndMirror) {
  using T = TypeParam;
  for_random_pairs<T>(3, [](const auto& a, const auto& pose_a, const auto& b, const auto& pose_b, double size,
                            double scale) {
    const T margin = static_cast<T>(0.1 * scale);
    Manifolds<T> there, back;
    const Distance<T> d = distance(a.shape, pose_a, b.shape, pose_b);
    const bool touch = contacts(a.shape, pose_a, b.shape, pose_b, margin, there);
    contacts(b.shape, pose_b, a.shape, pose_a, margin, back);
    const double allowed =
        2 * double(tolerance<T>) * size + double(d.error) + 48 * double(std::numeric_limits<T>::epsilon()) * scale;
    const std::string pair = std::string(a.shape.name()) + " and " + b.shape.name() + " of " + std::to_string(scale);
    ASSERT_EQ(touch, d.distance <= T(0)) << pair;
    if (std::abs(double(d.distance) - double(margin)) <= allowed) return;
    ASSERT_EQ(there.size(), d.distance <= margin ? 1u : 0u) << pair;
    ASSERT_EQ(back.size(), there.size()) << pair;
    if (there.empty()) return;
    ASSERT_LE(there[0].points.size(), 2u);
    // Where steps found the normal, it is right within the root of their goal, and so is the place along a side.
    const double on_surface = 1e-8 * size;
    double deepest = 1e300;
    for (const ContactPoint<T>& p : there[0].points) {
      deepest = std::min(deepest, double(p.distance));
      ASSERT_LE(double(gap_between(p.b, p.a + there[0].normal * p.distance)), allowed) << pair;
      // No point of a surface lies outside its shape, nor inside where that is convex: it is its own nearest point.
      ASSERT_LE(std::abs(double(closest(a.shape, pose_a, p.a).distance)), 16 * allowed + on_surface) << pair;
      ASSERT_LE(std::abs(double(closest(b.shape, pose_b, p.b).distance)), 16 * allowed + on_surface) << pair;
    }
    ASSERT_NEAR(deepest, double(d.distance), 4 * allowed) << pair;
  });
}

TEST(PlaneContacts, BoxesHaveTwoPointsNamedAlikeFromBothSides) {
  const Shaped a = Box<double>({2, 2}), b = Box<double>({1, 1});
  Manifolds<double> there, back;
  contacts<double>(a, {}, b, {{0.2, 1.4}, {}}, 0, there);
  contacts<double>(b, {{0.2, 1.4}, {}}, a, {}, 0, back);
  ASSERT_EQ(there[0].points.size(), 2u);
  ASSERT_EQ(back[0].points.size(), 2u);
  for (const auto& p : there[0].points) {
    EXPECT_NEAR(p.distance, -0.1, 1e-15);
    EXPECT_EQ(std::count_if(back[0].points.begin(), back[0].points.end(),
                            [&](const auto& q) { return q.feature == ((p.feature << 16) | (p.feature >> 16)); }),
              1);
  }
}

// Boxes edge on edge, as in a stack: neither a lean nor equal widths make the names of their points change.
TEST(PlaneContacts, NamesStayUnderJitter) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> jitter(-1e-4, 1e-4);
  const Shaped box = Box<double>({1, 1});
  for (const double offset : {0.0, 0.3, -0.7}) {
    std::vector<std::uint32_t> first;
    for (int frame = 0; frame < 1000; ++frame) {
      Manifolds<double> m;
      contacts<double>(box, {{}, Rot2<double>::from_angle(jitter(random))}, box,
                       {{offset + jitter(random), 0.999 + jitter(random)}, Rot2<double>::from_angle(jitter(random))},
                       0.01, m);
      ASSERT_EQ(m.size(), 1u);
      std::vector<std::uint32_t> names;
      for (const auto& p : m[0].points) names.push_back(p.feature);
      if (first.empty()) first = names;
      ASSERT_EQ(names, first) << offset << " frame " << frame;
    }
    EXPECT_EQ(first.size(), 2u);
  }
}

TEST(PlaneDistance, DegenerateShapes) {
  const auto between = [](const Shaped& a, const Shaped& b, double x, double y) {
    return distance<double>(a, {}, b, {{x, y}, {}}).distance;
  };
  const Shaped point = Box<double>({0, 0}), flat = Box<double>({2, 0}), piece = Segment<double>({-1, 0}, {1, 0});
  const Shaped spot = Segment<double>({0, 0}, {0, 0}), dot = Circle<double>(0);
  EXPECT_EQ(between(point, dot, 3, 4), 5);
  EXPECT_EQ(between(point, point, 0, 0), 0);
  EXPECT_EQ(between(spot, point, 3, 4), 5);
  EXPECT_EQ(between(piece, piece, 5, 0), 3);  // on one line
  EXPECT_EQ(between(piece, piece, 1, 0), 0);
  EXPECT_EQ(between(flat, piece, 5, 0), 3);
  EXPECT_EQ(between(flat, flat, 1, 2), 2);
  EXPECT_EQ(between(piece, Segment<double>({0, -1}, {0, 1}), 0.5, 0.25), -0.5);
  EXPECT_EQ(between(HalfPlane<double>(), spot, 7, 2), 2);
  EXPECT_EQ(distance<double>(Shaped(HalfPlane<double>()), {}, HalfPlane<double>(), {}).status, Status::unbounded);
}

// Edges in line with each other: the nearest point of the difference lies on the second of two.
TEST(PlaneDistance, BoxesInLine) {
  const Shaped large = Box<double>({2, 2}), small = Box<double>({1, 1});
  for (const double x : {-1.2, -0.9, -0.2, 0.2, 0.9, 1.2})
    for (const double y : {-1.4, 1.4}) {
      EXPECT_NEAR(distance<double>(large, {}, small, {{x, y}, {}}).distance, -0.1, 1e-15) << x << " " << y;
      EXPECT_NEAR(distance<double>(small, {{x, y}, {}}, large, {}).distance, -0.1, 1e-15) << x << " " << y;
      EXPECT_EQ(distance<double>(small, {{x, y}, {}}, large, {}).normal, (Vec2d{0, y < 0 ? 1.0 : -1.0}));
    }
}

TEST(PlaneDistance, PolygonsOfTenThousandVertices) {
  std::vector<Vec2d> points;
  for (int i = 0; i < 10000; ++i)
    points.push_back({std::cos(i * 6.283185307179586e-4), std::sin(i * 6.283185307179586e-4)});
  const ConvexPolygon<double> polygon(points);
  const double sagitta = 1 - std::cos(3.2e-4);
  EXPECT_GE(polygon.vertices().size(), 9990u);
  for (const double x : {3.0, 2.1, 1.9, 0.5})
    EXPECT_NEAR(distance<double>(polygon, {}, polygon, {{x * 0.6, x * 0.8}, Rot2<double>::from_angle(0.1)}).distance,
                x - 2, 2 * sagitta);
}

TEST(PlaneShapes, HullsKeepExactlyTheCorners) {
  const std::vector<Vec2d> grid = {{0, 0}, {0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, {0.3, 0}, {0.1, 0}, {0, 0.3}, {0.3, 0}};
  EXPECT_EQ(ConvexPolygon<double>(grid).vertices().size(), 4u);
  EXPECT_EQ(ConvexPolygon<float>(std::vector<Vec2f>{{1, 1}, {1, 1}}).vertices().size(), 1u);
  EXPECT_THROW(ConvexPolygon<float>(std::vector<Vec2f>{}), InvalidValue);
  EXPECT_THROW(Circle<double>(-1), InvalidValue);
  EXPECT_THROW(Box<double>({1, std::nan("")}), InvalidValue);
  EXPECT_THROW(Shaped(Compound<double>({{Circle<double>(1), {}}}), -0.5), InvalidValue);
  // A point a hair off the line through two others, told apart where rounding says they are one.
  EXPECT_GT(orientation({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 25.0)}), 0);
  EXPECT_LT(orientation({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 23.0)}), 0);
  EXPECT_EQ(orientation({0.5, 0.5}, {12, 12}, {24, 24}), 0);
}

}  // namespace
}  // namespace graze::plane
