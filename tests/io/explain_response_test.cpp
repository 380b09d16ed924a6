// Explanations of blows: that they agree with the answer of the protocol, and that each has its picture.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "graze/io/explain.hpp"
#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

/// Questions with bodies of all kinds: with a shape and without, immovable, in space and in the plane.
class Blows {
 public:
  Json next() {
    const bool flat = engine_() % 2 == 0;
    Json question = {{"query", "response"}, {"contact", {{"point", vector(flat)}, {"normal", unit(flat)}}}};
    if (flat) question["dimension"] = 2;
    question["a"] = body(flat, engine_() % 3 == 0);
    question["b"] = body(flat, false);
    question["restitution"] = number() * 0.5 + 0.5;
    question["friction"] = engine_() % 4 == 0 ? 0 : 5 * (number() + 1);
    return question;
  }

 private:
  double number() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  Json vector(bool flat) { return flat ? Json{number(), number()} : Json{number(), number(), number()}; }
  Json unit(bool flat) {
    const double angle = 3 * number(), up = flat ? 0 : number(), across = std::sqrt(1 - up * up);
    const Json normal = {across * std::cos(angle), across * std::sin(angle), up};
    return flat ? Json{normal[0], normal[1]} : normal;
  }
  Json body(bool flat, bool immovable) {
    Json body = {{"translation", vector(flat)}, {"linear", vector(flat)}};
    body["angular"] = flat ? Json(number()) : vector(false);
    body["rotation"] = flat ? Json(number()) : Json{number(), number(), number(), number() + 2};
    if (immovable && engine_() % 2 == 0)
      body["shape"] = {{"type", "plane"}};
    else if (engine_() % 2 == 0)
      body["shape"] = flat ? Json{{"type", "polygon"}, {"polygon", {{"points", {{0, 0}, {2, 0}, {0, 1}}}}}}
                           : Json{{"type", "box"}, {"box", {{"size", {1, 2, 0.5}}}}};
    else if (!immovable)
      body["inertia"] = flat ? Json(2) : Json{1, 2, 2.5};
    body["mass"] = immovable ? Json("infinity") : Json(number() + 2);
    return body;
  }

  std::mt19937 engine_{11};
};

void expect_equal(const Vec3d& v, const Json& numbers, const Json& asked) {
  EXPECT_EQ(v.x, numbers[0].get<double>()) << asked;
  EXPECT_EQ(v.y, numbers[1].get<double>()) << asked;
  EXPECT_EQ(v.z, numbers.size() > 2 ? numbers[2].get<double>() : 0) << asked;
}

TEST(ExplainResponse, TheAnswerIsTheProtocols) {
  Blows blows;
  for (int i = 0; i < 300; ++i) {
    const Json asked = blows.next(), answer = ask(asked.dump());
    const Explanation e = explain(asked.dump(), Precision::double_precision);
    ASSERT_TRUE(e.response.has_value());
    const Response<double>& r = e.response->result;
    EXPECT_EQ(r.normal_impulse, answer["normalImpulse"].get<double>()) << asked;
    expect_equal(r.impulse, answer["impulse"], asked);
    expect_equal(r.a.linear, answer["a"]["linear"], asked);
    expect_equal(r.b.linear, answer["b"]["linear"], asked);
    const Json& turning = answer["b"]["angular"];
    EXPECT_EQ(r.b.angular.z, (turning.is_array() ? turning[2] : turning).get<double>()) << asked;
  }
}

TEST(ExplainResponse, EveryBlowHasItsPictureAndItsTable) {
  Blows blows;
  for (int i = 0; i < 300; ++i) {
    const Json asked = blows.next();
    for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
      const Explanation e = explain(asked.dump(), precision);
      const std::string picture = draw_explanation(e, {1, 0.6, 1.4}), table = explanation_text(e);
      EXPECT_TRUE(picture.ends_with("</svg>\n"));
      EXPECT_EQ(picture.find("nan"), std::string::npos) << asked;
      EXPECT_EQ(picture.find("inf"), std::string::npos) << asked;
      EXPECT_NE(picture.find("effective mass"), std::string::npos) << asked;
      EXPECT_NE(picture.find("impulse on B</text>"), std::string::npos) << asked;
      EXPECT_NE(table.find("at fault"), std::string::npos) << asked;
    }
  }
}

// The centroid of this triangle is a third of its sides from the right angle, not at the origin of its points.
TEST(ExplainResponse, AShapeIsDrawnWithItsCentreOfMassAtTheBody) {
  const Explanation e = explain(
      R"({"query": "response", "dimension": 2, "a": {"mass": "infinity"}, "b": {"mass": 1, "translation": [5, 7],
          "shape": {"type": "polygon", "polygon": {"points": [[0, 0], [3, 0], [0, 6]]}}, "linear": [0, -1]},
          "contact": {"point": [5, 5], "normal": [0, 1]}})",
      Precision::double_precision);
  ASSERT_TRUE(e.plane_b.has_value());
  EXPECT_FALSE(e.plane_a.has_value());
  EXPECT_NEAR(e.plane_b->pose.translation.x, 4, 1e-12);
  EXPECT_NEAR(e.plane_b->pose.translation.y, 5, 1e-12);
}

// Seen across the sliding, friction points to the same side in the scene and in Coulomb's cone: a ball that slides to
// the right is pushed to the left.
TEST(ExplainResponse, TheImpulseLeansAgainstTheSliding) {
  const Explanation e = explain(
      R"({"query": "response", "a": {"mass": "infinity"}, "b": {"mass": 2, "shape": {"type": "sphere"},
          "translation": [0, 0.5, 0], "linear": [3, -4, 0]}, "contact": {"point": [0, 0, 0], "normal": [0, 1, 0]}})",
      Precision::double_precision);
  const std::string picture = draw_explanation(e, {0, 0, 1});
  std::size_t arrows = 0;
  for (std::size_t at = 0; (at = picture.find("class=\"shared\"", at)) != std::string::npos; ++at, ++arrows) {
    double x0, y0, x1, y1;
    const std::size_t path = picture.rfind("<path d=\"M", at);
    ASSERT_EQ(std::sscanf(picture.c_str() + path, "<path d=\"M%lf %lfL%lf %lf", &x0, &y0, &x1, &y1), 4);
    EXPECT_LT(x1, x0);
    EXPECT_LT(y1, y0);
  }
  EXPECT_EQ(arrows, 2u);
}

TEST(ExplainResponse, WhatHasNoAnswerHasNoExplanation) {
  for (const char* asked : {R"({"query": "response", "a": {"mass": -1}})",
                            R"({"query": "response", "a": {"mass": "infinity", "linear": [1, 0, 0]},
                                "b": {"mass": "infinity"}, "contact": {"point": [0, 0, 0], "normal": [1, 0, 0]}})"})
    EXPECT_THROW(explain(asked, Precision::double_precision), InvalidValue) << asked;
}

}  // namespace
}  // namespace graze::io
