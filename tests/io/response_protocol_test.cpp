// The query protocol: what a blow does.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

const std::string contact = R"("contact": {"point": [0, 0, 0], "normal": [0, 1, 0]})";
const std::string ground = R"("a": {"mass": "infinity"})";

Json respond(const std::string& members, Precision precision = Precision::double_precision) {
  return ask(R"({"query": "response", )" + members + "}", precision);
}

/// The question whose body B has these members besides.
Json onto_ground(const std::string& b, const std::string& more = "") {
  return respond(ground + R"(, "b": {)" + b + "}, " + contact + more);
}

TEST(ResponseProtocol, AnswersAreWhole) {
  const std::string ball = R"("mass": 2, "inertia": [1, 1, 1], "translation": [0, 1, 0], "linear": [0, -3, 0])";
  EXPECT_EQ(onto_ground(ball, R"(, "id": 7, "restitution": 0.5)"),
            Json::parse(R"({"id": 7, "normalImpulse": 9, "impulse": [0, 9, 0],
              "a": {"linear": [0, 0, 0], "angular": [0, 0, 0]}, "b": {"linear": [0, 1.5, 0], "angular": [0, 0, 0]}})"));
}

TEST(ResponseProtocol, RestitutionIsZeroAndFrictionThreeFifthsUnlessTold) {
  const std::string sliding = R"("mass": 2, "inertia": ["infinity", "infinity", "infinity"], "linear": [10, -1, 0])";
  const Json answer = onto_ground(sliding);
  EXPECT_NEAR(answer["impulse"][0].get<double>(), -0.6 * 2, 1e-12);
  EXPECT_NEAR(answer["impulse"][1].get<double>(), 2, 1e-12);
  EXPECT_NEAR(onto_ground(sliding, R"(, "friction": 20)")["b"]["linear"][0].get<double>(), 0, 1e-12);
}

TEST(ResponseProtocol, InertiaIsThatOfTheShapeUnlessGiven) {
  // A box 1 × 2 × 3 of mass 12 met under a corner: 1/m + (r × n)² · I⁻¹, about x and z.
  const std::string box = R"("mass": 12, "shape": {"type": "box", "box": {"size": [1, 2, 3]}},
      "translation": [0.5, 1, 1.5], "linear": [0, -1, 0])";
  const double resisting = 1 / (1.0 / 12 + 1.5 * 1.5 / (4 + 9) + 0.5 * 0.5 / (1 + 4));
  const Json answer = onto_ground(box, R"(, "friction": 0)");
  EXPECT_NEAR(answer["normalImpulse"].get<double>(), resisting, 1e-12);
  const Json given = onto_ground(box + R"(, "inertia": [13, 10, 5])", R"(, "friction": 0)");
  EXPECT_NEAR(given["normalImpulse"].get<double>(), resisting, 1e-12);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(answer["b"]["angular"][i].get<double>(), given["b"]["angular"][i].get<double>(), 1e-14);
  // Turned by a quarter about y, x and z change places.
  const std::string turned = R"(, "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476])";
  const double other = 1 / (1.0 / 12 + 1.5 * 1.5 / (1 + 4) + 0.5 * 0.5 / (4 + 9));
  EXPECT_NEAR(onto_ground(box + turned, R"(, "friction": 0)")["normalImpulse"].get<double>(), other, 1e-12);
}

