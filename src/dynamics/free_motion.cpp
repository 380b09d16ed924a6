#include "graze/free_motion.hpp"

#include "dynamics/free_turning.hpp"

namespace graze {

template <class T>
Vec3<T> angular_velocity(const FreeBody<T>& body) {
  return spin_of(body);
}

template <class T>
void set_angular_velocity(FreeBody<T>& body, const Vec3<T>& angular) {
  Vec3<T> in_body = rotate(conjugate(body.rotation), angular);
  for (std::size_t i = 0; i < 3; ++i)
    in_body[i] = body.inverse_inertia[i] > T(0) ? in_body[i] / body.inverse_inertia[i] : T(0);
  body.angular_momentum = rotate(body.rotation, in_body);
}

template <class T>
void advance(FreeBody<T>& body, const Vec3<T>& acceleration, T duration) {
  const Vec3<T> before = body.linear;
  body.linear += acceleration * duration;
  body.center += (before + body.linear) * (duration / T(2));
  turn(body, duration);
}

#define GRAZE_FREE_MOTION(T)                                                                                           \
  template Vec3<T> angular_velocity(const FreeBody<T>&);                                                               \
  template void set_angular_velocity(FreeBody<T>&, const Vec3<T>&);                                                    \
  template void advance(FreeBody<T>&, const Vec3<T>&, T);
GRAZE_FREE_MOTION(float)
GRAZE_FREE_MOTION(double)
#undef GRAZE_FREE_MOTION

}  // namespace graze
