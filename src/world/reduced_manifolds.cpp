// The points of a pair that may have no more than so many. The others are dropped before anything is carried over,
// since impulses are carried over point by point.
#include "composite/composite.hpp"
#include "graze/plane/space.hpp"
#include "graze/world/manifolds.hpp"

namespace graze {

/// Keeps as many of the points from `first_point` on, all of one manifold, as a pair may have; returns that number.
template <class T, class Space>
std::size_t ManifoldFinder<T, Space>::reduce_one(Found& found, const Vec& normal, std::size_t first_point) const {
  const std::span<SolverPoint<T, Space>> points = found.points.filled().subspan(first_point);
  found.choice.clear();
  for (const SolverPoint<T, Space>& p : points) found.choice.add(p, normal, 0);
  found.choice.choose(points_per_pair_);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (found.choice.kept(i)) points[kept++] = points[i];
  found.points.shorten(first_point + kept);
  return kept;
}

/// Keeps as many points of all manifolds of a pair, from these places on, as it may have, and no empty manifold.
template <class T, class Space>
void ManifoldFinder<T, Space>::reduce_many(Found& found, std::size_t first_manifold, std::size_t first_point) const {
  const std::span<ContactManifold<T, Space>> manifolds = found.manifolds.filled().subspan(first_manifold);
  const std::span<SolverPoint<T, Space>> points = found.points.filled();
  found.choice.clear();
  for (const ContactManifold<T, Space>& m : manifolds)
    for (const SolverPoint<T, Space>& p : points.subspan(m.first_point, m.point_count))
      found.choice.add(p, m.normal, m.first_point);
  found.choice.choose(points_per_pair_);
  std::size_t kept_manifolds = 0, kept = first_point, tried = 0;
  for (ContactManifold<T, Space> m : manifolds) {
    const std::size_t first = kept;
    for (const SolverPoint<T, Space>& p : points.subspan(m.first_point, m.point_count))
      if (found.choice.kept(tried++)) points[kept++] = p;
    if (kept == first) continue;
    m.first_point = static_cast<std::uint32_t>(first);
    m.point_count = static_cast<std::uint32_t>(kept - first);
    manifolds[kept_manifolds++] = m;
  }
  found.manifolds.shorten(first_manifold + kept_manifolds);
  found.points.shorten(kept);
}

template class ManifoldFinder<float>;
template class ManifoldFinder<double>;
template class ManifoldFinder<float, plane::Space<float>>;
template class ManifoldFinder<double, plane::Space<double>>;

}  // namespace graze
