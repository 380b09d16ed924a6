// Sparse accessors of glTF: what they replace, and what is refused.
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include <nlohmann/json.hpp>

#include "gltf_text.hpp"

namespace graze::io {
namespace {

using Json = nlohmann::json;

/// A buffer that grows, and the views of its parts.
class Bytes {
 public:
  template <class T>
  std::size_t add(std::initializer_list<T> numbers) {
    data_.resize((data_.size() + 3) / 4 * 4);
    const std::size_t offset = data_.size(), length = numbers.size() * sizeof(T);
    data_.resize(offset + length);
    std::memcpy(data_.data() + offset, numbers.begin(), length);
    views_.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
    return views_.size() - 1;
  }
  const std::string& data() const { return data_; }

  /// A node that collides with a mesh of accessors 0 (positions) and, with `indexed`, 1.
  Json file(const Json& accessors, bool indexed) const {
    Json json = Json::parse(R"({
      "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
      "nodes": [{"extensions": {"KHR_physics_rigid_bodies": {"collider": {"geometry": {"mesh": 0}}}}}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})");
    if (indexed) json["meshes"][0]["primitives"][0]["indices"] = 1;
    json["accessors"] = accessors;
    json["bufferViews"] = views_;
    json["buffers"][0] = {{"byteLength", data_.size()}, {"uri", data_uri(data_)}};
    return json;
  }

 private:
  std::string data_;
  Json views_ = Json::array();
};

Json accessor(int component, const char* type, std::size_t count) {
  return {{"componentType", component}, {"type", type}, {"count", count}};
}

Json sparse(std::size_t count, int component, std::size_t indices, std::size_t values) {
  return {{"count", count},
          {"indices", {{"bufferView", indices}, {"componentType", component}}},
          {"values", {{"bufferView", values}}}};
}

Mesh<double> mesh_of(const std::string& bytes) {
  return *load_gltf(bytes, "test.gltf").colliders.at(0).shape.as<Mesh<double>>();
}
Mesh<double> mesh_of(const Json& json) { return mesh_of(json.dump()); }

/// The corners of each triangle, one after another: independent of how equal points are joined.
std::vector<Vec3d> corners(const Mesh<double>& mesh) {
  std::vector<Vec3d> points;
  for (const auto& t : mesh.triangles())
    for (const auto i : t) points.push_back(mesh.points()[i]);
  return points;
}

/// Three points, of which the file moves the second and the third.
Json moved_points() {
  Bytes bytes;
  const auto base = bytes.add<float>({1, 2, 3, 4, 5, 6, 7, 8, 9});
  const auto indices = bytes.add<std::uint16_t>({1, 2});
  const auto values = bytes.add<float>({0, 1, 0, -1, -2, -3});
  Json points = accessor(5126, "VEC3", 3);
  points["bufferView"] = base;
  points["sparse"] = sparse(2, 5123, indices, values);
  return bytes.file(Json::array({points}), false);
}

TEST(GltfSparse, ReplacesPointsOfABufferView) {
  EXPECT_EQ(corners(mesh_of(moved_points())), (std::vector<Vec3d>{{1, 2, 3}, {0, 1, 0}, {-1, -2, -3}}));
}

TEST(GltfSparse, IndicesOfAllThreeTypesAndOffsets) {
  const auto moved = [](int component, auto zero) {
    using T = decltype(zero);
    Bytes bytes;
    const auto base = bytes.add<float>({99, 1, 2, 3, 99, 4, 5, 6, 99, 7, 8, 9});
    const auto indices = bytes.add<T>({T(77), T(0), T(2)});
    const auto values = bytes.add<float>({99, 0, 1, 0, -1, -2, -3});
    Json points = accessor(5126, "VEC3", 3);
    points["bufferView"] = base;
    points["byteOffset"] = 4;
    points["sparse"] = sparse(2, component, indices, values);
    points["sparse"]["indices"]["byteOffset"] = sizeof(T);
    points["sparse"]["values"]["byteOffset"] = 4;
    Json json = bytes.file(Json::array({points}), false);
    json["bufferViews"][base]["byteStride"] = 16;  // points 16 bytes apart, the first at 4
    return corners(mesh_of(json));
  };
  const std::vector<Vec3d> expected{{0, 1, 0}, {4, 5, 6}, {-1, -2, -3}};
  EXPECT_EQ(moved(5121, std::uint8_t{}), expected);
  EXPECT_EQ(moved(5123, std::uint16_t{}), expected);
  EXPECT_EQ(moved(5125, std::uint32_t{}), expected);
}

/// Both accessors without a buffer view: four points at the origin but for two, two triangles 0 0 0 but for two
/// corners.
Json from_zeros(Bytes& bytes) {
  const auto moved = bytes.add<std::uint8_t>({1, 3});
  const auto points_at = bytes.add<float>({1, 0, 0, 0, 2, 0});
  const auto corners_at = bytes.add<std::uint8_t>({1, 2});
  const auto named = bytes.add<std::uint16_t>({1, 3});
  Json points = accessor(5126, "VEC3", 4), order = accessor(5123, "SCALAR", 3);
  points["sparse"] = sparse(2, 5121, moved, points_at);
  order["sparse"] = sparse(2, 5121, corners_at, named);
  return bytes.file(Json::array({points, order}), true);
}

TEST(GltfSparse, ZerosWithoutABufferView) {
  Bytes bytes;
  EXPECT_EQ(corners(mesh_of(from_zeros(bytes))), (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}));
}

TEST(GltfSparse, ZerosWithoutABufferViewInAGlb) {
  Bytes bytes;
  Json json = from_zeros(bytes);
  json["buffers"][0].erase("uri");
  std::string text = json.dump(), binary = bytes.data();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  const auto word = [](std::size_t value) {
    const auto narrow = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&narrow), 4);
  };
  const std::string glb = "glTF" + word(2) + word(28 + text.size() + binary.size()) + word(text.size()) + "JSON" +
                          text + word(binary.size()) + std::string("BIN\0", 4) + binary;
  EXPECT_EQ(corners(mesh_of(glb)), (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}));
}

