// The plane's kernels against the same figures as prisms in space, which nothing but the reading of JSON has in common.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "graze/io/protocol.hpp"
#include "io/answer.hpp"
#include "io/prism_question.hpp"

namespace graze::io {
namespace {

/// A shape of all kinds that there are prisms of; a half-plane only where one is wanted.
std::string random_plane_shape(std::mt19937& random, bool half_planes, bool compounds = true) {
  const auto u = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const std::string margin = random() % 3 ? "" : R"(, "margin": )" + std::to_string(u(0, 0.3));
  switch (random() % 8) {
  case 0: return fmt::format(R"({{"type": "circle", "circle": {{"radius": {}}}{}}})", u(0.2, 1), margin);
  case 1: return fmt::format(R"({{"type": "box", "box": {{"size": [{}, {}]}}{}}})", u(0.2, 2), u(0.2, 2), margin);
  case 2: {
    const double r = u(0.1, 0.6);
    return fmt::format(R"({{"type": "capsule", "capsule": {{"height": {}, "radiusBottom": {}, "radiusTop": {}}}{}}})",
                       u(0.2, 2), r, random() % 2 ? r : u(0.1, 0.6), margin);
  }
  case 3:
    return fmt::format(R"({{"type": "segment", "segment": {{"points": [[{}, {}], [{}, {}]]}}{}}})", u(-1, 1), u(-1, 1),
                       u(-1, 1), u(-1, 1), margin);
  case 4:
    return fmt::format(R"({{"type": "ellipse", "ellipse": {{"radii": [{}, {}]}}{}}})", u(0.1, 1), u(0.1, 1), margin);
  case 5:
    if (half_planes) return fmt::format(R"({{"type": "plane"{}}})", margin);
    [[fallthrough]];
  case 6:
    if (compounds) {
      // Side by side, so that no point is inside of both.
      const std::string left = random_plane_shape(random, false, false),
                        right = random_plane_shape(random, false, false);
      return fmt::format(
          R"({{"type": "compound", "compound": {{"children": [{{"shape": {}, "translation": [-1.5, 0], "rotation": {}}},
             {{"shape": {}, "translation": [1.5, 0.2]}}]}}}})",
          left, u(-3, 3), right);
    }
    [[fallthrough]];
  default: {
    std::string points;
    for (int i = 0; i < 6; ++i) points += fmt::format("{}[{}, {}]", i ? ", " : "", u(-1, 1), u(-1, 1));
    return fmt::format(R"({{"type": "convex", "convex": {{"points": [{}]}}{}}})", points, margin);
  }
  }
}

/// The answer of the prisms.
Json by_prisms(const std::string& question) {
  const Json json = parse_json(question);
  JsonWriter out;
  out.open('{');
  write_answer(read_prism_question<double>(JsonValue(json, "")), out);
  return Json::parse(out.close('}').take());
}

/// Distances and times agree as well as the searches in space end; directions and places as well as the root of that.
constexpr double same_distance = 1e-8, same_place = 2e-4;

/// A vector of the plane against one in space, which lies in the plane.
::testing::AssertionResult alike(const Json& plane, const Json& space) {
  for (std::size_t i = 0; i < 2; ++i)
    if (!(std::abs(plane[i].get<double>() - space[i].get<double>()) <= same_place))
      return ::testing::AssertionFailure() << plane << " is not " << space;
  return ::testing::AssertionSuccess();
}

/// The answers of the plane and of the prisms to one query about `bodies`.
std::pair<Json, Json> answers(const std::string& query, const std::string& bodies) {
  const std::string question = fmt::format(R"({{"query": "{}", {}}})", query, bodies);
  return {Json::parse(answer_line(question, Precision::double_precision).text), by_prisms(question)};
}

double deepest(const Json& contacts) {
  double depth = 1e300;
  for (const Json& m : contacts["manifolds"])
    for (const Json& p : m["points"]) depth = std::min(depth, p["distance"].get<double>());
  return depth;
}

