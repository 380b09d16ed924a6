// The plane's kernels against the same figures as prisms in space, which nothing but the reading of JSON has in common.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "graze/io/protocol.hpp"
#include "io/answer.hpp"
#include "io/prism_question.hpp"

namespace graze::io {
namespace {

std::string random_plane_shape(std::mt19937& random) {
  const auto u = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const std::string margin = random() % 3 ? "" : R"(, "margin": )" + std::to_string(u(0, 0.3));
  switch (random() % 4) {
  case 0: return fmt::format(R"({{"type": "circle", "circle": {{"radius": {}}}{}}})", u(0.2, 1), margin);
  case 1: return fmt::format(R"({{"type": "box", "box": {{"size": [{}, {}]}}{}}})", u(0.2, 2), u(0.2, 2), margin);
  case 2: {
    const double r = u(0.1, 0.6);
    return fmt::format(R"({{"type": "capsule", "capsule": {{"height": {}, "radiusBottom": {}, "radiusTop": {}}}{}}})",
                       u(0.2, 2), r, random() % 2 ? r : u(0.1, 0.6), margin);
  }
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

TEST(PlaneOracle, PrismsAnswerAlike) {
  std::mt19937 random(1);
  const auto u = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  int overlaps = 0, hits = 0;
  for (int round = 0; round < 400; ++round) {
    const std::string bodies =
        fmt::format(R"("dimension": 2, "a": {{"shape": {}, "translation": [{}, {}], "rotation": {}}},
                       "b": {{"shape": {}, "translation": [{}, {}], "rotation": {}, "linear": [{}, {}]}})",
                    random_plane_shape(random), u(), u(), 3 * u(), random_plane_shape(random), 2 * u(), 2 * u(),
                    3 * u(), 4 * u(), 4 * u());
    const auto both = [&](const std::string& query) {
      const std::string question = fmt::format(R"({{"query": "{}", {}}})", query, bodies);
      return std::pair{Json::parse(answer_line(question, Precision::double_precision).text), by_prisms(question)};
    };
    const auto [distance, prisms] = both("distance");
    ASSERT_NEAR(distance["distance"].get<double>(), prisms["distance"].get<double>(), 1e-8) << bodies;
    const auto [cast, prism_cast] = both("cast");
    ASSERT_EQ(cast["hit"], prism_cast["hit"]) << bodies;
    if (cast["hit"] == true) {
      ++hits;
      ASSERT_NEAR(cast["t"].get<double>(), prism_cast["t"].get<double>(), 1e-4) << bodies;
    }
    const auto [contacts, prism_contacts] = both("contacts");
    ASSERT_EQ(contacts["overlap"], prism_contacts["overlap"]) << bodies;
    ASSERT_EQ(contacts["manifolds"].size(), prism_contacts["manifolds"].size()) << bodies;
    overlaps += contacts["overlap"] == true;
  }
  EXPECT_GT(overlaps, 100);
  EXPECT_GT(hits, 150);
}

}  // namespace
}  // namespace graze::io
