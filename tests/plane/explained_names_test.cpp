// Explanations of polygons name edges as contacts do, and those of chains by the numbers of their segments.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "graze/feature.hpp"
#include "graze/plane/cast.hpp"
#include "graze/plane/query.hpp"

namespace graze::plane {
namespace {

const std::string edge = "A edge ";

/// A star of twelve corners, of which every other one is reflex.
std::vector<Vec2d> star() {
  std::vector<Vec2d> out;
  for (int i = 0; i < 12; ++i) {
    const double angle = std::numbers::pi * i / 6, reach = i % 2 == 0 ? 2 : 0.9;
    out.push_back({reach * std::cos(angle), reach * std::sin(angle)});
  }
  return out;
}

TEST(PlaneExplained, TheEdgeThatDecidesIsThatOfTheContact) {
  const std::vector<Vec2d> corners = star();
  const Shaped solid{Polygon<double>(corners)}, chain{Chain<double>(corners, true)}, ball{Circle<double>(0.1)};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-2, 2);
  int named = 0;
  for (int i = 0; i < 2000; ++i) {
    const double x = uniform(random), y = uniform(random);
    const Shaped& shape = i % 2 == 0 ? solid : chain;
    Trace trace;
    Manifolds<double> manifolds;
    contacts(shape, {}, ball, {{x, y}, {}}, 0.0, manifolds, &trace);
    for (const TraceAxis& axis : trace.axes)
      if (axis.name.starts_with(edge)) {
        // Its normal is that of the edge with that number, and no cut's.
        const std::size_t from = std::stoul(axis.name.substr(edge.size()));
        ASSERT_LT(from, corners.size());
        const Vec2d along = normalized(corners[(from + 1) % corners.size()] - corners[from]);
        ASSERT_NEAR(std::abs(dot(along, Vec2d{axis.direction.x, axis.direction.y})), 0, 1e-12) << axis.name;
      }
    if (manifolds.size() != 1 || !trace.winner.starts_with(edge)) continue;
    const Feature touched = feature_of_a(manifolds[0].points[0].feature);
    if (touched.kind != FeatureKind::edge) continue;
    // A chain's edge begins at its other vertex where it is met from the left.
    ASSERT_EQ(trace.winner, edge + std::to_string(&shape == &solid ? touched.number : manifolds[0].piece_a));
    ++named;
  }
  EXPECT_GT(named, 200);
}

TEST(PlaneExplained, ARayComesInThroughAnEdgeOfTheOutline) {
  const Shaped solid{Polygon<double>(star())};
  // From the right above the corner at (2, 0) on the edge that begins there.
  Trace trace;
  const auto hit = raycast<double>(solid, {}, {{3, 0.1}, {-1, 0}}, std::numeric_limits<double>::infinity(), &trace);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(trace.winner, "edge 0");
  int cuts = 0;
  for (const TraceSpan& span : trace.spans) cuts += span.name.starts_with("cut from ");
  EXPECT_GT(cuts, 0);
}

}  // namespace
}  // namespace graze::plane
