// Scenes from glTF and mesh files, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include <nlohmann/json.hpp>

#include "gltf_text.hpp"
#include "graze/io/collide.hpp"
#include "graze/query.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

/// A scene of one box and one ball, both of size 1, to be changed by each test.
Json base() {
  return Json::parse(R"({
    "asset": {"version": "2.0"},
    "extensions": {
      "KHR_implicit_shapes": {"shapes": [{"type": "box", "box": {"size": [1, 1, 1]}},
                                         {"type": "sphere", "sphere": {"radius": 0.5}}]},
      "KHR_physics_rigid_bodies": {"collisionFilters": [
        {"collisionSystems": ["a"], "collideWithSystems": ["a"]},
        {"collisionSystems": ["b"], "notCollideWithSystems": ["a"]}]}},
    "scenes": [{"nodes": [0, 1]}],
    "nodes": [
      {"name": "box", "extensions": {"KHR_physics_rigid_bodies": {"collider": {"geometry": {"shape": 0}}}}},
      {"name": "ball", "translation": [0, 0.9, 0],
       "extensions": {"KHR_physics_rigid_bodies": {"motion": {"mass": 1}, "collider": {"geometry": {"shape": 1}}}}}]})");
}

Json& physics(Json& scene, std::size_t node) { return scene["nodes"][node]["extensions"]["KHR_physics_rigid_bodies"]; }

Scene load(const Json& json) { return load_gltf(json.dump(), "test.gltf"); }

/// The box's node gets a mesh instead, of one triangle in a buffer.
Json with_triangle() {
  Json json = base();
  json["meshes"] = Json::parse(R"([{"primitives": [{"attributes": {"POSITION": 0}}]}])");
  json["accessors"] = Json::parse(R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}])");
  json["bufferViews"] = Json::parse(R"([{"buffer": 0, "byteLength": 36}])");
  json["buffers"] = Json::parse(
      R"([{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])");
  physics(json, 0)["collider"]["geometry"] = {{"mesh", 0}};
  return json;
}

TEST(GltfScene, BodiesAndColliders) {
  const Scene scene = load(base());
  ASSERT_EQ(scene.colliders.size(), 2u);
  EXPECT_EQ(scene.colliders[0].name, "box");
  EXPECT_EQ(scene.bodies[scene.colliders[0].body].type, MotionType::fixed);
  EXPECT_EQ(scene.bodies[scene.colliders[1].body].type, MotionType::dynamic);
  const auto pairs = collide(scene);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_NEAR(pairs[0].distance(), -0.1, 1e-12);
  EXPECT_NEAR(pairs[0].normal().y, 1, 1e-12);
  CollideOptions single;
  single.precision = Precision::single_precision;
  EXPECT_NEAR(collide(scene, single).at(0).distance(), -0.1, 1e-5);
}

TEST(GltfScene, ScaleTurnsShapesIntoWhatTheyBecome) {
  Json json = base();
  json["nodes"][1]["scale"] = {2, 1, 3};
  const Scene scene = load(json);
  const auto* ellipsoid = scene.colliders[1].shape.as<Ellipsoid<double>>();
  ASSERT_NE(ellipsoid, nullptr);
  EXPECT_EQ(ellipsoid->radii(), (Vec3d{1, 0.5, 1.5}));
  json["nodes"][0]["scale"] = {2, 1, 3};
  EXPECT_EQ(load(json).colliders[0].shape.as<Box<double>>()->half_extents(), (Vec3d{1, 0.5, 1.5}));
  json["extensions"]["KHR_implicit_shapes"]["shapes"][0] = {{"type", "capsule"}};
  const Scene sampled = load(json);
  EXPECT_NE(sampled.colliders[0].shape.as<ConvexHull<double>>(), nullptr);
  ASSERT_EQ(sampled.notices.size(), 1u);
  EXPECT_NE(sampled.notices[0].find("too small"), std::string::npos);
}

// A turned scale shears: a box becomes the parallelepiped that it is, exactly.
TEST(GltfScene, ShearedBoxes) {
  Json json = base();
  json["nodes"].push_back({{"scale", {2, 1, 1}}, {"children", {0}}});
  json["nodes"][0]["rotation"] = {0, 0, std::sin(M_PI / 8), std::cos(M_PI / 8)};
  json["scenes"][0]["nodes"] = {2, 1};
  const Scene scene = load(json);
  const auto* hull = scene.colliders[0].shape.as<ConvexHull<double>>();
  ASSERT_NE(hull, nullptr);
  EXPECT_EQ(hull->data().vertices.size(), 8u);
  const Aabbd box = bounds(scene.colliders[0].shape, scene.colliders[0].pose);
  EXPECT_NEAR(box.upper.x, std::sqrt(2.0), 1e-9);
}

