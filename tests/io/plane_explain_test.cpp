// Explanations of the plane: what a search shows agrees with the answer, which comes about in another way.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "graze/io/explain.hpp"
#include "graze/io/protocol.hpp"

namespace graze::io {
namespace {

std::string polygon_or_round(std::mt19937& random) {
  const auto u = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  switch (random() % 5) {
  case 0:
    return fmt::format(R"({{"type": "box", "box": {{"size": [{}, {}]}}, "margin": {}}})", u(0.2, 2), u(0.2, 2),
                       random() % 2 ? 0 : u(0, 0.2));
  case 1: return fmt::format(R"({{"type": "ellipse", "ellipse": {{"radii": [{}, {}]}}}})", u(0.2, 1), u(0.2, 1));
  case 2:
    return fmt::format(R"({{"type": "segment", "segment": {{"points": [[{}, {}], [{}, {}]]}}}})", u(-1, 1), u(-1, 1),
                       u(-1, 1), u(-1, 1));
  case 3: return fmt::format(R"({{"type": "circle", "circle": {{"radius": {}}}}})", u(0.1, 1));
  default: {
    std::string points;
    for (int i = 0; i < 9; ++i) points += fmt::format("{}[{}, {}]", i ? ", " : "", u(-1, 1), u(-1, 1));
    return fmt::format(R"({{"type": "convex", "convex": {{"points": [{}]}}}})", points);
  }
  }
}

/// The distance of the origin from the outline of B - A, negative inside.
double to_outline(const std::vector<TraceSupport>& difference) {
  double outside = 1e300, inside = 1e300;
  for (std::size_t i = 0; i < difference.size(); ++i) {
    const Vec3d p = difference[i].b - difference[i].a;
    const TraceSupport& next = difference[(i + 1) % difference.size()];
    const Vec3d e = next.b - next.a - p;
    const double l2 = dot(e, e), t = l2 > 0 ? std::clamp(-dot(p, e) / l2, 0.0, 1.0) : 0;
    outside = std::min(outside, length(p + e * t));
    if (l2 > 0) inside = std::min(inside, (p.x * e.y - p.y * e.x) / std::sqrt(l2));
  }
  return inside > 0 && inside < 1e300 ? -inside : outside;
}

TEST(PlaneExplain, TheSearchEndsAtTheAnswer) {
  std::mt19937 random(7);
  const auto u = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  int outside = 0, inside = 0;
  for (int round = 0; round < 500; ++round) {
    const std::string question = fmt::format(
        R"({{"query": "distance", "dimension": 2, "a": {{"shape": {}, "rotation": {}}},
            "b": {{"shape": {}, "translation": [{}, {}], "rotation": {}}}}})",
        polygon_or_round(random), u(-3, 3), polygon_or_round(random), u(-1.5, 1.5), u(-1.5, 1.5), u(-3, 3));
    const Explanation e = explain(question, Precision::double_precision);
    const double cores = e.distance->distance + e.trace.rounding;
    ASSERT_FALSE(e.trace.difference.empty()) << question;
    const bool curved = question.find("ellipse") != std::string::npos;
    EXPECT_NEAR(to_outline(e.trace.difference), cores, curved ? 5e-3 : 1e-9) << question;
    // Bounds close in on the answer and never cross it.
    double lower = 0;
    for (const TraceGjk& step : e.trace.gjk) {
      if (cores > 1e-9 && step.direction != Vec3d{}) {
        EXPECT_LE(step.lower, cores + 1e-9) << question;
        EXPECT_GE(step.upper, cores - 1e-9) << question;
      }
      EXPECT_GE(step.lower, lower - 1e-12 - (cores < 1e-9 ? 1e300 : 0));
      lower = step.lower;
    }
    if (cores > 1e-9) {
      ++outside;
      ASSERT_FALSE(e.trace.gjk.empty()) << question;
      EXPECT_NEAR(e.trace.gjk.back().upper, cores, 1e-8) << question;
    } else if (cores < -1e-9) {
      ++inside;
      ASSERT_FALSE(e.trace.epa.empty()) << question;
      EXPECT_NEAR(e.trace.epa.back().found_depth, -cores, 1e-8) << question;
      // The search knows a normal within the root of what it knows of a depth.
      EXPECT_NEAR(length(e.trace.epa.back().normal - e.distance->normal), 0, 2e-5) << question;
      for (const TraceEpa& step : e.trace.epa) EXPECT_GE(step.polygon.size(), 2u);
    }
  }
  EXPECT_GT(outside, 100);
  EXPECT_GT(inside, 100);
}

