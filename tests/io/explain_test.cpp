// Explanations: of every query and kind of pair, in text and as a picture.
#include "graze/io/explain.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "graze/error.hpp"

namespace graze::io {
namespace {

constexpr const char* shapes[] = {
    R"({"type": "sphere", "sphere": {"radius": 0.7}})",
    R"({"type": "capsule", "capsule": {"height": 1, "radiusBottom": 0.4, "radiusTop": 0.4}})",
    R"({"type": "capsule", "capsule": {"height": 1, "radiusBottom": 0.4, "radiusTop": 0.1}})",
    R"({"type": "box", "box": {"size": [1, 1.5, 0.7]}, "margin": 0.1})",
    R"({"type": "cylinder", "cylinder": {"height": 1, "radiusBottom": 0.5, "radiusTop": 0}})",
    R"({"type": "plane"})",
    R"({"type": "plane", "plane": {"sizeX": 2, "sizeZ": 1}})",
    R"({"type": "ellipsoid", "ellipsoid": {"radii": [1, 0.5, 0.3]}})",
    R"({"type": "convex", "convex": {"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[1,1,1]]}})",
    R"({"type": "triangle", "triangle": {"points": [[0,0,0],[1,0,0],[0,1,0.2]]}})",
};

std::string question(const std::string& query, const std::string& a, const std::string& b, double away) {
  const std::string margin = query == "contacts" ? R"("margin": 0.1, )" : "";
  return R"({"query": ")" + query + R"(", )" + margin + R"("a": {"shape": )" + a + R"(}, "b": {"shape": )" + b +
         R"(, "translation": [0.2, )" + std::to_string(away) + R"(, 0.1], "rotation": [0.1, 0.2, 0.3, 1]}})";
}

TEST(Explain, EveryPairHasItsTextAndItsPicture) {
  for (const char* a : shapes)
    for (const char* b : shapes)
      for (const char* query : {"overlap", "distance", "contacts"})
        for (const double away : {0.3, 4.0}) {
          const std::string asked = question(query, a, b, away);
          const bool endless = query != std::string("overlap") && a == b && a == shapes[5];
          if (endless) continue;  // two half-spaces have no depth
          const Explanation e = explain(asked, Precision::double_precision);
          const std::string text = explanation_text(e), picture = draw_explanation(e, {1, 0.6, 1.4});
          EXPECT_NE(text.find("method"), std::string::npos) << asked;
          EXPECT_FALSE(e.trace.method.empty()) << asked;
          EXPECT_TRUE(picture.ends_with("</svg>\n"));
          EXPECT_EQ(picture.find("nan"), std::string::npos) << asked;
          EXPECT_EQ(picture.find("inf"), std::string::npos) << asked;
        }
}

/// The axis that is named as the winner, if there is one.
const TraceAxis* winner_of(const Explanation& e) {
  const auto at = std::find_if(e.trace.axes.begin(), e.trace.axes.end(),
                               [&](const TraceAxis& axis) { return axis.name == e.trace.winner; });
  return at == e.trace.axes.end() ? nullptr : &*at;
}

TEST(Explain, TheWinnersOverlapIsTheDepth) {
  for (const int away : {0, 1, 2, 3}) {
    const Explanation e = explain(question("distance", shapes[3], shapes[8], 0.1 * away), Precision::double_precision);
    if (!e.overlap) continue;
    const TraceAxis* winner = winner_of(e);
    ASSERT_NE(winner, nullptr);
    EXPECT_NEAR(winner->overlap(), -e.distance->distance, 1e-9);
  }
}

