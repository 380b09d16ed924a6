// The program as a person runs it: what it prints, writes and returns.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace {

using graze::cli::Result;
using graze::cli::run;

const std::string demo = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/demo.gltf";

TEST(Cli, CollidePrintsATableAndWritesPictures) {
  const auto folder = std::filesystem::temp_directory_path() / "graze_cli_test";
  std::filesystem::create_directories(folder);
  const Result r =
      run("collide " + demo + " --svg " + (folder / "a.svg").string() + " --out " + (folder / "a.glb").string());
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.output.find("crate 1"), std::string::npos);
  EXPECT_GT(std::filesystem::file_size(folder / "a.svg"), 1000u);
  EXPECT_EQ(run("info " + (folder / "a.glb").string()).code, 0);  // what we write we read
  std::filesystem::remove_all(folder);
}

TEST(Cli, CollideAsJsonIsTheSameInBothPrecisions) {
  const auto pairs = [](const std::string& precision) {
    return nlohmann::json::parse(run("collide " + demo + " --json --precision " + precision).output)["pairs"];
  };
  const auto d = pairs("double"), f = pairs("float");
  ASSERT_EQ(d.size(), f.size());
  EXPECT_GE(d.size(), 10u);
  for (std::size_t i = 0; i < d.size(); ++i) EXPECT_EQ(d[i]["a"], f[i]["a"]);
}

TEST(Cli, CollideLeavesSoManyPointsOfAPair) {
  const auto points = [](const nlohmann::json& pair) {
    std::size_t count = 0;
    for (const auto& m : pair["manifolds"]) count += m["points"].size();
    return count;
  };
  const auto pairs = [](const std::string& more) {
    return nlohmann::json::parse(run("collide " + demo + " --json" + more).output)["pairs"];
  };
  const auto all = pairs(""), two = pairs(" --points 2");
  ASSERT_EQ(two.size(), all.size());
  std::size_t more = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(points(two[i]), std::min<std::size_t>(2, points(all[i])));
    more += points(all[i]) > 2;
  }
  EXPECT_GE(more, 3u);
  EXPECT_EQ(run("collide " + demo + " --points 0").code, 2);
  EXPECT_EQ(run("collide " + demo + " --points some").code, 2);
}

TEST(Cli, CastTellsWhatIsHitFirstAndDrawsTheWay) {
  const auto file = std::filesystem::temp_directory_path() / "graze_cli_cast_test.glb";
  const std::string move = "cast " + demo + " --from 'crate 1' --motion 8,0,0 --slide";
  const Result r = run(move + " --spin 0,3,0 --out " + file.string());
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.output.find("crate 1 hits crate 2"), std::string::npos) << r.output;
  EXPECT_EQ(run("info " + file.string()).code, 0);  // what we write we read
  std::filesystem::remove(file);

  const auto all = nlohmann::json::parse(run(move + " --all --json").output);
  ASSERT_GE(all["hits"].size(), 3u);
  for (std::size_t i = 1; i < all["hits"].size(); ++i) EXPECT_LE(all["hits"][i - 1]["t"], all["hits"][i]["t"]);
  const auto single = nlohmann::json::parse(run(move + " --json --precision float").output);
  EXPECT_EQ(single["hits"].size(), 1u);
  EXPECT_NEAR(single["hits"][0]["t"].get<double>(), all["hits"][0]["t"].get<double>(), 1e-6);
  EXPECT_NE(run("cast " + demo + " --from 'crate 4' --motion 0,5,0 --slide").output.find("hits nothing"),
            std::string::npos);
  EXPECT_EQ(run("cast " + demo + " --from nobody").code, 2);
  EXPECT_EQ(run("cast " + demo + " --from floor --motion 1,2").code, 2);
  EXPECT_EQ(run("cast " + demo).code, 2);
}

TEST(Cli, BadInputIsNamedAndExitsWithTwo) {
  Result r = run("collide /nonexistent.glb");
  EXPECT_EQ(r.code, 2);
  EXPECT_NE(r.output.find("/nonexistent.glb"), std::string::npos);
  EXPECT_EQ(run("collide").code, 2);
  EXPECT_EQ(run("nonsense").code, 2);
  EXPECT_EQ(run("collide " + demo + " --margin -1").code, 2);
  EXPECT_EQ(run("query /nonexistent").code, 2);
}

