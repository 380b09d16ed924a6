// A scene's colliders put into a world, of space or of the plane, and the pairs that touch there.
//
// Guarantee: pairs in the order of the scene's colliders, the same for every scene of either kind; triggers have
// contacts too, so that they can be drawn.
#pragma once

#include "graze/io/collide.hpp"
#include "io/scene_world.hpp"

namespace graze::io {

/// Reports the progress of a world's update: its longest stage, the manifolds, is many tasks.
class ProgressExecutor final : public Executor {
 public:
  explicit ProgressExecutor(const std::function<void(std::size_t, std::size_t)>& progress) : progress_(progress) {}
  std::size_t concurrency() const override { return 1; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    for (std::size_t i = 0; i < count; ++i) {
      if (progress_) progress_(i, count);
      task(i);
    }
    if (progress_) progress_(count, count);
  }

 private:
  const std::function<void(std::size_t, std::size_t)>& progress_;
};

/// A vector of space or of the plane as one of space in double.
template <class Vec>
Vec3d in_space(const Vec& v) {
  if constexpr (requires { v.z; })
    return converted<double>(v);
  else
    return {double(v.x), double(v.y), 0};
}

template <class Arrays, class Found>
Manifold<double> in_double(const Arrays& contacts, const Found& m) {
  Manifold<double> out;
  out.normal = in_space(m.normal);
  out.piece_a = m.piece_a;
  out.piece_b = m.piece_b;
  for (const auto& p : contacts.points_of(m))
    out.points.push_back({in_space(p.a), in_space(p.b), double(p.distance), p.feature, double(p.weight)});
  return out;
}

/// The pairs of a scene that touch, by a world of its space.
template <class T, class Space, class AnyScene>
std::vector<TouchingPair> collide_in(const AnyScene& scene, const CollideOptions& options) {
  ProgressExecutor executor(options.progress);
  World<T, Space> world({checked_margin<T>(options.margin), {}, options.points_per_pair}, &executor);
  const bool moves = moves_by_itself(scene);
  for (const auto& c : scene.colliders)
    world.add(in_world<T>(scene, c, moves && scene.bodies[c.body].type == MotionType::fixed));
  world.update();
  std::vector<TouchingPair> touching;
  for (const auto& p : world.contacts().pairs) {
    TouchingPair pair{p.a, p.b, p.overlap, scene.colliders[p.a].trigger || scene.colliders[p.b].trigger, {}};
    const auto manifolds = world.contacts().manifolds_of(p);
    pair.manifolds.reserve(manifolds.size());
    for (const auto& m : manifolds) pair.manifolds.push_back(in_double(world.contacts(), m));
    touching.push_back(std::move(pair));
  }
  return touching;
}

}  // namespace graze::io
