// What the pages show of the query protocol is what the library answers.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "graze/io/protocol.hpp"

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

}  // namespace
}  // namespace graze::io
