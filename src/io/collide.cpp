#include "graze/io/collide.hpp"

#include <algorithm>

#include "graze/pairs.hpp"
#include "graze/query.hpp"
#include "io/convert.hpp"

namespace graze::io {

namespace {

template <class T>
struct Prepared {
  std::vector<Shape<T>> shapes;
  std::vector<Pose<T>> poses;
};

template <class T>
Prepared<T> prepare(const Scene& scene) {
  Prepared<T> out;
  for (const Collider& c : scene.colliders) {
    if constexpr (std::is_same_v<T, double>)
      out.shapes.push_back(c.shape);
    else
      out.shapes.push_back(to_single(c.shape));
    out.poses.push_back(cast<T>(c.pose));
  }
  return out;
}

bool movable(const Scene& scene, std::uint32_t collider) {
  return scene.bodies[scene.colliders[collider].body].type != MotionType::fixed;
}

/// The allowed pairs of colliders whose bounds, grown by half the margin each, overlap.
template <class T>
std::vector<IdPair> candidates(const Scene& scene, const Prepared<T>& prepared, T margin) {
  std::vector<Aabb<T>> boxes;
  std::vector<Filter> filters;
  for (std::size_t i = 0; i < scene.colliders.size(); ++i) {
    boxes.push_back(inflated(bounds(prepared.shapes[i], prepared.poses[i]), margin / T(2)));
    filters.push_back(scene.colliders[i].filter);
  }
  const bool moves =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& b) { return b.type != MotionType::fixed; });
  const auto allowed = [&](std::uint32_t a, std::uint32_t b) {
    return scene.colliders[a].body != scene.colliders[b].body && (!moves || movable(scene, a) || movable(scene, b));
  };
  return allowed_pairs<T>(boxes, filters, allowed);
}

template <class T>
Manifold<double> in_double(const Manifold<T>& m) {
  Manifold<double> out;
  out.normal = cast<double>(m.normal);
  out.piece_a = m.piece_a;
  out.piece_b = m.piece_b;
  for (const ContactPoint<T>& p : m.points)
    out.points.push_back({cast<double>(p.a), cast<double>(p.b), static_cast<double>(p.distance), p.feature,
                          static_cast<double>(p.weight)});
  return out;
}

template <class T>
std::vector<TouchingPair> collide_in(const Scene& scene, const CollideOptions& options) {
  const Prepared<T> prepared = prepare<T>(scene);
  const T margin = static_cast<T>(options.margin);
  const std::vector<IdPair> pairs = candidates(scene, prepared, margin);
  std::vector<TouchingPair> touching;
  Manifolds<T> manifolds;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [a, b] = pairs[i];
    if (options.progress) options.progress(i, pairs.size());
    manifolds.clear();
    const bool touch =
        contacts(prepared.shapes[a], prepared.poses[a], prepared.shapes[b], prepared.poses[b], margin, manifolds);
    if (manifolds.empty() && !touch) continue;
    TouchingPair pair{a, b, touch, scene.colliders[a].trigger || scene.colliders[b].trigger, {}};
    for (const Manifold<T>& m : manifolds) pair.manifolds.push_back(in_double(m));
    touching.push_back(std::move(pair));
  }
  if (options.progress) options.progress(pairs.size(), pairs.size());
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
