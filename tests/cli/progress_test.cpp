// Progress: on a terminal, of what takes over a second, and nowhere else.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "run_program.hpp"

namespace graze::cli {
namespace {

/// A terminal of the test's own.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) return;
    name_ = ptsname(master_);
    slave_ = open(name_.c_str(), O_RDWR | O_NOCTTY);  // kept open, so that what is written stays
    fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  ~Terminal() {
    close(slave_);
    close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool there() const { return slave_ >= 0; }
  const std::string& name() const { return name_; }
  /// What was written to it so far.
  std::string seen() const {
    std::string text;
    char part[4096];
    for (ssize_t n = 0; (n = read(master_, part, sizeof part)) > 0;) text.append(part, static_cast<std::size_t>(n));
    return text;
  }

 private:
  int master_, slave_ = -1;
  std::string name_;
};

// Questions that are two seconds in coming take as long to answer.
TEST(Progress, IsShownOnATerminalAndWipedOff) {
  const Terminal terminal;
  if (!terminal.there()) GTEST_SKIP() << "a system without terminals";
  EXPECT_EQ(run("query > /dev/null 2> " + terminal.name(), "sleep 2 | ").code, 0);
  const std::string seen = terminal.seen();
  EXPECT_NE(seen.find("answering: 1 s"), std::string::npos) << seen;
  EXPECT_TRUE(seen.ends_with("\r\x1b[K")) << seen;
}

// Answers on the same terminal have lines of their own.
TEST(Progress, MakesWayForAnswersOnTheSameTerminal) {
  const Terminal terminal;
  if (!terminal.there()) GTEST_SKIP() << "a system without terminals";
  const std::string question =
      R"('{"query": "distance", "a": {"shape": {"type": "box"}}, "b": {"shape": {"type": "box"}, )"
      R"("translation": [3, 0, 0]}}')";
  const Result r = run("query > " + terminal.name() + " 2> " + terminal.name(),
                       "(echo " + question + "; sleep 2; echo " + question + ") | ");
  EXPECT_EQ(r.code, 0) << r.output;
  const std::string seen = terminal.seen();
  EXPECT_EQ(seen.find("{\"distance\":2,"), 0u) << seen;
  EXPECT_NE(seen.find("answering: 1 s"), std::string::npos) << seen;
  EXPECT_NE(seen.find(" s\r\x1b[K{\"distance\":2,"), std::string::npos) << seen;
  EXPECT_TRUE(seen.ends_with("}\r\n")) << seen;
}

TEST(Progress, IsNotShownOfWhatTakesNoTime) {
  const Terminal terminal;
  if (!terminal.there()) GTEST_SKIP() << "a system without terminals";
  EXPECT_EQ(run("query > /dev/null < /dev/null 2> " + terminal.name()).code, 0);
  EXPECT_EQ(terminal.seen(), "");
}

TEST(Progress, IsNotShownWhereQuietIsAskedFor) {
  const Terminal terminal;
  if (!terminal.there()) GTEST_SKIP() << "a system without terminals";
  EXPECT_EQ(run("query --quiet > /dev/null 2> " + terminal.name(), "sleep 2 | ").code, 0);
  EXPECT_EQ(terminal.seen(), "");
}

TEST(Progress, IsNotShownInAPipe) { EXPECT_EQ(run("query > /dev/null", "sleep 2 | ").output, ""); }

}  // namespace
}  // namespace graze::cli
