#include "graze/raycast.hpp"

#include <algorithm>

#include "query/explain_ray.hpp"
#include "query/shape_rays.hpp"

#include "rays/box_rays.hpp"
#include "rays/convex.hpp"
#include "simd/flatten.hpp"

namespace graze {

using namespace shape_rays;
using rays::MaybeHit;

namespace {

template <class T>
std::optional<RayHit<T>> box_hit(const Vec3<T>& half, const Pose<T>& pose, const Ray<T>& ray, T length) {
  static const auto kernel = GRAZE_KERNEL(chosen_isa(), ray_at_box<T>);
  std::optional<RayHit<T>> hit(std::in_place);
  if (!kernel(half, pose, ray, length, *hit)) hit.reset();
  return hit;
}

/// The hit at the concrete shape C, which is convex. One function, so that numbers stay in registers.
template <class C, class T>
GRAZE_FLATTEN std::optional<RayHit<T>> convex_hit(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray,
                                                  T length, BackFaces back) {
  Frame frame = frame_of(pose);
  std::optional<LocalRay> local = local_ray(ray, length, frame);
  if (!local) return {};
  MaybeHit hit = rays::hit_convex(*shape.template as<C>(), shape.rounding(), *local, back);
  if (!hit) return {};
  return in_world<T>({*hit, 0}, frame, ray, length);
}

template <class T>
GRAZE_FLATTEN std::optional<RayHit<T>> composite_hit(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray,
                                                     T length, BackFaces back) {
  const Frame frame = frame_of(pose);
  std::optional<LocalRay> local = local_ray(ray, length, frame);
  if (!local) return {};
  const Candidate first = first_hit(shape, *local, back);
  if (!(first.hit.t < rays::infinity)) return {};
  return in_world(first, frame, ray, length);
}

}  // namespace

template <class T>
std::optional<RayHit<T>> raycast(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, T length,
                                 BackFaces back, Trace* trace) {
  if (trace) {
    const std::optional<RayHit<T>> hit = raycast(shape, pose, ray, length, back);
    explain_ray(shape, pose, ray, length, back, hit, *trace);
    return hit;
  }
  if (const Vec3<T>* half = rays::plain_box(shape)) return box_hit(*half, pose, ray, length);
  return shape.visit([&](const auto& c) {
    using C = std::decay_t<decltype(c)>;
    if constexpr (BoundedConvex<C> || std::is_same_v<C, HalfSpace<T>>)
      return convex_hit<C>(shape, pose, ray, length, back);
    else
      return composite_hit(shape, pose, ray, length, back);
  });
}

template <class T>
GRAZE_FLATTEN bool raycast_any(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, T length,
                               BackFaces back) {
  if (const Vec3<T>* half = rays::plain_box(shape)) return box_hit(*half, pose, ray, length).has_value();
  std::optional<LocalRay> local = local_ray(ray, length, frame_of(pose));
  if (!local) return false;
  return hits_any(shape, *local, back);
}

template <class T>
std::size_t raycast_all(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, std::vector<RayHit<T>>& hits,
                        T length, BackFaces back) {
  if (const Vec3<T>* half = rays::plain_box(shape)) {
    const auto hit = box_hit(*half, pose, ray, length);
    if (hit) hits.push_back(*hit);
    return hit ? 1 : 0;
  }
  const Frame frame = frame_of(pose);
  std::optional<LocalRay> local = local_ray(ray, length, frame);
  if (!local) return 0;
  std::vector<Candidate> all;
  auto keep = [&, end = local->end](const LocalHit& hit, std::uint32_t piece) {
    all.push_back({hit, piece});
    return end;
  };
  visit_hits(shape, *local, back, keep);
  std::sort(all.begin(), all.end(), before);
  const auto first = static_cast<std::ptrdiff_t>(hits.size());
  for (const Candidate& c : all) hits.push_back(in_world(c, frame, ray, length));
  // Rounded to T, times may be equal that were not.
  std::stable_sort(hits.begin() + first, hits.end(),
                   [](const RayHit<T>& p, const RayHit<T>& q) { return p.t != q.t ? p.t < q.t : p.piece < q.piece; });
  return all.size();
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::optional<RayHit<T>> raycast(const Shape<T>&, const Pose<T>&, const Ray<T>&, T, BackFaces, Trace*);     \
  template bool raycast_any(const Shape<T>&, const Pose<T>&, const Ray<T>&, T, BackFaces);                             \
  template std::size_t raycast_all(const Shape<T>&, const Pose<T>&, const Ray<T>&, std::vector<RayHit<T>>&, T,         \
                                   BackFaces);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