// Rounding counts for the choice as for the intervals, and the answer's own normal is one of the axes.
TEST(Explain, TheReasonSaysWhatTheTableShows) {
  const auto says = [](const Explanation& e, const char* words) {
    return e.trace.reason.find(words) != std::string::npos;
  };
  int corners = 0, gaps = 0, overlaps = 0;
  for (const char* a : shapes)
    for (const char* b : shapes)
      for (const char* query : {"overlap", "distance", "contacts"})
        for (const double away : {0.3, 0.9, 1.44, 4.0}) {
          if (query != std::string("overlap") && a == b && a == shapes[5]) continue;  // two half-spaces have no depth
          const std::string asked = question(query, a, b, away);
          const Explanation e = explain(asked, Precision::double_precision);
          const TraceAxis* winner = winner_of(e);
          if (!winner || says(e, "nearly as good")) continue;
          if (says(e, "corners or round sides")) {
            ++corners;
            EXPECT_EQ(e.trace.winner, "normal") << asked;
          } else if (!says(e, "widest gap") && !says(e, "least overlap")) {
            continue;  // of pairs without axes of their own
          }
          for (const TraceAxis& axis : e.trace.axes)
            EXPECT_LE(winner->overlap(), axis.overlap() + 1e-9) << asked << ": " << axis.name;
          if (says(e, "corners or round sides")) continue;
          EXPECT_EQ(says(e, "least overlap"), e.overlap) << asked;
          ++(e.overlap ? overlaps : gaps);
        }
  EXPECT_GT(corners, 10);
  EXPECT_GT(gaps, 50);
  EXPECT_GT(overlaps, 50);
}

TEST(Explain, BothShapesOfAPictureAreLabelled) {
  for (const std::string query : {"distance", "contacts"})
    for (const double away : {0.0, 0.9, 4.0}) {
      const std::string picture = draw_explanation(
          explain(question(query, shapes[3], shapes[1], away), Precision::double_precision), {1, 1, 1});
      EXPECT_NE(picture.find(">A</text>"), picture.rfind(">A</text>")) << "beside the shape and over the list";
      EXPECT_NE(picture.find(">B</text>"), picture.rfind(">B</text>"));
    }
}

TEST(Explain, ShapesWithoutThicknessAreSeen) {
  const std::string needle = R"({"shape": {"type": "convex", "convex": {"points": [[-1, 0, 0], [1, 0, 0]]}}})";
  const Explanation e =
      explain(R"({"query": "raycast", "a": )" + needle + R"(, "ray": {"origin": [0, 1, 0], "direction": [0, -1, 0]}})",
              Precision::double_precision);
  const std::string blue = R"(stroke="#1f6feb" stroke-width="2.4")";
  EXPECT_NE(draw_explanation(e, {1, 0.6, 1.4}).find(blue), std::string::npos);
}

TEST(Explain, HalfSpacesThatOverlapWithoutEndHaveNoDistanceToExplain) {
  for (const char* turned : {R"("rotation": [1, 0, 0, 1]}})", R"("rotation": 1}, "dimension": 2})"}) {
    const std::string asked =
        R"({"query": "distance", "a": {"shape": {"type": "plane"}}, "b": {"shape": {"type": "plane"}, )" +
        std::string(turned);
    for (const Precision precision : {Precision::double_precision, Precision::single_precision})
      EXPECT_THROW(explain(asked, precision), InvalidValue) << asked;
  }
}

TEST(Explain, InThePlaneTwoBoxesHaveFourAxes) {
  const Explanation e = explain(
      R"({"query": "contacts", "dimension": 2, "a": {"shape": {"type": "box", "box": {"size": [2, 2]}}},
          "b": {"shape": {"type": "box", "box": {"size": [2, 2]}}, "translation": [1.5, 1], "rotation": 0.3}})",
      Precision::double_precision);
  std::string names;
  for (const TraceAxis& axis : e.trace.axes) names += axis.name + " ";
  EXPECT_EQ(names, "A0 A1 B0 B1 normal ");
  ASSERT_EQ(e.manifolds.size(), 1u);
  EXPECT_EQ(e.manifolds[0].points.size(), 2u);
  for (const auto& p : e.manifolds[0].points) EXPECT_EQ(p.a.z, 0);
}

TEST(Explain, InThePlaneAlignedBoxesHaveFourAxesToo) {
  const Explanation e = explain(
      R"({"query": "contacts", "dimension": 2, "a": {"shape": {"type": "box", "box": {"size": [2, 2]}}},
          "b": {"shape": {"type": "box", "box": {"size": [2, 2]}}, "translation": [1.5, 1]}})",
      Precision::double_precision);
  std::string names;
  for (const TraceAxis& axis : e.trace.axes) names += axis.name + " ";
  EXPECT_EQ(names, "A0 A1 B0 B1 normal ");
}

