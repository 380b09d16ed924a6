#include "graze/io/tiles.hpp"

#include "io/gltf_document.hpp"
#include "io/scene_file.hpp"

namespace graze::io {

namespace {

constexpr const char* tile_key = "grazeTile";

std::optional<JsonValue> tile_name(const JsonValue& node) {
  const auto extras = node.find("extras");
  return extras ? extras->find(tile_key) : std::nullopt;
}

Quatd rotation_of(const JsonValue& json) {
  const auto parts = json.elements(4);
  const Quatd turn{parts[0].number<double>(), parts[1].number<double>(), parts[2].number<double>(),
                   parts[3].number<double>()};
  const double length = turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w;
  if (!(length > 0.5 && length < 2)) json.fail("a unit quaternion");
  return normalized(turn);
}

/// The tile that a node references. Its file stands below the folder of the scene.
ScenePart tile_of(const JsonValue& node, const JsonValue& name, const std::filesystem::path& folder) {
  for (const char* key : {"matrix", "scale", "children"})
    if (node.has(key)) throw InvalidValue(node.path(), "a tile without " + std::string(key), "one with it");
  const std::filesystem::path file = std::filesystem::path(name.string()).lexically_normal();
  if (file.empty() || file.is_absolute() || *file.begin() == "..") name.fail("a file below the folder of the scene");
  ScenePart tile{folder / file, {}, true};
  if (const auto at = node.find("translation")) tile.pose.translation = at->vector<double>();
  if (const auto turn = node.find("rotation")) tile.pose.rotation = rotation_of(*turn);
  return tile;
}

std::vector<ScenePart> tiles_of(const std::string& bytes, const std::filesystem::path& folder) {
  // Most scenes have none, and are read only once.
  if (bytes.find(tile_key) == std::string::npos) return {};
  const GltfDocument document(bytes, "");
  const JsonValue root(document.json(), "");
  const auto nodes = root.find("nodes");
  if (!nodes) return {};
  std::vector<ScenePart> tiles;
  for (const JsonValue& node : nodes->elements())
    if (const auto name = tile_name(node)) tiles.push_back(tile_of(node, *name, folder));
  for (const JsonValue& node : nodes->elements())
    if (const auto children = node.find("children"))
      for (const JsonValue& child : children->elements())
        if (tile_name(nodes->elements()[child.index_below(nodes->elements().size())]))
          child.fail("a node that is no tile, which has no parent");
  return tiles;
}

/// Moves all of a scene by a pose.
void place(Scene& scene, const Posed& pose) {
  for (Body& body : scene.bodies) {
    body.pose = compose(pose, body.pose);
    if (!body.motion) continue;
    body.motion->linear_velocity = rotate(pose.rotation, body.motion->linear_velocity);
    body.motion->angular_velocity = rotate(pose.rotation, body.motion->angular_velocity);
  }
  for (Collider& collider : scene.colliders) collider.pose = compose(pose, collider.pose);
  for (Joint& joint : scene.joints) {
    if (!joint.body_a) joint.frame_a = compose(pose, joint.frame_a);
    if (!joint.body_b) joint.frame_b = compose(pose, joint.frame_b);
  }
}

}  // namespace

std::vector<ScenePart> scene_parts(const std::filesystem::path& file) {
  std::vector<ScenePart> parts{{file, {}, false}};
  const std::string ending = ending_of(file);
  if (ending != "glb" && ending != "gltf") return parts;
  const std::string bytes = read_file(file);
  try {
    for (ScenePart& tile : tiles_of(bytes, file.has_parent_path() ? file.parent_path() : "."))
      parts.push_back(std::move(tile));
  } catch (const InvalidValue& e) {
    throw InvalidValue(file.filename().string() + ": " + e.path(), e.expectation(), e.found());
  }
  return parts;
}

Scene load_part(const ScenePart& part, const LoadOptions& options) {
  if (!part.tile) return load_whole(part.file, options);
  LoadOptions still = options;
  still.animations = false;
  if (scene_parts(part.file).size() > 1)
    throw InvalidValue(part.file.string(), "a tile, which references no tiles", "one that does");
  Scene scene = load_whole(part.file, still);
  if (options.animations) scene.notices.push_back(scene.source + ": animations of tiles are not played");
  place(scene, part.pose);
  return scene;
}

}  // namespace graze::io
