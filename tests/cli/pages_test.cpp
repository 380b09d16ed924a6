// The pages' commands of the program, run as they stand there, print what stands there.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "run_program.hpp"

namespace {

/// A fenced block of a page.
struct Fenced {
  std::string language, body;
};

std::vector<Fenced> fenced_blocks(const std::filesystem::path& page) {
  std::vector<Fenced> blocks;
  std::ifstream in(page);
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), ""});
    } else if (inside) {
      blocks.back().body += line + "\n";
    }
  }
  return blocks;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::filesystem::path> all_pages() {
  const std::filesystem::path root = GRAZE_SOURCE_DIR;
  std::vector<std::filesystem::path> pages = {root / "README.md"};
  for (const auto& entry : std::filesystem::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  return pages;
}

/// A folder in which the program is called `graze` and the repository's examples are at hand, as the pages have it.
class PagesOfTheProgram : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "bin");
    std::filesystem::create_symlink(GRAZE_CLI_PATH, folder_ / "bin/graze");
    std::filesystem::create_directory_symlink(std::filesystem::path(GRAZE_SOURCE_DIR) / "examples",
                                              folder_ / "examples");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// What a script prints here; it has to succeed.
  std::string printed(const std::string& script) const {
    const std::string whole = "cd '" + folder_.string() + "' && PATH=\"$PWD/bin:$PATH\" && set -e\n" + script;
    std::FILE* pipe = popen(("( " + whole + "\n) 2>&1").c_str(), "r");
    std::string output;
    std::array<char, 4096> part{};
    for (std::size_t n = 0; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) output.append(part.data(), n);
    EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 0) << script << output;
    return output;
  }

  /// Runs a block of lines that begin with "$ " and what each of them prints; `$ cat file` shows a file that the lines
  /// after it use. Returns how many commands of the program there were.
  std::size_t run_session(const std::string& body) const {
    std::size_t run = 0;
    std::vector<std::pair<std::string, std::string>> commands;
    for (const std::string& line : lines_of(body)) {
      if (line.starts_with("$ "))
        commands.emplace_back(line.substr(2), "");
      else if (!commands.empty())
        commands.back().second += line + "\n";
    }
    for (const auto& [command, shown] : commands) {
      if (command.starts_with("cat ")) {
        std::ofstream(folder_ / command.substr(4)) << shown;
        continue;
      }
      EXPECT_EQ(printed(command), shown) << command;
      ++run;
    }
    return run;
  }

  // Tests run side by side, each in a process of its own.
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("graze_pages_test_" + std::to_string(getpid()));
};

TEST_F(PagesOfTheProgram, CommandsPrintWhatIsShown) {
  std::size_t run = 0;
  for (const auto& page : all_pages()) {
    SCOPED_TRACE(page.string());
    const std::vector<Fenced> blocks = fenced_blocks(page);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (blocks[i].language != "console") continue;
      if (blocks[i].body.starts_with("$ ")) {
        run += run_session(blocks[i].body);
      } else if (i > 0 && blocks[i - 1].language == "sh" && blocks[i - 1].body.starts_with("graze ")) {
        EXPECT_EQ(printed(blocks[i - 1].body), blocks[i].body);
        ++run;
      }
    }
  }
  EXPECT_GE(run, 2u);
}

TEST_F(PagesOfTheProgram, CommandsAndOptionsThatAreNamedAreThere) {
  std::size_t named = 0;
  for (const auto& page : all_pages())
    for (const Fenced& block : fenced_blocks(page)) {
      if (block.language != "sh") continue;
      for (std::string line : lines_of(block.body)) {
        if (!line.starts_with("graze ")) continue;
        line = line.substr(0, line.find(" #"));
        std::istringstream words(line);
        std::string help;
        for (std::string word; words >> word;) {
          if (word == "graze" && words >> word) help = printed("graze " + word + " --help");
          if (!word.starts_with("--")) continue;
          EXPECT_NE(help.find(word), std::string::npos) << page << ": " << line;
        }
        ++named;
      }
    }
  EXPECT_GE(named, 10u);
}

}  // namespace
