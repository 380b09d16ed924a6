// Polygons of few vertices by the axes of their edges, against the walk around the Minkowski difference, bit for bit,
// and against all vertices, edges and normals one by one in extended precision.
#include <gtest/gtest.h>

#include "plane/edge_axes.hpp"
#include "plane/entry_axes.hpp"
#include "plane/figures.hpp"
#include "plane/leaves.hpp"
#include "plane/nearest_axes.hpp"

namespace graze::plane {
namespace {

template <class T>
class PlaneEdgeAxes : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(PlaneEdgeAxes, Scalars);

using Point = std::pair<Wide, Wide>;

/// Points about a circle, all over a square, in a strip, or on a grid, where edges are in line and parallel.
template <class T>
Shape<T> random_polygon(std::size_t least_count, double scale, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Vec2<T>> points(least_count + random() % (17 - least_count));
  const std::uint32_t kind = random() % 4;
  const double radius = 0.6 + 0.4 * uniform(random), flat = kind == 2 ? 1e-3 : 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double angle = 6.283185307179586 * (double(i) + 0.3 * uniform(random)) / double(points.size());
    Vec2d p{uniform(random), flat * uniform(random)};
    if (kind == 0) p = {radius * std::cos(angle), radius * std::sin(angle)};
    if (kind == 3) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
    points[i] = converted<T>(p * scale);
  }
  return ConvexPolygon<T>(points);
}

/// A pair of polygons in place, with all that the routines take.
template <class T>
struct PolygonPair {
  Shape<T> a, b;
  Pose2d b_in_a;
  Core<T> core_a, core_b;
  double size;

  PolygonPair(const Shape<T>& shape_a, const Shape<T>& shape_b, const Pose2d& pose)
      : a(shape_a),
        b(shape_b),
        b_in_a(pose),
        core_a(convex_core(a)),
        core_b(convex_core(b)),
        size(std::max(double(extent(a)), double(extent(b)))) {}
  PolygonPair(const PolygonPair&) = delete;

  std::vector<Point> vertices(bool of_b) const {
    std::vector<Point> out;
    const Core<T>& core = of_b ? core_b : core_a;
    for (std::uint32_t i = 0; i < core.count; ++i) {
      const Vec2d own = core.vertex(i);
      const auto wide = [](double number) { return static_cast<Wide>(number); };
      const Wide x = wide(own.x), y = wide(own.y), c = wide(b_in_a.rotation.cosine), s = wide(b_in_a.rotation.sine);
      const Point moved{wide(b_in_a.translation.x) + (c * x - s * y), wide(b_in_a.translation.y) + (s * x + c * y)};
      out.push_back(of_b ? moved : Point{x, y});
    }
    return out;
  }
};

template <class T, class F>
void for_polygon_pairs(int rounds, const F& f) {
  std::mt19937 random(5);
  for (const double scale : {1e-4, 1.0, 1e5})
    for (int round = 0; round < rounds; ++round) {
      const bool first_small = random() % 4 == 0, second_small = !first_small && random() % 4 == 0;
      const Shape<T> a = random_polygon<T>(first_small ? 1 : 3, scale, random),
                     b = random() % 16 == 0 ? a : random_polygon<T>(second_small ? 1 : 3, scale, random);
      Pose2d pose = at_unit(random_pose<T>(random() % 2 ? scale / 2 : scale / 8, random));
      if (random() % 8 == 0)
        pose.translation = {std::round(pose.translation.x / scale) * scale,
                            std::round(pose.translation.y / scale) * scale};
      if (random() % 64 == 0) pose = {};
      PolygonPair<T> pair(a, b, pose);
      f(pair, scale, "round " + std::to_string(round) + " of " + std::to_string(scale));
    }
}

TYPED_TEST(PlaneEdgeAxes, AreTheWalkBitForBit) {
  using T = TypeParam;
  int answered = 0, all = 0;
  for_polygon_pairs<T>(20000, [&](const auto& pair, double, const std::string& name) {
    ++all;
    Nearest axes;
    if (!nearest_by_axes(pair.core_a, pair.core_b, pair.b_in_a, pair.size, axes)) return;
    ++answered;
    const Nearest walk = nearest_by_walk(pair.core_a, pair.core_b, pair.b_in_a);
    ASSERT_EQ(axes.distance, walk.distance) << name;
    ASSERT_EQ(axes.normal, walk.normal) << name;
    ASSERT_EQ(axes.a.point, walk.a.point) << name;
    ASSERT_EQ(axes.b.point, walk.b.point) << name;
    ASSERT_EQ(axes.a.feature, walk.a.feature) << name;
    ASSERT_EQ(axes.b.feature, walk.b.feature) << name;
  });
  EXPECT_GT(answered, all * 9 / 10);
}

Wide to_edge(const Point& p, const Point& from, const Point& to) {
  const Wide x = to.first - from.first, y = to.second - from.second, squared = x * x + y * y;
  Wide t = squared > 0 ? ((p.first - from.first) * x + (p.second - from.second) * y) / squared : 0;
  t = std::clamp(t, Wide(0), Wide(1));
  return std::hypot(p.first - from.first - t * x, p.second - from.second - t * y);
}

/// The largest gap along the normals of one polygon's edges, and the least distance of its edges from the other's
/// vertices.
void measure_edges(const std::vector<Point>& own, const std::vector<Point>& other, Wide& gap, Wide& distance) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Point p = own[i], q = own[(i + 1) % own.size()];
    for (const Point& v : other) distance = std::min(distance, to_edge(v, p, q));
    const Wide x = q.second - p.second, y = p.first - q.first, l = std::hypot(x, y);
    if (!(l > 0)) continue;
    Wide lowest = std::numeric_limits<Wide>::infinity();
    for (const Point& v : other) lowest = std::min(lowest, ((v.first - p.first) * x + (v.second - p.second) * y) / l);
    gap = std::max(gap, lowest);
  }
}

