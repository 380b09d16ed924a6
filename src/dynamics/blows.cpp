#include "graze/blows.hpp"

#include <limits>

#include "graze/small_vector.hpp"

namespace graze {

namespace {

/// How often the points of a manifold are visited at most. Four corners of a face agree to rounding after some forty.
constexpr int most_visits = 200;

/// One point of a manifold while it is struck.
template <class T>
struct StruckPoint {
  Vec3<T> position;
  T effective_mass, target, impulse;
};

template <class T>
T normal_velocity(const StruckBody<T>& a, const StruckBody<T>& b, const Vec3<T>& point, const Vec3<T>& normal) {
  return dot(velocity_at(b.motion, point) - velocity_at(a.motion, point), normal);
}

template <class T>
T inverse_effective_mass(const StruckBody<T>& body, const Vec3<T>& point, const Vec3<T>& normal) {
  const Vec3<T> turning = cross(point - body.motion.center, normal);
  return body.mass.mass + dot(turning, body.mass.inertia * turning);
}

/// Lets the points of one manifold agree on impulses that push, and that reverse what they push.
template <class T>
void strike(StruckBody<T>& a, StruckBody<T>& b, const Blow<T>& blow, std::span<const Vec3<T>> points,
            std::span<T> impulses) {
  SmallVector<StruckPoint<T>, 8> struck;
  T fastest(0);
  for (const Vec3<T>& p : points) {
    const T v = normal_velocity(a, b, p, blow.normal);
    const T yields = inverse_effective_mass(a, p, blow.normal) + inverse_effective_mass(b, p, blow.normal);
    struck.push_back({p, T(1) / yields, -blow.restitution * v, T(0)});
    fastest = greatest(fastest, std::abs(v));
  }
  const T rounding = T(4) * std::numeric_limits<T>::epsilon() * fastest;
  T change = fastest;
  for (int visit = 0; visit < most_visits && change > rounding; ++visit) {
    change = T(0);
    for (StruckPoint<T>& p : struck) {
      const T missing = p.target - normal_velocity(a, b, p.position, blow.normal);
      const T impulse = greatest(T(0), p.impulse + missing * p.effective_mass);
      const Vec3<T> more = blow.normal * (impulse - p.impulse);
      change = greatest(change, std::abs(impulse - p.impulse) / p.effective_mass);
      p.impulse = impulse;
      a.motion = apply_impulse(a, -more, p.position);
      b.motion = apply_impulse(b, more, p.position);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) impulses[i] += struck[i].impulse;
}

/// The speed at which the points of a blow approach, the fastest of them; nothing resists between immovable bodies.
template <class T>
T approach_of(std::span<const StruckBody<T>> bodies, const Blow<T>& blow, std::span<const Vec3<T>> points) {
  const StruckBody<T>&a = bodies[blow.a], &b = bodies[blow.b];
  if (!a.mass.movable() && !b.mass.movable()) return T(0);
  T fastest(0);
  for (const Vec3<T>& p : points.subspan(blow.first_point, blow.point_count))
    fastest = greatest(fastest, -normal_velocity(a, b, p, blow.normal));
  return fastest;
}

}  // namespace

template <class T>
PassedOn<T> pass_on(std::span<StruckBody<T>> bodies, std::span<const Blow<T>> blows, std::span<const Vec3<T>> points,
                    std::span<T> impulses, T resting_speed, std::size_t most) {
  PassedOn<T> passed;
  while (true) {
    const Blow<T>* next = nullptr;
    passed.approach = T(0);
    for (const Blow<T>& blow : blows) {
      const T approach = approach_of<T>(bodies, blow, points);
      if (!(approach > passed.approach)) continue;
      passed.approach = approach;
      next = &blow;
    }
    if (!next || passed.approach <= resting_speed || passed.struck == most) return passed;
    strike(bodies[next->a], bodies[next->b], *next, points.subspan(next->first_point, next->point_count),
           impulses.subspan(next->first_point, next->point_count));
    ++passed.struck;
  }
}

template PassedOn<float> pass_on(std::span<StruckBody<float>>, std::span<const Blow<float>>,
                                 std::span<const Vec3<float>>, std::span<float>, float, std::size_t);
template PassedOn<double> pass_on(std::span<StruckBody<double>>, std::span<const Blow<double>>,
                                  std::span<const Vec3<double>>, std::span<double>, double, std::size_t);

}  // namespace graze