TEST(ResponseProtocol, InTwoDimensions) {
  const auto answer = [](const std::string& b) {
    return respond(R"("dimension": 2, "a": {"mass": "infinity"}, "b": {"mass": 12, "linear": [0, -1],
        "translation": [0.5, 1], )" +
                   b + R"(}, "contact": {"point": [0, 0], "normal": [0, 1]}, "friction": 0)");
  };
  const Json box = answer(R"("shape": {"type": "box", "box": {"size": [1, 2]}})");
  EXPECT_NEAR(box["normalImpulse"].get<double>(), 1 / (1.0 / 12 + 0.25 / 5), 1e-12);
  EXPECT_EQ(box["impulse"].size(), 2u);
  EXPECT_EQ(box["b"]["linear"].size(), 2u);
  EXPECT_NEAR(box["b"]["angular"].get<double>(), -0.5 * box["normalImpulse"].get<double>() / 5, 1e-12);
  EXPECT_NEAR(answer(R"("inertia": 5)")["normalImpulse"].get<double>(), box["normalImpulse"].get<double>(), 1e-12);
  const auto inertia_of = [&](const std::string& shape) {
    const Json found = answer(R"("shape": )" + shape);
    return 0.25 / (1 / found["normalImpulse"].get<double>() - 1.0 / 12);
  };
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(inertia_of(R"({"type": "circle", "circle": {"radius": 2}})"), 12 * 4 / 2.0, 1e-9);
  EXPECT_NEAR(inertia_of(R"({"type": "convex", "convex": {"points": [[0, 0], [3, 0], [0, 3]]}})"), 12.0, 1e-9);
  // A stadium: the middle by its sides, the two half discs about their own centres of mass and then moved.
  const double disc = pi, middle = 4, rim = 4 / (3 * pi);
  const double stadium = middle * (4 + 4) / 12 + disc * (0.5 - rim * rim) + disc * (1 + rim) * (1 + rim);
  EXPECT_NEAR(inertia_of(R"({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 1, "radiusTop": 1}})"),
              12 * stadium / (disc + middle), 1e-8);
}

TEST(ResponseProtocol, ATraceHasTheQuantitiesOfTheLectureAndChangesNothing) {
  const std::string ball = R"("mass": 7, "shape": {"type": "sphere", "sphere": {"radius": 1}}, "translation": [0, 1, 0],
      "linear": [2, -3, 0])";
  Json answer = onto_ground(ball, R"(, "explain": true)");
  const Json trace = answer["trace"];
  answer.erase("trace");
  EXPECT_EQ(answer, onto_ground(ball));
  EXPECT_EQ(trace["relativeVelocity"]["normal"], -3);
  EXPECT_EQ(trace["relativeVelocity"]["tangential"], Json({2, 0, 0}));
  EXPECT_NEAR(trace["effectiveMass"].get<double>(), 7, 1e-12);
  EXPECT_NEAR(trace["normalImpulse"].get<double>(), 21, 1e-12);
  EXPECT_NEAR(trace["friction"]["limit"].get<double>(), 0.6 * 21, 1e-12);
  EXPECT_NEAR(trace["friction"]["stopping"][0].get<double>(), -2 * 7 * 2 / 7.0, 1e-12);
  EXPECT_EQ(trace["friction"]["holds"], true);
  EXPECT_EQ(trace["atFault"], "b");
}