// Options are input too.
TEST(Cli, OptionsThatAreNoNumbersAreRefused) {
  const auto refusal = [](const std::string& options) {
    const Result r = run("collide " + demo + " " + options);
    EXPECT_EQ(r.code, 2) << options;
    return r.output;
  };
  EXPECT_EQ(refusal("--margin nan"), "graze: --margin: expected a finite number >= 0, got nan\n");
  EXPECT_EQ(refusal("--margin inf"), "graze: --margin: expected a finite number >= 0, got inf\n");
  EXPECT_EQ(refusal("--margin -1"), "graze: --margin: expected a finite number >= 0, got -1\n");
  EXPECT_EQ(refusal("--margin 1e300"), "graze: --margin: expected a magnitude of at most 1e48, got 1e+300\n");
  EXPECT_EQ(refusal("--precision float --margin 1e300"),
            "graze: --margin: expected a finite number >= 0, got 1e+300\n");
  EXPECT_EQ(refusal("--precision float --margin 1e18"),
            "graze: --margin: expected a magnitude of at most 1e17 (in float), got 1e+18\n");
  EXPECT_EQ(refusal("--direction nan,0,1"), "graze: --direction[0]: expected a finite number, got nan\n");
  EXPECT_EQ(refusal("--direction nan 0 1 --svg n.svg"), "graze: --direction[0]: expected a finite number, got nan\n");
  EXPECT_EQ(refusal("--direction 0,0,0"), "graze: --direction: expected a direction that is not zero, got 0, 0, 0\n");
}

// The colliders that a file has stay, and it is said that none are made of its meshes.
// What a variable of the shell has that was never set is no zero.
TEST(Cli, NumbersThatAreEmptyAreRefused) {
  const std::string moving = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/moving.gltf";
  const std::string cast = "cast " + demo + " --from 'crate 1' ", simulate = "simulate " + demo + " ";
  const std::pair<std::string, std::string> numbers[] = {{simulate, "--seconds"},
                                                         {simulate, "--rate"},
                                                         {simulate, "--threads"},
                                                         {simulate, "--substeps"},
                                                         {simulate + "--seconds 0.1 ", "--gravity"},
                                                         {"capture " + demo + " --out none.capture ", "--seconds"},
                                                         {"collide " + demo + " ", "--margin"},
                                                         {"collide " + moving + " --frames ", "--fps"},
                                                         {cast + "--motion 8,0,0 ", "--duration"},
                                                         {cast, "--motion"}};
  for (const auto& [command, option] : numbers) {
    for (const char* empty : {" ''", "="}) {
      const Result r = run(command + option + empty);
      EXPECT_EQ(r.code, 2) << command << option << empty;
      EXPECT_NE(r.output.find(option), std::string::npos) << r.output;
    }
  }
  EXPECT_EQ(run(cast + "--motion 8,,0").code, 2);
}

TEST(Cli, CollidersOfMeshesLeaveThoseOfTheFileAlone) {
  const Result own = run("info " + demo), asked = run("info " + demo + " --colliders hull");
  EXPECT_EQ(asked.code, 0);
  const std::string note = "note: the file has colliders of its own, which stay: none are made of its meshes\n";
  EXPECT_NE(asked.output.find(note), std::string::npos) << asked.output;
  std::string rest = asked.output;
  if (const auto at = rest.find(note); at != std::string::npos) rest.erase(at, note.size());
  EXPECT_EQ(rest, own.output);
}

TEST(Cli, QueryExitsWithOneWhenAnAnswerIsAnError) {
  EXPECT_EQ(run("query < /dev/null").code, 0);
  const auto file = std::filesystem::temp_directory_path() / "graze_cli_test.jsonl";
  std::ofstream(file) << "{\"id\": 1}\n";
  const Result r = run("query " + file.string());
  EXPECT_EQ(r.code, 1);
  EXPECT_EQ(r.output, "{\"id\":1,\"error\":\"query: expected a value, got nothing\"}\n");
  std::filesystem::remove(file);
}

const std::string moving = std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/moving.gltf";

TEST(Cli, FramesAreATableOrJson) {
  const Result table = run("collide " + moving + " --frames");
  EXPECT_EQ(table.code, 0);
  EXPECT_NE(table.output.find("3 of 6 colliders move in \"swing and throw\", 121 frames to 4 s"), std::string::npos)
      << table.output;
  EXPECT_NE(table.output.find("begin  thrown ball  gate         trigger"), std::string::npos) << table.output;

  const auto json = nlohmann::json::parse(run("collide " + moving + " --frames --json --fps 20 --duration 3").output);
  EXPECT_EQ(json["frames"].size(), 61u);
  EXPECT_EQ(json["moved"], nlohmann::json({1, 2, 3}));
  EXPECT_EQ(json["animation"]["name"], "swing and throw");
  // What begins and ends in a frame is what its count of pairs grows by.
  int pairs = 0;
  std::size_t next = 0;
  for (const auto& frame : json["frames"]) {
    for (; next < json["events"].size() && json["events"][next]["t"] == frame["t"]; ++next) {
      const auto& e = json["events"][next];
      pairs += e["kind"] == "begin" ? 1 : -1;
      EXPECT_EQ(e["depth"].is_number(), e["kind"] == "begin" && !e["trigger"].get<bool>());
    }
    EXPECT_EQ(frame["pairs"], pairs);
  }
  EXPECT_EQ(next, json["events"].size());
  EXPECT_GE(next, 8u);

  const auto grow = nlohmann::json::parse(run("collide " + moving + " --frames --json --animation grow").output);
  EXPECT_EQ(grow["events"].back()["kind"], "end");  // scaled to nothing at the end
}

