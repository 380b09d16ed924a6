// graze simulate, as a person runs it.
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace graze::cli::simulate_test {
namespace {

const std::string demo = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/demo.gltf";

/// A folder of its own for each test, removed at its end.
class Simulate : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder =
        std::filesystem::temp_directory_path() / ("graze_simulate_" + std::to_string(getpid()) + "_" + test->name());
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::string file(const char* name) const { return (folder / name).string(); }
  static std::string text_of(const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::filesystem::path folder;
};

TEST_F(Simulate, WritesTheSameBytesWithAnyThreads) {
  for (const char* ending : {"jsonl", "gltf", "glb"}) {
    const std::string a = file("a.") + ending, b = file("b.") + ending, c = file("c.") + ending;
    const std::string command = "simulate " + demo + " --seconds 0.5 --out ";
    EXPECT_EQ(run(command + a).code, 0);
    EXPECT_EQ(run(command + b).code, 0);
    EXPECT_EQ(run(command + c + " --threads 3").code, 0);
    EXPECT_FALSE(text_of(a).empty());
    EXPECT_EQ(text_of(a), text_of(b));
    EXPECT_EQ(text_of(a), text_of(c));
  }
}

TEST_F(Simulate, HasALineForEachFrame) {
  const std::string out = file("a.jsonl");
  EXPECT_EQ(run("simulate " + demo + " --seconds 0.5 --rate 20 --gravity 0,0,-1 --precision float --out " + out).code,
            0);
  std::ifstream in(out);
  std::string line;
  int frames = 0;
  for (; std::getline(in, line); ++frames) EXPECT_EQ(nlohmann::json::parse(line)["time"], frames / 20.0);
  EXPECT_EQ(frames, 11);
}

TEST_F(Simulate, ReportsWhatItTook) {
  const Result text = run("simulate " + demo + " --seconds 0.5");
  EXPECT_EQ(text.code, 0);
  for (const char* word : {"14 moving bodies", "0.5 s in 30 steps", "deepest", "energy", "awake"})
    EXPECT_NE(text.output.find(word), std::string::npos) << text.output;
  const Result json = run("simulate " + demo + " --seconds 0.5 --report json");
  const auto whole = nlohmann::json::parse(json.output);
  EXPECT_EQ(whole["steps"], 30);
  EXPECT_EQ(whole["bodies"], 14);
  EXPECT_GT(whole["milliseconds"]["whole"], 0);
}

TEST_F(Simulate, TellsWhatCameIntoTriggers) {
  const std::string scene = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/conformance/sample-triggers.gltf";
  EXPECT_NE(run("simulate " + scene + " --seconds 2").output.find("trigger   zone: 1 in, 1 out\n"), std::string::npos);
  const auto told = nlohmann::json::parse(run("simulate " + scene + " --seconds 2 --report json").output)["triggers"];
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0]["kind"], "begin");
  EXPECT_EQ(told[1]["kind"], "end");
  for (const auto& event : told) {
    EXPECT_EQ(event["trigger"], "zone");
    EXPECT_EQ(event["body"], "ball");
  }
  EXPECT_NEAR(told[0]["time"].get<double>(), 0.5, 0.02);
}

TEST_F(Simulate, DrawsBeforeAndAfter) {
  const std::string out = file("a.svg");
  EXPECT_EQ(run("simulate " + demo + " --seconds 1 --svg " + out).code, 0);
  const std::string picture = text_of(out);
  EXPECT_NE(picture.find("demo.gltf, before"), std::string::npos);
  EXPECT_NE(picture.find("demo.gltf, after"), std::string::npos);
}

TEST_F(Simulate, PlaysScenesOfThePlane) {
  const std::string scene = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/plane.svg";
  const auto after = [&](const std::string& options) {
    const std::string out = file("a.jsonl");
    EXPECT_EQ(run("simulate " + scene + " --out " + out + " " + options).code, 0) << options;
    const std::string text = text_of(out);
    return nlohmann::json::parse(text.substr(text.rfind('\n', text.size() - 2) + 1));
  };
  // The ghost falls freely, by g t^2 / 2 of the file's gravity, or of that which is asked for.
  const auto fallen = [](const nlohmann::json& frame) {
    return -120 - frame["bodies"][8]["translation"][1].get<double>();
  };
  EXPECT_EQ(after("--seconds 0")["bodies"][8]["body"], "ghost");
  EXPECT_NEAR(fallen(after("--seconds 0.25")), 981 * 0.0625 / 2, 1e-6);
  EXPECT_NEAR(fallen(after("--seconds 0.25 --gravity 0,-8,0 --threads 2")), 0.25, 1e-9);
  const std::string picture = file("a.svg");
  const Result played = run("simulate " + scene + " --seconds 0.5 --out " + picture);
  EXPECT_EQ(played.code, 0);
  EXPECT_NE(played.output.find("9 moving bodies"), std::string::npos) << played.output;
  EXPECT_NE(text_of(picture).find("<animateTransform"), std::string::npos);
  EXPECT_EQ(run("simulate " + scene + " --out " + file("a.glb")).output,
            "graze: " + file("a.glb") +
                ": expected a file name that ends in .svg or .jsonl, for a scene of the plane, got \".glb\"\n");
  EXPECT_EQ(run("simulate " + scene + " --seconds 0.5 --svg " + picture).code, 0);
  for (const char* when : {"plane.svg, before", "plane.svg, after"})
    EXPECT_NE(text_of(picture).find(when), std::string::npos) << when;
  EXPECT_EQ(text_of(picture).find("nan"), std::string::npos);
  EXPECT_EQ(run("simulate " + scene + " --svg a.png").output,
            "graze: --svg: expected a file name that ends in .svg, got a.png\n");
}

