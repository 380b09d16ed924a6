// docs/how-a-pair-is-answered.md: what it quotes stands in the sources, and its last lines find the contacts.
#include "how-a-pair-is-answered_includes.inc"

#include <gtest/gtest.h>

#include <fstream>

#include "graze/graze.hpp"

namespace {

/// A file without spaces, ends of lines and the marks that continue a macro's.
std::string bare(const std::string& path) {
  std::ifstream in(path);
  EXPECT_TRUE(in.good()) << path;
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\\'; });
  return text;
}
std::string quoted(const std::string& block) { return bare(std::string(GRAZE_PAGES_DIR) + "/" + block); }
std::string source(const std::string& path) { return bare(std::string(GRAZE_SOURCE_DIR) + "/" + path); }

}  // namespace

TEST(Pages, APairsStructIsQuotedFromItsFile) {
  const std::string header = source("src/narrow/pairs/capsule_rectangle.hpp");
  std::string start = quoted("how-a-pair-is-answered_1.inc");
  const std::string end = "};";  // after the third block, in the file
  ASSERT_TRUE(start.ends_with(end));
  start.resize(start.size() - end.size());
  EXPECT_NE(header.find(start), std::string::npos) << start;
  const std::string kernels = quoted("how-a-pair-is-answered_2.inc"), rows = quoted("how-a-pair-is-answered_3.inc");
  EXPECT_NE(source("src/narrow/pairs/capsule_rectangle.kernel.cpp").find(kernels), std::string::npos) << kernels;
  EXPECT_NE(header.find(rows), std::string::npos) << rows;
}

TEST(Pages, CompactContactsAreHandedOn) {
  using namespace graze;
  const std::vector<Shapef> shapes{Box<float>({1, 1, 1}), Sphere<float>(0.5f)};
  const std::vector<Posef> poses{{}, {{0, 0.99f, 0}, {}}};
  const std::vector<IdPair> pairs{{0, 1}};
  const Bodies<float> bodies(shapes, poses);
  std::size_t pushed = 0;
  const auto push = [&](IdPair pair, const Vec3f& normal, const Vec3f&, float distance) {
    EXPECT_EQ(pair.b, 1u);
    EXPECT_GT(normal.y, 0.9f);
    EXPECT_LT(distance, 0);
    ++pushed;
  };
#include "how-a-pair-is-answered_4.inc"
  EXPECT_EQ(pushed, 1u);
}
