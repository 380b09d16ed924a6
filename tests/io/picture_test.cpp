// Pictures: that what they say can be read, on light paper and on dark.
#include "graze/io/picture.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "graze/io/explain.hpp"
#include "io/labels.hpp"

namespace graze::io {
namespace {

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

std::string boxes(double overlap) {
  return draw_explanation(explain(R"({"query": "contacts", "a": {"shape": {"type": "box"}},
      "b": {"shape": {"type": "box"}, "translation": [0.1, )" +
                                      std::to_string(1 - overlap) + R"(, 0.05], "rotation": [0, 0.3, 0, 1]}})",
                                  Precision::double_precision),
                          {1, 0.6, 1.4});
}

TEST(Picture, AnOverlapTooSmallToSeeIsEnlarged) {
  EXPECT_FALSE(has(boxes(0.3), ", × "));
  EXPECT_TRUE(has(boxes(0.001), "overlap 0.001, × "));
  EXPECT_TRUE(has(boxes(0.00002), "overlap 2e-05, × "));
}

TEST(Picture, LabelsDoNotCollide) {
  struct Box {
    double x0, y0, x1, y1;
  };
  Labels labels;
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 24; ++i) points.emplace_back(300 + 3.0 * (i % 6), 200 + 2.0 * (i / 6));
  for (const auto& [x, y] : points) labels.keep_clear(x, y, 4);
  std::vector<Box> placed;
  const std::regex place(R"re(<text x="([0-9.]+)" y="([0-9.]+)")re");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string words = std::to_string(i + 1), svg = labels.at(points[i].first, points[i].second, words);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(svg, found, place)) << svg;
    // Digits of 11 pixels are 6 wide and 8 tall, above the line that they stand on.
    const double x = std::stod(found[1]), y = std::stod(found[2]), half = 3.0 * static_cast<double>(words.size());
    placed.push_back({x - half, y - 8, x + half, y});
  }
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(placed[i].x0 < placed[k].x1 && placed[k].x0 < placed[i].x1 && placed[i].y0 < placed[k].y1 &&
                   placed[k].y0 < placed[i].y1)
          << i + 1 << " upon " << k + 1;
    for (const auto& [x, y] : points)
      EXPECT_FALSE(x > placed[i].x0 && x < placed[i].x1 && y > placed[i].y0 && y < placed[i].y1) << i + 1;
  }
}

TEST(Picture, TheLegendNamesWhatIsShown) {
  Scene scene;
  scene.source = "scene";
  scene.bodies = {{"floor", -1, MotionType::fixed, {}}, {"ball", -1, MotionType::dynamic, {}}};
  scene.colliders.push_back({"floor", -1, 0, Shaped(Box<double>({4, 1, 4})), {}, {}, false, {}});
  scene.colliders.push_back({"ball", -1, 1, Shaped(Sphere<double>(0.5)), {{0, 3, 0}, {}}, {}, false, {}});
  const std::string apart = draw_picture(scene, collide(scene), {1, 1, 1});
  EXPECT_TRUE(has(apart, ">static<"));
  EXPECT_TRUE(has(apart, ">moving<"));
  for (const char* absent : {">touching<", ">static, touched<", ">trigger<", ">contact point"})
    EXPECT_FALSE(has(apart, absent)) << absent;
  scene.colliders[1].pose.translation.y = 0.9;
  const std::string together = draw_picture(scene, collide(scene), {1, 1, 1});
  for (const char* present : {">static, touched<", ">touching<", ">contact point", "1 pair in contact"})
    EXPECT_TRUE(has(together, present)) << present;
  for (const char* absent : {">static<", ">moving<", ">trigger<"}) EXPECT_FALSE(has(together, absent)) << absent;
}

TEST(Picture, ShapesWithoutThicknessAreLinesAndDots) {
  const auto drawn = [](const Shaped& shape) {
    Scene scene;
    scene.bodies = {{"floor", -1, MotionType::fixed, {}}, {"thin", -1, MotionType::dynamic, {}}};
    scene.colliders.push_back({"floor", -1, 0, Shaped(Box<double>({4, 1, 4})), {}, {}, false, {}});
    scene.colliders.push_back({"thin", -1, 1, shape, {{0, 3, 0}, {}}, {}, false, {}});
    return draw_picture(scene, collide(scene), {1, 1, 1});
  };
  const std::string moving = "#8da9c4";
  EXPECT_TRUE(has(drawn(LineSegment<double>({-1, 0, 0}, {1, 0, 0})), "stroke=\"" + moving + "\" stroke-width=\"2.4\""));
  const std::regex dot("<circle [^>]*fill=\"" + moving + "\"");
  EXPECT_TRUE(std::regex_search(drawn(Sphere<double>(0)), dot));
}

// Whatever stands on the paper and is no shape has a colour for each paper.
TEST(Picture, ReadersOfDarkPagesHaveDarkPaper) {
  Scene scene;
  for (const std::string& picture : {boxes(0.3), boxes(0.001), draw_picture(scene, {}, {1, 1, 1})}) {
    EXPECT_TRUE(has(picture, "@media (prefers-color-scheme:dark)"));
    const std::string body = picture.substr(picture.find("</style>"));
    for (const char* fixed : {"#f8f9fa", "#212529", "#495057", "#1d3557", "#c1121f", "#adb5bd", "#fff\""})
      EXPECT_FALSE(has(body, fixed)) << fixed;
  }
}

TEST(Picture, FeaturesAreToldInWords) {
  const Explanation e = explain(R"({"query": "contacts", "a": {"shape": {"type": "box"}}, "b": {"shape":
      {"type": "sphere"}, "translation": [0.1, 0.9, 0]}})",
                                Precision::double_precision);
  ASSERT_EQ(e.manifolds.size(), 1u);
  const std::string words = feature_text(e.manifolds[0].points[0].feature, e);
  EXPECT_TRUE(words.starts_with("face ") && words.ends_with(" of A, surface of B")) << words;
  // An edge by its two vertices: 2 * 127 + 6.
  EXPECT_EQ(feature_text((0x8000u | 260u) << 16 | 0x4003u, e), "edge 2-6 of A, surface of B");
}

}  // namespace
}  // namespace graze::io
