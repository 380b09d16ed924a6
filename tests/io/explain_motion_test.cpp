// Explanations of rays and of bodies that move: that they change nothing of the answer, and that they agree with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "graze/io/explain.hpp"
#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

constexpr const char* convex_shapes[] = {
    R"({"type": "sphere", "sphere": {"radius": 0.7}})",
    R"({"type": "capsule", "capsule": {"height": 1, "radiusBottom": 0.4, "radiusTop": 0.4}})",
    R"({"type": "capsule", "capsule": {"height": 1, "radiusBottom": 0.4, "radiusTop": 0.1}})",
    R"({"type": "box", "box": {"size": [1, 1.5, 0.7]}})",
    R"({"type": "box", "box": {"size": [1, 1.5, 0.7]}, "margin": 0.1})",
    R"({"type": "cylinder", "cylinder": {"height": 1, "radiusBottom": 0.5, "radiusTop": 0.5}})",
    R"({"type": "cylinder", "cylinder": {"height": 1, "radiusBottom": 0.5, "radiusTop": 0}})",
    R"({"type": "cylinder", "cylinder": {"height": 1, "radiusBottom": 0.5, "radiusTop": 0.2}, "margin": 0.1})",
    R"({"type": "plane"})",
    R"({"type": "plane", "plane": {"sizeX": 2, "sizeZ": 1}})",
    R"({"type": "ellipsoid", "ellipsoid": {"radii": [1, 0.5, 0.3]}})",
    R"({"type": "ellipsoid", "ellipsoid": {"radii": [1, 0.5, 0.3]}, "margin": 0.2})",
    R"({"type": "convex", "convex": {"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[1,1,1]]}})",
    R"({"type": "convex", "convex": {"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[1,1,1]]}, "margin": 0.1})",
    R"({"type": "convex", "convex": {"points": [[-1,0,0],[1,0,0],[1,1,0],[-1,1,0]]}})",
    R"({"type": "triangle", "triangle": {"points": [[-1,0,0],[1,0,0],[0,1,0.2]]}})",
    R"({"type": "triangle", "triangle": {"points": [[-1,0,0],[1,0,0],[0,1,0.2]]}, "margin": 0.1})",
};
constexpr const char* composites[] = {
    R"({"type": "mesh", "mesh": {"points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "triangles": [[0,2,1],[0,1,3],[0,3,2],[1,2,3]]}})",
    R"({"type": "heightfield", "heightfield": {"columns": 4, "rows": 3, "heights": [0,1,0,0, 0,0.3,0.5,0, 0,0.2,1,null]}})",
    R"({"type": "compound", "compound": {"children": [{"shape": {"type": "sphere"}, "translation": [1, 0, 0]},
        {"shape": {"type": "compound", "compound": {"children": [{"shape": {"type": "box"}}, {"shape": {"type": "mesh",
         "mesh": {"points": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,2]]}}, "translation": [0, 0, -1]}]}}},
        {"shape": {"type": "plane"}, "translation": [0, -2, 0]}]}})",
};

std::vector<std::string> all_shapes() {
  std::vector<std::string> all(std::begin(convex_shapes), std::end(convex_shapes));
  all.insert(all.end(), std::begin(composites), std::end(composites));
  return all;
}

/// Numbers that are the same in every run.
class Numbers {
 public:
  double operator()(double scale) { return std::uniform_real_distribution<double>(-scale, scale)(engine_); }
  Json vector(double scale) { return {(*this)(scale), (*this)(scale), (*this)(scale)}; }
  Json rotation() { return {(*this)(1), (*this)(1), (*this)(1), (*this)(1)}; }

 private:
  std::mt19937 engine_{7};
};

Json ray_question(const std::string& shape, Numbers& next) {
  const Json origin = next.vector(4), target = next.vector(1);
  Json direction = Json::array();
  for (std::size_t i = 0; i < 3; ++i) direction.push_back(target[i].get<double>() - origin[i].get<double>());
  return {{"query", "raycast"},
          {"a", {{"shape", Json::parse(shape)}, {"translation", next.vector(0.3)}, {"rotation", next.rotation()}}},
          {"ray", {{"origin", origin}, {"direction", direction}}}};
}

Json cast_question(const std::string& a, const std::string& b, Numbers& next) {
  const auto body = [&](const std::string& shape, double away, double speed) -> Json {
    Json placed{{"shape", Json::parse(shape)}, {"translation", {next(0.5), away + next(0.5), next(0.5)}}};
    if (shape.find(R"("plane"})") == std::string::npos) {
      placed["rotation"] = next.rotation();
      placed["angular"] = next.vector(1);
    }
    placed["linear"] = {next(0.3), speed, next(0.3)};
    return placed;
  };
  return {{"query", "cast"}, {"duration", 3}, {"a", body(a, 0, 0)}, {"b", body(b, 4, -1.5)}};
}

