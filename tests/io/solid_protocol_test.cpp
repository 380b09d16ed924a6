// The query protocol: solid meshes, and distance with a limit.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "graze/vec3.hpp"
#include "protocol_answer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

const std::string cube_points = "[[-2,-2,-2],[2,-2,-2],[-2,2,-2],[2,2,-2],[-2,-2,2],[2,-2,2],[-2,2,2],[2,2,2]]";
const std::string cube_triangles =
    "[[0,2,1],[1,2,3],[4,5,6],[5,7,6],[0,1,4],[1,5,4],[2,6,3],[3,6,7],[0,4,2],[2,4,6],[1,3,5],[3,7,5]]";
/// Near the side at x = 2 of a cube of edge 4, and wholly inside it.
const std::string ball = R"({"shape": {"type": "sphere", "sphere": {"radius": 0.5}}, "translation": [1, 0.1, 0.2]})";

/// `more`: what else the mesh says of itself.
std::string cube(const std::string& more = R"(, "solid": true)") {
  return R"({"type": "mesh", "mesh": {"points": )" + cube_points + R"(, "triangles": )" + cube_triangles + more + "}}";
}

class SolidProtocol : public ::testing::TestWithParam<Precision> {
 public:
  /// A cube against the ball, or the ball against the cube.
  static Json ask_pair(const std::string& query, const std::string& shape, bool swapped = false,
                       const std::string& more = "") {
    const std::string body = R"({"shape": )" + shape + "}";
    return ask(R"({"query": ")" + query + R"(", "a": )" + (swapped ? ball : body) + R"(, "b": )" +
                   (swapped ? body : ball) + more + "}",
               GetParam());
  }
  static Json ask_cube(const std::string& query, const std::string& more) {
    return ask(R"({"query": ")" + query + R"(", "a": {"shape": )" + cube() + "}" + more + "}", GetParam());
  }
  static double noise() { return GetParam() == Precision::double_precision ? 1e-12 : 1e-5; }

  static Vec3d vector(const Json& json) {
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
  }
  static void expect_vector(const Json& json, const Vec3d& v) { EXPECT_LE(max_abs(vector(json) - v), noise()) << json; }
  /// b - a = d * normal.
  static void expect_consistent(const Json& answer, const Json& normal) {
    EXPECT_LE(max_abs(vector(answer["b"]) - vector(answer["a"]) - vector(normal) * answer["distance"].get<double>()),
              noise())
        << answer;
  }
};
INSTANTIATE_TEST_SUITE_P(Precisions, SolidProtocol,
                         ::testing::Values(Precision::double_precision, Precision::single_precision),
                         [](const auto& p) { return p.param == Precision::double_precision ? "Double" : "Float"; });

TEST_P(SolidProtocol, TrueFalseAndAbsent) {
  for (const bool swapped : {false, true}) {
    EXPECT_EQ(ask_pair("overlap", cube(), swapped)["overlap"], true);
    EXPECT_EQ(ask_pair("overlap", cube(R"(, "solid": false)"), swapped)["overlap"], false);
    EXPECT_EQ(ask_pair("overlap", cube(""), swapped)["overlap"], false);
  }
}

TEST_P(SolidProtocol, DistanceIsTheWayOut) {
  for (const bool swapped : {false, true}) {
    const Json answer = ask_pair("distance", cube(), swapped);
    EXPECT_NEAR(answer["distance"].get<double>(), -1.5, noise());
    // B leaves along -distance * normal: the ball towards +x, the cube towards -x.
    expect_vector(answer["normal"], {swapped ? -1.0 : 1.0, 0, 0});
    expect_consistent(answer, answer["normal"]);
  }
  // The translation that is told makes them touch.
  const Json moved = ask(R"({"query": "distance", "a": {"shape": )" + cube() +
                             R"(}, "b": {"shape": {"type": "sphere"}, "translation": [2.5, 0.1, 0.2]}})",
                         GetParam());
  EXPECT_NEAR(moved["distance"].get<double>(), 0, noise());
  EXPECT_NEAR(ask_pair("distance", cube(""))["distance"].get<double>(), 0.5, noise());
}