TEST(GltfScene, FiltersBodiesAndTriggers) {
  Json json = base();
  physics(json, 0)["collider"]["collisionFilter"] = 0;
  physics(json, 1)["collider"]["collisionFilter"] = 1;
  EXPECT_TRUE(collide(load(json)).empty());
  physics(json, 1)["collider"]["collisionFilter"] = 0;
  EXPECT_EQ(collide(load(json)).size(), 1u);
  // A collider of one system that names what it collides with has nothing to do with one that names no system.
  physics(json, 1)["collider"].erase("collisionFilter");
  EXPECT_TRUE(collide(load(json)).empty());

  json = base();
  physics(json, 1)["trigger"] = physics(json, 1)["collider"];
  physics(json, 1).erase("collider");
  EXPECT_TRUE(collide(load(json)).at(0).trigger);

  // Two colliders of one body, and two bodies that cannot move, are no pair.
  json = base();
  json["nodes"][1]["children"] = {0};
  json["scenes"][0]["nodes"] = {1};
  EXPECT_EQ(load(json).bodies.size(), 1u);
  EXPECT_TRUE(collide(load(json)).empty());
}

// A list of what to collide with and one of what not to exclude each other.
TEST(GltfScene, FilterWithBothListsIsRefused) {
  Json json = base();
  json["extensions"]["KHR_physics_rigid_bodies"]["collisionFilters"][1]["collideWithSystems"] = {"b"};
  EXPECT_EQ(gltf_refusal(json),
            "test.gltf: extensions.KHR_physics_rigid_bodies.collisionFilters[1]: expected collideWithSystems or "
            "notCollideWithSystems, got both, which exclude each other");
}

TEST(GltfScene, AppendJoinsSystemsByName) {
  Json json = base();
  physics(json, 0)["collider"]["collisionFilter"] = 0;
  physics(json, 1)["collider"]["collisionFilter"] = 1;
  Json other = json;
  std::swap(other["extensions"]["KHR_physics_rigid_bodies"]["collisionFilters"][0],
            other["extensions"]["KHR_physics_rigid_bodies"]["collisionFilters"][1]);
  Scene scene = load(json);
  append(scene, load(other));
  ASSERT_EQ(scene.collision_systems.size(), 2u);
  EXPECT_EQ(scene.colliders[3].filter, scene.colliders[0].filter);
  EXPECT_EQ(scene.colliders[2].filter, scene.colliders[1].filter);
}

TEST(GltfScene, EveryFaultIsNamed) {
  const auto with = [](const std::function<void(Json&)>& change) {
    Json json = base();
    change(json);
    return gltf_refusal(json);
  };
  EXPECT_EQ(
      with([](Json& j) { physics(j, 0)["collider"]["geometry"]["shape"] = 12; }),
      "test.gltf: nodes[0].extensions.KHR_physics_rigid_bodies.collider.geometry.shape: expected an index below 2, "
      "got 12");
  EXPECT_EQ(with([](Json& j) { j["extensions"]["KHR_implicit_shapes"]["shapes"][0]["box"]["size"][1] = -2; }),
            "test.gltf: extensions.KHR_implicit_shapes.shapes[0].box.size[1]: expected a finite number >= 0, got -2");
  EXPECT_EQ(with([](Json& j) {
              j["nodes"][0]["rotation"] = {0, 0, 0, 0};
            }),
            "test.gltf: nodes[0].rotation: expected a quaternion that is not zero, got [0,0,0,0]");
  EXPECT_NE(with([](Json& j) {
              j["nodes"][0]["scale"] = {1, 0, 1};
            }).find("neither zero nor singular"),
            std::string::npos);
  EXPECT_NE(with([](Json& j) { j["nodes"][0]["children"] = {1}; }).find("reached twice"), std::string::npos);
  EXPECT_NE(with([](Json& j) { j["nodes"][0]["children"] = {0}; }).find("reached twice"), std::string::npos);
  EXPECT_NE(with([](Json& j) { j["nodes"][0]["children"] = {7}; }).find("children[0]"), std::string::npos);
  EXPECT_NE(with([](Json& j) { j["nodes"][0]["translation"] = {0, "x", 0}; }).find("expected"), std::string::npos);
}

TEST(GltfScene, BrokenFilesAreRefused) {
  for (const char* bytes : {"", "{", "glTF", "glTF\2\0\0\0", "[]", "nonsense"})
    EXPECT_NE(gltf_refusal(std::string(bytes)), "loaded");
  std::string glb("glTF\2\0\0\0\xff\xff\xff\x7f\xff\xff\xff\x7fJSON", 20);
  EXPECT_NE(gltf_refusal(glb).find("header.length"), std::string::npos);
  EXPECT_NE(gltf_refusal(std::string(100000, '[')).find("nested"), std::string::npos);
}