/// The answer with its trace, and without; both as text.
void expect_the_same_answer(Json question, Precision precision) {
  const std::string plain = answer_line(question.dump(), precision).text;
  question["explain"] = true;
  const std::string explained = answer_line(question.dump(), precision).text;
  const std::size_t trace = explained.find(",\"trace\":");
  ASSERT_NE(trace, std::string::npos) << explained << question;
  EXPECT_EQ(explained.substr(0, trace) + "}", plain) << question;
}

TEST(ExplainMotion, TheAnswerIsTheOrdinaryOne) {
  Numbers next;
  for (const std::string& shape : all_shapes())
    for (int i = 0; i < 20; ++i)
      for (const Precision precision : {Precision::double_precision, Precision::single_precision})
        expect_the_same_answer(ray_question(shape, next), precision);
  for (const std::string& a : all_shapes())
    for (const char* b : {convex_shapes[0], convex_shapes[3], convex_shapes[12], composites[0]})
      for (const Precision precision : {Precision::double_precision, Precision::single_precision})
        expect_the_same_answer(cast_question(a, b, next), precision);
}

// The spans are found by other formulas than the answer.
TEST(ExplainMotion, TheLastSpanToBeEnteredIsTheHit) {
  Numbers next;
  std::size_t hits = 0, misses = 0;
  for (const char* shape : convex_shapes)
    for (int i = 0; i < 100; ++i) {
      const Json question = ray_question(shape, next);
      const Explanation e = explain(question.dump(), Precision::double_precision);
      if (e.trace.spans.empty()) continue;
      const bool of_any = e.trace.method.find("balls") != std::string::npos;
      double enter = -1e300, leave = 1e300;
      for (const TraceSpan& span : e.trace.spans) {
        if (of_any && span.name != "balls and side") continue;
        enter = std::max(enter, span.enter);
        leave = std::min(leave, span.leave);
      }
      EXPECT_EQ(enter <= leave && leave >= 0, e.ray->hit.has_value()) << question << e.trace.method;
      (e.ray->hit ? hits : misses) += 1;
      if (e.ray->hit) {
        EXPECT_NEAR(std::max(enter, 0.0), e.ray->hit->t, 1e-9) << question << e.trace.method;
      }
    }
  EXPECT_GT(hits, 300u);
  EXPECT_GT(misses, 100u);
}

TEST(ExplainMotion, StepsOfARayLeadToItsHit) {
  Numbers next;
  std::size_t seen = 0;
  for (const char* shape : convex_shapes)
    for (int i = 0; i < 40; ++i) {
      const Explanation e = explain(ray_question(shape, next).dump(), Precision::double_precision);
      if (e.trace.steps.empty() || !e.ray->hit || e.ray->hit->t == 0) continue;
      ++seen;
      for (std::size_t k = 1; k < e.trace.steps.size(); ++k) EXPECT_LT(e.trace.steps[k - 1].t, e.trace.steps[k].t);
      EXPECT_NEAR(e.trace.steps.back().t, e.ray->hit->t, 1e-8);
      EXPECT_NEAR(e.trace.steps.back().distance, 0, 1e-8);
    }
  EXPECT_GT(seen, 50u);
}

TEST(ExplainMotion, StepsOfACastLeadToItsContact) {
  Numbers next;
  std::size_t hits = 0, misses = 0;
  for (const std::string& a : all_shapes())
    for (const char* b : {convex_shapes[0], convex_shapes[3], convex_shapes[12], composites[0]}) {
      const Json question = cast_question(a, b, next);
      const Explanation e = explain(question.dump(), Precision::double_precision);
      ASSERT_FALSE(e.trace.steps.empty()) << question;
      for (std::size_t k = 1; k < e.trace.steps.size(); ++k) EXPECT_LT(e.trace.steps[k - 1].t, e.trace.steps[k].t);
      if (e.cast->hit) {
        ++hits;
        EXPECT_EQ(e.trace.steps.back().t, e.cast->hit->t) << question;
        EXPECT_NEAR(e.trace.steps.back().distance, -e.cast->hit->depth, 1e-8) << question;
        EXPECT_EQ(e.trace.winner.empty(), false) << question;
      } else {
        ++misses;
        EXPECT_GT(e.trace.steps.back().distance, 0) << question;
      }
      EXPECT_LE(e.trace.steps.size(), 65u);
    }
  EXPECT_GT(hits, 20u);
  EXPECT_GT(misses, 5u);
}

