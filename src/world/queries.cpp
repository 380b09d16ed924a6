// The queries of a world: down its tree, and then at each body that is left.
#include <algorithm>

#include "composite/sweep.hpp"
#include "graze/plane/world.hpp"
#include "shape/hierarchy.hpp"

namespace graze {

namespace {

template <class T>
constexpr T infinity = std::numeric_limits<T>::infinity();

}  // namespace

/// The tree, which the first query after a change brings up to date.
template <class T, class Space>
const DynamicTree<T>& World<T, Space>::tree() const {
  const std::uint64_t revision = bodies_.revision();
  if (tree_revision_.load(std::memory_order_acquire) != revision) {
    const std::scoped_lock lock(mutex_);
    if (tree_revision_.load(std::memory_order_relaxed) != revision) {
      const std::span<const std::uint32_t> changes = bodies_.unsorted_changes();
      boxes_.resize(bodies_.size());
      SerialExecutor serial;
      find_bounds<T, Space>(bodies_.shapes(), bodies_.poses(), bodies_.margins(), changes, boxes_, serial);
      candidates_.tree(boxes_, bodies_.alive(), changes);
      tree_revision_.store(revision, std::memory_order_release);
    }
  }
  return candidates_.tree();
}

template <class T, class Space>
bool World<T, Space>::is_asked(const QueryFilter& filter, std::uint32_t index) const {
  return (filter.triggers || bodies_.triggers()[index] == 0) && may_collide(filter.filter, bodies_.filters()[index]) &&
         (!filter.accept || filter.accept(bodies_.id(index)));
}

template <class T, class Space>
void World<T, Space>::overlapping(const Shape& shape, const Pose& pose, const QueryFilter& filter,
                                  std::vector<BodyId>& out) const {
  const std::size_t first = out.size();
  tree().overlapping(Space::bounds(shape, pose), [&](std::uint32_t i, const Aabb<T>&) {
    if (is_asked(filter, i) && overlap(shape, pose, bodies_.shapes()[i], bodies_.poses()[i]))
      out.push_back(bodies_.id(i));
  });
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
}

template <class T, class Space>
bool World<T, Space>::overlaps_any(const Shape& shape, const Pose& pose, const QueryFilter& filter) const {
  bool found = false;
  tree().nearest(Space::bounds(shape, pose), T(0), [&](std::uint32_t i, const Aabb<T>&) {
    found = found || (is_asked(filter, i) && overlap(shape, pose, bodies_.shapes()[i], bodies_.poses()[i]));
    return found ? T(-1) : T(0);
  });
  return found;
}

template <class T, class Space>
void World<T, Space>::nearest(const Shape& shape, const Pose& pose, std::size_t count, T limit,
                              const QueryFilter& filter, std::vector<BodyDistance<T, Space>>& out) const {
  if (count == 0 || !(limit >= T(0))) return;
  std::vector<BodyDistance<T, Space>> found;  // sorted, and never longer than asked for
  const auto before = [](const BodyDistance<T, Space>& p, const BodyDistance<T, Space>& q) {
    return p.distance.distance != q.distance.distance ? p.distance.distance < q.distance.distance : p.body < q.body;
  };
  tree().nearest(Space::bounds(shape, pose), limit, [&](std::uint32_t i, const Aabb<T>&) {
    const auto furthest = [&] { return found.size() < count ? limit : found.back().distance.distance; };
    if (!is_asked(filter, i)) return greatest(furthest(), T(0));
    BodyDistance<T, Space> candidate{bodies_.id(i), distance(shape, pose, bodies_.shapes()[i], bodies_.poses()[i])};
    // Half-spaces that overlap without a depth are nearer than anything.
    if (candidate.distance.status == Status::unbounded) candidate.distance.distance = -infinity<T>;
    if (candidate.distance.distance <= furthest()) {
      found.insert(std::upper_bound(found.begin(), found.end(), candidate, before), candidate);
      if (found.size() > count) found.pop_back();
    }
    // Bodies that overlap are ordered by their depth, for which their boxes give no bound.
    return greatest(furthest(), T(0));
  });
  out.insert(out.end(), found.begin(), found.end());
}

template <class T, class Space>
std::optional<BodyDistance<T, Space>> World<T, Space>::closest(const Shape& shape, const Pose& pose, T limit,
                                                               const QueryFilter& filter) const {
  std::vector<BodyDistance<T, Space>> one;
  nearest(shape, pose, 1, limit, filter, one);
  return one.empty() ? std::nullopt : std::optional(one.front());
}

/// Calls `f(hit)` for the bodies that the ray hits; `f` returns the length to which it still has to be followed, less
/// than zero for no further.
template <class T, class Space>
template <class F>
void World<T, Space>::each_hit(const Ray& ray, T length, const QueryFilter& filter, BackFaces back, F&& f) const {
  const Vec3d direction = normalized(converted<double>(Space::among_boxes(ray.direction)), Vec3d{});
  // A hit is known up to the rounding of the ray, which the boxes' own margin need not cover.
  const double slack =
      16 * static_cast<double>(std::numeric_limits<T>::epsilon()) * max_abs(converted<double>(ray.origin));
  const NodeRay<T> seen(Space::among_boxes(ray.origin), direction, slack);
  const auto entries = [&](const WideNode<T>& node, std::array<T, WideNode<T>::width>& out) {
    node.entries(seen, out);
  };
  // The limit is finite, so that boxes that the ray misses are left out.
  const auto limit = [&](T end) { return least(end + static_cast<T>(2 * slack), std::numeric_limits<T>::max()); };
  T end = length;
  tree().in_order(entries, limit(end), [&](std::uint32_t i, const Aabb<T>&) {
    if (is_asked(filter, i))
      if (const auto hit = Space::raycast(bodies_.shapes()[i], bodies_.poses()[i], ray, end, back))
        end = f(BodyRayHit<T, Space>{bodies_.id(i), *hit});
    return end < T(0) ? end : limit(end);
  });
}

namespace {

/// The order of two hits of rays or of casts.
template <class Hit>
bool before(const Hit& p, const Hit& q) {
  return p.hit.t != q.hit.t ? p.hit.t < q.hit.t : p.body < q.body;
}

/// Sorts the hits that were appended from `first` on.
template <class Hit>
void sort_hits(std::vector<Hit>& hits, std::size_t first) {
  std::sort(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), before<Hit>);
}

}  // namespace

