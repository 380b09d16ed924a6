#include "graze/io/scene.hpp"

#include <algorithm>

#include "graze/io/file.hpp"
#include "graze/io/tiles.hpp"
#include "io/mesh_collider.hpp"
#include "io/mesh_file.hpp"
#include "io/scene_file.hpp"

namespace graze::io {

namespace {

Scene load_mesh(const std::string& bytes, const std::filesystem::path& file, const LoadOptions& options) {
  const std::string name = file.stem().string();
  Scene scene;
  scene.source = file.filename().string();
  try {
    const Shaped shape = mesh_collider(read_mesh_file(bytes, ending_of(file)), options.mesh_colliders);
    scene.bodies.push_back({name, -1, MotionType::fixed, {}});
    scene.colliders.push_back({name, -1, 0, shape, {}, {}, false, {}});
  } catch (const InvalidValue& e) {
    throw InvalidValue(e.path().empty() ? scene.source : scene.source + ": " + e.path(), e.expectation(), e.found());
  }
  return scene;
}

/// The bits of `mask` moved to the places that `append` gives the systems of another scene.
std::uint64_t moved_bits(std::uint64_t mask, const std::vector<std::size_t>& place) {
  constexpr std::uint64_t named = ~(std::uint64_t{1} << 63);
  // A mask that leaves some systems out, and so holds all bits above them, goes on holding all others.
  const bool complement = (mask & named) >> place.size() != 0;
  std::uint64_t bits = complement ? ~std::uint64_t{0} : mask & ~named;
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::uint64_t bit = std::uint64_t{1} << place[i];
    const bool set = ((mask >> i) & 1) != 0;
    if (complement && !set) bits &= ~bit;
    if (!complement && set) bits |= bit;
  }
  return bits;
}

}  // namespace

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in = open_file(file);
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed)) throw InvalidValue(file.string(), "", "not a regular file");
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  if (!in && !in.eof()) throw InvalidValue(file.string(), "", "cannot be read to its end");
  return bytes;
}

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending.empty() ? ending : ending.substr(1);
}

Scene load_whole(const std::filesystem::path& file, const LoadOptions& options) {
  const std::string ending = ending_of(file);
  const std::string bytes = read_file(file);
  if (ending == "glb" || ending == "gltf")
    return load_gltf_from(bytes, file.filename().string(), file.has_parent_path() ? file.parent_path() : ".", options);
  if (ending == "obj" || ending == "stl" || ending == "ply") return load_mesh(bytes, file, options);
  throw InvalidValue(file.string(),
                     "a file that ends in .gltf, .glb, .obj, .stl or .ply, or of the plane in .svg or .json",
                     "\"." + ending + "\"");
}

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options) {
  const std::vector<ScenePart> parts = scene_parts(file);
  Scene scene = load_part(parts[0], options);
  const std::string source = scene.source;
  for (std::size_t i = 1; i < parts.size(); ++i) append(scene, load_part(parts[i], options));
  scene.source = source;
  return scene;
}

void append(Scene& scene, Scene other) {
  std::vector<std::size_t> place;
  for (const std::string& name : other.collision_systems) {
    auto& names = scene.collision_systems;
    const auto found = std::find(names.begin(), names.end(), name);
    place.push_back(static_cast<std::size_t>(found - names.begin()));
    if (place.back() >= 63) throw InvalidValue(other.source, "at most 63 collision systems in all", "more");
    if (found == names.end()) names.push_back(name);
  }
  const auto first_body = static_cast<std::uint32_t>(scene.bodies.size());
  const auto first_collider = static_cast<std::uint32_t>(scene.colliders.size());
  for (Animation& animation : other.animations) {
    animation.first_collider += first_collider;
    animation.first_body += first_body;
    scene.animations.push_back(std::move(animation));
  }
  for (Body& body : other.bodies) scene.bodies.push_back(std::move(body));
  for (Collider& collider : other.colliders) {
    collider.body += first_body;
    collider.filter.category = moved_bits(collider.filter.category, place);
    collider.filter.mask = moved_bits(collider.filter.mask, place);
    scene.colliders.push_back(std::move(collider));
  }
  for (Joint& joint : other.joints) {
    if (joint.body_a) *joint.body_a += first_body;
    if (joint.body_b) *joint.body_b += first_body;
    scene.joints.push_back(std::move(joint));
  }
  for (std::string& text : other.notices) scene.notices.push_back(std::move(text));
  if (!scene.source.empty()) scene.source += " + ";
  scene.source += other.source;
}

}  // namespace graze::io