TEST(PlaneOracle, PrismsAnswerAlike) {
  std::mt19937 random(1);
  const auto u = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  int overlaps = 0, hits = 0;
  for (int round = 0; round < 600; ++round) {
    const std::string a = random_plane_shape(random, false), b = random_plane_shape(random, true);
    const std::string bodies =
        fmt::format(R"("dimension": 2, "a": {{"shape": {}, "translation": [{}, {}], "rotation": {}}},
                       "b": {{"shape": {}, "translation": [{}, {}], "rotation": {}, "linear": [{}, {}]}})",
                    a, u(), u(), 3 * u(), b, 2 * u(), 2 * u(), 3 * u(), 4 * u(), 4 * u());
    const bool convex = (a + b).find("compound") == std::string::npos;
    const auto [distance, prisms] = answers("distance", bodies);
    ASSERT_NEAR(distance["distance"].get<double>(), prisms["distance"].get<double>(), same_distance) << bodies;
    ASSERT_TRUE(alike(distance["normal"], prisms["normal"])) << bodies;
    if (b.find("plane") == std::string::npos) {
      ASSERT_TRUE(alike(distance["a"], prisms["a"])) << bodies;
      ASSERT_TRUE(alike(distance["b"], prisms["b"])) << bodies;
    }
    const auto [cast, prism_cast] = answers("cast", bodies);
    ASSERT_EQ(cast["hit"], prism_cast["hit"]) << bodies;
    if (cast["hit"] == true) {
      ++hits;
      ASSERT_NEAR(cast["t"].get<double>(), prism_cast["t"].get<double>(), 1e-4) << bodies;
    }
    const auto [contacts, prism_contacts] = answers("contacts", bodies);
    ASSERT_EQ(contacts["overlap"], prism_contacts["overlap"]) << bodies;
    if (convex) {
      ASSERT_EQ(contacts["manifolds"].size(), prism_contacts["manifolds"].size()) << bodies;
      for (std::size_t i = 0; i < contacts["manifolds"].size(); ++i) {
        ASSERT_TRUE(alike(contacts["manifolds"][i]["normal"], prism_contacts["manifolds"][i]["normal"])) << bodies;
        ASSERT_NEAR(deepest(contacts), deepest(prism_contacts), same_distance) << bodies;
      }
    }
    overlaps += contacts["overlap"] == true;
  }
  EXPECT_GT(overlaps, 150);
  EXPECT_GT(hits, 250);
}

TEST(PlaneOracle, PrismsAnswerPointsAndRaysAlike) {
  std::mt19937 random(2);
  const auto u = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  int inside = 0, hits = 0, misses = 0;
  for (int round = 0; round < 600; ++round) {
    const std::string body =
        fmt::format(R"("dimension": 2, "a": {{"shape": {}, "translation": [{}, {}], "rotation": {}}})",
                    random_plane_shape(random, true), u(), u(), 3 * u());
    const auto [near, prism_near] = answers("closest", body + fmt::format(R"(, "point": [{}, {}])", 2 * u(), 2 * u()));
    ASSERT_NEAR(near["distance"].get<double>(), prism_near["distance"].get<double>(), same_distance) << body;
    ASSERT_TRUE(alike(near["point"], prism_near["point"])) << body;
    ASSERT_TRUE(alike(near["normal"], prism_near["normal"])) << body;
    inside += near["distance"].get<double>() < 0;
    const auto [hit, prism_hit] =
        answers("raycast", body + fmt::format(R"(, "ray": {{"origin": [{}, {}], "direction": [{}, {}], "length": 4}})",
                                              3 * u(), 3 * u(), u(), u()));
    ASSERT_EQ(hit["hit"], prism_hit["hit"]) << body;
    ++(hit["hit"] == true ? hits : misses);
    if (hit["hit"] != true) continue;
    ASSERT_NEAR(hit["t"].get<double>(), prism_hit["t"].get<double>(), 1e-7) << body;
    ASSERT_TRUE(alike(hit["point"], prism_hit["point"])) << body;
    ASSERT_TRUE(alike(hit["normal"], prism_hit["normal"])) << body;
  }
  EXPECT_GT(inside, 60);
  EXPECT_GT(hits, 100);
  EXPECT_GT(misses, 100);
}

}  // namespace
}  // namespace graze::io
