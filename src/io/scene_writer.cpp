#include "graze/io/scene_writer.hpp"

#include <algorithm>
#include <optional>

#include "io/gltf_drawing.hpp"

namespace graze::io {

namespace {

/// The colliders to tint: those that touch and can move, or, where nothing can, all that touch. Else every floor would
/// be tinted at all times.
std::set<std::uint32_t> touching_colliders(const Scene& scene, const std::vector<TouchingPair>& pairs) {
  const auto fixed = [](const Body& body) { return body.type == MotionType::fixed; };
  const bool still = std::all_of(scene.bodies.begin(), scene.bodies.end(), fixed);
  std::set<std::uint32_t> touching;
  for (const TouchingPair& p : pairs)
    for (const std::uint32_t i : {p.a, p.b})
      if (p.overlap && !p.trigger && (still || !fixed(scene.bodies[scene.colliders[i].body]))) touching.insert(i);
  return touching;
}

void draw_contacts(ModelWriter& writer, const std::vector<TouchingPair>& pairs, double size) {
  std::optional<std::size_t> dot_mesh, arrow_mesh;
  for (const TouchingPair& pair : pairs)
    for (const auto& m : pair.manifolds) {
      if (!dot_mesh) dot_mesh = writer.mesh("contact", octahedron(size / 150), contact_look);
      if (!arrow_mesh) arrow_mesh = writer.mesh("normal", arrow_up(size / 12), normal_look);
      if (!dot_mesh || !arrow_mesh) return;  // a scene without extent: nothing would be seen
      Vec3d middle;
      for (const auto& p : m.points) {
        middle += p.position() / static_cast<double>(m.points.size());
        writer.place("contact", *dot_mesh, {p.position(), {}});
      }
      writer.place("normal", *arrow_mesh, {middle, turn_to(m.normal)});
    }
}

}  // namespace

std::vector<std::string> write_contacts(const std::filesystem::path& file, const Scene& scene,
                                        const std::vector<TouchingPair>& pairs, const std::filesystem::path& source) {
  const bool kept = is_gltf(source);
  GltfModel model = kept ? GltfModel(source) : GltfModel();
  ModelWriter writer(model);
  draw_colliders(writer, model, scene, touching_colliders(scene, pairs), kept);
  draw_contacts(writer, pairs, max_abs(extent(scene).extent()));
  model.save(file);
  return model.notices();
}

}  // namespace graze::io