template <class T, class Space>
std::optional<BodyRayHit<T, Space>> World<T, Space>::raycast(const Ray& ray, T length, const QueryFilter& filter,
                                                             BackFaces back) const {
  std::optional<BodyRayHit<T, Space>> first;
  each_hit(ray, length, filter, back, [&](const BodyRayHit<T, Space>& hit) {
    if (!first || before(hit, *first)) first = hit;
    return first->hit.t;
  });
  return first;
}

template <class T, class Space>
bool World<T, Space>::raycast_any(const Ray& ray, T length, const QueryFilter& filter, BackFaces back) const {
  bool found = false;
  each_hit(ray, length, filter, back, [&](const BodyRayHit<T, Space>&) {
    found = true;
    return T(-1);
  });
  return found;
}

template <class T, class Space>
void World<T, Space>::raycast_all(const Ray& ray, T length, const QueryFilter& filter,
                                  std::vector<BodyRayHit<T, Space>>& out, BackFaces back) const {
  const std::size_t first = out.size();
  each_hit(ray, length, filter, back, [&](const BodyRayHit<T, Space>& hit) {
    out.push_back(hit);
    return length;
  });
  sort_hits(out, first);
}

/// Calls `f(hit)` for the bodies that the shape meets; `f` returns the time until which the rest matters.
template <class T, class Space>
template <class F>
void World<T, Space>::each_met(const Shape& shape, const Pose& pose, const Velocity& velocity, T duration,
                               const QueryFilter& filter, const CastOptions& options, F&& f) const {
  const Sweep<T> sweep = safe_sweep(Space::bounds_turning(shape, pose, velocity.angular),
                                    Space::among_boxes(velocity.linear * duration), T(0));
  T end = duration;
  const auto entries = [&](const WideNode<T>& node, std::array<T, WideNode<T>::width>& out) {
    for (std::uint32_t i = 0; i < WideNode<T>::width; ++i)
      out[i] = node.child[i] == TreeChild::none ? infinity<T> : entry(node.box(i), sweep) * duration;
  };
  tree().in_order(entries, end, [&](std::uint32_t i, const Aabb<T>&) {
    if (!is_asked(filter, i)) return end;
    // For the whole time, whatever is known already: the last digits of a time depend on the duration of the cast.
    const auto hit = Space::cast(shape, pose, velocity, bodies_.shapes()[i], bodies_.poses()[i], {}, duration, options);
    if (hit) end = f(BodyCastHit<T, Space>{bodies_.id(i), *hit});
    return end;
  });
}

