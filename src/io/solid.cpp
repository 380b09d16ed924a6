#include "graze/io/solid.hpp"

#include <algorithm>

#include "graze/broad_phase.hpp"
#include "graze/query.hpp"
#include "io/scene_world.hpp"

namespace graze::io {

namespace {

struct Filled {
  Shaped shape;
  std::size_t filled = 0, open = 0;  ///< meshes that became solid, and that cannot
};

/// A shape with its closed meshes solid.
Filled filled(const Shaped& shape) {
  if (const auto* mesh = shape.as<Mesh<double>>()) {
    if (!mesh->closed()) return {shape, 0, 1};
    if (mesh->solid()) return {shape};
    return {Mesh<double>({mesh->points().begin(), mesh->points().end()},
                         {mesh->triangles().begin(), mesh->triangles().end()}, mesh->sides(), true),
            1, 0};
  }
  const auto* compound = shape.as<Compound<double>>();
  if (!compound) return {shape};
  Filled all{shape};
  std::vector<Placed<double>> children(compound->children().begin(), compound->children().end());
  for (Placed<double>& child : children) {
    Filled inner = filled(child.shape);
    child.shape = std::move(inner.shape);
    all.filled += inner.filled;
    all.open += inner.open;
  }
  if (all.filled != 0) all.shape = Compound<double>(std::move(children));
  return all;
}

/// Whether two colliders are compared, as `collide` defines it.
bool compared(const Scene& scene, const Collider& a, const Collider& b, bool moves) {
  const auto fixed = [&](const Collider& c) { return scene.bodies[c.body].type == MotionType::fixed; };
  return a.body != b.body && may_collide(a.filter, b.filter) && !(moves && fixed(a) && fixed(b));
}

}  // namespace

void make_solid(Scene& scene) {
  for (Collider& c : scene.colliders) {
    Filled solid = filled(c.shape);
    if (solid.filled != 0) c.shape = std::move(solid.shape);
    if (solid.open != 0) scene.notices.push_back(c.name + ": a mesh that is not closed stays a surface");
  }
}

std::vector<std::string> unseen_inside(const Scene& scene) {
  std::vector<std::string> sentences;
  const bool moves = moves_by_itself(scene);
  const auto tree = make_dynamic_tree<double>();
  bool built = false;
  for (std::uint32_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& outer = scene.colliders[i];
    const Filled solid = filled(outer.shape);
    if (solid.filled == 0) continue;
    for (std::uint32_t k = 0; !built && k < scene.colliders.size(); ++k)
      tree->insert(k, bounds(scene.colliders[k].shape, scene.colliders[k].pose));
    built = true;
    std::vector<std::uint32_t> near;
    tree->query(bounds(outer.shape, outer.pose), near);
    std::sort(near.begin(), near.end());
    for (const std::uint32_t k : near) {
      const Collider& inner = scene.colliders[k];
      if (compared(scene, outer, inner, moves) && !overlap(outer.shape, outer.pose, inner.shape, inner.pose) &&
          overlap(solid.shape, outer.pose, inner.shape, inner.pose))
        sentences.push_back(inner.name + " lies wholly inside " + outer.name +
                            ", a closed mesh that is a surface: they do not touch (--solid fills it)");
    }
  }
  return sentences;
}

}  // namespace graze::io