TEST_F(Simulate, SaysWhatIsWrong) {
  const auto refusal = [](const std::string& options) {
    const Result r = run("simulate " + demo + " " + options);
    EXPECT_EQ(r.code, 2) << options;
    return r.output;
  };
  EXPECT_EQ(refusal("--seconds -1"), "graze: --seconds: expected a finite number >= 0, got -1\n");
  EXPECT_EQ(refusal("--rate 0"), "graze: --rate: expected a finite number >= 1, got 0\n");
  EXPECT_EQ(refusal("--substeps 3"), "graze: --substeps: expected a power of two from 1 to 1024, got 3\n");
  EXPECT_EQ(refusal("--threads 0"), "graze: --threads: expected a number from 1 to 1024, got 0\n");
  EXPECT_EQ(refusal("--out moved.avi"),
            "graze: moved.avi: expected a file name that ends in .gltf, .glb or .jsonl, got \".avi\"\n");
  EXPECT_EQ(refusal("--out " + file("none/a.glb")),
            "graze: " + file("none/a.glb") + ": cannot be written: no such folder\n");
}

/// A run that is refused leaves the file of an earlier one as it was, and makes none.
TEST_F(Simulate, ARefusedRunLeavesItsFiles) {
  const std::string plane = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/plane.svg";
  const std::string leaf = file("leaf.gltf"), line = file("line.svg");
  std::ofstream(leaf) << R"({"asset": {"version": "2.0"}, "extensions": {"KHR_implicit_shapes": {"shapes": [
    {"type": "plane", "plane": {"sizeX": 1, "sizeZ": 1}}]}}, "nodes": [{"extensions": {"KHR_physics_rigid_bodies": {
    "motion": {}, "collider": {"geometry": {"shape": 0}}}}}]})";
  std::ofstream(line) << R"(<svg><line x2="1" class="dynamic"/></svg>)";
  for (const std::string& arguments :
       {"simulate " + demo + " --substeps 3", "simulate " + plane + " --substeps 3", "simulate " + leaf,
        "simulate " + line, "capture " + demo + " --substeps 3", "capture " + leaf, "capture " + line}) {
    const std::string ending = arguments.starts_with("capture") ? ".capture" : ".jsonl";
    const std::string kept = file(("kept" + ending).c_str()), none = file(("none" + ending).c_str());
    std::ofstream(kept) << "old";
    EXPECT_EQ(run(arguments + " --out " + kept).code, 2) << arguments;
    EXPECT_EQ(text_of(kept), "old") << arguments;
    EXPECT_EQ(run(arguments + " --out " + none).code, 2) << arguments;
    EXPECT_FALSE(std::filesystem::exists(none)) << arguments;
  }
  for (const auto& [command, name] : {std::pair{"simulate ", "none/a.jsonl"}, {"capture ", "none/a.capture"}}) {
    const Result r = run(command + demo + " --out " + file(name));
    EXPECT_NE(r.output.find("cannot be written: no such folder"), std::string::npos) << r.output;
  }
}

/// Lines go into a pipe that another program reads, which has all of them until it ends.
TEST_F(Simulate, WritesIntoAPipe) {
  const std::string pipe = file("pipe"), out = file("a.jsonl");
  const std::string command = "simulate " + demo + " --seconds 0.5 --out ";
  EXPECT_EQ(run(command + out).code, 0);
  const Result r = run(command + pipe + " -q; wait", "mkfifo " + pipe + "; cat " + pipe + " > " + file("read") + " & ");
  EXPECT_EQ(r.code, 0) << r.output;
  EXPECT_EQ(text_of(file("read")), text_of(out));
  EXPECT_FALSE(text_of(out).empty());
}

}  // namespace
}  // namespace graze::cli::simulate_test