TEST(ResponseProtocol, ErrorsNameWhatIsWrong) {
  const std::string good = R"("mass": 1, "inertia": [1, 1, 1], "linear": [0, -1, 0])";
  const auto error = [&](const std::string& b, const std::string& more = "") {
    return onto_ground(b, more)["error"].get<std::string>();
  };
  EXPECT_EQ(error(R"("inertia": [1, 1, 1])"), "b.mass: expected a value, got nothing");
  EXPECT_EQ(error(R"("mass": 0, "inertia": [1, 1, 1])"),
            R"(b.mass: expected a finite number > 0, or "infinity", got 0)");
  EXPECT_EQ(error(R"("mass": "heavy", "inertia": [1, 1, 1])"),
            R"(b.mass: expected a finite number > 0, or "infinity", got "heavy")");
  EXPECT_EQ(error(R"("mass": 1, "inertia": [1, -1, 1])"),
            R"(b.inertia[1]: expected a finite number > 0, or "infinity", got -1)");
  EXPECT_EQ(error(R"("mass": 1, "inertia": [1, 1, 3])"),
            "b.inertia[2]: expected at most the sum of the other two, got 3");
  EXPECT_EQ(error(R"("mass": "infinity", "inertia": [3, 1, 1])"),
            "b.inertia[0]: expected at most the sum of the other two, got 3");
  EXPECT_EQ(error(R"("mass": 1)"), "b.shape: expected a value, got nothing");
  EXPECT_EQ(error(R"("mass": 1, "shape": {"type": "plane"})"),
            "b.inertia: expected a value, since the shape has no volume to take it from, got nothing");
  EXPECT_EQ(error(R"("mass": "infinity", "shape": {"type": "box", "box": {"size": [1, -2, 1]}})"),
            "b.shape.box.size[1]: expected a finite number >= 0, got -2");
  EXPECT_EQ(error(R"("mass": "infinity", "linear": [0, -1, 0])"),
            R"(a.mass, b.mass: expected a finite mass of one of two bodies that approach, got "infinity" twice)");
  EXPECT_EQ(error(good, R"(, "restitution": -1)"), "restitution: expected a finite number >= 0, got -1");
  EXPECT_EQ(error(good, R"(, "friction": null)"), "friction: expected a finite number >= 0, got null");
  EXPECT_TRUE(error(good, R"(, "bounce": 1)").starts_with("bounce: expected one of the keys "));
  EXPECT_TRUE(error(good + R"(, "weight": 1)").starts_with("b.weight: expected one of the keys "));
  const std::string b = R"(, "b": {)" + good + "}";
  EXPECT_EQ(respond(ground + b)["error"], "contact: expected a value, got nothing");
  EXPECT_EQ(respond(ground + b + R"(, "contact": {"point": [0, 0, 0], "normal": [0, 2, 0]})")["error"],
            "contact.normal: expected a unit vector, got [0,2,0]");
  EXPECT_EQ(respond(ground + b + R"(, "contact": {"normal": [0, 1, 0]})")["error"],
            "contact.point: expected a value, got nothing");
  EXPECT_EQ(respond(ground + ", " + contact)["error"], "b: expected a value, got nothing");
}

TEST(ResponseProtocol, NoNumberIsEverLost) {
  const Json answer =
      respond(ground + R"(, "b": {"mass": 1e38, "inertia": [1, 1, 1], "linear": [0, -1e16, 0]}, )" + contact,
              Precision::single_precision);
  EXPECT_EQ(answer["error"],
            "a, b: expected masses and velocities of which the products are finite numbers, got larger ones");
}

// What docs/resolution.md works through.
TEST(ResponseProtocol, ThePageSaysWhatTheProgramAnswers) {
  std::ifstream file(GRAZE_SOURCE_DIR "/docs/resolution.jsonl");
  std::map<std::string, Json> answers;
  for (std::string line; std::getline(file, line);) {
    const Json answer = ask(line);
    answers[answer.at("id").get<std::string>()] = answer;
  }
  EXPECT_NEAR(answers["crate"]["trace"]["effectiveMass"].get<double>(), 7.5, 1e-12);
  EXPECT_NEAR(answers["crate"]["b"]["linear"][1].get<double>(), -1.125, 1e-12);
  EXPECT_NEAR(answers["crate"]["b"]["angular"][2].get<double>(), -2.25, 1e-12);
  EXPECT_NEAR(answers["ball"]["trace"]["friction"]["limit"].get<double>(), 7.2, 1e-12);
  EXPECT_NEAR(answers["ball"]["b"]["linear"][0].get<double>(), 3 * 5 / 7.0, 1e-12);
  EXPECT_NEAR(answers["ball"]["b"]["angular"][2].get<double>(), -3 * 10 / 7.0, 1e-12);
  EXPECT_NEAR(answers["two"]["trace"]["effectiveMass"].get<double>(), 1.085, 5e-4);
  EXPECT_NEAR(answers["two"]["normalImpulse"].get<double>(), 4.556, 5e-4);
  EXPECT_NEAR(answers["two"]["trace"]["friction"]["stopping"][1].get<double>(), 2.050, 5e-4);
  EXPECT_EQ(answers["two"]["trace"]["atFault"], "both");
}

}  // namespace
}  // namespace graze::io