TEST(GltfSparse, ReplacesIndicesOfABufferView) {
  Bytes bytes;
  Json points = accessor(5126, "VEC3", 4), order = accessor(5125, "SCALAR", 3);
  points["bufferView"] = bytes.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  order["bufferView"] = bytes.add<std::uint32_t>({0, 1, 2});
  const auto at = bytes.add<std::uint32_t>({2});
  const auto named = bytes.add<std::uint32_t>({3});
  order["sparse"] = sparse(1, 5125, at, named);
  EXPECT_EQ(corners(mesh_of(bytes.file(Json::array({points, order}), true))),
            (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}));
  // What is put in is checked as what it replaces.
  Json four = bytes.file(Json::array({points, order}), true);
  four["accessors"][0]["count"] = 3;
  EXPECT_EQ(gltf_refusal(four), "test.gltf: meshes[0].primitives[0].indices[2]: expected an index below 3, got 3");
}

TEST(GltfSparse, EveryFaultIsNamed) {
  const auto with = [](const std::function<void(Json & json, Json & accessor)>& change) {
    Json json = moved_points();
    change(json, json["accessors"][0]);
    return gltf_refusal(json);
  };
  const std::string at = "test.gltf: accessors[0].";
  for (const Json& count : {Json(0), Json(4)})
    EXPECT_EQ(with([&](Json&, Json& a) { a["sparse"]["count"] = count; }),
              at + "sparse.count: expected a whole number from 1 to the 3 of accessors[0], got " + count.dump());
  EXPECT_EQ(with([](Json&, Json& a) { a["sparse"]["count"] = -1; }),
            at + "sparse.count: expected a whole number >= 0, got -1");
  // One more than 2^32 is not one.
  EXPECT_EQ(with([](Json&, Json& a) { a["sparse"]["count"] = 4294967297; }),
            at + "sparse.count: expected a whole number from 1 to the 3 of accessors[0], got 4294967297");
  EXPECT_EQ(with([](Json&, Json& a) { a["sparse"]["indices"]["componentType"] = 5126; }),
            at + "sparse.indices.componentType: expected 5121, 5123 or 5125 (unsigned byte, short or int), got 5126");
  for (const char* part : {"indices", "values"}) {
    const std::string here = at + "sparse." + part;
    EXPECT_EQ(with([&](Json&, Json& a) { a["sparse"][part]["bufferView"] = 3; }),
              here + ".bufferView: expected an index below 3, got 3");
    EXPECT_EQ(with([&](Json&, Json& a) { a["sparse"][part]["bufferView"] = -1; }),
              here + ".bufferView: expected a whole number >= 0, got -1");
    for (const Json& offset : {Json(1), Json(1000), Json(9007199254740992)})
      EXPECT_EQ(with([&](Json&, Json& a) { a["sparse"][part]["byteOffset"] = offset; }),
                at + "sparse.count: expected as many elements as its buffer view holds, got 2");
    EXPECT_EQ(with([&](Json&, Json& a) { a["sparse"][part]["byteOffset"] = -4; }),
              here + ".byteOffset: expected a whole number >= 0, got -4");
    EXPECT_NE(with([&](Json&, Json& a) { a["sparse"].erase(part); }), "loaded");
  }
  EXPECT_EQ(with([](Json& j, Json&) {
              j["bufferViews"][1]["byteLength"] = 8;
              j["bufferViews"][1]["byteStride"] = 4;
            }),
            at + "sparse.indices.bufferView: expected a buffer view without byteStride, for a sparse accessor, got 1");
  EXPECT_EQ(with([](Json& j, Json&) { j["bufferViews"][2]["byteOffset"] = 44; }),
            at + "sparse.values.bufferView: expected a range within the 64 bytes of its buffer, got 44 + 24");
  EXPECT_EQ(with([](Json&, Json& a) { a["bufferView"] = 9; }), at + "bufferView: expected an index below 3, got 9");
  EXPECT_EQ(with([](Json&, Json& a) { a["bufferView"] = nullptr; }),
            at + "bufferView: expected a whole number >= 0, got null");
  EXPECT_EQ(with([](Json&, Json& a) { a["count"] = 4; }),
            at + "count: expected as many elements as its buffer view holds, got 4");
}

