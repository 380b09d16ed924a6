#include "graze/raycast.hpp"

#include <algorithm>

#include "query/shape_rays.hpp"

namespace graze {

using namespace shape_rays;

template <class T>
[[gnu::flatten]] std::optional<RayHit<T>> raycast(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray,
                                                  T length, BackFaces back) {
  const Posed frame = precise(pose);
  std::optional<LocalRay> local = local_ray(ray, length, frame);
  if (!local) return {};
  const Candidate first = first_hit(shape, *local, back);
  if (!(first.hit.t < rays::infinity)) return {};
  return in_world(first, frame, ray, length);
}

template <class T>
[[gnu::flatten]] bool raycast_any(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, T length,
                                  BackFaces back) {
  std::optional<LocalRay> local = local_ray(ray, length, precise(pose));
  if (!local) return false;
  return hits_any(shape, *local, back);
}

template <class T>
std::size_t raycast_all(const Shape<T>& shape, const Pose<T>& pose, const Ray<T>& ray, std::vector<RayHit<T>>& hits,
                        T length, BackFaces back) {
  const Posed frame = precise(pose);
  std::optional<LocalRay> local = local_ray(ray, length, frame);
  if (!local) return 0;
  std::vector<Candidate> all;
  auto keep = [&, end = local->end](const LocalHit& hit, std::uint32_t piece) {
    all.push_back({hit, piece});
    return end;
  };
  visit_hits(shape, *local, back, keep);
  std::sort(all.begin(), all.end(), before);
  for (const Candidate& c : all) hits.push_back(in_world(c, frame, ray, length));
  return all.size();
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template std::optional<RayHit<T>> raycast(const Shape<T>&, const Pose<T>&, const Ray<T>&, T, BackFaces);             \
  template bool raycast_any(const Shape<T>&, const Pose<T>&, const Ray<T>&, T, BackFaces);                             \
  template std::size_t raycast_all(const Shape<T>&, const Pose<T>&, const Ray<T>&, std::vector<RayHit<T>>&, T,         \
                                   BackFaces);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
