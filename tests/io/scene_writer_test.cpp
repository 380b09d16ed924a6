// Contacts drawn into scenes: what the file held stays as it was, what is added is all there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "graze/io/collide.hpp"
#include "graze/io/scene_writer.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

const fs::path demo = fs::path(GRAZE_SOURCE_DIR) / "examples/scenes/demo.gltf";

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
void write(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

/// A .glb taken apart by the letter of the format.
struct Glb {
  Json json;
  std::string data;

  explicit Glb(const fs::path& file) {
    const std::string bytes = bytes_of(file);
    const auto word = [&](std::size_t at) {
      std::uint32_t v = 0;
      std::memcpy(&v, bytes.data() + at, 4);
      return v;
    };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(8), bytes.size());
    const std::size_t length = word(12);
    EXPECT_EQ(length % 4, 0u);
    json = Json::parse(bytes.substr(20, length));
    if (bytes.size() == 20 + length) return;
    EXPECT_EQ(word(20 + length) % 4, 0u);
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    data = bytes.substr(28 + length);
    EXPECT_EQ(data.size(), word(20 + length));
  }

  std::string view(std::size_t index) const {
    const Json& v = json["bufferViews"][index];
    EXPECT_EQ(v["buffer"], 0);
    return data.substr(v.value("byteOffset", 0u), v["byteLength"]);
  }
  /// The nodes behind the first `count` that have a name.
  std::vector<Json> added(const std::string& name, std::size_t count = 0) const {
    std::vector<Json> found;
    for (std::size_t i = count; i < json["nodes"].size(); ++i)
      if (json["nodes"][i]["name"] == name) found.push_back(json["nodes"][i]);
    return found;
  }
  Json material(const Json& node) const {
    return json["materials"]
               [json["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]["material"].get<std::size_t>()];
  }
};

/// A folder for one test, gone after it.
struct Folder {
  fs::path path;
  Folder() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    path = fs::temp_directory_path() / ("graze_writer_" + std::string(test->name()));
    fs::create_directories(path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }
};

std::vector<std::string> draw(const fs::path& source, const fs::path& out) {
  const Scene scene = load_scene(source);
  return write_contacts(out, scene, collide(scene), source);
}

/// Every list of the source begins the same list of the result; all else is equal.
void expect_kept(const Json& source, const Json& result, const std::vector<std::string>& but = {}) {
  for (const auto& [key, value] : source.items()) {
    if (std::find(but.begin(), but.end(), key) != but.end()) continue;
    ASSERT_TRUE(result.contains(key)) << key;
    if (!value.is_array() || key == "extensionsUsed") {
      EXPECT_EQ(result[key], value) << key;
      continue;
    }
    ASSERT_GE(result[key].size(), value.size()) << key;
    for (std::size_t i = 0; i < value.size(); ++i) EXPECT_EQ(result[key][i], value[i]) << key << i;
  }
}

void expect_same_colliders(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.colliders.size(), b.colliders.size());
  for (std::size_t i = 0; i < a.colliders.size(); ++i) {
    const Collider &x = a.colliders[i], &y = b.colliders[i];
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.node, y.node);
    EXPECT_EQ(x.body, y.body);
    EXPECT_EQ(x.filter, y.filter);
    EXPECT_EQ(x.trigger, y.trigger);
    const Aabbd p = bounds(x.shape, x.pose), q = bounds(y.shape, y.pose);
    EXPECT_EQ(p.lower, q.lower);
    EXPECT_EQ(p.upper, q.upper);
  }
}