TEST(Cli, FramesNeedAnAnimationAndSoundOptions) {
  const auto refusal = [](const std::string& arguments) {
    const Result r = run("collide " + arguments);
    EXPECT_EQ(r.code, 2) << arguments;
    return r.output;
  };
  EXPECT_EQ(refusal(demo + " --frames"), "graze: demo.gltf: expected at least one animation, got no animation\n");
  EXPECT_EQ(refusal(moving + " --frames --fps 0"), "graze: --fps: expected a finite number above 0, got 0\n");
  EXPECT_EQ(refusal(moving + " --frames --duration nan"),
            "graze: --duration: expected a finite number >= 0, got nan\n");
  EXPECT_EQ(refusal(moving + " --frames --animation fall"),
            "graze: --animation: expected the name of one or an index below 2 (swing and throw, grow), got fall\n");
  EXPECT_NE(refusal(moving + " --fps 60").find("--frames"), std::string::npos);
  EXPECT_NE(refusal(moving + " --frames --svg a.svg").find("--svg"), std::string::npos);
  EXPECT_NE(refusal(moving + " --frames --fps 1e9").find("frames in all"), std::string::npos);
}

TEST(Cli, HelpHasAnExampleForEachCommand) {
  EXPECT_EQ(run("--help").code, 0);
  for (const char* command : {"cast", "collide", "info", "query"}) {
    const Result r = run(std::string(command) + " --help");
    EXPECT_EQ(r.code, 0);
    EXPECT_NE(r.output.find("Example"), std::string::npos) << command;
  }
}

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The page about separating axes promises that its pictures are drawn by the program.
TEST(Cli, ExplainDrawsThePicturesOfTheDocumentation) {
  const std::string docs = std::string(GRAZE_SOURCE_DIR) + "/docs/separating-axes";
  const auto picture = std::filesystem::temp_directory_path() / "graze_explain_test.svg";
  for (const char* line : {"1", "2", "3", "4"}) {
    const Result r = run("explain " + docs + ".jsonl --line " + line + " --svg " + picture.string());
    EXPECT_EQ(r.code, 0);
    EXPECT_NE(r.output.find("A0"), std::string::npos);
    EXPECT_EQ(content(picture), content(docs + "-" + line + ".svg")) << "line " << line;
  }
  std::filesystem::remove(picture);
}

// And so does the page about blows.
TEST(Cli, ExplainDrawsThePicturesOfBlows) {
  const std::string docs = std::string(GRAZE_SOURCE_DIR) + "/docs/resolution";
  const auto picture = std::filesystem::temp_directory_path() / "graze_explain_blow_test.svg";
  for (const char* line : {"1", "2", "3"}) {
    EXPECT_EQ(run("explain " + docs + ".jsonl --line " + line + " --svg " + picture.string()).code, 0);
    EXPECT_EQ(content(picture), content(docs + "-" + line + ".svg")) << "line " << line;
  }
  std::filesystem::remove(picture);
}

// And so does the page about the plane, of its tables too.
TEST(Cli, ExplainDrawsThePicturesOfThePlane) {
  const std::string docs = std::string(GRAZE_SOURCE_DIR) + "/docs/plane";
  const auto picture = std::filesystem::temp_directory_path() / "graze_explain_plane_test.svg";
  std::string printed;
  for (const char* line : {"1", "2", "3", "4", "5", "6", "7"}) {
    const Result r = run("explain " + docs + ".jsonl --line " + line + " --svg " + picture.string());
    EXPECT_EQ(r.code, 0);
    printed += r.output;
    EXPECT_EQ(content(picture), content(docs + "-" + line + ".svg")) << "line " << line;
  }
  const Result scene =
      run("collide " + std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/plane.svg --svg " + picture.string());
  EXPECT_EQ(scene.code, 0);
  EXPECT_EQ(content(picture), content(docs + "-scene.svg"));
  printed += scene.output;
  std::filesystem::remove(picture);
  // Every table of the page is a part of what was printed.
  std::istringstream page(content(docs + ".md"));
  std::size_t tables = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("    ") || line.starts_with("    graze ")) continue;
    EXPECT_NE(printed.find(line.substr(4)), std::string::npos) << line;
    ++tables;
  }
  EXPECT_GT(tables, 20u);
}