TYPED_TEST(PlaneEdgeAxes, HaveTheDistanceOfAllEdgesAndVertices) {
  using T = TypeParam;
  for_polygon_pairs<T>(5000, [](const auto& pair, double scale, const std::string& name) {
    Nearest found;
    if (!nearest_by_axes(pair.core_a, pair.core_b, pair.b_in_a, pair.size, found)) return;
    Wide gap = -std::numeric_limits<Wide>::infinity(), apart = std::numeric_limits<Wide>::infinity();
    const std::vector<Point> a = pair.vertices(false), b = pair.vertices(true);
    measure_edges(a, b, gap, apart);
    measure_edges(b, a, gap, apart);
    const double allowed = 1e-14 * scale;
    ASSERT_NEAR(found.distance, double(gap > 0 ? apart : gap), allowed) << name;
    ASSERT_NEAR(length(found.normal), 1, 1e-15) << name;
    // Of an edge of A and one of B in line with each other the foot may lie on the one that is not named.
    const auto is_vertex = [](std::uint32_t feature) { return feature >> graze::detail::feature_number_bits == 1; };
    if (found.distance > 0 || !is_vertex(found.a.feature) || !is_vertex(found.b.feature)) {
      ASSERT_LE(length(found.b.point - found.a.point - found.normal * found.distance), allowed) << name;
    }
    // Seen from the other side.
    const Pose2d a_in_b = relative(pair.b_in_a, Pose2d{});
    Nearest back;
    if (!nearest_by_axes(pair.core_b, pair.core_a, a_in_b, pair.size, back)) return;
    ASSERT_NEAR(back.distance, found.distance, allowed) << name;
    for (const double limit : {0.0, 0.1 * scale}) {
      const auto within = within_by_axes(pair.core_a, pair.core_b, pair.b_in_a, pair.size, limit);
      ASSERT_EQ(within.value_or(found.distance <= limit), found.distance <= limit) << name;
    }
  });
}

