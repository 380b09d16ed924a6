#include "graze/plane/free_motion.hpp"

#include "dynamics/free_turning.hpp"

namespace graze::plane {

template <class T>
Rot2<T> rotation_by(T angle) {
  return rotation_of_angle(angle);
}

template <class T>
void advance(FreeBody<T>& body, const Vec2<T>& acceleration, T duration) {
  const Vec2<T> before = body.linear;
  body.linear += acceleration * duration;
  body.center += (before + body.linear) * (duration / T(2));
  turn(body, duration);
}

#define GRAZE_FREE_MOTION(T)                                                                                           \
  template Rot2<T> rotation_by(T);                                                                                     \
  template void advance(FreeBody<T>&, const Vec2<T>&, T);
GRAZE_FREE_MOTION(float)
GRAZE_FREE_MOTION(double)
#undef GRAZE_FREE_MOTION

}  // namespace graze::plane