template <class T, class Space>
std::optional<BodyCastHit<T, Space>>
World<T, Space>::cast(const Shape& shape, const Pose& pose, const Velocity& velocity, T duration,
                      const QueryFilter& filter, const CastOptions& options) const {
  std::optional<BodyCastHit<T, Space>> first;
  each_met(shape, pose, velocity, duration, filter, options, [&](const BodyCastHit<T, Space>& hit) {
    if (!first || before(hit, *first)) first = hit;
    return first->hit.t;
  });
  return first;
}

template <class T, class Space>
void World<T, Space>::cast_all(const Shape& shape, const Pose& pose, const Velocity& velocity, T duration,
                               const QueryFilter& filter, std::vector<BodyCastHit<T, Space>>& out,
                               const CastOptions& options) const {
  const std::size_t first = out.size();
  each_met(shape, pose, velocity, duration, filter, options, [&](const BodyCastHit<T, Space>& hit) {
    out.push_back(hit);
    return duration;
  });
  sort_hits(out, first);
}

#define GRAZE_INSTANTIATE(T, S)                                                                                        \
  template const DynamicTree<T>& World<T, S<T>>::tree() const;                                                         \
  template bool World<T, S<T>>::is_asked(const QueryFilter&, std::uint32_t) const;                                     \
  template void World<T, S<T>>::overlapping(const S<T>::Shape&, const S<T>::Pose&, const QueryFilter&,                 \
                                            std::vector<BodyId>&) const;                                               \
  template bool World<T, S<T>>::overlaps_any(const S<T>::Shape&, const S<T>::Pose&, const QueryFilter&) const;         \
  template void World<T, S<T>>::nearest(const S<T>::Shape&, const S<T>::Pose&, std::size_t, T, const QueryFilter&,     \
                                        std::vector<BodyDistance<T, S<T>>>&) const;                                    \
  template std::optional<BodyDistance<T, S<T>>> World<T, S<T>>::closest(const S<T>::Shape&, const S<T>::Pose&, T,      \
                                                                        const QueryFilter&) const;                     \
  template std::optional<BodyRayHit<T, S<T>>> World<T, S<T>>::raycast(const S<T>::Ray&, T, const QueryFilter&,         \
                                                                      S<T>::BackFaces) const;                          \
  template bool World<T, S<T>>::raycast_any(const S<T>::Ray&, T, const QueryFilter&, S<T>::BackFaces) const;           \
  template void World<T, S<T>>::raycast_all(const S<T>::Ray&, T, const QueryFilter&,                                   \
                                            std::vector<BodyRayHit<T, S<T>>>&, S<T>::BackFaces) const;                 \
  template std::optional<BodyCastHit<T, S<T>>> World<T, S<T>>::cast(                                                   \
      const S<T>::Shape&, const S<T>::Pose&, const S<T>::Velocity&, T, const QueryFilter&, const CastOptions&) const;  \
  template void World<T, S<T>>::cast_all(const S<T>::Shape&, const S<T>::Pose&, const S<T>::Velocity&, T,              \
                                         const QueryFilter&, std::vector<BodyCastHit<T, S<T>>>&, const CastOptions&)   \
      const;
GRAZE_INSTANTIATE(float, Space)
GRAZE_INSTANTIATE(double, Space)
GRAZE_INSTANTIATE(float, plane::Space)
GRAZE_INSTANTIATE(double, plane::Space)
#undef GRAZE_INSTANTIATE

}  // namespace graze