// The kernels of all levels find the nearest edge among others.
TYPED_TEST(PlaneEdgeAxes, KernelsOfAllLevelsFindTheNearestEdge) {
  using T = TypeParam;
  for (const Isa level : {Isa::baseline, Isa::avx2, Isa::avx512}) {
    if (!isa_available(level)) continue;
    const EdgeAxesKernels& kernels = GRAZE_KERNEL(level, plane_edge_axes)();
    for_polygon_pairs<T>(2000, [&](const auto& pair, double, const std::string& name) {
      if (pair.core_a.count < 3 || pair.core_b.count < 3) return;
      const auto kernel = [&] {
        if constexpr (std::is_same_v<T, float>)
          return kernels.of_float;
        else
          return kernels.of_double;
      }();
      const double slack = 1e-5 * (2 * pair.size + max_abs(pair.b_in_a.translation));
      const auto vertices = [](const Core<T>& core) { return core.outside ? core.outside : core.inside.data(); };
      EdgeAxes axes;
      kernel({vertices(pair.core_a), pair.core_a.count}, {vertices(pair.core_b), pair.core_b.count}, pair.b_in_a, slack,
             axes);
      ASSERT_TRUE(axes.regular) << name;
      const auto gap_of = [](const std::vector<Point>& own, const std::vector<Point>& other, std::size_t i) {
        const Point p = own[i], q = own[(i + 1) % own.size()];
        const Wide x = q.second - p.second, y = p.first - q.first, l = std::hypot(x, y);
        Wide lowest = std::numeric_limits<Wide>::infinity();
        for (const Point& v : other)
          lowest = std::min(lowest, ((v.first - p.first) * x + (v.second - p.second) * y) / l);
        return lowest;
      };
      const std::vector<Point> a = pair.vertices(false), b = pair.vertices(true);
      Wide best = -std::numeric_limits<Wide>::infinity();
      for (std::size_t i = 0; i < a.size(); ++i) best = std::max(best, gap_of(a, b, i));
      for (std::size_t i = 0; i < b.size(); ++i) best = std::max(best, gap_of(b, a, i));
      for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_TRUE((axes.edges_a >> i & 1) != 0 || gap_of(a, b, i) < best - Wide(slack) / 4) << name;
      for (std::size_t i = 0; i < b.size(); ++i)
        ASSERT_TRUE((axes.edges_b >> i & 1) != 0 || gap_of(b, a, i) < best - Wide(slack) / 4) << name;
      ASSERT_NEAR(double(axes.height), double(-best), slack / 4) << name;
    });
  }
}

/// The hits that the walk around the difference finds.
template <class T>
DifferenceHit hits_of_walk(const PolygonPair<T>& pair, const Vec2d& direction) {
  const double radius = pair.core_a.radius + pair.core_b.radius;
  DifferenceHit hit;
  for_each_difference_edge(pair.core_a, pair.core_b, pair.b_in_a, [&](const DifferenceEdge& e) {
    if (meet_edge(e.start, e.edge, radius, direction, hit.on_edge)) hit.edge = e;
    if (radius > 0 && meet_disc(e.start, radius, direction, hit.on_disc)) hit.vertex_a = e.i;
  });
  return hit;
}

/// Rays from outside, at the difference of two polygons and past it, and through its vertices; calls `f` with the pair,
/// the ray's direction, and the hits of the walk.
template <class T, class F>
void for_rays_at_differences(double rounding, F&& f) {
  std::mt19937 random(7);
  for_polygon_pairs<T>(20000, [&](auto& pair, double scale, const std::string& name) {
    pair.core_b.radius = rounding * scale;
    pair.size += pair.core_b.radius;
    if (!(nearest_polygons(pair.core_a, pair.core_b, pair.b_in_a, pair.size).distance > pair.core_b.radius)) return;
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double x = uniform(random), y = uniform(random);
    const Vec2d beside = Vec2d{x, y} * (random() % 2 ? scale : 0.0);
    const Vec2d to = pair.core_a.vertex(0) - transform(pair.b_in_a, pair.core_b.vertex(0)) + beside;
    const Vec2d direction = normalized(to);
    f(pair, direction, hits_of_walk(pair, direction), name);
  });
}

TYPED_TEST(PlaneEdgeAxes, EntriesAreThoseOfTheWalk) {
  using T = TypeParam;
  int answered = 0, hits = 0, all = 0;
  for_rays_at_differences<T>(
      0, [&](const auto& pair, const Vec2d& direction, const DifferenceHit& walk, const std::string& name) {
        ++all;
        DifferenceHit axes;
        if (!entry_by_axes(pair.core_a, pair.core_b, pair.b_in_a, direction, pair.size, axes)) return;
        ++answered;
        hits += axes.on_edge.t != never;
        ASSERT_EQ(axes.on_edge.t, walk.on_edge.t) << name;
        ASSERT_EQ(axes.on_edge.normal, walk.on_edge.normal) << name;
      });
  EXPECT_GT(answered, all * 3 / 4);
  EXPECT_GT(hits, all / 4);
}

