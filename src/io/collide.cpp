#include "graze/io/collide.hpp"

#include <algorithm>

#include "io/scene_world.hpp"

namespace graze::io {

namespace {

/// Tells how far a world's update is: its longest stage, the manifolds, is many tasks.
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

template <class T>
Manifold<double> in_double(const ContactArrays<T>& contacts, const ContactManifold<T>& m) {
  Manifold<double> out;
  out.normal = converted<double>(m.normal);
  out.piece_a = m.piece_a;
  out.piece_b = m.piece_b;
  for (const SolverPoint<T>& p : contacts.points_of(m))
    out.points.push_back({converted<double>(p.a), converted<double>(p.b), static_cast<double>(p.distance), p.feature,
                          static_cast<double>(p.weight)});
  return out;
}

/// Triggers are asked for contacts too, so that they can be drawn.
template <class T>
std::vector<TouchingPair> collide_in(const Scene& scene, const CollideOptions& options) {
  ProgressExecutor executor(options.progress);
  World<T> world({checked_margin<T>(options.margin), {}, options.points_per_pair}, &executor);
  const bool moves = moves_by_itself(scene);
  for (const Collider& c : scene.colliders)
    world.add(in_world<T>(scene, c, moves && scene.bodies[c.body].type == MotionType::fixed));
  world.update();
  std::vector<TouchingPair> touching;
  for (const ContactPair<T>& p : world.contacts().pairs) {
    TouchingPair pair{p.a, p.b, p.overlap, scene.colliders[p.a].trigger || scene.colliders[p.b].trigger, {}};
    const auto manifolds = world.contacts().manifolds_of(p);
    pair.manifolds.reserve(manifolds.size());
    for (const ContactManifold<T>& m : manifolds) pair.manifolds.push_back(in_double(world.contacts(), m));
    touching.push_back(std::move(pair));
  }
  return touching;
}

/// The manifold with the deepest point, and that point's distance.
std::pair<const Manifold<double>*, double> deepest(const Manifolds<double>& manifolds) {
  const Manifold<double>* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Manifold<double>& m : manifolds)
    for (const ContactPoint<double>& p : m.points)
      if (p.distance < least) {
        least = p.distance;
        best = &m;
      }
  return {best, least};
}

}  // namespace

double TouchingPair::distance() const { return deepest(manifolds).second; }

Vec3d TouchingPair::normal() const {
  const Manifold<double>* m = deepest(manifolds).first;
  return m ? m->normal : Vec3d{};
}

std::size_t TouchingPair::point_count() const {
  std::size_t count = 0;
  for (const Manifold<double>& m : manifolds) count += m.points.size();
  return count;
}

std::vector<TouchingPair> collide(const Scene& scene, const CollideOptions& options) {
  return options.precision == Precision::double_precision ? collide_in<double>(scene, options)
                                                          : collide_in<float>(scene, options);
}

}  // namespace graze::io