// Transforms multiply from node to node; and what double holds may be too large for float.
TEST(GltfScene, MagnitudesAreBounded) {
  Json json = base();
  json["nodes"].push_back({{"scale", {1e25, 1e25, 1e25}}, {"children", {0}}});
  json["nodes"][0]["translation"] = {1e25, 0, 0};
  json["scenes"][0]["nodes"] = {2, 1};
  EXPECT_EQ(gltf_refusal(json),
            "test.gltf: nodes[0] (in the world).translation[0]: expected a magnitude of at most 1e48, "
            "got 1.0000000000000003e+50");
  json["nodes"][0] = base()["nodes"][0];
  json["nodes"][0]["scale"] = {1e25, 1e25, 1e25};
  EXPECT_EQ(
      gltf_refusal(json),
      "test.gltf: nodes[0] (in the world).size[0]: expected a magnitude of at most 1e48, got 1.0000000000000003e+50");
  json["nodes"][0]["scale"] = {1, 1, 1};
  const Scene scene = load(json);
  EXPECT_EQ(collide(scene).size(), 1u);
  CollideOptions single;
  single.precision = Precision::single_precision;
  try {
    collide(scene, single);
    FAIL() << "a box of 1e25 in float";
  } catch (const InvalidValue& e) {
    EXPECT_STREQ(e.what(),
                 "test.gltf: box.size[0]: expected a magnitude of at most 1e17 (in float), got 9.999999562023526e+24");
  }
}

// What tinygltf refuses without a place, or takes for absent.
TEST(GltfScene, FaultsOfBuffersAndAccessorsAreNamed) {
  const auto with = [](const std::function<void(Json&)>& change) {
    Json json = with_triangle();
    change(json);
    return gltf_refusal(json);
  };
  EXPECT_EQ(with([](Json&) {}), "loaded");
  EXPECT_EQ(with([](Json& j) { j["buffers"][0].erase("uri"); }),
            "test.gltf: buffers[0].uri: expected a value, of all but the first buffer of a .glb, got nothing");
  EXPECT_EQ(with([](Json& j) { j["buffers"][0]["byteLength"] = 40; }),
            "test.gltf: buffers[0].byteLength: expected the 36 bytes of its uri, got 40");
  EXPECT_EQ(with([](Json& j) { j["buffers"][0]["uri"] = "x.bin"; }),
            "test.gltf: buffers[0].uri: expected a file below the scene's folder, got \"x.bin\"");
  EXPECT_EQ(with([](Json& j) { j["bufferViews"][0].erase("buffer"); }),
            "test.gltf: bufferViews[0].buffer: expected a value, got nothing");
  EXPECT_EQ(with([](Json& j) { j["bufferViews"][0]["byteOffset"] = -3; }),
            "test.gltf: bufferViews[0].byteOffset: expected a whole number >= 0, got -3");
  EXPECT_EQ(with([](Json& j) { j["bufferViews"][0]["byteStride"] = 3; }),
            "test.gltf: bufferViews[0].byteStride: expected a multiple of 4 from 4 to 252, got 3");
  EXPECT_EQ(with([](Json& j) { j["accessors"][0].erase("count"); }),
            "test.gltf: accessors[0].count: expected a value, got nothing");
  EXPECT_EQ(with([](Json& j) { j["accessors"][0]["componentType"] = 7; }),
            "test.gltf: accessors[0].componentType: expected a component type of glTF: 5120 to 5126, got 7");
  EXPECT_EQ(with([](Json& j) { j["accessors"][0].erase("bufferView"); }),
            "test.gltf: accessors[0].bufferView: expected a value, of an accessor that is not sparse, got nothing");
  EXPECT_EQ(with([](Json& j) { j["meshes"][0]["primitives"][0]["indices"] = "x"; }),
            "test.gltf: meshes[0].primitives[0].indices: expected a whole number >= 0, got \"x\"");
  EXPECT_EQ(with([](Json& j) { j["materials"] = {3}; }), "test.gltf: materials[0]: expected an object, got 3");
  EXPECT_EQ(with([](Json& j) { j["asset"]["version"] = "1.0"; }),
            "test.gltf: asset.version: expected a version 2.x of glTF, got \"1.0\"");
}

