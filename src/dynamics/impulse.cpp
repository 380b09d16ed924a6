#include "graze/impulse.hpp"

#include <limits>

#include "dynamics/stopping_impulse.hpp"
#include "graze/plane/rigid.hpp"

namespace graze {

template <class T, class Space>
typename Rigid<Space>::Motion apply_impulse(const StruckBody<T, Space>& body, const typename Space::Vec& impulse,
                                            const typename Space::Vec& point) {
  auto after = body.motion;
  after.linear += impulse * body.mass.mass;
  after.angular += body.mass.inertia * cross(point - body.motion.center, impulse);
  return after;
}

template <class T>
Response<T> response(const StruckContact<T>& contact, const StruckBody<T>& a, const StruckBody<T>& b) {
  const Vec3<T>& n = contact.normal;
  ContactPoint<T> at;
  at.a = at.b = contact.point;
  const Yielding<T> k{a.mass, b.mass, contact.point - a.motion.center, contact.point - b.motion.center};

  Response<T> r;
  r.a = a.motion;
  r.b = b.motion;
  r.approach = relative_velocity(at, n, a.motion, b.motion);
  r.at_fault = at_fault(at, n, a.motion, b.motion);
  const bool movable = a.mass.movable() || b.mass.movable();
  const Vec3<T> kn = k * n;
  r.effective_mass = movable ? T(1) / dot(n, kn) : std::numeric_limits<T>::infinity();
  if (!movable || !(r.approach.normal < T(0))) return r;

  r.normal_impulse = greatest(T(0), -(T(1) + contact.restitution) * r.approach.normal * r.effective_mass);
  const Vec3<T> left = r.approach.tangential + kn * r.normal_impulse;
  r.sliding = left - n * dot(n, left);
  r.stopping_impulse = stopping(k, n, r.sliding);
  r.friction_limit = contact.friction * r.normal_impulse;
  const T stop = length(r.stopping_impulse);
  r.friction_impulse = stop > r.friction_limit ? r.stopping_impulse * (r.friction_limit / stop) : r.stopping_impulse;
  r.impulse = n * r.normal_impulse + r.friction_impulse;
  r.a = apply_impulse(a, -r.impulse, contact.point);
  r.b = apply_impulse(b, r.impulse, contact.point);
  return r;
}

#define GRAZE_APPLY_IMPULSE(T)                                                                                         \
  template Motion<T> apply_impulse(const StruckBody<T>&, const Vec3<T>&, const Vec3<T>&);                              \
  template plane::Motion<T> apply_impulse(const StruckBody<T, plane::Space<T>>&, const plane::Vec2<T>&,                \
                                          const plane::Vec2<T>&);
GRAZE_APPLY_IMPULSE(float)
GRAZE_APPLY_IMPULSE(double)
#undef GRAZE_APPLY_IMPULSE
template Response<float> response(const StruckContact<float>&, const StruckBody<float>&, const StruckBody<float>&);
template Response<double> response(const StruckContact<double>&, const StruckBody<double>&, const StruckBody<double>&);

}  // namespace graze
