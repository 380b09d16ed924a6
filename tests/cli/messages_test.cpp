// What the program says when something is not as it should be: full disks, missing files, misspelt words.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace graze::cli {
namespace {

const std::string example = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/demo.gltf";
const std::string plane_example = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/plane.svg";
const std::string capture = std::string(GRAZE_SOURCE_DIR) + "/fuzz/corpus/capture/whole-file";
const std::string questions = std::string(GRAZE_SOURCE_DIR) + "/docs/separating-axes.jsonl";

/// A folder of the test's own, removed at its end.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(std::filesystem::temp_directory_path() / ("graze_" + name)) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& file) const { return (path_ / file).string(); }

 private:
  std::filesystem::path path_;
};

class FullDisk : public testing::TestWithParam<std::string> {};

// /dev/full takes no byte, as a disk without room.
TEST_P(FullDisk, IsNoSuccess) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "a system without /dev/full";
  const Result r = run(GetParam() + " > /dev/full");
  EXPECT_EQ(r.code, 2);
  const std::string said = "graze: standard output cannot be written: No space left on device";
  EXPECT_NE(r.output.find(said), std::string::npos) << r.output;
}

INSTANTIATE_TEST_SUITE_P(Cli, FullDisk,
                         testing::Values("query " + questions, "response " + questions, "query - < " + questions,
                                         "explain " + questions, "explain --json " + questions, "info " + example,
                                         "info --json " + example, "collide " + example, "collide --json " + example,
                                         "collide " + std::string(GRAZE_SOURCE_DIR) +
                                             "/examples/scenes/moving.gltf --frames",
                                         "cast " + example + " --from 'crate 1' --motion 8,0,0 --slide",
                                         "capture " + example + " --seconds 0.1 --out /dev/null", "replay " + capture,
                                         "replay --json " + capture, "simulate " + example + " --seconds 0.1",
                                         "simulate " + example + " --seconds 0.1 --report json", "--help",
                                         "collide --help", "--version", ""));

// Questions without end: the error is met on the way.
TEST(Messages, AFullDiskEndsAStreamOfAnswers) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "a system without /dev/full";
  const Result r = run("query > /dev/full", "yes '{\"query\": 1}' | ");
  EXPECT_EQ(r.code, 2);
  EXPECT_NE(r.output.find("No space left on device"), std::string::npos) << r.output;
}

TEST(Messages, AFullDiskUnderAFileIsNamed) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "a system without /dev/full";
  const Folder folder("full_disk_test");
  for (const char* name : {"full.svg", "full.glb"}) std::filesystem::create_symlink("/dev/full", folder / name);
  const Result captured = run("capture " + example + " --seconds 0.1 --out /dev/full");
  EXPECT_EQ(captured.code, 2);
  EXPECT_EQ(captured.output, "graze: /dev/full: cannot be written: no space left on device\n");
  const std::string cast = "cast " + example + " --from 'crate 1' --motion 8,0,0 --slide";
  for (const std::string& arguments :
       {"collide " + example + " --svg " + (folder / "full.svg"),
        "explain " + questions + " --svg " + (folder / "full.svg"),
        "collide " + example + " --out " + (folder / "full.glb"), cast + " --out " + (folder / "full.glb")}) {
    const Result r = run(arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    EXPECT_NE(r.output.find("cannot be written: no space left on device"), std::string::npos) << r.output;
  }
}

// A file larger than the shell allows ends a program by a signal in the midst of writing it.
TEST(Messages, AProgramThatIsKilledLeavesFilesAsTheyWere) {
  const Folder folder("killed_test");
  for (const char* option : {"--svg", "--out"}) {
    const std::string file = folder / (std::string("kept.") + (option == std::string("--svg") ? "svg" : "gltf"));
    std::ofstream(file) << "old";
    const Result r = run("collide " + example + " " + option + " " + file, "ulimit -f 2; ");
    EXPECT_NE(r.code, 0) << r.output;
    std::ifstream in(file);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "old");
  }
}