// On roundings of a hundredth of the size and of half of it, rays meet edges and the discs about vertices.
TYPED_TEST(PlaneEdgeAxes, EntriesOfRoundedPolygonsAreThoseOfTheWalk) {
  using T = TypeParam;
  int answered = 0, edges = 0, discs = 0, all = 0;
  for (const double rounding : {0.01, 0.5})
    for_rays_at_differences<T>(
        rounding, [&](const auto& pair, const Vec2d& direction, const DifferenceHit& walk, const std::string& name) {
          ++all;
          DifferenceHit axes;
          if (!entry_by_axes(pair.core_a, pair.core_b, pair.b_in_a, direction, pair.size, axes)) return;
          ++answered;
          const bool on_disc = axes.on_disc.t < axes.on_edge.t;
          ASSERT_EQ(on_disc, walk.on_disc.t < walk.on_edge.t) << name;
          const OutlineHit &hit = on_disc ? axes.on_disc : axes.on_edge, &known = on_disc ? walk.on_disc : walk.on_edge;
          ASSERT_EQ(hit.t, known.t) << name;
          if (hit.t == never) return;
          ++(on_disc ? discs : edges);
          ASSERT_EQ(hit.normal, known.normal) << name;
          if (on_disc)
            ASSERT_EQ(axes.vertex_a, walk.vertex_a) << name;
          else
            ASSERT_EQ(axes.edge.start, walk.edge.start) << name;
        });
  EXPECT_GT(answered, all * 3 / 5);
  EXPECT_GT(edges, all / 10);
  EXPECT_GT(discs, all / 40);
}

// Beside an edge as short as a rounding lies another disc that is met as early: which one it is the walk decides.
TEST(PlaneEdgeAxes, DiscsARoundingApartAreLeftToTheWalk) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int met = 0;
  for (int round = 0; round < 2000; ++round) {
    const double length = std::pow(10, -16 + 2 * uniform(random));
    const PolygonPair<double> pair(random_polygon<double>(3, 1, random), Capsule<double>(length, 1),
                                   at_unit(random_pose<double>(4, random)));
    const double x = uniform(random), y = uniform(random);
    const Vec2d direction = normalized(Vec2d{x, y} - pair.b_in_a.translation);
    if (!(nearest_polygons(pair.core_a, pair.core_b, pair.b_in_a, pair.size).distance > pair.core_b.radius)) continue;
    const DifferenceHit walk = hits_of_walk(pair, direction);
    DifferenceHit axes;
    if (!entry_by_axes(pair.core_a, pair.core_b, pair.b_in_a, direction, pair.size, axes)) continue;
    ++met;
    const bool on_disc = axes.on_disc.t < axes.on_edge.t;
    ASSERT_EQ(on_disc ? axes.on_disc.t : axes.on_edge.t, std::min(walk.on_disc.t, walk.on_edge.t)) << round;
    if (on_disc) {
      ASSERT_EQ(axes.vertex_a, walk.vertex_a) << round;
    }
  }
  EXPECT_GT(met, 200);
}

// Sizes that floats cannot square are left to the walk, and so are more vertices than the kernel has lanes.
TEST(PlaneEdgeAxes, LeaveTheRestToTheWalk) {
  for (const double scale : {1e-18, 1e16}) {
    const std::vector<Vec2d> points{{0, 0}, {scale, 0}, {0, scale}};
    const PolygonPair<double> pair(ConvexPolygon<double>{points}, ConvexPolygon<double>{points},
                                   Pose2d{{scale / 4, scale / 4}, {}});
    Nearest out;
    EXPECT_FALSE(nearest_by_axes(pair.core_a, pair.core_b, pair.b_in_a, pair.size, out));
    EXPECT_NEAR(nearest_polygons(pair.core_a, pair.core_b, pair.b_in_a, pair.size).distance / scale,
                -0.5 / std::sqrt(2.0), 1e-15);
  }
  for (const int count : {16, 17}) {
    std::vector<Vec2d> points;
    for (int i = 0; i < count; ++i)
      points.push_back({std::cos(6.283185307179586 * i / count), std::sin(6.283185307179586 * i / count)});
    const PolygonPair<double> pair(ConvexPolygon<double>{points}, ConvexPolygon<double>{points},
                                   Pose2d{{1.5, 0.2}, {}});
    Nearest out;
    EXPECT_EQ(nearest_by_axes(pair.core_a, pair.core_b, pair.b_in_a, pair.size, out), count == 16);
  }
}

}  // namespace
}  // namespace graze::plane