TEST_P(SolidProtocol, ContactsHaveAPoint) {
  for (const char* margin : {"0", "0.75"})
    for (const bool swapped : {false, true}) {
      const Json answer = ask_pair("contacts", cube(), swapped, R"(, "margin": )" + std::string(margin));
      EXPECT_EQ(answer["overlap"], true);
      ASSERT_EQ(answer["manifolds"].size(), 1u) << answer;
      const Json& manifold = answer["manifolds"][0];
      expect_vector(manifold["normal"], {swapped ? -1.0 : 1.0, 0, 0});
      ASSERT_EQ(manifold["points"].size(), 1u);
      EXPECT_NEAR(manifold["points"][0]["distance"].get<double>(), -1.5, noise());
      expect_consistent(manifold["points"][0], manifold["normal"]);
    }
  const Json hollow = ask_pair("contacts", cube(""));
  EXPECT_EQ(hollow["overlap"], false);
  EXPECT_TRUE(hollow["manifolds"].empty());
}

TEST_P(SolidProtocol, CastStartsInContact) {
  for (const bool swapped : {false, true}) {
    const Json answer = ask_pair("cast", cube(), swapped);
    EXPECT_EQ(answer["hit"], true);
    EXPECT_EQ(answer["t"], 0.0);
    expect_vector(answer["normal"], {swapped ? -1.0 : 1.0, 0, 0});
    EXPECT_EQ(ask_pair("cast", cube(""), swapped)["hit"], false);
  }
}

TEST_P(SolidProtocol, RaysFromInsideHitAtOnce) {
  Json answer = ask_cube("raycast", R"(, "ray": {"origin": [1, 0.1, 0.2], "direction": [0, 3, 0]})");
  EXPECT_EQ(answer["hit"], true);
  EXPECT_EQ(answer["t"], 0.0);
  expect_vector(answer["normal"], {0, -1, 0});
  expect_vector(answer["point"], {1, 0.1, 0.2});
  answer = ask_cube("raycast", R"(, "ray": {"origin": [1, 5, 0.2], "direction": [0, -3, 0]})");
  EXPECT_NEAR(answer["t"].get<double>(), 3, noise());
  expect_vector(answer["normal"], {0, 1, 0});
}

TEST_P(SolidProtocol, ClosestIsNegativeInside) {
  const Json answer = ask_cube("closest", R"(, "point": [1, 0.1, 0.2])");
  EXPECT_NEAR(answer["distance"].get<double>(), -1, noise());
  expect_vector(answer["normal"], {1, 0, 0});
  expect_vector(answer["point"], {2, 0.1, 0.2});
}

TEST_P(SolidProtocol, AsAChildOfACompound) {
  const std::string compound = R"({"type": "compound", "compound": {"children": [{"shape": )" + cube() + "}]}}";
  EXPECT_EQ(ask_pair("overlap", compound)["overlap"], true);
  EXPECT_NEAR(ask_pair("distance", compound)["distance"].get<double>(), -1.5, noise());
  EXPECT_FALSE(ask_pair("contacts", compound)["manifolds"].empty());
  EXPECT_EQ(ask_pair("cast", compound)["t"], 0.0);
}

// An explanation changes no bit of the rest.
TEST_P(SolidProtocol, ExplainedTheSame) {
  for (const char* query : {"overlap", "distance", "contacts", "cast"}) {
    Json explained = ask_pair(query, cube(), false, R"(, "explain": true)");
    EXPECT_TRUE(explained.contains("trace")) << query;
    explained.erase("trace");
    EXPECT_EQ(explained, ask_pair(query, cube())) << query;
  }
}

TEST_P(SolidProtocol, OnlyClosedMeshesAreSolid) {
  const auto error = [](const std::string& shape) { return ask_pair("overlap", shape)["error"].get<std::string>(); };
  const std::string one_triangle =
      R"({"type": "mesh", "mesh": {"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]], "solid": )";
  EXPECT_EQ(error(one_triangle + "true}}"),
            "a.shape.mesh.solid: expected triangles that bound a solid, got a mesh that is not closed");
  EXPECT_EQ(error(R"({"type": "compound", "compound": {"children": [{"shape": )" + one_triangle + "true}}}]}}"),
            "a.shape.compound.children[0].shape.mesh.solid: expected triangles that bound a solid, got a mesh that is "
            "not closed");
  EXPECT_TRUE(ask_pair("overlap", one_triangle + "false}}").contains("overlap"));
  EXPECT_EQ(error(cube(R"(, "solid": 1)")), "a.shape.mesh.solid: expected true or false, got 1");
  EXPECT_EQ(error(cube(R"(, "solid": null)")), "a.shape.mesh.solid: expected true or false, got null");
}

