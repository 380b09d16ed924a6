#include "graze/io/collide.hpp"

#include <algorithm>

#include "io/scene_collide.hpp"

namespace graze::io {

namespace {

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

std::size_t count_in_contact(const std::vector<TouchingPair>& pairs) {
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [](const TouchingPair& pair) { return pair.in_contact(); }));
}

std::vector<TouchingPair> collide(const Scene& scene, const CollideOptions& options) {
  return options.precision == Precision::double_precision ? collide_in<double, Space<double>>(scene, options)
                                                          : collide_in<float, Space<float>>(scene, options);
}

}  // namespace graze::io