/// A box on a floor and a box apart, all three shown; a ball apart that shows nothing; and one of everything else.
Json rich() {
  return Json::parse(R"({
    "asset": {"version": "2.0", "generator": "a test", "extras": {"kept": [1, 2.5]}},
    "extensionsUsed": ["KHR_implicit_shapes", "KHR_physics_rigid_bodies", "KHR_lights_punctual", "TEST_unknown"],
    "extensions": {
      "KHR_lights_punctual": {"lights": [{"type": "point", "name": "lamp"}]},
      "TEST_unknown": {"anything": {"nested": [null, true]}},
      "KHR_implicit_shapes": {"shapes": [{"type": "box", "box": {"size": [1, 1, 1]}}, {"type": "sphere"}]}},
    "scene": 1,
    "scenes": [{"name": "other", "nodes": [5]}, {"name": "main", "nodes": [0, 1, 2, 3, 4]}],
    "nodes": [
      {"name": "floor", "mesh": 0, "extensions": {"KHR_physics_rigid_bodies": {"collider": {"geometry": {"shape": 0}}}}},
      {"name": "on it", "mesh": 0, "translation": [0, 0.9, 0], "extras": {"a": 1},
       "extensions": {"KHR_physics_rigid_bodies": {"motion": {}, "collider": {"geometry": {"shape": 0}}}}},
      {"name": "apart", "mesh": 0, "translation": [5, 0, 0],
       "extensions": {"KHR_physics_rigid_bodies": {"motion": {}, "collider": {"geometry": {"shape": 0}}}}},
      {"name": "unseen", "translation": [8, 0, 0],
       "extensions": {"KHR_physics_rigid_bodies": {"motion": {}, "collider": {"geometry": {"shape": 1}}}}},
      {"name": "eye", "camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}},
      {"name": "elsewhere"}],
    "cameras": [{"type": "perspective", "name": "eye", "perspective": {"yfov": 0.8, "znear": 0.1}}],
    "meshes": [{"name": "triangle", "primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
    "materials": [{"name": "painted", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
    "samplers": [{"name": "sampler", "magFilter": 9728}],
    "images": [{"name": "png", "uri": "a%20picture.png"},
               {"name": "inline", "uri": "data:image/png;base64,iVBORw0KGgo="}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0, 0, 0], "max": [0, 0, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 1, "type": "SCALAR", "min": [0], "max": [0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 1, "byteLength": 4}],
    "buffers": [{"byteLength": 37, "uri": "points.bin", "name": "points"}, {"byteLength": 4, "uri": "times.bin"}],
    "animations": [{"name": "turn", "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}],
                    "samplers": [{"input": 1, "output": 0}]}]})");
}

const std::string picture("\x89PNG\r\n\x1a\n\0\1\2\xff not decoded", 25);

fs::path write_rich(const fs::path& folder, const Json& json) {
  write(folder / "a picture.png", picture);
  write(folder / "points.bin", std::string(37, '\0'));
  write(folder / "times.bin", std::string("\0\0\x80?", 4));
  write(folder / "rich.gltf", json.dump());
  return folder / "rich.gltf";
}

TEST(SceneWriter, DemoIsKeptAndContactsAreAdded) {
  const Folder folder;
  const fs::path out = folder.path / "demo.glb";
  EXPECT_TRUE(draw(demo, out).empty());
  const Json source = Json::parse(bytes_of(demo));
  const Glb result(out);
  expect_kept(source, result.json, {"scenes", "buffers"});

  const Scene scene = load_scene(demo);
  std::size_t points = 0, manifolds = 0;
  for (const TouchingPair& p : collide(scene)) points += p.point_count(), manifolds += p.manifolds.size();
  ASSERT_GT(points, 10u);
  EXPECT_EQ(result.added("contact").size(), points);
  EXPECT_EQ(result.added("normal").size(), manifolds);
  expect_same_colliders(scene, load_scene(out));
}

TEST(SceneWriter, EverythingOfTheSourceIsKept) {
  const Folder folder;
  const Json source = rich();
  const fs::path out = folder.path / "out.glb";
  EXPECT_TRUE(draw(write_rich(folder.path, source), out).empty());
  const Glb result(out);
  expect_kept(source, result.json, {"scenes", "buffers", "images"});
  EXPECT_EQ(result.json["scenes"][0], source["scenes"][0]);
  EXPECT_EQ(result.json["scenes"][1]["name"], "main");
  EXPECT_EQ(result.json["scenes"][1]["nodes"][4], 4);
  EXPECT_EQ(result.json["scenes"][1]["nodes"].size(), 5 + result.json["nodes"].size() - source["nodes"].size());
  EXPECT_EQ(result.json["images"][1], source["images"][1]);
  EXPECT_EQ(result.json["buffers"][0]["name"], "points");
  EXPECT_EQ(result.json["buffers"][1]["uri"], "data:application/octet-stream;base64,AACAPw==");
  EXPECT_EQ(result.view(0), std::string(36, '\0'));
  const Scene scene = load_scene(folder.path / "rich.gltf");
  for (const char* file : {"points.bin", "times.bin", "a picture.png"}) fs::remove(folder.path / file);
  expect_same_colliders(scene, load_scene(out));  // which stands alone
}

TEST(SceneWriter, PicturesSurviveByteForByte) {
  const Folder folder;
  const fs::path out = folder.path / "out.glb", again = folder.path / "again.glb";
  draw(write_rich(folder.path, rich()), out);
  EXPECT_TRUE(draw(out, again).empty());  // and once more from inside of a .glb
  for (const fs::path& file : {out, again}) {
    const Glb result(file);
    const Json& image = result.json["images"][0];
    EXPECT_FALSE(image.contains("uri"));
    EXPECT_EQ(image["mimeType"], "image/png");
    EXPECT_EQ(image["name"], "png");
    EXPECT_EQ(result.view(image["bufferView"]), picture);
  }
}

TEST(SceneWriter, FilesOutsideOfTheFolderStayThere) {
  const Folder folder;
  fs::create_directories(folder.path / "scene");
  write(folder.path / "secret.png", picture);
  Json json = rich();
  json["images"][0]["uri"] = "../secret.png";
  const auto notices = draw(write_rich(folder.path / "scene", json), folder.path / "out.glb");
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_NE(notices[0].find("../secret.png"), std::string::npos);
  EXPECT_EQ(Glb(folder.path / "out.glb").json["images"][0], json["images"][0]);
}

TEST(SceneWriter, TouchingCollidersAreTintedAndUnseenOnesShown) {
  const Folder folder;
  const fs::path out = folder.path / "out.glb";
  draw(write_rich(folder.path, rich()), out);
  const Glb result(out);
  const std::size_t first = rich()["nodes"].size();
  const auto tinted = result.added("on it", first), unseen = result.added("unseen", first);
  ASSERT_EQ(tinted.size(), 1u);
  EXPECT_EQ(result.material(tinted[0])["name"], "touching");
  EXPECT_EQ(result.material(tinted[0])["alphaMode"], "BLEND");
  ASSERT_EQ(unseen.size(), 1u);
  EXPECT_EQ(result.material(unseen[0])["alphaMode"], "BLEND");
  EXPECT_TRUE(result.added("apart", first).empty());
  EXPECT_TRUE(result.added("floor", first).empty());  // touches, but cannot move

  // The tint lies a little outside of what it is drawn over.
  const Json& mesh = result.json["meshes"][tinted[0]["mesh"].get<std::size_t>()];
  const Json& accessor = result.json["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_GT(accessor["max"][0], 0.5);
  EXPECT_LT(accessor["max"][0], 0.51);
}

TEST(SceneWriter, WhereNothingMovesAllThatTouchesIsTinted) {
  const Folder folder;
  Json json = rich();
  for (std::size_t i = 1; i < 4; ++i) json["nodes"][i]["extensions"]["KHR_physics_rigid_bodies"].erase("motion");
  const fs::path out = folder.path / "out.glb";
  draw(write_rich(folder.path, json), out);
  EXPECT_EQ(Glb(out).added("floor", json["nodes"].size()).size(), 1u);
  EXPECT_EQ(Glb(out).added("on it", json["nodes"].size()).size(), 1u);
}

TEST(SceneWriter, AFileWithoutScenesGetsOneOfAllItsRoots) {
  const Folder folder;
  Json json = rich();
  json.erase("scene");
  json.erase("scenes");
  json["nodes"][4]["children"] = {5};
  const fs::path source = write_rich(folder.path, json), out = folder.path / "out.glb";
  draw(source, out);
  const Json scene = Glb(out).json["scenes"].at(0);
  EXPECT_EQ(std::count(scene["nodes"].begin(), scene["nodes"].end(), 4), 1);
  EXPECT_EQ(std::count(scene["nodes"].begin(), scene["nodes"].end(), 5), 0);
  expect_same_colliders(load_scene(source), load_scene(out));
}

TEST(SceneWriter, MeshFilesAreDrawnAlone) {
  const Folder folder;
  const fs::path file = folder.path / "corner.obj", out = folder.path / "out.glb";
  write(file, "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  draw(file, out);
  const Glb result(out);
  ASSERT_EQ(result.json["nodes"].size(), 1u);
  EXPECT_EQ(result.json["nodes"][0]["name"], "corner");
  EXPECT_EQ(result.material(result.json["nodes"][0])["name"], "static");
  EXPECT_EQ(result.json["accessors"][0]["max"], Json({2, 2, 2}));  // nothing is drawn over, so nothing is moved
  EXPECT_EQ(load_scene(out).colliders.size(), 1u);

  write_contacts(out, Scene{}, {});
  EXPECT_TRUE(load_scene(out).colliders.empty());
}

TEST(SceneWriter, ShapesWithoutThicknessAreThinSolids) {
  const Folder folder;
  const fs::path out = folder.path / "out.glb";
  Scene scene;
  scene.bodies = {{"all", -1, MotionType::fixed, {}}};
  const auto add = [&](const char* name, const Shaped& shape) {
    scene.colliders.push_back({name, -1, 0, shape, {}, {}, false, {}});
  };
  add("box", Box<double>({4, 4, 4}));
  add("segment", LineSegment<double>({-1, 0, 0}, {1, 0, 0}));
  add("point", Sphere<double>(0));
  write_contacts(out, scene, {});
  const Glb result(out);
  const double rod = 4.0 / 400, dot = 4.0 / 150;
  for (const auto& [name, most] :
       {std::pair{"segment", Vec3d{1, rod, rod}}, std::pair{"point", Vec3d{dot, dot, dot}}}) {
    const auto nodes = result.added(name, 0);
    ASSERT_EQ(nodes.size(), 1u) << name;
    const Json& mesh = result.json["meshes"][nodes[0]["mesh"].get<std::size_t>()];
    const Json& accessor = result.json["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(accessor["max"][axis].get<double>(), most[axis], 1e-6) << name;
      EXPECT_NEAR(accessor["min"][axis].get<double>(), -most[axis], 1e-6) << name;
    }
  }
}

TEST(SceneWriter, FaultsNameTheFile) {
  const Folder folder;
  const auto refusal = [&](const fs::path& out, const fs::path& source) -> std::string {
    try {
      write_contacts(out, Scene{}, {}, source);
    } catch (const InvalidValue& e) {
      return e.what();
    }
    return "written";
  };
  EXPECT_NE(refusal(folder.path / "none/out.glb", "").find("none/out.glb"), std::string::npos);
  EXPECT_NE(refusal(folder.path / "out.glb", "/nowhere.glb").find("/nowhere.glb"), std::string::npos);
  write(folder.path / "bad.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 3, \"scenes\": [{}]}");
  EXPECT_NE(refusal(folder.path / "out.glb", folder.path / "bad.gltf").find("bad.gltf"), std::string::npos);
}

}  // namespace
}  // namespace graze::io
