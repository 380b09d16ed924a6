// Captures as a person makes them and runs them again.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace {

using graze::cli::run;

TEST(CaptureProgram, AScenePlayedRunsAgainToTheSameBits) {
  const auto folder = std::filesystem::temp_directory_path() / "graze_capture_test";
  std::filesystem::create_directories(folder);
  const std::string file = (folder / "demo.capture").string();
  const std::string scenes = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/", demo = scenes + "demo.gltf";
  for (const auto& [scene, precision] : {std::pair{demo, "double"}, {scenes + "plane.svg", "float"}, {demo, "float"}}) {
    const auto made = run("capture " + scene + " --seconds 0.5 --precision " + precision + " --out " + file);
    ASSERT_EQ(made.code, 0) << made.output;
    EXPECT_NE(made.output.find("30 frames"), std::string::npos) << made.output;
    const auto again = run("replay -q --json --threads 2 " + file);
    ASSERT_EQ(again.code, 0) << again.output;
    const auto report = nlohmann::json::parse(again.output);
    EXPECT_EQ(report["frames"], 30);
    EXPECT_EQ(report["precision"], precision);
    EXPECT_EQ(report["same"], true);
    EXPECT_EQ(report["cut"], false);
    std::vector<std::string> names;
    for (const auto& body : report["names"]) names.push_back(body["name"]);
    EXPECT_NE(std::find(names.begin(), names.end(), scene == demo ? "ball in the bowl" : "marble"), names.end())
        << again.output;
  }
  // Cut within its last frame, as by a crash.
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 3);
  const auto cut = run("replay " + file);
  EXPECT_EQ(cut.code, 0);
  EXPECT_NE(cut.output.find("29 frames"), std::string::npos) << cut.output;
  EXPECT_NE(cut.output.find("ends within a frame"), std::string::npos) << cut.output;
  // Cut within its first: nothing is left that could be compared.
  const std::string head = (folder / "head.capture").string();
  std::filesystem::copy_file(file, head, std::filesystem::copy_options::overwrite_existing);
  std::filesystem::resize_file(head, 300);
  for (const char* how : {"replay ", "replay --json "}) {
    const auto nothing = run(how + head);
    EXPECT_EQ(nothing.code, 2);
    EXPECT_EQ(nothing.output,
              "graze: " + head + ": expected a capture of one frame at least, got none that is whole\n");
  }
  {
    std::fstream damaged(file, std::ios::in | std::ios::out | std::ios::binary);
    damaged.seekp(400);
    damaged.put('\x7f');
  }
  const auto damaged = run("replay " + file);
  EXPECT_EQ(damaged.code, 2);
  EXPECT_NE(damaged.output.find("frame"), std::string::npos) << damaged.output;
  EXPECT_EQ(run("replay " + demo).code, 2);
  EXPECT_EQ(run("replay " + (folder / "none").string()).code, 2);
  EXPECT_EQ(run("capture " + demo + " --out " + (folder / "no/such/place").string()).code, 2);
  EXPECT_EQ(run("capture " + demo + " " + scenes + "plane.svg --out " + file).code, 2);
  std::filesystem::remove_all(folder);
}

}  // namespace
