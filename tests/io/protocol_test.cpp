// The query protocol, rule by rule.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

std::string error(const std::string& line, Precision precision = Precision::double_precision) {
  const Json json = ask(line, precision);
  return json.contains("error") ? json["error"].get<std::string>() : "no error: " + json.dump();
}

/// A distance from a shape to a ball of radius 0.5 at (3, 0, 0).
std::string to_ball(const std::string& shape, const std::string& more = "") {
  return R"({"query": "distance", "a": {"shape": )" + shape +
         R"(}, "b": {"shape": {"type": "sphere", "sphere": {"radius": 0.5}}, "translation": [3, 0, 0]})" + more + "}";
}

TEST(Protocol, TheExampleOfEveryShape) {
  const std::pair<const char*, double> cases[] = {
      {R"({"type": "sphere", "sphere": {"radius": 1}})", 1.5},
      {R"({"type": "sphere"})", 2},  // the default radius is one half
      {R"({"type": "box", "box": {"size": [2, 2, 2]}})", 1.5},
      {R"({"type": "box", "box": {"size": [2, 2, 2]}, "margin": 0.25})", 1.25},
      {R"({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 1, "radiusTop": 1}})", 1.5},
      {R"({"type": "cylinder", "cylinder": {"height": 2, "radiusBottom": 1, "radiusTop": 1}})", 1.5},
      {R"({"type": "cylinder", "cylinder": {"height": 2, "radiusBottom": 1, "radiusTop": 0}, "comment": "a cone"})",
       std::sqrt(5.0) - 0.5},  // to the rim at (1, -1, 0)
      {R"({"type": "ellipsoid", "ellipsoid": {"radii": [1, 2, 3]}})", 1.5},
      {R"({"type": "convex", "convex": {"points": [[1, 0, 0]]}})", 1.5},
      {R"({"type": "convex", "convex": {"points": [[1, -1, 0], [1, 1, 0]]}})", 1.5},
      {R"({"type": "triangle", "triangle": {"points": [[1, -1, -1], [1, 1, -1], [1, 0, 2]]}})", 1.5},
      {R"({"type": "plane"})", -0.5},
      {R"({"type": "plane", "plane": {"sizeX": 2, "sizeZ": 2}})", 1.5},
      {R"({"type": "mesh", "mesh": {"points": [[1, -1, -1], [1, 1, -1], [1, 0, 2]], "triangles": [[0, 1, 2]]}})", 1.5},
      {R"({"type": "heightfield", "heightfield": {"columns": 2, "rows": 2, "spacing": [2, 2], "heights": [0, 0, 0, 0]}})",
       1.5},
      {R"({"type": "compound", "compound": {"children": [{"shape": {"type": "sphere"}, "translation": [0.5, 0, 0]}]}})",
       1.5},
  };
  for (const auto& [shape, expected] : cases) {
    const Json answer = ask(to_ball(shape));
    ASSERT_TRUE(answer.contains("distance")) << shape << answer;
    EXPECT_NEAR(answer["distance"].get<double>(), expected, 1e-9) << shape;
  }
}

TEST(Protocol, NamesTheValueAtFault) {
  EXPECT_EQ(error(to_ball(R"({"type": "box", "box": {"size": [1, -2, 1]}})")),
            "a.shape.box.size[1]: expected a finite number >= 0, got -2");
  EXPECT_EQ(error(to_ball(R"({"type": "box", "box": {"size": null}})")),
            "a.shape.box.size: expected an array of 3, got null");
  EXPECT_EQ(error(to_ball(R"({"type": "sphere", "sphere": {"radius": 1e400}})")),
            "a.shape.sphere.radius: expected a finite number >= 0, got 1e400");
  EXPECT_EQ(error(to_ball(R"({"type": "sphere", "sphere": {"radius": "1"}})")),
            "a.shape.sphere.radius: expected a finite number >= 0, got \"1\"");
  EXPECT_EQ(error(to_ball(R"({"type": "convex", "convex": {"points": []}})")),
            "a.shape.convex.points: expected at least one point, got none");
  EXPECT_EQ(error(to_ball(R"({"type": "plane", "plane": {"sizeX": 1}})")),
            "a.shape.plane.sizeZ: expected a value, got nothing");
  EXPECT_EQ(error(to_ball(R"({"type": "mesh", "mesh": {"points": [[0, 0, 0]], "triangles": [[0, 0, 1]]}})")),
            "a.shape.mesh.triangles[0][2]: expected an index below 1, got 1");
  EXPECT_EQ(
      error(to_ball(R"({"type": "compound", "compound": {"children": [{"shape": {"type": "ball"}}]}})")),
      "a.shape.compound.children[0].shape.type: expected one of sphere, box, capsule, cylinder, plane, ellipsoid, "
      "convex, triangle, mesh, heightfield, compound, got \"ball\"");
  EXPECT_EQ(error(R"({"query": "distance", "a": {"shape": {"type": "sphere"}}})"), "b: expected a value, got nothing");
  EXPECT_EQ(error(to_ball(R"({"type": "sphere"})", R"(, "margin": -1)")),
            "margin: expected a finite number >= 0, got -1");
}

