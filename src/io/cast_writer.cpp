#include "graze/io/cast_scene.hpp"
#include "io/gltf_drawing.hpp"

namespace graze::io {

namespace {

constexpr Look path_look{"path", 0.95, 0.6, 0.1, 1}, ghost_look{"ghost", 0.95, 0.6, 0.1, 0.15},
    impact_look{"impact", 0.95, 0.6, 0.1, 0.6};

/// A turn is drawn by so many copies, a translation by a few; more would hide each other.
constexpr double copies_a_turn = 12, most_copies = 24;
constexpr int fewest_copies = 4;

int copies(const SceneCast& question, double until) {
  constexpr double turn = 6.283185307179586;
  const double turns = length(question.velocity.angular) * until / turn;
  return static_cast<int>(greatest(double{fewest_copies}, least(most_copies, turns * copies_a_turn)));
}

/// The way of the pivot as a thin rod.
void draw_path(ModelWriter& writer, const Vec3d& from, const Vec3d& to, double thickness) {
  const double way = length(to - from);
  if (!(way > 0)) return;
  const Posed middle{(from + to) * 0.5, turn_to(normalized(to - from))};
  writer.add("path", tessellate(Cylinder<double>(way, thickness, thickness), middle, {}, 0), path_look);
}

void draw_hit(ModelWriter& writer, const SceneHit& hit, double size) {
  const auto dot_mesh = writer.mesh("contact", octahedron(size / 150), contact_look);
  const auto arrow_mesh = writer.mesh("normal", arrow_up(size / 12), normal_look);
  if (!dot_mesh || !arrow_mesh) return;  // a scene without extent: nothing would be seen
  writer.place("contact", *dot_mesh, {hit.point, {}});
  writer.place("normal", *arrow_mesh, {hit.point, turn_to(hit.normal)});
}

}  // namespace

std::vector<std::string> write_cast(const std::filesystem::path& file, const Scene& scene, const SceneCast& question,
                                    const std::vector<SceneHit>& hits, const std::filesystem::path& source) {
  const bool kept = is_gltf(source);
  GltfModel model = kept ? GltfModel(source) : GltfModel();
  ModelWriter writer(model);
  const Mover mover = find_mover(scene, question);
  const Aabbd all = extent(scene);
  const double size = max_abs(all.extent()), until = hits.empty() ? question.duration : hits.front().t;

  std::set<std::uint32_t> hit;
  if (!hits.empty()) hit.insert(hits.front().other);
  draw_colliders(writer, model, scene, hit, kept);

  const int count = copies(question, until);
  for (int i = 1; i <= count && until > 0; ++i) {
    const bool last = i == count;
    const double t = last ? until : until * i / count;
    for (const std::uint32_t c : mover.colliders) {
      const Collider& collider = scene.colliders[c];
      const Posed pose = mover.pose_at(collider.pose, question.velocity, t);
      writer.add(last ? "impact" : "ghost", tessellate(collider.shape, pose, all.center(), size),
                 last ? impact_look : ghost_look);
    }
  }
  draw_path(writer, mover.pivot, mover.pivot + question.velocity.linear * until, size / 400);
  if (!hits.empty()) draw_hit(writer, hits.front(), size);
  model.save(file);
  return model.notices();
}

}  // namespace graze::io
