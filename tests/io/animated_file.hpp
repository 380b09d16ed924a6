// Animated glTF files for tests: a scene as JSON, and accessors of floats that are added to it.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "gltf_text.hpp"

namespace graze::io {

/// A box of size 1 at the origin and a ball of radius 0.5, its node at (-3, 0, 0); neither can move by itself.
class AnimatedFile {
 public:
  using Json = nlohmann::json;

  AnimatedFile() {
    json = Json::parse(R"({
      "asset": {"version": "2.0"},
      "extensions": {"KHR_implicit_shapes": {"shapes": [{"type": "box", "box": {"size": [1, 1, 1]}},
                                                        {"type": "sphere", "sphere": {"radius": 0.5}}]}},
      "scenes": [{"nodes": [0, 1]}],
      "nodes": [
        {"name": "box", "extensions": {"KHR_physics_rigid_bodies": {"collider": {"geometry": {"shape": 0}}}}},
        {"name": "ball", "translation": [-3, 0, 0],
         "extensions": {"KHR_physics_rigid_bodies": {"collider": {"geometry": {"shape": 1}}}}}]})");
  }

  /// The index of a new accessor.
  std::size_t add(const char* type, std::size_t width, const std::vector<float>& values) {
    const std::size_t offset = data_.size(), length = values.size() * sizeof(float);
    data_.resize(offset + length);
    if (length > 0) std::memcpy(data_.data() + offset, values.data(), length);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", 5126},
                                 {"type", type},
                                 {"count", values.size() / width}});
    return json["accessors"].size() - 1;
  }

  /// A channel of the animation `a`, which is made when it is not there.
  AnimatedFile& move(std::size_t node, const char* path, const std::vector<float>& times,
                     const std::vector<float>& values, const char* interpolation = "LINEAR", std::size_t a = 0) {
    const bool rotation = std::string(path) == "rotation";
    Json& animation = json["animations"][a];
    const std::size_t input = add("SCALAR", 1, times),
                      output = add(rotation ? "VEC4" : "VEC3", rotation ? 4 : 3, values);
    animation["channels"].push_back({{"sampler", animation.contains("samplers") ? animation["samplers"].size() : 0},
                                     {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
    return *this;
  }

  std::string text() const {
    Json whole = json;
    if (!data_.empty()) whole["buffers"][0] = {{"byteLength", data_.size()}, {"uri", data_uri(data_)}};
    return whole.dump();
  }
  Scene load() const { return load_gltf(text(), "test.gltf", with_animations()); }
  std::string refusal() const { return gltf_refusal(text(), with_animations()); }

  Json json;

 private:
  static LoadOptions with_animations() {
    LoadOptions options;
    options.animations = true;
    return options;
  }

  std::string data_;
};

}  // namespace graze::io