TEST(Protocol, NumbersAreFiniteInThePrecisionAskedFor) {
  const std::string big = to_ball(R"({"type": "sphere", "sphere": {"radius": 1e39}})");
  EXPECT_EQ(error(big, Precision::single_precision), "a.shape.sphere.radius: expected a finite number >= 0, got 1e+39");
  EXPECT_TRUE(ask(big).contains("distance"));
}

// Lengths are multiplied with each other: what would overflow is refused where it stands.
TEST(Protocol, MagnitudesAreBounded) {
  const std::string ball = R"({"shape": {"type": "sphere"}})", far = R"(1.1e48)", near = R"(1e48)";
  const auto placed = [](const std::string& x) {
    return R"({"shape": {"type": "box"}, "translation": [)" + x + R"(, 0, 0]})";
  };
  const auto between = [&](const std::string& a, const std::string& more = "") {
    return R"({"query": "distance", "a": )" + a + R"(, "b": )" + ball + more + "}";
  };
  EXPECT_EQ(error(between(placed(far))), "a.translation[0]: expected a magnitude of at most 1e48, got 1.1e+48");
  EXPECT_NEAR(ask(between(placed(near)))["distance"].get<double>() / 1e48, 1, 1e-12);
  EXPECT_EQ(error(between(placed("2e17")), Precision::single_precision),
            "a.translation[0]: expected a magnitude of at most 1e17 (in float), got 2e+17");
  EXPECT_NEAR(ask(between(placed("-1e17")), Precision::single_precision)["distance"].get<double>() / 1e17, 1, 1e-5);
  EXPECT_EQ(error(between(R"({"shape": {"type": "sphere", "margin": 1e49}})")),
            "a.shape.margin: expected a magnitude of at most 1e48, got 1e+49");
  EXPECT_EQ(error(between(R"({"shape": {"type": "box", "box": {"size": [1, 1, 1e49]}}})")),
            "a.shape.box.size[2]: expected a magnitude of at most 1e48, got 1e+49");
  EXPECT_EQ(error(between(ball, R"(, "margin": 1e49)")), "margin: expected a magnitude of at most 1e48, got 1e+49");
  EXPECT_EQ(error(R"({"query": "closest", "point": [1e25, 0, 0], "a": )" + ball + "}", Precision::single_precision),
            "point[0]: expected a magnitude of at most 1e17 (in float), got 1e+25");
  EXPECT_EQ(
      error(R"({"query": "raycast", "ray": {"origin": [0, 1e49, 0], "direction": [1, 0, 0]}, "a": )" + ball + "}"),
      "ray.origin[1]: expected a magnitude of at most 1e48, got 1e+49");
  EXPECT_EQ(
      error(R"({"query": "cast", "duration": 10, "a": {"shape": {"type": "sphere"}, "linear": [2e47, 0, 0]}, "b": )" +
            ball + "}"),
      "a.linear: expected a velocity that leads no further than 1e+48 within the duration, got [2e+47,0,0]");
  EXPECT_EQ(
      error(R"({"dimension": 2, "query": "overlap", "a": {"shape": {"type": "circle", "circle": {"radius": 5e48}}},
                      "b": {"shape": {"type": "circle", "circle": {"radius": 1}}}})"),
      "a.shape.circle.radius: expected a magnitude of at most 1e48, got 5e+48");
  // Children of children add up.
  std::string child = placed("1e48");
  for (int i = 0; i < 9; ++i)
    child =
        R"({"translation": [1e48, 0, 0], "shape": {"type": "compound", "compound": {"children": [)" + child + "]}}}";
  EXPECT_NE(error(between(child)).find("expected a child that reaches at most 8e+48, got "), std::string::npos);
}