TEST_P(SolidProtocol, OtherShapesHaveNoSuchKey) {
  for (const char* shape :
       {R"({"type": "sphere", "sphere": {"solid": true}})", R"({"type": "plane", "plane": {"solid": true}})",
        R"({"type": "heightfield", "heightfield": {"columns": 2, "rows": 2, "heights": [0,0,0,0], "solid": true}})",
        R"({"type": "convex", "convex": {"points": [[0,0,0]], "solid": false}})",
        R"({"type": "sphere", "solid": true})"}) {
    const Json answer = ask_pair("overlap", shape);
    ASSERT_TRUE(answer.contains("error")) << shape;
    const auto text = answer["error"].get<std::string>();
    EXPECT_NE(text.find("solid: expected one of the keys"), std::string::npos) << text;
    EXPECT_NE(text.find("got an unknown key"), std::string::npos) << text;
  }
}

TEST_P(SolidProtocol, WhatIsBeyondTheLimit) {
  const auto apart = [&](const std::string& limit, const std::string& more = "") {
    return ask(R"({"query": "distance", "a": {"shape": )" + cube(more) +
                   R"(}, "b": {"shape": {"type": "sphere"}, "translation": [5, 0.25, 0.5]}, "limit": )" + limit + "}",
               GetParam());
  };
  for (const char* more : {"", R"(, "solid": true)"}) {
    EXPECT_EQ(apart("2.25", more), Json::parse(R"({"beyond": true})"));
    EXPECT_EQ(apart("0", more), Json::parse(R"({"beyond": true})"));
    const Json near = apart("2.75", more);
    EXPECT_FALSE(near.contains("beyond"));
    EXPECT_NEAR(near["distance"].get<double>(), 2.5, noise());
    expect_vector(near["normal"], {1, 0, 0});
  }
  // What overlaps is within any limit.
  EXPECT_NEAR(ask_pair("distance", cube(), false, R"(, "limit": 0)")["distance"].get<double>(), -1.5, noise());
  // The id is echoed and a trace is given to what is beyond, too.
  EXPECT_EQ(ask_pair("distance", cube(""), false, R"(, "limit": 0.25, "id": 5)"),
            Json::parse(R"({"id": 5, "beyond": true})"));
  EXPECT_TRUE(ask_pair("distance", cube(""), false, R"(, "limit": 0.25, "explain": true)").contains("trace"));
}

// With a limit that is not reached, an answer has the bits it has without.
TEST_P(SolidProtocol, ALimitChangesNoBit) {
  for (const std::string& more : {std::string(), std::string(R"(, "solid": true)")}) {
    const Json free = ask_pair("distance", cube(more));
    EXPECT_EQ(ask_pair("distance", cube(more), false, R"(, "limit": 0.625)"), free);
    EXPECT_EQ(ask_pair("distance", cube(more), false, R"(, "limit": 100)"), free);
  }
}

TEST_P(SolidProtocol, LimitsThatAreNone) {
  const auto error = [](const std::string& query, const std::string& limit) {
    return ask_pair(query, cube(), false, R"(, "limit": )" + limit)["error"].get<std::string>();
  };
  EXPECT_EQ(error("distance", "-1"), "limit: expected a finite number >= 0, got -1");
  EXPECT_EQ(error("distance", "null"), "limit: expected a finite number >= 0, got null");
  EXPECT_EQ(error("distance", "\"1\""), "limit: expected a finite number >= 0, got \"1\"");
  EXPECT_EQ(error("distance", "1e400"), "limit: expected a finite number >= 0, got 1e400");
  for (const char* query : {"overlap", "contacts", "cast"})
    EXPECT_EQ(error(query, "1").substr(0, 7), "limit: ") << query;
}

TEST_P(SolidProtocol, LimitsInTwoDimensions) {
  const auto circles = [](const std::string& limit) {
    return ask(R"({"dimension": 2, "query": "distance", "a": {"shape": {"type": "circle", "circle": {"radius": 1}}},
                   "b": {"shape": {"type": "circle", "circle": {"radius": 1}}, "translation": [5, 0]}, "limit": )" +
                   limit + "}",
               GetParam());
  };
  EXPECT_EQ(circles("2.75"), Json::parse(R"({"beyond": true})"));
  EXPECT_NEAR(circles("3.25")["distance"].get<double>(), 3, noise());
}

}  // namespace
}  // namespace graze::io