TEST(PlaneExplain, EveryShapeHasItsPicture) {
  const char* shapes[] = {
      R"({"type": "circle", "circle": {"radius": 0.5}})",
      R"({"type": "box", "box": {"size": [1, 2]}, "margin": 0.1})",
      R"({"type": "box", "box": {"size": [0, 0]}})",
      R"({"type": "capsule", "capsule": {"height": 1, "radiusBottom": 0.4, "radiusTop": 0.1}})",
      R"({"type": "plane"})",
      R"({"type": "ellipse", "ellipse": {"radii": [1, 0.5]}, "margin": 0.1})",
      R"({"type": "segment", "segment": {"points": [[-1, 0], [1, 0.5]]}})",
      R"({"type": "polygon", "polygon": {"points": [[-1, -1], [1, -1], [1, 1], [0, 0], [-1, 1]]}})",
      R"({"type": "polygon", "polygon": {"points": [[-1, -1], [1, -1], [1, 1], [0, 0], [-1, 1]]}, "margin": 0.2})",
      R"({"type": "chain", "chain": {"points": [[-1, 0], [0, 0.3], [1, 0]], "sides": "one"}})",
      R"({"type": "compound", "compound": {"children": [{"shape": {"type": "box", "box": {"size": [1, 1]}}},
          {"shape": {"type": "circle", "circle": {"radius": 0.4}}, "translation": [1, 0]}]}})",
      R"({"type": "compound", "margin": 0.2, "compound": {"children": [
          {"shape": {"type": "box", "box": {"size": [1, 1]}}},
          {"shape": {"type": "polygon", "polygon": {"points": [[-1, -1], [1, -1], [1, 1], [0, 0], [-1, 1]]}}}]}})"};
  for (const char* a : shapes)
    for (const char* b : shapes)
      for (const char* query : {"overlap", "contacts", "distance", "cast", "closest", "raycast"})
        for (const double away : {0.3, 5.0}) {
          const std::string what = query;
          if (what == "distance" && a == b && a == shapes[4]) continue;  // two half-planes have no depth
          const bool alone = what == "closest" || what == "raycast";
          if (alone && b != shapes[0]) continue;
          const std::string rest =
              what == "closest"   ? fmt::format(R"("point": [{}, 0.2])", away)
              : what == "raycast" ? fmt::format(R"("ray": {{"origin": [-4, {}], "direction": [1, -0.1]}})", away)
                                  : fmt::format(R"("b": {{"shape": {}, "translation": [{}, 0.4], "rotation": 0.3{}}})",
                                                b, away, what == "cast" ? R"(, "linear": [-4, 0])" : "");
          const std::string asked =
              fmt::format(R"({{"query": "{}", "dimension": 2, "a": {{"shape": {}}}, {}}})", query, a, rest);
          const Explanation e = explain(asked, Precision::double_precision);
          const std::string text = explanation_text(e), picture = draw_explanation(e, {1, 0.6, 1.4});
          EXPECT_FALSE(e.trace.method.empty()) << asked;
          EXPECT_TRUE(picture.ends_with("</svg>\n"));
          EXPECT_EQ(picture.find("nan"), std::string::npos) << asked;
          EXPECT_EQ(picture.find("inf"), std::string::npos) << asked;
        }
}