TEST(Cli, ExplainNamesTheWinnerAndTheFeatures) {
  const Result r = run("explain " + std::string(GRAZE_SOURCE_DIR) + "/docs/separating-axes.jsonl --precision float");
  EXPECT_NE(r.output.find("> B0"), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("B0 has the least overlap"), std::string::npos) << r.output;
  EXPECT_NE(r.output.find("vertex 2 of A, vertex 3 of B"), std::string::npos) << r.output;
}

TEST(Cli, ResponseIsAnotherNameOfQuery) {
  const std::string file = std::string(GRAZE_SOURCE_DIR) + "/docs/resolution.jsonl";
  const Result r = run("response " + file);
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.output.find("\"normalImpulse\":"), std::string::npos) << r.output;
  EXPECT_EQ(r.output, run("query " + file).output);
  EXPECT_NE(run("response --help").output.find("Queries:"), std::string::npos);
}

// Two bodies of mass 1, the first of which runs into the second that rests: both go on with half of its speed.
TEST(Cli, ExplainShowsTheQuantitiesOfAResponse) {
  const auto file = std::filesystem::temp_directory_path() / "graze_explain_response_test.jsonl";
  std::ofstream(file) << R"({"query": "response", "a": {"shape": {"type": "box"}, "mass": 1, "linear": [1, 0, 0]}, )"
                         R"("b": {"shape": {"type": "box"}, "mass": 1}, )"
                         R"("contact": {"point": [0, 0, 0], "normal": [1, 0, 0]}})"
                      << std::endl;
  const Result table = run("explain " + file.string()), json = run("explain --json " + file.string());
  EXPECT_EQ(table.code, 0);
  EXPECT_NE(table.output.find("the impulse along the normal is 0.5, friction holds"), std::string::npos)
      << table.output;
  EXPECT_NE(table.output.find("B moves on by              0.5         0         0"), std::string::npos) << table.output;
  EXPECT_NE(table.output.find("effective mass             0.5\n"), std::string::npos) << table.output;
  EXPECT_EQ(json.code, 0);
  EXPECT_NE(json.output.find("\"effectiveMass\": 0.5"), std::string::npos) << json.output;
  std::ofstream(file) << R"({"query": "response", "a": {"mass": -1}})" << std::endl;
  const Result refused = run("explain " + file.string());
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.output.find(file.string() + ", line 1: a.mass"), std::string::npos) << refused.output;
  std::filesystem::remove(file);
}

TEST(Cli, ExplainCountsTheLinesThatQueryNames) {
  const auto file = std::filesystem::temp_directory_path() / "graze_explain_lines_test.jsonl";
  const std::string ball = R"({"query": "raycast", "a": {"shape": {"type": "sphere", "sphere": {"radius": )";
  const std::string ray = R"(}}}, "ray": {"origin": [9, 0, 0], "direction": [-1, 0, 0]}})";
  std::ofstream(file) << "\n" << ball << 1 << ray << "\n  \n" << ball << 2 << ray << "\n" << ball << -1 << ray << "\n";
  const auto explained = [&](const std::string& options) { return run("explain " + file.string() + options); };
  EXPECT_NE(explained("").output.find("hits at 8"), std::string::npos) << "the first question";
  EXPECT_NE(explained(" --line 2").output.find("hits at 8"), std::string::npos);
  EXPECT_NE(explained(" --line 4").output.find("hits at 7"), std::string::npos);
  EXPECT_EQ(explained(" --line 3").code, 2);
  EXPECT_NE(explained(" --line 3").output.find("a question as line 3, got a blank line"), std::string::npos);
  EXPECT_NE(run("query " + file.string()).output.find("line 5: a.shape"), std::string::npos);
  EXPECT_NE(explained(" --line 5").output.find(", line 5: a.shape"), std::string::npos);
  EXPECT_NE(explained(" --line 6").output.find("got 5 lines"), std::string::npos);
  std::filesystem::remove(file);
}

TEST(Cli, ExplainRefusesWhatIsNoQuestion) {
  const std::string docs = std::string(GRAZE_SOURCE_DIR) + "/docs/separating-axes.jsonl";
  EXPECT_EQ(run("explain " + docs + " --line 99").code, 2);
  EXPECT_EQ(run("explain /nonexistent").code, 2);
  EXPECT_EQ(run("explain " + docs + " --svg /nonexistent/a.svg").code, 2);
  EXPECT_EQ(run("explain " + docs + " --direction 0,0,0").code, 2);
  const Result r = run("explain " + std::string(GRAZE_SOURCE_DIR) + "/README.md");
  EXPECT_EQ(r.code, 2);
  EXPECT_NE(r.output.find("graze: "), std::string::npos);
}

}  // namespace
