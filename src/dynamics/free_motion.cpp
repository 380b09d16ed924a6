#include "graze/free_motion.hpp"

#include <cmath>

namespace graze {

namespace {

/// The largest angle of one step of rotation. Its error grows with the fifth power. A book that is spun about its
/// middle axis, a thousandth beside it, turns over 9 times in 20 s at 10 rad/s; with steps 2.5 times as large 10 times.
template <class T>
constexpr T step_angle = T(0.1);

/// The rotation of a Rodrigues vector, which is the axis times the tangent of half the angle.
template <class T>
Quat<T> rotation_of(const Vec3<T>& g) {
  return normalized(Quat<T>{g.x, g.y, g.z, T(1)});
}

template <class T>
Vec3<T> angular_velocity_at(const FreeBody<T>& body, const Quat<T>& rotation) {
  const Vec3<T> in_body = rotate(conjugate(rotation), body.angular_momentum);
  return rotate(rotation, scaled(in_body, body.inverse_inertia));
}

/// The rate of the Rodrigues vector g of the rotation since the beginning of a step. From q' = ω q / 2 follows
/// g' = (ω + ω × g + g (g·ω)) / 2, an equation in a vector space, on which the classical method of Runge and Kutta
/// keeps its fourth order.
template <class T>
Vec3<T> rate(const FreeBody<T>& body, const Vec3<T>& g) {
  const Vec3<T> w = angular_velocity_at(body, rotation_of(g) * body.rotation);
  return (w + cross(w, g) + g * dot(g, w)) / T(2);
}

template <class T>
void turn(FreeBody<T>& body, T h) {
  const Vec3<T> k1 = rate(body, Vec3<T>{});
  const Vec3<T> k2 = rate(body, k1 * (h / T(2)));
  const Vec3<T> k3 = rate(body, k2 * (h / T(2)));
  const Vec3<T> k4 = rate(body, k3 * h);
  const Vec3<T> g = (k1 + (k2 + k3) * T(2) + k4) * (h / T(6));
  body.rotation = normalized(rotation_of(g) * body.rotation);
}

/// How many steps of rotation a duration takes: by the greatest rate that the angular momentum can cause.
template <class T>
int rotation_steps(const FreeBody<T>& body, T duration) {
  const T angle = length(body.angular_momentum) * max_abs(body.inverse_inertia) * std::abs(duration);
  const T steps = std::ceil(angle / step_angle<T>);
  return steps < T(most_rotation_steps) ? static_cast<int>(steps) : most_rotation_steps;
}

}  // namespace

template <class T>
Vec3<T> angular_velocity(const FreeBody<T>& body) {
  return angular_velocity_at(body, body.rotation);
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
  const int steps = rotation_steps(body, duration);
  for (int i = 0; i < steps; ++i) turn(body, duration / T(steps));
}

#define GRAZE_FREE_MOTION(T)                                                                                           \
  template Vec3<T> angular_velocity(const FreeBody<T>&);                                                               \
  template void set_angular_velocity(FreeBody<T>&, const Vec3<T>&);                                                    \
  template void advance(FreeBody<T>&, const Vec3<T>&, T);
GRAZE_FREE_MOTION(float)
GRAZE_FREE_MOTION(double)
#undef GRAZE_FREE_MOTION

}  // namespace graze
