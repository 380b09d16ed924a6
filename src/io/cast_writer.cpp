#include "draw/motion_copies.hpp"
#include "graze/io/cast_scene.hpp"
#include "io/gltf_drawing.hpp"

namespace graze::io {

std::vector<std::string> write_cast(const std::filesystem::path& file, const Scene& scene, const SceneCast& question,
                                    const std::vector<SceneHit>& hits, const std::filesystem::path& source) {
  const bool kept = is_gltf(source);
  GltfModel model = kept ? GltfModel(source) : GltfModel();
  ModelWriter writer(model);
  const Mover mover = find_mover(scene, question);
  const Aabbd all = extent(scene);
  GltfDraw canvas(writer, {all.center(), max_abs(all.extent())}, kept);
  const double until = hits.empty() ? question.duration : hits.front().t;

  std::set<std::uint32_t> hit;
  if (!hits.empty()) hit.insert(hits.front().other);
  draw_colliders(canvas, model, scene, hit, kept);

  const int count = draw_detail::motion_copies(length(question.velocity.angular), until);
  for (int i = 1; i <= count && until > 0; ++i) {
    const bool last = i == count;
    const double t = last ? until : until * i / count;
    for (const std::uint32_t c : mover.colliders) {
      const Collider& collider = scene.colliders[c];
      const Posed pose = mover.pose_at(collider.pose, question.velocity, t);
      canvas.polygons(tessellate(collider.shape, pose, canvas.area().center, canvas.area().size), DrawLayer::casts,
                      last ? DrawMeaning::touching : DrawMeaning::ghost);
    }
  }
  canvas.line(mover.pivot, mover.pivot + question.velocity.linear * until, DrawLayer::casts, DrawMeaning::path);
  if (!hits.empty()) {
    canvas.point(hits.front().point, DrawLayer::casts, DrawMeaning::contact);
    canvas.arrow(hits.front().point, hits.front().normal, DrawLayer::casts, DrawMeaning::normal);
  }
  model.save(file);
  return model.notices();
}

}  // namespace graze::io