TEST(Protocol, UnknownKeysAreErrorsAndCommentsAreNot) {
  EXPECT_EQ(error(to_ball(R"({"type": "sphere", "sphere": {"radios": 1}})")),
            "a.shape.sphere.radios: expected one of the keys radius, got an unknown key");
  EXPECT_EQ(error(to_ball(R"({"type": "sphere", "box": {}})")),
            "a.shape.box: expected one of the keys type, sphere, margin, got an unknown key");
  EXPECT_TRUE(ask(to_ball(R"({"type": "sphere", "comment": [1]})", R"(, "comment": null)")).contains("distance"));
}

TEST(Protocol, OfDuplicateKeysTheLastCounts) {
  EXPECT_NEAR(ask(to_ball(R"({"type": "sphere", "sphere": {"radius": -1, "radius": 1}})"))["distance"].get<double>(),
              1.5, 1e-12);
}

TEST(Protocol, EchoesTheIdInAnswersAndErrors) {
  EXPECT_EQ(ask(R"({"id": {"n": [1, null]}, "query": "x"})")["id"], Json::parse(R"({"n": [1, null]})"));
  EXPECT_EQ(ask(to_ball(R"({"type": "sphere"})", R"(, "id": null)"))["id"], nullptr);
  EXPECT_FALSE(ask(to_ball(R"({"type": "sphere"})")).contains("id"));
  for (const char* bad : {"", "{", "[]", "1", "{} {}", "{\"id\": 1} x", "\xff"}) EXPECT_FALSE(ask(bad).contains("id"));
}

TEST(Protocol, EchoesTheIdAsItIsWritten) {
  for (const char* id : {"12345678901234567890123", "1.10", "-0", "1e400", "1E+5", "\"\\u0041 \\\" , } \"",
                         "[1.0, {\"a\": [] }]", "{}", "null", "\"\xc3\xa9\""}) {
    const std::string head = std::string("{\"id\":") + id + ",";
    for (const std::string& line :
         {std::string("{\"id\": ") + id + "}", std::string("{\"x\": {\"id\": 3}, \"id\" :") + id + " \t}",
          std::string("{\"id\": 5, \"a\": \"id\", \"\\u0069d\":\r\n") + id + "\n, \"b\": []}"})
      EXPECT_EQ(answer_line(line, Precision::double_precision).text.substr(0, head.size()), head) << line;
  }
  EXPECT_EQ(answer_line("{\"id\": [1,\n2]}", Precision::double_precision).text.substr(0, 13), "{\"id\":[1, 2],");
}

TEST(Protocol, ContactsGiveTheWholeManifold) {
  const Json answer = ask(
      R"({"query": "contacts", "a": {"shape": {"type": "box", "box": {"size": [2, 2, 2]}}},
          "b": {"shape": {"type": "box"}, "translation": [0, 1.55, 0]}, "margin": 0.1})");
  EXPECT_EQ(answer["overlap"], false);
  ASSERT_EQ(answer["manifolds"].size(), 1u);
  EXPECT_EQ(answer["manifolds"][0]["points"].size(), 4u);
  for (const Json& p : answer["manifolds"][0]["points"]) EXPECT_NEAR(p["distance"].get<double>(), 0.05, 1e-12);
}

TEST(Protocol, HalfSpacesThatAreNotOpposite) {
  const std::string pair = R"("a": {"shape": {"type": "plane"}}, "b": {"shape": {"type": "plane"}}})";
  EXPECT_EQ(ask(R"({"query": "overlap", )" + pair)["overlap"], true);
  EXPECT_EQ(error(R"({"query": "distance", )" + pair),
            "a, b: expected shapes of finite depth, got two half-spaces that are not opposite");
}

// They overlap without a depth, and so without points, alone and as children.
TEST(Protocol, HalfSpacesThatAreNotOppositeHaveNoManifold) {
  const std::string plane = R"({"type": "plane"})", ball = R"({"type": "sphere"})";
  const auto contacts = [&](const std::string& a) {
    return ask(R"({"query": "contacts", "a": {"shape": )" + a + R"(}, "b": {"shape": )" + plane + "}}");
  };
  Json answer = contacts(plane);
  EXPECT_EQ(answer["overlap"], true);
  EXPECT_TRUE(answer["manifolds"].empty());
  answer = contacts(R"({"type": "compound", "compound": {"children": [{"shape": )" + plane + R"(}, {"shape": )" + ball +
                    "}]}}");
  EXPECT_EQ(answer["overlap"], true);
  EXPECT_EQ(answer["manifolds"].size(), 1u);
}

