// What is drawn is what the library says: every call of a renderer is recorded and held against the scene.
#include "graze/draw.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "draw/draw_recorder.hpp"

namespace graze::testing {
namespace {

/// Twice the area that triangles cover, signed as seen along -Z.
double doubled_area(const std::vector<DrawnPart>& triangles) {
  double sum = 0;
  for (const DrawnPart& t : triangles) sum += cross(t.at[1] - t.at[0], t.at[2] - t.at[0]).z;
  return sum;
}

/// Six times the volume within triangles that turn counter-clockwise seen from outside.
double sixfold_volume(const std::vector<DrawnPart>& triangles) {
  double sum = 0;
  for (const DrawnPart& t : triangles) sum += dot(t.at[0], cross(t.at[1], t.at[2]));
  return sum;
}

TEST(DebugDraw, FacesOfABoxEncloseItAndItsEdgesAreLines) {
  DrawRecorder drawn;
  draw(drawn, Shaped(Box<double>({2, 4, 6})), Posed{{10, 20, 30}, {}}, DrawMeaning::a);
  EXPECT_EQ(drawn.triangles.size(), 12u);
  EXPECT_NEAR(sixfold_volume(drawn.triangles), 6 * 48.0, 1e-9);
  EXPECT_EQ(drawn.lines.size(), 12u) << "each edge once, though two faces have it";
  EXPECT_EQ(count_of(drawn.triangles, DrawLayer::shapes, DrawMeaning::a), 12u);
  for (const DrawnPart& line : drawn.lines)
    EXPECT_TRUE(std::fmod(length(line.at[1] - line.at[0]), 2.0) == 0) << "no diagonal of a face is an edge";
}

TEST(DebugDraw, EdgesThatTrianglesOfAHeightFieldShareAreDrawnOnce) {
  DrawRecorder drawn;
  draw(drawn, Shaped(HeightField<double>(3, 2, {0, 0.1, 0.2, 0, 0.3, 0}, 1, 1)), Posed{});
  EXPECT_EQ(drawn.triangles.size(), 4u);
  EXPECT_EQ(drawn.lines.size(), 9u) << "four along X, three along Z, and two diagonals";
}

TEST(DebugDraw, ShapesWithoutThicknessAreLinesAndPoints) {
  const auto expect = [](const auto& shape, std::size_t lines, std::size_t points, const char* what) {
    using T = std::decay_t<decltype(shape.rounding())>;
    const Pose<T> pose{{T(1), T(2), T(3)}, normalized(Quat<T>{T(0.1), T(0.2), T(0.3), T(0.9)})};
    DrawRecorder drawn;
    draw(drawn, shape, pose, DrawMeaning::a);
    EXPECT_EQ(drawn.triangles.size(), 0u) << what;
    EXPECT_EQ(count_of(drawn.lines, DrawLayer::shapes, DrawMeaning::a), lines) << what;
    EXPECT_EQ(count_of(drawn.points, DrawLayer::shapes, DrawMeaning::a), points) << what;
    for (const auto* parts : {&drawn.lines, &drawn.points})
      for (const DrawnPart& part : *parts)
        for (const Vec3d& p : part.at)
          EXPECT_NEAR(double(closest(shape, pose, converted<T>(p)).distance), 0, 2e-6) << what;
  };
  const auto each = [&]<class T>(T) {
    expect(Shape<T>(LineSegment<T>({T(-1), T(0), T(0)}, {T(1), T(0), T(0)})), 1, 0, "segment");
    expect(Shape<T>(ConvexHull<T>(std::vector<Vec3<T>>{{T(-1), T(0), T(0)}, {T(1), T(1), T(0)}})), 1, 0, "hull of two");
    expect(Shape<T>(Box<T>({T(1), T(0), T(0)})), 1, 0, "box with one side");
    expect(Shape<T>(Capsule<T>(T(1), T(0), T(0))), 1, 0, "capsule without radius");
    expect(Shape<T>(Cylinder<T>(T(1), T(0), T(0))), 1, 0, "cylinder without radius");
    expect(Shape<T>(Ellipsoid<T>({T(0), T(2), T(0)})), 1, 0, "ellipsoid with one radius");
    expect(Shape<T>(ConvexHull<T>(std::vector<Vec3<T>>{{T(1), T(0), T(0)}})), 0, 1, "hull of one");
    expect(Shape<T>(Box<T>({T(0), T(0), T(0)})), 0, 1, "box without sides");
    expect(Shape<T>(Sphere<T>(T(0))), 0, 1, "sphere without radius");
    expect(Shape<T>(Compound<T>({{Shape<T>(LineSegment<T>({T(-1), T(0), T(0)}, {T(1), T(0), T(0)})), {}},
                                 {Shape<T>(Sphere<T>(T(0))), {{T(0), T(1), T(0)}, {}}}})),
           1, 1, "compound of thin shapes");
  };
  each(float{});
  each(double{});
}

TEST(DebugDraw, EveryShapeHasFacesOnItsSurfaceInBothPrecisions) {
  const auto check = [](const auto& shape) {
    using T = std::decay_t<decltype(shape.rounding())>;
    const Pose<T> pose{{T(1), T(-2), T(0.5)}, normalized(Quat<T>{T(0.2), T(-0.4), T(0.1), T(0.8)})};
    const Polygons polygons = tessellate(shape, pose, {}, 1.0);
    ASSERT_FALSE(polygons.points.empty());
    for (const Vec3d& p : polygons.points) {
      const auto nearest = closest(shape, pose, converted<T>(p));
      EXPECT_NEAR(double(nearest.distance), 0, 2e-6);
    }
  };
  const auto each = [&]<class T>(T) {
    check(Shape<T>(Sphere<T>(T(1.5))));
    check(Shape<T>(Capsule<T>(T(2), T(0.5), T(0.75))));
    check(Shape<T>(Box<T>({T(1), T(2), T(3)}), T(0.25)));
    check(Shape<T>(Cylinder<T>(T(2), T(1), T(0.25))));
    check(Shape<T>(Ellipsoid<T>({T(1), T(2), T(0.5)})));
    check(Shape<T>(HalfSpace<T>()));
    check(Shape<T>(Triangle<T>({T(0), T(0), T(0)}, {T(1), T(0), T(0)}, {T(0), T(1), T(0)})));
    check(Shape<T>(Compound<T>(
        {{Shape<T>(Sphere<T>(T(1))), {{T(3), T(0), T(0)}, {}}}, {Shape<T>(Box<T>({T(1), T(1), T(1)})), {}}})));
  };
  each(float{});
  each(double{});
}

TEST(DebugDraw, APolygonThatIsNotConvexIsCoveredOnce) {
  const std::vector<plane::Vec2d> notch{{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};
  DrawRecorder drawn;
  draw(drawn, plane::Shaped(plane::Polygon<double>(notch)), plane::Pose2d{}, DrawMeaning::fixed);
  EXPECT_NEAR(doubled_area(drawn.triangles), 2 * 8.0, 1e-12);
  EXPECT_EQ(drawn.lines.size(), notch.size());
}

TEST(DebugDraw, AChainIsItsLines) {
  const std::vector<plane::Vec2f> points{{0, 0}, {1, 0}, {2, 1}};
  DrawRecorder drawn;
  draw(drawn, plane::Shape<float>(plane::Chain<float>(points)), plane::Pose2<float>{});
  EXPECT_TRUE(drawn.triangles.empty());
  ASSERT_EQ(drawn.lines.size(), 2u);
  EXPECT_EQ(drawn.lines[0].at[1], (Vec3d{1, 0, 0}));
}

TEST(DebugDraw, ABoxHasTwelveEdgesAFlatOneFourAndOneWithoutAnEndNone) {
  const auto edges = [](const Aabbd& box) {
    DrawRecorder drawn;
    draw(drawn, box);
    EXPECT_EQ(count_of(drawn.lines, DrawLayer::bounds, DrawMeaning::bounds), drawn.lines.size());
    double sum = 0;
    for (const DrawnPart& line : drawn.lines) sum += length(line.at[1] - line.at[0]);
    return std::pair{drawn.lines.size(), sum};
  };
  EXPECT_EQ(edges({{0, 0, 0}, {1, 2, 3}}), (std::pair{std::size_t{12}, 24.0}));
  EXPECT_EQ(edges({{0, 0, 0}, {1, 2, 0}}), (std::pair{std::size_t{4}, 6.0}));
  EXPECT_EQ(edges({{0, 0, 0}, {0, 2, 3}}), (std::pair{std::size_t{4}, 10.0}));
  EXPECT_EQ(edges({{1, 0, 0}, {1, 0, 3}}), (std::pair{std::size_t{1}, 3.0}));
  EXPECT_EQ(edges(Aabbd::everything()).first, 0u);
  EXPECT_EQ(edges(Aabbd::empty()).first, 0u);
}

TEST(DebugDraw, AManifoldIsItsPointsAndOneArrow) {
  const Shaped box = Box<double>({2, 2, 2});
  Manifolds<double> manifolds;
  ASSERT_TRUE(contacts(box, Posed{}, box, Posed{{0, 1.9, 0}, {}}, 0.0, manifolds));
  ASSERT_EQ(manifolds.size(), 1u);
  DrawRecorder drawn(DrawArea{{}, 12});
  draw(drawn, manifolds[0]);
  ASSERT_EQ(drawn.points.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(drawn.points[i].at[0], manifolds[0].points[i].position());
  ASSERT_EQ(drawn.lines.size(), 3u);
  EXPECT_NEAR(length(drawn.lines[0].at[0] - Vec3d{0, 0.95, 0}), 0, 1e-12);
  EXPECT_NEAR(length(drawn.lines[0].at[1] - drawn.lines[0].at[0] - Vec3d{0, 1, 0}), 0, 1e-12)
      << "a twelfth of the area, from A to B";
}

TEST(DebugDraw, ADistanceIsTheWayBetweenItsPoints) {
  const Shapef ball = Sphere<float>(1.0f);
  const auto d = distance(ball, Posef{}, ball, Posef{{3, 0, 0}, {}});
  DrawRecorder drawn;
  draw(drawn, d);
  ASSERT_EQ(drawn.lines.size(), 1u);
  EXPECT_EQ(drawn.lines[0].at, (std::vector<Vec3d>{{1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(count_of(drawn.points, DrawLayer::distances, DrawMeaning::a), 1u);
  EXPECT_EQ(count_of(drawn.points, DrawLayer::distances, DrawMeaning::b), 1u);
}

TEST(DebugDraw, ARayEndsAtItsHitOrOutsideTheArea) {
  const Shaped ball = Sphere<double>(1.0);
  const Ray<double> ray{{-5, 0, 0}, {2, 0, 0}};
  DrawRecorder drawn(DrawArea{{}, 2});
  draw(drawn, ray, std::numeric_limits<double>::infinity(), raycast(ball, Posed{}, ray));
  ASSERT_EQ(count_of(drawn.lines, DrawLayer::rays, DrawMeaning::path), 1u);
  EXPECT_EQ(drawn.lines[0].at[1], (Vec3d{-1, 0, 0}));
  EXPECT_EQ(count_of(drawn.points, DrawLayer::rays, DrawMeaning::contact), 1u);

  DrawRecorder missed(DrawArea{{}, 2});
  draw(missed, ray, std::numeric_limits<double>::infinity(), std::optional<RayHit<double>>{});
  ASSERT_FALSE(missed.lines.empty());
  EXPECT_EQ(missed.lines[0].at[1], (Vec3d{2, 0, 0}));
  EXPECT_TRUE(missed.points.empty());
}

TEST(DebugDraw, ACastShowsWhereItCameFromAndWhereItMet) {
  const Shaped ball = Sphere<double>(1.0), wall = HalfSpace<double>();
  const Posed from{{0, 5, 0}, {}};
  const Velocity<double> down{{0, -1, 0}, {}};
  const auto hit = cast(ball, from, down, wall, Posed{}, Velocity<double>{}, 10.0);
  ASSERT_TRUE(hit);
  DrawRecorder drawn;
  draw(drawn, ball, from, down, 10.0, hit);
  EXPECT_EQ(count_of(drawn.points, DrawLayer::casts, DrawMeaning::contact), 1u);
  ASSERT_GE(count_of(drawn.lines, DrawLayer::casts, DrawMeaning::path), 1u);
  double lowest = 5;
  for (const DrawnPart& t : drawn.triangles)
    for (const Vec3d& p : t.at) lowest = std::min(lowest, p.y);
  EXPECT_NEAR(lowest, 0, 1e-6) << "nothing is drawn beyond the hit";
  EXPECT_GT(count_of(drawn.triangles, DrawLayer::casts, DrawMeaning::ghost), 0u);
}

TEST(DebugDraw, ATraceOfSeparatingAxesShowsTheOneThatDecidedByName) {
  const Shaped box = Box<double>({2, 2, 2});
  Trace trace;
  const Posed away{{3, 0.2, 0}, normalized(Quatd{0.1, 0.2, 0.3, 0.9})};
  ASSERT_FALSE(overlap(box, Posed{}, box, away, &trace));
  DrawRecorder drawn(DrawArea{{1.5, 0, 0}, 6});
  draw(drawn, trace);
  ASSERT_EQ(drawn.texts.size(), 1u);
  EXPECT_EQ(drawn.texts[0].words, trace.winner);
  ASSERT_EQ(count_of(drawn.lines, DrawLayer::trace, DrawMeaning::gap), 1u);
  const auto winner =
      std::find_if(trace.axes.begin(), trace.axes.end(), [&](const TraceAxis& a) { return a.name == trace.winner; });
  ASSERT_NE(winner, trace.axes.end());
  for (const DrawnPart& line : drawn.lines)
    if (line.meaning == DrawMeaning::gap) {
      EXPECT_NEAR(length(line.at[1] - line.at[0]), -winner->overlap(), 1e-12) << "the gap in true length";
    }
}

TEST(DebugDraw, ATraceOfASearchShowsTheMinkowskiDifference) {
  const Shaped hull = ConvexHull<double>(std::vector<Vec3d>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  const Shaped cylinder = Cylinder<double>(2, 1, 1);
  Trace trace;
  distance(hull, Posed{}, cylinder, Posed{{0.2, 0.1, 0.3}, {}}, &trace);
  ASSERT_FALSE(trace.gjk.empty() && trace.polytope.empty());
  DrawRecorder drawn;
  draw(drawn, trace);
  EXPECT_EQ(count_of(drawn.points, DrawLayer::trace, DrawMeaning::normal) > 0,
            !trace.gjk.empty() || !trace.epa.empty());
  EXPECT_EQ(drawn.triangles.size(), trace.triangles.size());
}

TEST(DebugDraw, AnAxisStandsWhereTheAreaIsAndItsIntervalsHaveTheirTrueLengths) {
  const TraceAxis axis{"A1", {0, 1, 0}, -2, 5, 4, 30};
  DrawRecorder drawn(DrawArea{{7, 100, 0}, 6});
  draw(drawn, axis);
  ASSERT_EQ(drawn.lines.size(), 3u);
  const double lengths[] = {7, 26, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& at = drawn.lines[i].at;
    EXPECT_DOUBLE_EQ(at[1].y - at[0].y, lengths[i]) << "however small the area is";
    EXPECT_NEAR(at[0].x, 7, 0.1 + 1e-12) << "a sixtieth of the area beside each other";
  }
  EXPECT_EQ(drawn.lines[2].meaning, DrawMeaning::contact);
  ASSERT_EQ(drawn.texts.size(), 1u);
  EXPECT_EQ(drawn.texts[0].at[0], (Vec3d{7, 4.5, 0}));

  DrawRecorder endless(DrawArea{{0, 0, 0}, 6});
  const double infinite = std::numeric_limits<double>::infinity();
  draw(endless, TraceAxis{"normal", {0, 1, 0}, -infinite, 0, 1, 2});
  ASSERT_EQ(endless.lines.size(), 3u);
  EXPECT_DOUBLE_EQ(endless.lines[0].at[0].y, -6);

  DrawRecorder other(DrawArea{{}, 6});
  draw(other, axis, false);
  EXPECT_EQ(count_of(other.lines, DrawLayer::trace, DrawMeaning::ruled_out), 2u);
  EXPECT_TRUE(other.texts.empty());
}

TEST(DebugDraw, TheSpansOfARayLieOnIt) {
  const Shaped box = Box<double>({2, 4, 6});
  const Ray<double> ray{{-5, 0.5, 0.25}, {4, 0.5, 0.25}};
  Trace trace;
  const auto hit = raycast(box, Posed{}, ray, 100.0, BackFaces::hit, &trace);
  ASSERT_TRUE(hit);
  ASSERT_GE(trace.spans.size(), 3u);
  const Vec3d way = normalized(ray.direction);
  for (const TraceSpan& span : trace.spans) {
    const bool decides = span.name == trace.winner;
    DrawRecorder drawn(DrawArea{{}, 8});
    draw(drawn, span, ray, decides);
    ASSERT_FALSE(drawn.lines.empty()) << span.name;
    for (const Vec3d& p : drawn.lines[0].at) EXPECT_NEAR(length(cross(p - ray.origin, way)), 0, 1e-12) << span.name;
    EXPECT_NEAR(length(drawn.lines[0].at[1] - drawn.lines[0].at[0]), span.leave - span.enter, 1e-12) << span.name;
    ASSERT_EQ(drawn.points.size(), decides ? 1u : 0u) << span.name;
    if (!decides) continue;
    EXPECT_NEAR(length(drawn.points[0].at[0] - hit->point), 0, 1e-12);
    EXPECT_EQ(drawn.texts.at(0).words, trace.winner);
  }
  const double infinite = std::numeric_limits<double>::infinity();
  DrawRecorder endless(DrawArea{{}, 8}), never(DrawArea{{}, 8});
  draw(endless, TraceSpan{"below", {0, 1, 0}, -infinite, infinite}, Ray<double>{{0, -3, 0}, {2, 0, 0}});
  ASSERT_EQ(endless.lines.size(), 1u);
  EXPECT_EQ(endless.lines[0].at, (std::vector<Vec3d>{{-8, -3, 0}, {8, -3, 0}}));
  draw(never, TraceSpan{"above", {0, 1, 0}, infinite, -infinite}, Ray<double>{{0, -3, 0}, {2, 0, 0}});
  EXPECT_TRUE(never.lines.empty() && never.points.empty());
}

TEST(DebugDraw, ACutShowsTheSideThatCutsAndWhatIsLeft) {
  const TraceCut cut{{0, 0, 0}, {2, 0, 0}, {{0, 1, 0}, {2, 1, 0}, {1, 2, 0}}};
  DrawRecorder drawn;
  draw(drawn, cut);
  ASSERT_EQ(drawn.lines.size(), 4u);
  EXPECT_EQ(drawn.lines[0].meaning, DrawMeaning::normal);
  EXPECT_EQ(drawn.lines[0].at, (std::vector<Vec3d>{cut.from, cut.to}));
  EXPECT_EQ(count_of(drawn.lines, DrawLayer::trace, DrawMeaning::contact), 3u);
  EXPECT_EQ(count_of(drawn.points, DrawLayer::trace, DrawMeaning::contact), 3u);
}

TEST(DebugDraw, AnExpansionLeadsFromTheOriginToTheNearestSide) {
  const plane::Shaped a = plane::Polygon<double>(std::vector<plane::Vec2d>{{-1, -1}, {1, -0.8}, {0.9, 1}, {-1.1, 0.7}});
  const plane::Shaped b = plane::Ellipse<double>({1, 0.6});
  Trace trace;
  plane::distance(a, {}, b, plane::Pose2d{{0.7, 0.3}, {}}, &trace);
  ASSERT_FALSE(trace.epa.empty());
  for (const TraceEpa& expansion : trace.epa) {
    DrawRecorder drawn;
    draw(drawn, expansion);
    const auto way = std::find_if(drawn.lines.begin(), drawn.lines.end(),
                                  [](const DrawnPart& line) { return line.meaning == DrawMeaning::gap; });
    ASSERT_NE(way, drawn.lines.end());
    const Vec3d end = way->at[1];
    EXPECT_DOUBLE_EQ(length(end), expansion.face_depth);
    std::size_t on_side = 0;
    for (const TraceSupport& s : expansion.polygon)
      if (std::abs(dot(s.b - s.a - end, end)) <= 1e-9) ++on_side;
    EXPECT_GE(on_side, 2u);
  }
}

TEST(DebugDraw, AnIterationWhoseSimplexHoldsTheOriginHasNoDirection) {
  const TraceGjk enclosed{{{{0, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {-1, -1, 0}}}, {}, {}, 0, 0};
  DrawRecorder drawn;
  draw(drawn, enclosed);
  EXPECT_EQ(drawn.points.size(), 3u) << "two corners and the origin, nothing found";
  EXPECT_EQ(drawn.lines.size(), 1u) << "no arrow";
}

TEST(DebugDraw, TheTwoShapesOfAQueryAreBlueAndOrange) {
  const DrawColor a = suggested_color(DrawMeaning::a), b = suggested_color(DrawMeaning::b);
  EXPECT_EQ((std::array{int(a.red), int(a.green), int(a.blue)}), (std::array{0x1f, 0x6f, 0xeb}));
  EXPECT_EQ((std::array{int(b.red), int(b.green), int(b.blue)}), (std::array{0xd9, 0x82, 0x2b}));
}

TEST(DebugDraw, MeaningsThatStandBesideEachOtherHaveColoursOfTheirOwn) {
  const auto apart = [](DrawMeaning p, DrawMeaning q) {
    const DrawColor a = suggested_color(p), b = suggested_color(q);
    return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
  };
  EXPECT_GT(apart(DrawMeaning::a, DrawMeaning::b), 150);
  EXPECT_GT(apart(DrawMeaning::moving, DrawMeaning::touching), 100);
  EXPECT_GT(apart(DrawMeaning::contact, DrawMeaning::normal), 150);
}

}  // namespace
}  // namespace graze::testing
