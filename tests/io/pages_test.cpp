// What the pages show of the query protocol is what the library answers.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "graze/io/plane_simulate.hpp"
#include "graze/io/protocol.hpp"
#include "io/answer.hpp"

namespace graze::io {
namespace {

std::string read(const std::string& path) {
  std::ifstream in(std::string(GRAZE_SOURCE_DIR) + "/" + path);
  EXPECT_TRUE(in.good()) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The lines of each block of a page that is fenced under that name.
std::vector<std::vector<std::string>> blocks(const std::string& page, const std::string& name) {
  std::vector<std::vector<std::string>> all;
  std::istringstream lines(read(page));
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (!inside && line == "```" + name) {
      inside = true;
      all.emplace_back();
    } else if (line == "```") {
      inside = false;
    } else if (inside) {
      all.back().push_back(line);
    }
  }
  return all;
}

std::string answer(const std::string& line) { return answer_line(line, Precision::double_precision).text; }

TEST(Pages, TheProtocolsSecondLineAnswersTheFirst) {
  std::size_t asked = 0;
  for (const auto& block : blocks("docs/protocol.md", "jsonl")) {
    ASSERT_EQ(block.size() % 2, 0u) << block.front();
    for (std::size_t i = 0; i < block.size(); i += 2, ++asked) EXPECT_EQ(answer(block[i]), block[i + 1]) << block[i];
  }
  EXPECT_GE(asked, 14u);
}

TEST(Pages, TheFirstPagesQuestionHasTheAnswerShown) {
  std::map<std::string, std::string> files;
  std::size_t asked = 0;
  for (const auto& block : blocks("README.md", "console"))
    for (std::size_t i = 0; i + 1 < block.size(); ++i) {
      const std::string cat = "$ cat ", query = "$ graze query ";
      if (block[i].starts_with(cat)) files[block[i].substr(cat.size())] = block[i + 1];
      if (!block[i].starts_with(query)) continue;
      EXPECT_EQ(answer(files[block[i].substr(query.size())]), block[i + 1]);
      ++asked;
    }
  EXPECT_EQ(asked, 1u);
}

TEST(Pages, TheQuestionsBesideThePagesAreAnswered) {
  for (const char* page : {"docs/separating-axes.jsonl", "docs/resolution.jsonl", "docs/plane.jsonl"}) {
    std::istringstream lines(read(page));
    std::size_t asked = 0;
    for (std::string line; std::getline(lines, line); ++asked)
      EXPECT_FALSE(answer_line(line, Precision::double_precision).error) << line;
    EXPECT_GE(asked, 3u) << page;
  }
}

/// Whether `shown` is what a page may show of `whole`: parts of it, with numbers that differ by less than a unit of the
/// fifth digit of the largest beside them, or of the last that a page prints.
::testing::AssertionResult shown_of(const Json& shown, const Json& whole) {
  if (shown.is_object()) {
    for (const auto& [key, value] : shown.items()) {
      if (!whole.contains(key)) return ::testing::AssertionFailure() << "no " << key;
      if (const auto part = shown_of(value, whole[key]); !part) return part;
    }
    return ::testing::AssertionSuccess();
  }
  if (shown.is_array()) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (i >= whole.size()) return ::testing::AssertionFailure() << "no entry " << i;
      if (const auto part = shown_of(shown[i], whole[i]); !part) return part;
    }
    return ::testing::AssertionSuccess();
  }
  const bool same = !shown.is_number() ? shown == whole
                                       : std::abs(shown.get<double>() - whole.get<double>()) <=
                                             1e-5 * std::abs(whole.get<double>()) + 6e-4;
  return same ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << shown << " is shown for " << whole;
}

TEST(Pages, ThePlayedDrawingIsAsShown) {
  std::size_t shown = 0;
  for (const auto& block : blocks("docs/plane.md", "json")) {
    std::string text;
    for (const std::string& line : block) text += line + "\n";
    const Json frame = Json::parse(text);
    if (!frame.contains("time")) continue;
    ++shown;
    const PlaneScene scene =
        load_plane_scene(std::filesystem::path(GRAZE_SOURCE_DIR) / "examples" / "scenes" / "plane.svg");
    SimulateOptions options{.seconds = 1};
    options.gravity = {scene.gravity->x, scene.gravity->y, 0};
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("graze_page_" + std::to_string(getpid()) + ".jsonl");
    const auto recording = record(file, scene);
    simulate(scene, options, [&](const PlaneSimulationFrame& played) { recording->add(played); });
    recording->close();
    std::ifstream in(file);
    bool found = false;
    for (std::string line; std::getline(in, line);) {
      const Json played = Json::parse(line);
      if (std::abs(played["time"].get<double>() - frame["time"].get<double>()) > 1e-6) continue;
      found = true;
      EXPECT_TRUE(shown_of(frame, played));
    }
    EXPECT_TRUE(found);
    in.close();
    std::filesystem::remove(file);
  }
  EXPECT_EQ(shown, 1u);
}

}  // namespace
}  // namespace graze::io