TEST(Messages, AFileThatIsNotThere) {
  for (const char* command : {"info", "collide", "cast --from x", "query", "explain"}) {
    const Result r = run(std::string(command) + " /nonexistent.glb");
    EXPECT_EQ(r.code, 2) << command;
    EXPECT_EQ(r.output, "graze: /nonexistent.glb: no such file\n") << command;
    const Result folder = run(std::string(command) + " /usr");
    EXPECT_EQ(folder.code, 2) << command;
    EXPECT_EQ(folder.output, "graze: /usr: a folder, not a file\n") << command;
  }
  EXPECT_EQ(run("collide " + example + " --svg /nonexistent/a.svg > /dev/null").output,
            "graze: /nonexistent/a.svg: cannot be written: no such folder\n");
}

TEST(Messages, AFileOfNoSceneIsToldEveryEnding) {
  const Folder folder("endings_test");
  const std::string text = folder / "x.txt";
  std::ofstream(text) << "text";
  for (const char* command : {"info", "collide", "simulate", "capture --out /dev/null", "cast --from x"}) {
    const Result r = run(std::string(command) + " " + text);
    EXPECT_EQ(r.code, 2) << command;
    EXPECT_EQ(r.output, "graze: " + text +
                            ": expected a file that ends in .gltf, .glb, .obj, .stl or .ply, or of the plane in .svg "
                            "or .json, got \".txt\"\n")
        << command;
  }
}

TEST(Messages, HelpOfViewNamesAllThatItShows) {
  const std::string help = run("view --help").output;
  for (const char* file : {"glTF", ".svg", ".json", "question", "capture"})
    EXPECT_NE(help.find(file), std::string::npos) << file << " in " << help;
}

TEST(Messages, AnUnknownCommandIsNamedAndTheKnownOnesListed) {
  const Result r = run("colide " + example);
  EXPECT_EQ(r.code, 2);
  EXPECT_EQ(r.output, "graze: colide: no such command; there are capture, cast, collide, explain, info, "
                      "query, response, replay, simulate, view (graze --help)\n");
}

TEST(Messages, AloneItHelps) {
  const Result alone = run("");
  EXPECT_EQ(alone.code, 0);
  EXPECT_EQ(alone.output, run("--help").output);
}

TEST(Messages, InfoSaysWhatAMeshIsLike) {
  const Folder folder("findings_test");
  std::ofstream(folder / "seam.obj") << "v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 0 0\nv 0 -1 0\nv 2 -1 0\n"
                                        "f 1 2 3\nf 1 5 4\nf 4 6 2\nf 4 5 6\n";
  const Result table = run("info " + (folder / "seam.obj")), json = run("info --json " + (folder / "seam.obj"));
  EXPECT_NE(table.output.find("10 edges: 2 flat, 0 convex, 0 concave, 8 open; 1 T-junction\n"), std::string::npos)
      << table.output;
  for (const char* key : {"\"tJunctions\"", "\"bytes\""})
    EXPECT_NE(json.output.find(key), std::string::npos) << json.output;
}

TEST(Messages, InfoListsADrawing) {
  const Result r = run("info " + plane_example);
  EXPECT_EQ(r.code, 0) << r.output;
  EXPECT_NE(r.output.find("plane.svg: "), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("circle (radius 21.3)"), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("chain (6 segments)"), std::string::npos) << r.output;
  const auto as_json = nlohmann::json::parse(run("info --json " + plane_example).output);
  for (const auto& c : as_json.at("colliders"))
    if (c.at("name") == "ball") {
      EXPECT_EQ(c.at("translation"), nlohmann::json::parse("[190.0, -229.0]"));
      EXPECT_EQ(c.at("rotation"), 0.0);
      EXPECT_NEAR(c.at("upper").at(1), -229 + 21.3, 1e-9);
    }
}