/// A compound with a margin is answered as one whose children have it, and is told as it was given.
TEST(PlaneExplain, AMarginOfACompoundIsOneOfItsChildren) {
  const auto question = [](const char* query, const char* whole, const char* part) {
    return fmt::format(
        R"({{"query": "{}", "dimension": 2, "a": {{"shape": {{"type": "compound"{}, "compound": {{"children": [
        {{"shape": {{"type": "box", "box": {{"size": [1, 1]}}{}}}}},
        {{"shape": {{"type": "circle", "circle": {{"radius": 0.5}}{}}}, "translation": [2, 0]}}]}}}}}},
        "b": {{"shape": {{"type": "circle", "circle": {{"radius": 0.5}}}}, "translation": [1, 0.6]}}}})",
        query, whole, part, part);
  };
  for (const char* query : {"overlap", "distance", "contacts", "cast"})
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
      const std::string of_whole = answer_line(question(query, R"(, "margin": 0.25)", ""), precision).text,
                        of_parts = answer_line(question(query, "", R"(, "margin": 0.25)"), precision).text;
      EXPECT_EQ(of_whole, of_parts) << query;
      EXPECT_EQ(of_whole.find("error"), std::string::npos) << of_whole;
      EXPECT_NE(of_whole, answer_line(question(query, "", ""), precision).text) << query;
    }
}

/// The value of an attribute of an element of a picture.
double attribute(const std::string& element, const std::string& name) {
  return std::stod(element.substr(element.find(" " + name + "=\"") + name.size() + 3));
}

TEST(PlaneExplain, TheCircleOfTheRoundingIsInThePicture) {
  for (const char* radii : {"0.5 0.5", "0.1 2", "1e-6 1e6"}) {
    const std::string two = radii, first = two.substr(0, two.find(' ')), second = two.substr(two.find(' ') + 1);
    const Explanation e =
        explain(fmt::format(R"({{"query": "overlap", "dimension": 2, "a": {{"shape": {{"type": "circle",
            "circle": {{"radius": {}}}}}}}, "b": {{"shape": {{"type": "box", "box": {{"size": [1, 1]}}, "margin": {}}},
            "translation": [0.15, 0.45], "rotation": 0.4}}}})",
                            first, second),
                Precision::double_precision);
    const std::string picture = draw_explanation(e, {0, 0, 1});
    const std::size_t dashes = picture.find("stroke-dasharray", picture.find("Minkowski difference"));
    ASSERT_NE(dashes, std::string::npos) << radii;
    const std::string circle = picture.substr(picture.rfind('<', dashes));
    ASSERT_TRUE(circle.starts_with("<circle")) << radii;
    const double x = attribute(circle, "cx"), y = attribute(circle, "cy"), r = attribute(circle, "r");
    EXPECT_GE(x - r, 0) << radii;
    EXPECT_GE(y - r, 600) << "below the shapes, " << radii;
    EXPECT_LE(y + r, attribute(picture, "height")) << radii;
    EXPECT_LE(x + r, 350) << "left of the steps, " << radii;
  }
}

TEST(PlaneExplain, AOneSidedChainSaysWhyItHasNoContacts) {
  const auto asked = [](const char* points) {
    return explain(fmt::format(R"({{"query": "contacts", "dimension": 2, "margin": 0.05,
        "a": {{"shape": {{"type": "chain", "chain": {{"points": {}, "sides": "one"}}}}}},
        "b": {{"shape": {{"type": "box", "box": {{"size": [1, 0.7]}}}}, "translation": [0, 0.25]}}}})",
                               points),
                   Precision::double_precision);
  };
  const Explanation front = asked("[[2, 0], [-2, 0]]"), behind = asked("[[-2, 0], [2, 0]]");
  ASSERT_TRUE(front.overlap && behind.overlap);
  ASSERT_NE(front.manifolds.empty(), behind.manifolds.empty());
  for (const Explanation* e : {&front, &behind})
    EXPECT_EQ(e->trace.reason.find("a chain of one side") != std::string::npos, e->manifolds.empty());
}

