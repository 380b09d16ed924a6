#include "graze/slide.hpp"

#include "world/slide_steps.hpp"

namespace graze {

template <class T>
Vec3<T> along_planes(const Vec3<T>& motion, std::span<const Vec3<T>> normals) {
  if (leads_into_none<T>(motion, normals)) return motion;
  // The nearest motion that is allowed is `motion` projected on one plane or on the line of two; there are few of them.
  NearestMotion<T, Vec3<T>> nearest(motion, normals);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    nearest.consider(motion - normals[i] * dot(motion, normals[i]));
    for (std::size_t j = i + 1; j < normals.size(); ++j) {
      const Vec3<T> line = normalized(cross(normals[i], normals[j]), Vec3<T>{});
      nearest.consider(line * dot(motion, line));
    }
  }
  return nearest.best();
}

template <class T>
SlideResult<T> slide(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& motion, const World<T>& world,
                     const QueryFilter& filter, const SlideOptions& options) {
  return slide_through<SlideResult<T>>(world, shape, pose, motion, filter, options, along_planes<T>);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template Vec3<T> along_planes(const Vec3<T>&, std::span<const Vec3<T>>);                                             \
  template SlideResult<T> slide(const Shape<T>&, const Pose<T>&, const Vec3<T>&, const World<T>&, const QueryFilter&,  \
                                const SlideOptions&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze
