#include "graze/plane/free_motion.hpp"

namespace graze::plane {

namespace {

/// The largest angle whose series is summed; larger ones are halved first.
template <class T>
constexpr T series_angle = T(0.25);

}  // namespace

/// cos x - 1 and sin x by their series, whose first terms left out are below 0.25^14 / 14! = 5e-20; then doubled as
/// often as the angle was halved.
template <class T>
Rot2<T> rotation_by(T angle) {
  if (!std::isfinite(angle)) return {};
  int halvings = 0;
  for (; std::abs(angle) > series_angle<T>; ++halvings) angle /= T(2);
  const T square = angle * angle;
  T cosine(0), sine(0);
  for (int n = 12; n > 0; n -= 2) {
    cosine = -square / T(n * (n - 1)) * (T(1) + cosine);
    sine = -square / T(n * (n + 1)) * (T(1) + sine);
  }
  Rot2<T> turn = normalized(Rot2<T>{T(1) + cosine, angle * (T(1) + sine)});
  for (; halvings > 0; --halvings) turn = normalized(turn * turn);
  return turn;
}

template <class T>
void advance(FreeBody<T>& body, const Vec2<T>& acceleration, T duration) {
  const Vec2<T> before = body.linear;
  body.linear += acceleration * duration;
  body.center += (before + body.linear) * (duration / T(2));
  const T angle = angular_velocity(body) * duration;
  if (angle != T(0)) body.rotation = normalized(rotation_by(angle) * body.rotation);
}

#define GRAZE_FREE_MOTION(T)                                                                                           \
  template Rot2<T> rotation_by(T);                                                                                     \
  template void advance(FreeBody<T>&, const Vec2<T>&, T);
GRAZE_FREE_MOTION(float)
GRAZE_FREE_MOTION(double)
#undef GRAZE_FREE_MOTION

}  // namespace graze::plane