TEST(Explain, ProductsOfEdgesAreWrittenWithTheirSign) {
  const auto has = [](const Explanation& e, const std::string& name) {
    return std::any_of(e.trace.axes.begin(), e.trace.axes.end(), [&](const auto& axis) { return axis.name == name; });
  };
  EXPECT_TRUE(has(explain(question("distance", shapes[3], shapes[3], 1), Precision::double_precision), "A1×B0"));
  EXPECT_TRUE(has(explain(question("distance", shapes[3], shapes[1], 1), Precision::double_precision), "A0×B"));
  const Explanation hulls = explain(question("distance", shapes[8], shapes[9], 0), Precision::double_precision);
  EXPECT_TRUE(std::any_of(hulls.trace.axes.begin(), hulls.trace.axes.end(),
                          [](const TraceAxis& axis) { return axis.name.find(" × B edge ") != std::string::npos; }));
}

TEST(Explain, OfCompositesThePairOfPiecesThatDecides) {
  const std::string two = R"({"type": "compound", "compound": {"children": [
      {"shape": {"type": "box", "box": {"size": [1, 1, 1]}}},
      {"shape": {"type": "box", "box": {"size": [1, 1, 1]}}, "translation": [3, 0, 0]}]}})";
  const std::string box = R"({"type": "box", "box": {"size": [1, 1, 1]}})";
  for (const std::string query : {"overlap", "distance", "contacts"})
    for (const double y : {0.9, 1.05, 4.0}) {  // overlapping, within the margin, apart
      const std::string asked = R"({"query": ")" + query + R"(", )" +
                                (query == "contacts" ? R"("margin": 0.1, )" : "") +
                                R"("explain": true, "a": {"shape": )" + two + R"(}, "b": {"shape": )" + box +
                                R"(, "translation": [2.9, )" + std::to_string(y) + R"(, 0]}})";
      const Explanation e = explain(asked, Precision::double_precision);
      EXPECT_EQ(e.trace.method.find("pieces of composites, A piece 1 and B: "), 0u) << asked << e.trace.method;
      ASSERT_GT(e.trace.axes.size(), 6u) << asked;
      EXPECT_NEAR(e.trace.axes[1].overlap(), 1 - y, 1e-12);
    }
}

TEST(Explain, ClosestAndSinglePrecisionAreExplainedToo) {
  const Explanation e = explain(R"({"query": "closest", "a": {"shape": {"type": "box", "box": {"size": [2, 2, 2]}}},
                                    "point": [0.25, 0.75, 0]})",
                                Precision::single_precision);
  ASSERT_TRUE(e.distance);
  EXPECT_EQ(e.distance->distance, -0.25);
  EXPECT_TRUE(e.overlap);
  EXPECT_NE(draw_explanation(e, {0, 1, 0}).find("normal"), std::string::npos);
}

TEST(Explain, WhatTheProtocolRefusesIsRefused) {
  EXPECT_THROW(explain("nonsense", Precision::double_precision), InvalidValue);
  EXPECT_THROW(explain("[]", Precision::double_precision), InvalidValue);
  EXPECT_THROW(explain(R"({"query": "overlap"})", Precision::double_precision), InvalidValue);
  EXPECT_THROW(explain(R"({"query": "raycast", "a": {"shape": {"type": "sphere", "sphere": {"radius": 1}}},
                           "ray": {"origin": [0, 0, 0], "direction": [0, 0, 0]}})",
                       Precision::double_precision),
               InvalidValue);
}

TEST(Explain, FeaturesAreNamedByTheirParts) {
  EXPECT_EQ(feature_text(0xc0054000), "face 5 of A, vertex 0 of B");
  EXPECT_EQ(feature_text(0x80848002), "edge 132 of A, edge 2 of B");
}

}  // namespace
}  // namespace graze::io