/// What glTF forbids and would be read as something else.
TEST(GltfScene, VersionsExtensionsStridesAndCountsThatAreNotReadAreRefused) {
  const auto with = [](const std::function<void(Json&)>& change) {
    Json json = with_triangle();
    change(json);
    return gltf_refusal(json);
  };
  EXPECT_EQ(with([](Json& j) { j["asset"]["minVersion"] = "2.0"; }), "loaded");
  EXPECT_EQ(with([](Json& j) { j["asset"]["minVersion"] = "2.1"; }),
            "test.gltf: asset.minVersion: expected a version of at most 2.0, got \"2.1\"");
  EXPECT_EQ(with([](Json& j) { j["bufferViews"][0]["byteStride"] = 4; }),
            "test.gltf: bufferViews[0].byteStride: expected at least the 12 bytes of an element, got 4");
  EXPECT_EQ(with([](Json& j) { j["bufferViews"][0]["byteStride"] = 12; }), "loaded");
  EXPECT_EQ(with([](Json& j) {
              j["extensionsRequired"] = {"KHR_implicit_shapes", "FOO_bar"};
            }),
            "test.gltf: extensionsRequired[1]: expected an extension that is read (KHR_implicit_shapes, "
            "KHR_physics_rigid_bodies) or only seen (materials, textures, lights), got \"FOO_bar\"");
  for (const char* known :
       {"KHR_implicit_shapes", "KHR_physics_rigid_bodies", "KHR_materials_unlit", "KHR_texture_transform",
        "EXT_texture_webp", "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_xmp_json_ld", "KHR_animation_pointer"})
    EXPECT_EQ(with([&](Json& j) { j["extensionsRequired"] = {known}; }), "loaded") << known;
  // Two triangles want six corners: four are one, and a rest.
  const auto corners = [&](int mode, int count) {
    return with([&](Json& j) {
      j["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 4}});
      j["accessors"].push_back({{"bufferView", 1}, {"componentType", 5121}, {"count", count}, {"type", "SCALAR"}});
      j["meshes"][0]["primitives"][0].update({{"indices", 1}, {"mode", mode}});
    });
  };
  EXPECT_EQ(corners(4, 3), "loaded");
  EXPECT_EQ(corners(4, 4),
            "test.gltf: meshes[0].primitives[0].indices: expected three corners for each triangle, got 4");
  EXPECT_EQ(corners(5, 4), "loaded");
}

/// How meshes are stored is nothing to a file whose colliders are shapes, and is told.
TEST(GltfScene, CompressedMeshesAreRefusedWhereTheyAreRead) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"}) {
    Json json = with_triangle();
    json["extensionsRequired"] = {name};
    EXPECT_EQ(gltf_refusal(json),
              "test.gltf: extensionsRequired[0]: expected no extension of how meshes are stored, as "
              "they are read, got \"" +
                  std::string(name) + "\"");
    physics(json, 0)["collider"]["geometry"] = {{"shape", 0}};
    const Scene scene = load(json);
    EXPECT_EQ(scene.colliders.size(), 2u);
    EXPECT_EQ(scene.notices, std::vector<std::string>{"extensionsRequired[0]: " + std::string(name) +
                                                      " is not read, and no collider is made of a mesh"});
  }
}

// A gigabyte of points claimed in a kilobyte of file.
TEST(GltfScene, CountsBeyondTheBufferAreRefused) {
  Json json = with_triangle();
  EXPECT_NE(load(json).colliders[0].shape.as<Mesh<double>>(), nullptr);
  json["accessors"][0]["count"] = 90000000;
  EXPECT_NE(gltf_refusal(json).find("accessors[0].count"), std::string::npos);
  json["accessors"][0]["count"] = 3;
  json["bufferViews"][0]["byteOffset"] = 4294967200u;
  EXPECT_NE(gltf_refusal(json), "loaded");
}

TEST(MeshFile, ObjLoadsAsTrianglesHullBoxOrBall) {
  const auto file = std::filesystem::temp_directory_path() / "graze_scene_test.obj";
  std::ofstream(file) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  EXPECT_EQ(load_scene(file).colliders.at(0).shape.as<Mesh<double>>()->triangles().size(), 4u);
  LoadOptions options;
  options.mesh_colliders = MeshColliders::hull;
  EXPECT_EQ(load_scene(file, options).colliders[0].shape.as<ConvexHull<double>>()->data().planes.size(), 4u);
  options.mesh_colliders = MeshColliders::sphere;
  EXPECT_LT(load_scene(file, options).colliders[0].shape.as<Sphere<double>>()->radius(), 1.2 * 1.633);
  options.mesh_colliders = MeshColliders::box;
  const Scene box = load_scene(file, options);
  EXPECT_NEAR(bounds(box.colliders[0].shape, {}).upper.y, 2, 1e-9);
  std::ofstream(file) << "v 0 0\nf 1 2 99\n";
  EXPECT_THROW(load_scene(file), InvalidValue);
  std::filesystem::remove(file);
  EXPECT_THROW(load_scene(file), InvalidValue);
}

}  // namespace
}  // namespace graze::io