TEST(PlaneExplain, TheWayOutOfAPolygonIsNotThatOfItsPieces) {
  const std::string polygon =
      R"({"type": "polygon", "polygon": {"points": [[-1, -1], [1, -1], [1, 1], [0, 0], [-1, 1]]}})";
  int whole = 0;
  for (int i = 0; i < 40; ++i) {
    const Explanation e =
        explain(fmt::format(R"({{"query": "distance", "dimension": 2, "a": {{"shape": {}}}, "b": {{"shape": {},
            "translation": [{}, {}], "rotation": {}}}}})",
                            polygon, polygon, 0.02 * i, 0.03 * i - 0.4, 0.15 * i),
                Precision::double_precision);
    double least = 1e300, named = 1e300;
    for (const TraceAxis& axis : e.trace.axes) {
      least = std::min(least, axis.overlap());
      if (axis.name == e.trace.winner) named = axis.overlap();
    }
    ASSERT_LT(named, 1e300);
    const bool others = e.trace.reason.find("others are in the way") != std::string::npos;
    EXPECT_EQ(others, named > least + 1e-8) << e.trace.reason;
    whole += others ? 1 : 0;
  }
  EXPECT_GT(whole, 5);
}

TEST(PlaneExplain, BoxesAreDrawnOnAllFourAxes) {
  const Explanation e = explain(
      R"({"query": "contacts", "dimension": 2, "a": {"shape": {"type": "box", "box": {"size": [2, 2]}}},
          "b": {"shape": {"type": "box", "box": {"size": [2, 2]}}, "translation": [1.5, 1], "rotation": 0.3}})",
      Precision::double_precision);
  const std::string picture = draw_explanation(e, {0, 0, 1});
  for (const char* axis : {"A0: overlap", "A1: overlap", "B0: overlap", "B1: overlap", "Minkowski difference"})
    EXPECT_NE(picture.find(axis), std::string::npos) << axis;
}

TEST(PlaneExplain, ARoundedCornerIsASpanOfItsOwn) {
  const Explanation e = explain(
      R"({"query": "raycast", "dimension": 2, "a": {"shape": {"type": "box", "box": {"size": [2, 2]}, "margin": 0.5}},
          "ray": {"origin": [3, 3], "direction": [-1, -1]}})",
      Precision::double_precision);
  EXPECT_EQ(e.trace.winner, "corner 2");
  ASSERT_TRUE(e.ray->hit);
  EXPECT_NEAR(e.ray->hit->t, 2 * std::sqrt(2.0) - 0.5, 1e-12);
}

TEST(PlaneExplain, CastsShowTheirWayInTheDifference) {
  const std::string bodies = R"("a": {"shape": {"type": "box", "box": {"size": [2, 2]}}},
      "b": {"shape": {"type": "box", "box": {"size": [1, 1]}}, "translation": [4, 0.2], "linear": [-1, 0])";
  const Explanation straight =
      explain(R"({"query": "cast", "dimension": 2, "duration": 5, )" + bodies + "}}", Precision::double_precision);
  EXPECT_EQ(straight.trace.method, "ray against the Minkowski difference");
  EXPECT_TRUE(straight.trace.steps.empty());
  EXPECT_NEAR(to_outline(straight.trace.difference), 2.5, 1e-12);  // at the start
  const Explanation turning =
      explain(R"({"query": "cast", "dimension": 2, "duration": 5, )" + bodies + R"(, "angular": 1}})",
              Precision::double_precision);
  EXPECT_EQ(turning.trace.method, "conservative advancement");
  ASSERT_FALSE(turning.trace.steps.empty());
  EXPECT_NEAR(turning.trace.steps.back().t, turning.cast->hit->t, 1e-12);
  for (std::size_t i = 1; i < turning.trace.steps.size(); ++i)
    EXPECT_GE(turning.trace.steps[i].t, turning.trace.steps[i - 1].t);
}

}  // namespace
}  // namespace graze::io
