#include "graze/plane/slide.hpp"

#include "world/slide_steps.hpp"

namespace graze::plane {

template <class T>
Vec2<T> along_lines(const Vec2<T>& motion, std::span<const Vec2<T>> normals) {
  if (leads_into_none<T>(motion, normals)) return motion;
  NearestMotion<T, Vec2<T>> nearest(motion, normals);
  for (const Vec2<T>& n : normals) nearest.consider(motion - n * dot(motion, n));
  return nearest.best();
}

template <class T>
SlideResult<T> slide(const Shape<T>& shape, const Pose2<T>& pose, const Vec2<T>& motion, const World<T>& world,
                     const QueryFilter& filter, const SlideOptions& options) {
  return slide_through<SlideResult<T>>(world, shape, pose, motion, filter, options, along_lines<T>);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template Vec2<T> along_lines(const Vec2<T>&, std::span<const Vec2<T>>);                                              \
  template SlideResult<T> slide(const Shape<T>&, const Pose2<T>&, const Vec2<T>&, const World<T>&, const QueryFilter&, \
                                const SlideOptions&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::plane
