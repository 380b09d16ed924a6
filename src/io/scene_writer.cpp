#include "graze/io/scene_writer.hpp"

#include <algorithm>

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

}  // namespace

std::vector<std::string> write_contacts(const std::filesystem::path& file, const Scene& scene,
                                        const std::vector<TouchingPair>& pairs, const std::filesystem::path& source) {
  const bool kept = is_gltf(source);
  GltfModel model = kept ? GltfModel(source) : GltfModel();
  ModelWriter writer(model);
  const Aabbd all = extent(scene);
  GltfDraw canvas(writer, {all.center(), max_abs(all.extent())}, kept);
  draw_colliders(canvas, model, scene, touching_colliders(scene, pairs), kept);
  for (const TouchingPair& pair : pairs)
    for (const auto& manifold : pair.manifolds) draw(canvas, manifold);
  model.save(file);
  return model.notices();
}

}  // namespace graze::io