TEST(ExplainMotion, OfACompositeItTellsHowMuchWasVisited) {
  std::string points, triangles;
  const int n = 20;
  for (int r = 0; r <= n; ++r)
    for (int c = 0; c <= n; ++c) {
      points += (points.empty() ? "" : ",") + Json{c, 0, r}.dump();
      const int at = r * (n + 1) + c;
      if (r == n || c == n) continue;
      triangles += (triangles.empty() ? "" : ",") + Json{at, at + n + 1, at + 1}.dump() + "," +
                   Json{at + 1, at + n + 1, at + n + 2}.dump();
    }
  const std::string question = R"({"query": "raycast", "ray": {"origin": [7.3, 5, 3.2], "direction": [0, -1, 0]},
      "a": {"shape": {"type": "mesh", "mesh": {"points": [)" +
                               points + R"(], "triangles": [)" + triangles + "]}}}}";
  const Explanation e = explain(question, Precision::double_precision);
  EXPECT_GE(e.trace.nodes, 2u);
  EXPECT_GE(e.trace.pieces, 1u);
  EXPECT_LT(e.trace.pieces, 40u);  // of 800
  EXPECT_NE(e.trace.method.find("triangle " + std::to_string(e.ray->hit->piece)), std::string::npos) << e.trace.method;
  EXPECT_NE(explanation_text(e).find("visited"), std::string::npos);
}

TEST(ExplainMotion, InThePlaneARayHasTheSpansOfItsEdges) {
  const Explanation box = explain(
      R"({"query": "raycast", "dimension": 2, "a": {"shape": {"type": "box", "box": {"size": [2, 2]}}},
          "ray": {"origin": [-3, 0.5], "direction": [1, 0.2]}})",
      Precision::double_precision);
  ASSERT_EQ(box.trace.spans.size(), 4u);
  EXPECT_EQ(box.trace.winner, "edge 3");  // the left one
  EXPECT_NEAR(box.trace.spans[3].enter, box.ray->hit->t, 1e-12);
  const Explanation circle = explain(
      R"({"query": "raycast", "dimension": 2, "a": {"shape": {"type": "circle", "circle": {"radius": 1}}},
          "ray": {"origin": [-3, 0.5], "direction": [1, 0.05]}})",
      Precision::double_precision);
  ASSERT_EQ(circle.trace.spans.size(), 1u);
  EXPECT_NEAR(circle.trace.spans[0].enter, circle.ray->hit->t, 1e-12);
}

/// How many numbers of a picture are none.
std::size_t broken(const std::string& picture) {
  std::size_t count = 0;
  for (const char* word : {"nan", "inf"})
    for (std::size_t at = picture.find(word); at != std::string::npos; at = picture.find(word, at + 1)) ++count;
  return count;
}

TEST(ExplainMotion, EveryShapeHasItsPictures) {
  Numbers next;
  for (const std::string& shape : all_shapes())
    for (int i = 0; i < 6; ++i) {
      const Json ray = ray_question(shape, next), cast = cast_question(shape, convex_shapes[3], next);
      for (const Json& question : {ray, cast}) {
        const Explanation e = explain(question.dump(), Precision::double_precision);
        const std::string picture = draw_explanation(e, {1, 0.6, 1.4});
        EXPECT_TRUE(picture.ends_with("</svg>\n"));
        EXPECT_EQ(broken(picture), 0u) << question;
        EXPECT_NE(explanation_text(e).find("method"), std::string::npos);
        EXPECT_FALSE(e.trace.method.empty()) << question;
        EXPECT_FALSE(e.trace.reason.empty()) << question;
      }
    }
}

// Two half-spaces that are not opposite overlap from the start.
TEST(ExplainMotion, HalfSpacesThatOverlapHitAtOnce) {
  const Json answer = ask(R"({"query": "cast", "explain": true, "a": {"shape": {"type": "plane"}},
                              "b": {"shape": {"type": "plane"}, "rotation": [0, 0, 1, 1]}})");
  EXPECT_EQ(answer["hit"], true) << answer;
  EXPECT_EQ(answer["t"], 0) << answer;
  EXPECT_FALSE(answer.contains("bounded")) << answer;
  EXPECT_TRUE(answer.contains("trace")) << answer;
}

}  // namespace
}  // namespace graze::io
