// graze collide: what lies inside closed meshes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace graze::cli {
namespace {

/// A cube of edge 2 `half` about (x, 0, 0), as OBJ. Without its last side it is open.
std::string cube(double half, double x, bool closed = true) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += "v " + std::to_string(x + (i & 1 ? half : -half)) + " " + std::to_string(i & 2 ? half : -half) + " " +
            std::to_string(i & 4 ? half : -half) + "\n";
  const int triangles[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (int t = 0; t < (closed ? 12 : 10); ++t) {
    text += "f";
    for (const int corner : triangles[t]) text += " " + std::to_string(corner + 1);
    text += "\n";
  }
  return text;
}

class SolidCollide : public ::testing::Test {
 public:
  SolidCollide() {
    std::filesystem::create_directories(folder_);
    write("outer", cube(2, 0));
    write("inner", cube(0.25, 1));
    write("beside", cube(0.25, 9));
    write("across", cube(0.25, 2));
    write("open", cube(2, 0, false));
  }
  ~SolidCollide() override { std::filesystem::remove_all(folder_); }

  std::string of(const std::string& name) const { return (folder_ / (name + ".obj")).string(); }
  std::string both(const std::string& a, const std::string& b) const { return "collide " + of(a) + " " + of(b) + " "; }

 private:
  void write(const std::string& name, const std::string& text) const { std::ofstream(of(name)) << text; }
  // One a case: cases run side by side.
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      (std::string("graze_solid_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

const std::string unseen =
    "inner lies wholly inside outer, a closed mesh that is a surface: they do not touch (--solid fills it)";

TEST_F(SolidCollide, WhatLiesInsideASurfaceIsSaid) {
  for (const std::string& pair : {both("outer", "inner"), both("inner", "outer")}) {
    Result r = run(pair);
    EXPECT_EQ(r.code, 0);
    EXPECT_NE(r.output.find("note: " + unseen + "\n"), std::string::npos) << r.output;
    EXPECT_NE(r.output.find("0 pairs in contact"), std::string::npos) << r.output;
    EXPECT_EQ(run("--quiet " + pair).output.find("note:"), std::string::npos);
    const auto json = nlohmann::json::parse(run(pair + "--json").output);
    EXPECT_EQ(json["notices"], nlohmann::json::array({unseen}));
    EXPECT_TRUE(json["pairs"].empty());
  }
}

TEST_F(SolidCollide, SolidMeshesTouchWhatLiesInside) {
  for (const char* precision : {"double", "float"}) {
    const auto json =
        nlohmann::json::parse(run(both("outer", "inner") + "--solid --json --precision " + precision).output);
    EXPECT_TRUE(json["notices"].empty()) << json["notices"];
    ASSERT_EQ(json["pairs"].size(), 1u);
    EXPECT_EQ(json["pairs"][0]["overlap"], true);
    const auto& manifolds = json["pairs"][0]["manifolds"];
    ASSERT_EQ(manifolds.size(), 1u);
    EXPECT_NEAR(manifolds[0]["points"][0]["distance"].get<double>(), -1.25, 1e-5);
    EXPECT_NEAR(manifolds[0]["normal"][0].get<double>(), 1, 1e-5);
  }
}

TEST_F(SolidCollide, NothingIsSaidOfWhatIsOutsideOrTouches) {
  for (const char* other : {"beside", "across"}) {
    const Result r = run(both("outer", other));
    EXPECT_EQ(r.code, 0);
    EXPECT_EQ(r.output.find("note:"), std::string::npos) << r.output;
  }
}

TEST_F(SolidCollide, AMeshThatIsNotClosedStaysASurface) {
  const Result r = run(both("open", "inner") + "--solid");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.output.find("note: open: a mesh that is not closed stays a surface\n"), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("0 pairs in contact"), std::string::npos) << r.output;
  // Without --solid there is nothing to say: it has no inside.
  EXPECT_EQ(run(both("open", "inner")).output.find("note:"), std::string::npos);
}

TEST_F(SolidCollide, HelpNamesIt) { EXPECT_NE(run("collide --help").output.find("--solid"), std::string::npos); }

}  // namespace
}  // namespace graze::cli
