// Scenes with physics, made by tests: nodes, shapes, materials, filters and joints as KHR_physics_rigid_bodies has
// them; and what they do when they are played.
#pragma once

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "gltf_text.hpp"
#include "graze/io/simulate.hpp"

namespace graze::io {

/// Limits of joints: no way at all, and no turn about some axes.
inline const nlohmann::json together{{"linearAxes", {0, 1, 2}}, {"min", 0}, {"max", 0}};
inline nlohmann::json straight(const std::vector<int>& axes) { return {{"angularAxes", axes}, {"min", 0}, {"max", 0}}; }
/// The physics of a node with an index added to its collider: of a material, or of a filter.
inline nlohmann::json with(nlohmann::json physics, const char* key, std::size_t index) {
  physics["collider"][key] = index;
  return physics;
}

class PhysicsScene {
 public:
  using Json = nlohmann::json;

  std::size_t shape(const Json& json) { return push(json_["extensions"]["KHR_implicit_shapes"]["shapes"], json); }
  std::size_t box(double x, double y, double z) { return shape({{"type", "box"}, {"box", {{"size", {x, y, z}}}}}); }
  std::size_t ball(double radius) { return shape({{"type", "sphere"}, {"sphere", {{"radius", radius}}}}); }
  std::size_t material(const Json& json) { return push(physics()["physicsMaterials"], json); }
  std::size_t filter(const Json& json) { return push(physics()["collisionFilters"], json); }
  std::size_t joint(const Json& json) { return push(physics()["physicsJoints"], json); }

  /// A mesh of triangles; its collider's geometry names it.
  std::size_t mesh(const std::vector<float>& points, const std::vector<std::uint32_t>& corners) {
    const std::size_t position = accessor("VEC3", 5126, points.size() / 3, points.data(), points.size() * 4);
    const std::size_t indices = accessor("SCALAR", 5125, corners.size(), corners.data(), corners.size() * 4);
    return push(json_["meshes"], {{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", indices}}}}});
  }

  /// A node with physics; `translation` of three numbers, `rotation` of four or none.
  std::size_t node(const std::string& name, const Json& physics, const Vec3d& at = {}, const Quatd& turn = {}) {
    Json node{{"name", name}, {"translation", {at.x, at.y, at.z}}, {"rotation", {turn.x, turn.y, turn.z, turn.w}}};
    if (!physics.is_null()) node["extensions"]["KHR_physics_rigid_bodies"] = physics;
    return push(json_["nodes"], node);
  }
  void put_below(std::size_t parent, std::size_t child) { json_["nodes"][parent]["children"].push_back(child); }
  Json& at(std::size_t node) { return json_["nodes"][node]; }

  /// A translation, or a scale, by linear interpolation, of a node.
  void animate(std::size_t node, const std::vector<float>& times, const std::vector<float>& places,
               const char* path = "translation") {
    Json& animation = json_["animations"][0];
    const std::size_t input = accessor("SCALAR", 5126, times.size(), times.data(), times.size() * 4);
    const std::size_t output = accessor("VEC3", 5126, places.size() / 3, places.data(), places.size() * 4);
    animation["channels"].push_back({{"sampler", animation.contains("samplers") ? animation["samplers"].size() : 0},
                                     {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", input}, {"output", output}});
  }

  std::string text() const {
    Json whole = json_;
    whole["scenes"][0]["nodes"] = roots();
    whole["scene"] = 0;
    whole["extensionsUsed"] = {"KHR_implicit_shapes", "KHR_physics_rigid_bodies"};
    if (!data_.empty()) whole["buffers"][0] = {{"byteLength", data_.size()}, {"uri", data_uri(data_)}};
    return whole.dump();
  }
  Scene load() const {
    LoadOptions options;
    options.animations = options.physics_only = true;
    return load_gltf(text(), "scene.gltf", options);
  }

 private:
  /// The nodes that are nobody's child.
  Json roots() const {
    std::vector<bool> child(json_["nodes"].size());
    for (const Json& node : json_["nodes"])
      if (node.contains("children"))
        for (const Json& below : node["children"]) child[below.get<std::size_t>()] = true;
    Json found = Json::array();
    for (std::size_t i = 0; i < child.size(); ++i)
      if (!child[i]) found.push_back(i);
    return found;
  }
  static std::size_t push(Json& list, const Json& json) {
    list.push_back(json);
    return list.size() - 1;
  }
  Json& physics() { return json_["extensions"]["KHR_physics_rigid_bodies"]; }

  std::size_t accessor(const char* type, int component, std::size_t count, const void* values, std::size_t bytes) {
    const std::size_t offset = data_.size();
    data_.append(static_cast<const char*>(values), bytes);
    const std::size_t view = push(json_["bufferViews"], {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}});
    return push(json_["accessors"],
                {{"bufferView", view}, {"componentType", component}, {"type", type}, {"count", count}});
  }

  Json json_{{"asset", {{"version", "2.0"}}}};
  std::string data_;
};

/// A scene played, all of its frames.
struct Played {
  explicit Played(const PhysicsScene& made, double seconds = 10, const SimulateOptions& how = {}) : scene(made.load()) {
    SimulateOptions options = how;
    options.seconds = seconds;
    moving = moving_bodies(scene);
    summary = simulate(scene, options, [&](const SimulationFrame& frame) { frames.push_back(frame); });
  }

  std::size_t index(const std::string& name) const {
    for (std::size_t i = 0; i < moving.size(); ++i)
      if (scene.bodies[moving[i]].name == name) return i;
    throw std::logic_error("no body " + name);
  }
  const BodyState& at(const std::string& name, double time) const {
    return frames.at(static_cast<std::size_t>(std::lround(time * 60))).bodies[index(name)];
  }
  Vec3d place(const std::string& name, double time) const { return at(name, time).pose.translation; }
  const BodyState& end(const std::string& name) const { return frames.back().bodies[index(name)]; }

  Scene scene;
  std::vector<std::uint32_t> moving;
  std::vector<SimulationFrame> frames;
  SimulateSummary summary;
};

}  // namespace graze::io
