// The query protocol: ray casts.
#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

Json raycast(const std::string& shape, const std::string& ray, const std::string& more = "",
             Precision precision = Precision::double_precision) {
  const std::string line = R"({"query": "raycast", "a": {"shape": )" + shape + "}" + ray + more + "}";
  return ask(line, precision);
}

/// Down from (0.25, 5, 0.125) with a direction of length 4.
const std::string down = R"(, "ray": {"origin": [0.25, 5, 0.125], "direction": [0, -4, 0]})";

TEST(RaycastProtocol, EveryShapeIsHit) {
  const std::pair<const char*, double> cases[] = {
      {R"({"type": "sphere", "sphere": {"radius": 1}})", std::sqrt(1 - 0.078125)},
      {R"({"type": "box", "box": {"size": [2, 2, 2]}})", 1},
      {R"({"type": "box", "box": {"size": [2, 2, 2]}, "margin": 0.25})", 1.25},
      {R"({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 1, "radiusTop": 1}})",
       1 + std::sqrt(1 - 0.078125)},
      {R"({"type": "cylinder", "cylinder": {"height": 2, "radiusBottom": 1, "radiusTop": 1}})", 1},
      {R"({"type": "cylinder", "cylinder": {"height": 2, "radiusBottom": 1, "radiusTop": 0}})",
       1 - 2 * std::sqrt(0.078125)},
      {R"({"type": "ellipsoid", "ellipsoid": {"radii": [1, 2, 1]}})", 2 * std::sqrt(1 - 0.078125)},
      {R"({"type": "convex", "convex": {"points": [[2, 0, 2], [-2, 0, 2], [0, 0, -2], [0, -1, 0]]}})", 0},
      {R"({"type": "triangle", "triangle": {"points": [[2, 1, 2], [-2, 1, 2], [0, 1, -2]]}})", 1},
      {R"({"type": "plane"})", 0},
      {R"({"type": "plane", "margin": 0.5})", 0.5},
      {R"({"type": "plane", "plane": {"sizeX": 2, "sizeZ": 2}})", 0},
      {R"({"type": "mesh", "mesh": {"points": [[2, 1, 2], [-2, 1, 2], [0, 1, -2]], "triangles": [[0, 1, 2]]}})", 1},
      {R"({"type": "mesh", "mesh": {"points": [[2, 1, 2], [-2, 1, 2], [0, 1, -2]], "triangles": [[0, 2, 1]]}})", 1},
      {R"({"type": "heightfield", "heightfield": {"columns": 2, "rows": 2, "spacing": [2, 2], "heights": [1, 1, 1, 1]}})",
       1},
      {R"({"type": "compound", "compound": {"children": [{"shape": {"type": "box"}, "translation": [0, 2, 0]}]}})",
       2.5},
  };
  for (const auto& [shape, height] : cases) {
    const Json answer = raycast(shape, down);
    ASSERT_TRUE(answer.value("hit", false)) << shape << answer;
    EXPECT_NEAR(answer["t"].get<double>(), 5 - height, 1e-9) << shape;
    EXPECT_NEAR(answer["point"][1].get<double>(), height, 1e-9) << shape;
    EXPECT_GT(answer["normal"][1].get<double>(), 0) << shape;
    EXPECT_NEAR(raycast(shape, down, "", Precision::single_precision)["t"].get<double>(), 5 - height, 1e-4) << shape;
  }
}

TEST(RaycastProtocol, AnswersAreWhole) {
  const Json answer = raycast(R"({"type": "box", "box": {"size": [2, 2, 2]}})", down, R"(, "id": 7)");
  EXPECT_EQ(answer, Json::parse(R"({"id": 7, "hit": true, "t": 4, "point": [0.25, 1, 0.125], "normal": [0, 1, 0]})"));
}

TEST(RaycastProtocol, AMissIsHitFalse) {
  const std::string sphere = R"({"type": "sphere", "sphere": {"radius": 1}})";
  EXPECT_EQ(raycast(sphere, R"(, "ray": {"origin": [2, 5, 0], "direction": [0, -1, 0]})"), Json({{"hit", false}}));
  EXPECT_EQ(raycast(sphere, R"(, "ray": {"origin": [0, 5, 0], "direction": [0, 1, 0]})"), Json({{"hit", false}}));
}