TEST(GltfSparse, IndicesMustIncreaseAndBeInRange) {
  const auto with = [](std::initializer_list<std::uint16_t> where) {
    Bytes bytes;
    Json points = accessor(5126, "VEC3", 3);
    const auto indices = bytes.add<std::uint16_t>(where);
    const auto values = bytes.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    points["sparse"] = sparse(where.size(), 5123, indices, values);
    return gltf_refusal(bytes.file(Json::array({points}), false));
  };
  const std::string at = "test.gltf: accessors[0].sparse.indices";
  EXPECT_EQ(with({0, 1, 2}), "loaded");
  EXPECT_EQ(with({0, 1, 3}), at + "[2]: expected an index below 3, got 3");
  EXPECT_EQ(with({0, 65535}), at + "[1]: expected an index below 3, got 65535");
  EXPECT_EQ(with({0, 2, 1}), at + "[2]: expected an index above the one before, 2, got 1");
  EXPECT_EQ(with({0, 1, 1}), at + "[2]: expected an index above the one before, 1, got 1");
}

// A kilobyte of file may not ask for gigabytes of zeros, neither at once nor again and again.
TEST(GltfSparse, ZerosAreLimited) {
  Bytes bytes;
  Json json = from_zeros(bytes);
  json["accessors"][0]["count"] = 9007199254740992;
  EXPECT_EQ(gltf_refusal(json),
            "test.gltf: accessors[0].count: expected at most 1048576 without a buffer view (of 1048576 in a "
            "file), got 9007199254740992");
  json["accessors"][0]["count"] = 4;
  json["accessors"][1]["count"] = 1048573;
  EXPECT_EQ(gltf_refusal(json),
            "test.gltf: accessors[1].count: expected at most 1048572 without a buffer view (of 1048576 in a "
            "file), got 1048573");
  json["accessors"][1]["count"] = 1048572;
  EXPECT_EQ(gltf_refusal(json), "loaded");
  json["nodes"].push_back(json["nodes"][0]);
  json["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(gltf_refusal(json),
            "test.gltf: accessors[0].count: expected at most 0 without a buffer view (of 1048576 in a file), "
            "got 4");
  json["accessors"][1]["count"] = 300;
  EXPECT_EQ(gltf_refusal(json), "loaded");
}

}  // namespace
}  // namespace graze::io