TEST(Messages, OneIsSingular) {
  const Folder folder("singular_test");
  std::ofstream(folder / "one.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_TRUE(run("info " + (folder / "one.obj")).output.starts_with("one.obj: 1 collider in 1 body\n"));
  EXPECT_NE(run("info " + (folder / "one.obj")).output.find("mesh (1 triangle)"), std::string::npos);
  EXPECT_EQ(run("collide " + (folder / "one.obj")).output, "one.obj: 1 collider in 1 body, 0 pairs in contact\n");
  const std::string both = (folder / "one.obj") + " " + (folder / "one.obj");
  EXPECT_NE(run("collide " + both).output.find("2 colliders in 2 bodies, 1 pair in contact\n"), std::string::npos)
      << run("collide " + both).output;
}

// A marble on the back of a chain with one side overlaps it and touches nothing.
TEST(Messages, AnOverlapWithoutContactIsNoContact) {
  const Folder folder("back_of_chain_test");
  std::ofstream(folder / "back.svg")
      << "<svg xmlns='http://www.w3.org/2000/svg'><path id='arc' d='M 210 100 a 30 30 0 0 0 60 0' data-sides='one'/>"
         "<circle id='marble' class='dynamic' cx='240' cy='120' r='11'/></svg>";
  const std::string output = run("collide " + (folder / "back.svg")).output;
  EXPECT_NE(output.find("0 pairs in contact"), std::string::npos) << output;
  EXPECT_NE(output.find("overlap without contact"), std::string::npos) << output;
}

// What the plane refuses is called by the plane's names.
TEST(Messages, ThePlaneHasItsOwnWords) {
  const Folder folder("plane_words_test");
  const std::string plane = "{\"shape\": {\"type\": \"plane\"}";
  std::ofstream(folder / "q.jsonl")
      << "{\"id\": 1, \"dimension\": 2, \"query\": \"distance\", \"a\": " << plane << "}, \"b\": " << plane
      << ", \"rotation\": 1}}\n"
      << "{\"id\": 2, \"dimension\": 2, \"query\": \"cast\", \"duration\": 1, \"a\": " << plane
      << ", \"angular\": 1}, \"b\": " << plane << "}}\n"
      << "{\"id\": 3, \"dimension\": 2, \"query\": \"overlap\", \"a\": {\"shape\": {\"type\": \"plane\", "
      << "\"plane\": {\"sizeX\": 1}}}, \"b\": " << plane << "}}\n";
  const std::string output = run("query " + (folder / "q.jsonl")).output;
  for (const char* said : {"two half-planes that are not opposite", "no angular velocity of a half-plane",
                           "sizeX: expected no keys, got an unknown key"})
    EXPECT_NE(output.find(said), std::string::npos) << said << " in " << output;
}

TEST(Messages, AnErrorWithoutIdHasItsLine) {
  const Folder folder("lines_test");
  std::ofstream(folder / "q.jsonl") << "\n{\"query\": \"overlap\"}\nnonsense\n{\"id\": 7, \"query\": \"overlap\"}\n";
  EXPECT_EQ(run("query " + (folder / "q.jsonl")).output.substr(0, 52),
            "{\"error\":\"line 2: a: expected a value, got nothing\"}");
  const std::string output = run("query " + (folder / "q.jsonl")).output;
  EXPECT_NE(output.find("{\"error\":\"line 3: "), std::string::npos) << output;
  EXPECT_NE(output.find("{\"id\":7,\"error\":\"a: expected a value, got nothing\"}"), std::string::npos) << output;
}

TEST(Messages, PicturesHaveTheirEnding) {
  const auto refusal = [](const std::string& arguments) {
    const Result r = run(arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    return r.output;
  };
  EXPECT_EQ(refusal("collide " + example + " --svg x.png"),
            "graze: --svg: expected a file name that ends in .svg, got x.png\n");
  EXPECT_EQ(refusal("explain " + questions + " --svg x.png"),
            "graze: --svg: expected a file name that ends in .svg, got x.png\n");
  EXPECT_EQ(refusal("collide " + example + " --out x.gltf"),
            "graze: --out: expected a file name that ends in .glb, got x.gltf\n");
  EXPECT_EQ(refusal("cast " + example + " --from floor --out x"),
            "graze: --out: expected a file name that ends in .glb, got x\n");
  EXPECT_EQ(refusal("capture " + example + " --seconds 0.1 --out x.png"),
            "graze: --out: expected a file name that ends in .capture, got x.png\n");
  EXPECT_FALSE(std::filesystem::exists("x.png"));
  // A pipe is no file that somebody opens by its name.
  EXPECT_TRUE(run("explain " + questions + " --svg /dev/stdout").output.starts_with("<svg"));
}

/// A scene written over itself would be lost.
TEST(Messages, AnOutputIsNoneOfTheInputs) {
  const Folder folder("own_input");
  const std::string scene = folder / "scene.gltf", drawing = folder / "drawing.svg";
  std::filesystem::copy_file(example, scene);
  std::filesystem::copy_file(plane_example, drawing);
  const auto size = std::filesystem::file_size(scene), of_drawing = std::filesystem::file_size(drawing);
  const std::string here = folder / "./scene.gltf";
  for (const std::string& command :
       {"capture " + scene + " --seconds 0.1 --out " + here, "simulate " + scene + " --seconds 0.1 --out " + here,
        "simulate " + drawing + " --seconds 0.1 --svg " + drawing, "collide " + drawing + " --svg " + drawing}) {
    const Result r = run(command);
    EXPECT_EQ(r.code, 2) << command;
    EXPECT_NE(r.output.find(": expected another file than the one that is read, got "), std::string::npos) << r.output;
  }
  EXPECT_EQ(std::filesystem::file_size(scene), size);
  EXPECT_EQ(std::filesystem::file_size(drawing), of_drawing);
}

TEST(Messages, OptionsAreNamedAsTheyWereGiven) {
  const std::string out = " --out /dev/null";
  EXPECT_NE(run("capture " + example + " --substeps 3" + out).output.find("graze: --substeps: expected"),
            std::string::npos);
  EXPECT_NE(run("capture " + example + " --rate 0" + out).output.find("graze: --rate: expected"), std::string::npos);
  const std::string cast = "cast " + example + " --from ";
  EXPECT_NE(run(cast + "nobody").output.find("graze: --from: expected"), std::string::npos);
  EXPECT_NE(run(cast + "\"ball\" --motion nan,0,0").output.find("graze: --"), std::string::npos);
  EXPECT_NE(run("collide " + example + " --svg ''").output.find("--svg: expected a name, got nothing"),
            std::string::npos);
}

TEST(Messages, NumbersOutOfRangeAreToldWithoutTheRangeOfDouble) {
  EXPECT_EQ(run("explain " + questions + " --line 0").output, "graze: --line: expected a whole number >= 1, got 0\n");
  EXPECT_EQ(run("cast " + example + " --from floor --duration -1").output,
            "graze: --duration: expected a finite number >= 0, got -1\n");
  EXPECT_EQ(run("explain " + questions + " --line 99").code, 2);
  EXPECT_EQ(run("explain " + questions + " --line 99999999999999999999").output,
            "graze: --line: expected a whole number of at most 19 digits, got 99999999999999999999\n");
  for (const std::string count : {"0", "-3", "x", "2.5"})
    EXPECT_EQ(run("collide " + example + " --points " + count).output,
              "graze: --points: expected a whole number >= 1, got " + count + "\n");
  EXPECT_EQ(run("explain " + questions + " --line -3").output, "graze: --line: expected a whole number >= 1, got -3\n");
}

TEST(Messages, QuietHasNoNotes) {
  const std::string chosen = "info " + example + " --colliders hull";
  EXPECT_NE(run(chosen).output.find("note: "), std::string::npos);
  EXPECT_EQ(run(chosen + " --quiet").output, run("info " + example).output);
  EXPECT_EQ(run(chosen + " -q").output, run("info " + example).output);
}

TEST(Messages, HelpOfQueryNamesEveryQuery) {
  const std::string help = run("query --help").output;
  for (const char* query : {"overlap", "distance", "contacts", "raycast", "cast,", "closest"})
    EXPECT_NE(help.find(query), std::string::npos) << query;
}

TEST(Messages, ExplainAsJsonIsTheAnswerOfTheProtocol) {
  auto explained = nlohmann::json::parse(run("explain " + questions + " --line 2 --json").output);
  EXPECT_TRUE(explained["trace"]["axes"].is_array());
  explained.erase("trace");
  const std::string answers = run("query " + questions).output;
  const std::size_t second = answers.find('\n') + 1;
  EXPECT_EQ(explained, nlohmann::json::parse(answers.substr(second, answers.find('\n', second) - second)));
}

}  // namespace
}  // namespace graze::cli