TEST(RaycastProtocol, LengthIsInUnitsOfLengthAndMayBeAbsent) {
  const std::string sphere = R"({"type": "sphere", "sphere": {"radius": 1}})";
  const auto hit = [&](const std::string& length) {
    return raycast(sphere, R"(, "ray": {"origin": [0, 5, 0], "direction": [0, -0.5, 0])" + length + "}")
        .at("hit")
        .get<bool>();
  };
  EXPECT_TRUE(hit(""));
  EXPECT_TRUE(hit(R"(, "length": 4)"));
  EXPECT_FALSE(hit(R"(, "length": 3.999)"));
  EXPECT_FALSE(hit(R"(, "length": 0)"));
  const Json far = raycast(sphere, R"(, "ray": {"origin": [0, 1e6, 0], "direction": [0, -1, 0]})");
  EXPECT_NEAR(far["t"].get<double>(), 999999, 1e-9);
}

TEST(RaycastProtocol, FromInsideASolidItHitsAtOnceAndFacesBack) {
  for (const std::string length : {"", R"(, "length": 0)"}) {
    const Json answer = raycast(R"({"type": "box", "box": {"size": [2, 2, 2]}})",
                                R"(, "ray": {"origin": [0.5, 0, 0], "direction": [0, 0, -2])" + length + "}");
    EXPECT_EQ(answer, Json::parse(R"({"hit": true, "t": 0, "point": [0.5, 0, 0], "normal": [0, 0, 1]})"));
  }
}

TEST(RaycastProtocol, InTwoDimensions) {
  const std::string ray = R"(, "ray": {"origin": [-3, 0.25], "direction": [2, 0]}, "dimension": 2)";
  const std::pair<const char*, double> cases[] = {
      {R"({"type": "circle", "circle": {"radius": 1}})", std::sqrt(1 - 0.0625)},
      {R"({"type": "box", "box": {"size": [2, 2]}})", 1},
      {R"({"type": "box", "box": {"size": [2, 2]}, "margin": 0.5})", 1.5},
      {R"({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 0.5, "radiusTop": 0.5}})", 0.5},
      {R"({"type": "capsule", "capsule": {"height": 2, "radiusBottom": 0.75, "radiusTop": 0.5}})", -1},
      {R"({"type": "convex", "convex": {"points": [[-1, -1], [1, -1], [-1, 1]]}})", 1},
      {R"({"type": "segment", "segment": {"points": [[-1, -1], [-1, 1]]}})", 1},
      {R"({"type": "compound", "compound": {"children": [{"shape": {"type": "circle", "circle": {"radius": 1}},
          "translation": [0, 0.25]}]}})",
       1},
  };
  for (const auto& [shape, left] : cases) {
    const Json answer = raycast(shape, ray);
    ASSERT_TRUE(answer.value("hit", false)) << shape << answer;
    ASSERT_EQ(answer["point"].size(), 2u);
    ASSERT_EQ(answer["normal"].size(), 2u);
    const double x = answer["normal"][0].get<double>(), y = answer["normal"][1].get<double>();
    EXPECT_NEAR(x * x + y * y, 1, 1e-12) << shape;
    EXPECT_LT(x, 0) << shape;
    if (left > 0) {
      EXPECT_NEAR(answer["t"].get<double>(), 3 - left, 1e-9) << shape;
    }
  }
  // On the tapered capsule's side: its centres (0, -1) and (0, 1), the side's normals (-cos, sin) with sin = 1/8.
  const double sine = 0.125, cosine = std::sqrt(1 - sine * sine);
  EXPECT_NEAR(raycast(cases[4].first, ray)["t"].get<double>(), 3 - (0.75 - sine * 1.25) / cosine, 1e-9);
  const Json ground =
      raycast(R"({"type": "plane"})", R"(, "ray": {"origin": [0, 2], "direction": [1, -1]}, "dimension": 2)");
  EXPECT_NEAR(ground["t"].get<double>(), std::sqrt(8.0), 1e-9);
  EXPECT_EQ(ground["normal"], Json({0, 1}));
}

TEST(RaycastProtocol, ErrorsNameWhatIsWrong) {
  const std::string sphere = R"({"type": "sphere", "sphere": {"radius": 1}})";
  EXPECT_EQ(raycast(sphere, R"(, "ray": {"origin": [0, 0, 0], "direction": [0, 0, 0]})")["error"],
            "ray.direction: expected a direction that is not zero, got [0,0,0]");
  EXPECT_EQ(raycast(sphere, "")["error"], "ray: expected a value, got nothing");
  EXPECT_EQ(raycast(sphere, R"(, "ray": {"origin": [0, 0, 0]})")["error"],
            "ray.direction: expected a value, got nothing");
  EXPECT_EQ(raycast(sphere, R"(, "ray": {"origin": [0, 0, 0], "direction": [1, 0, 0], "length": -1})")["error"],
            "ray.length: expected a finite number >= 0, got -1");
}

}  // namespace
}  // namespace graze::io