TEST(Protocol, TwoDimensions) {
  const auto plane = [](const std::string& query, const std::string& a, const std::string& b) {
    return ask(R"({"dimension": 2, "query": ")" + query + R"(", "a": {"shape": )" + a + R"(}, "b": {"shape": )" + b +
               "}");
  };
  const std::string box = R"({"type": "box", "box": {"size": [2, 2]}})";
  Json answer = plane("distance", box, R"({"type": "circle", "circle": {"radius": 0.5}}, "translation": [1.4, 0]})");
  EXPECT_NEAR(answer["distance"].get<double>(), -0.1, 1e-9);
  EXPECT_EQ(answer["normal"].size(), 2u);
  EXPECT_NEAR(answer["b"][0].get<double>(), 0.9, 1e-9);
  answer = plane("contacts", box, R"({"type": "box", "box": {"size": [1, 1]}}, "translation": [0.2, 1.4]})");
  EXPECT_EQ(answer["manifolds"][0]["points"].size(), 2u);
  answer = plane("distance", R"({"type": "plane"})",
                 R"({"type": "circle", "circle": {"radius": 1}}, "translation": [5, 3]})");
  EXPECT_NEAR(answer["distance"].get<double>(), 2, 1e-9);
  // A deep overlap is left by the plane's shortest way, never along the axis that is not there.
  answer = plane("distance", R"({"type": "circle", "circle": {"radius": 1}})",
                 R"({"type": "circle", "circle": {"radius": 2}}, "translation": [0.5, 0]})");
  EXPECT_NEAR(answer["distance"].get<double>(), -2.5, 1e-9);
  answer = plane("distance", R"({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 0.5, "radiusTop": 0.25}})",
                 R"({"type": "segment", "segment": {"points": [[1, -3], [1, 3]]}}})");
  EXPECT_NEAR(answer["distance"].get<double>(), 0.5, 1e-9);
}

TEST(Protocol, ExplainAddsTheTrace) {
  const Json answer =
      ask(to_ball(R"({"type": "ellipsoid", "ellipsoid": {"radii": [1, 2, 3]}})", R"(, "explain": true)"));
  EXPECT_EQ(answer["trace"]["method"], "gjk");
  EXPECT_FALSE(answer["trace"]["gjk"].empty());
}

// A half-space covers all that lies below it, which has no number.
TEST(Protocol, AnEndlessIntervalOfATraceSaysSo) {
  Json answer = ask(to_ball(R"({"type": "plane"})", R"(, "explain": true)"));
  EXPECT_EQ(answer["trace"]["axes"][0]["a"], Json::parse(R"(["-infinity", 0.0])"));
  answer = ask(R"({"query": "distance", "explain": true, "a": {"shape": {"type": "sphere"}, "translation": [0, 1, 0]},
                   "b": {"shape": {"type": "plane"}}})");
  EXPECT_EQ(answer["trace"]["axes"][0]["b"], Json::parse(R"([0.0, "infinity"])"));
}

TEST(Protocol, AZeroByteIsAnErrorWhateverFollowsIt) {
  using namespace std::string_literals;
  EXPECT_EQ(error("{\"id\": 1}\0query: \"\0 e\"\0}"s), "expected one JSON object, got a zero byte behind 9 others");
  EXPECT_EQ(error("{\"id\": 1}\0"s), "expected one JSON object, got a zero byte behind 9 others");
  EXPECT_EQ(error("\0"s), "expected one JSON object, got a zero byte behind 0 others");
  EXPECT_EQ(error("{\"id\": \"\0\"}"s), "expected one JSON object, got a zero byte behind 8 others");
}

TEST(Protocol, DeepNestingIsAnErrorAndNotACrash) {
  EXPECT_EQ(error(std::string(1000000, '[')), "expected JSON nested at most 2000 deep, got deeper nesting");
  std::string shape = R"({"type": "sphere"})";
  for (int i = 0; i < 400; ++i) shape = R"({"type": "compound", "compound": {"children": [{"shape": )" + shape + "}]}}";
  EXPECT_NEAR(ask(to_ball(shape))["distance"].get<double>(), 2, 1e-12);
}

TEST(Protocol, StreamsInOrderAndSkipsBlankLines) {
  std::istringstream in("{\"id\": 1, \"query\": \"x\"}\r\n\n  \n" + to_ball(R"({"type": "sphere"})", R"(, "id": 2)"));
  std::ostringstream out;
  EXPECT_EQ(answer_stream(in, out, Precision::double_precision), 1u);
  std::istringstream lines(out.str());
  std::string line;
  for (int id = 1; id <= 2; ++id) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(Json::parse(line)["id"], id);
  }
  EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace
}  // namespace graze::io
