#include "graze/blows.hpp"

#include <limits>

#include "dynamics/turning.hpp"
#include "graze/plane/blows.hpp"
#include "graze/small_vector.hpp"

namespace graze {

namespace {

/// The most visits of the points of a manifold. Four corners of a face agree to rounding after some forty.
constexpr int most_visits = 200;

/// One point of a manifold while it is struck.
template <class T, class Space>
struct StruckPoint {
  typename Space::Vec position;
  T effective_mass, target, impulse;
};

template <class T, class Space>
T normal_velocity(const StruckBody<T, Space>& a, const StruckBody<T, Space>& b, const typename Space::Vec& point,
                  const typename Space::Vec& normal) {
  return dot(velocity_at(b.motion, point) - velocity_at(a.motion, point), normal);
}

template <class T, class Space>
T inverse_effective_mass(const StruckBody<T, Space>& body, const typename Space::Vec& point,
                         const typename Space::Vec& normal) {
  const typename Space::Turning turning = cross(point - body.motion.center, normal);
  return body.mass.mass + dot(turning, body.mass.inertia * turning);
}

/// Adds the impulses on the points of one manifold: none of them pulls, and a point that is pushed leaves at the speed
/// of its approach times the restitution.
template <class T, class Space>
void strike(StruckBody<T, Space>& a, StruckBody<T, Space>& b, const Blow<T, Space>& blow,
            std::span<const typename Space::Vec> points, std::span<T> impulses) {
  SmallVector<StruckPoint<T, Space>, 8> struck;
  T fastest(0);
  for (const typename Space::Vec& p : points) {
    const T v = normal_velocity<T, Space>(a, b, p, blow.normal);
    const T yields =
        inverse_effective_mass<T, Space>(a, p, blow.normal) + inverse_effective_mass<T, Space>(b, p, blow.normal);
    struck.push_back({p, T(1) / yields, -blow.restitution * v, T(0)});
    fastest = greatest(fastest, std::abs(v));
  }
  const T rounding = T(4) * std::numeric_limits<T>::epsilon() * fastest;
  T change = fastest;
  for (int visit = 0; visit < most_visits && change > rounding; ++visit) {
    change = T(0);
    for (StruckPoint<T, Space>& p : struck) {
      const T missing = p.target - normal_velocity<T, Space>(a, b, p.position, blow.normal);
      const T impulse = greatest(T(0), p.impulse + missing * p.effective_mass);
      const typename Space::Vec more = blow.normal * (impulse - p.impulse);
      change = greatest(change, std::abs(impulse - p.impulse) / p.effective_mass);
      p.impulse = impulse;
      a.motion = apply_impulse(a, -more, p.position);
      b.motion = apply_impulse(b, more, p.position);
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) impulses[i] += struck[i].impulse;
}

/// The speed at which the points of a blow approach, the fastest of them; nothing resists between immovable bodies.
template <class T, class Space>
T approach_of(std::span<const StruckBody<T, Space>> bodies, const Blow<T, Space>& blow,
              std::span<const typename Space::Vec> points) {
  const StruckBody<T, Space>&a = bodies[blow.a], &b = bodies[blow.b];
  if (!a.mass.movable() && !b.mass.movable()) return T(0);
  T fastest(0);
  for (const typename Space::Vec& p : points.subspan(blow.first_point, blow.point_count))
    fastest = greatest(fastest, -normal_velocity<T, Space>(a, b, p, blow.normal));
  return fastest;
}

template <class T, class Space>
PassedOn<T> strike_until_none(std::span<StruckBody<T, Space>> bodies, std::span<const Blow<T, Space>> blows,
                              std::span<const typename Space::Vec> points, std::span<T> impulses, T resting_speed,
                              std::size_t most) {
  PassedOn<T> passed;
  while (true) {
    const Blow<T, Space>* next = nullptr;
    passed.approach = T(0);
    for (const Blow<T, Space>& blow : blows) {
      const T approach = approach_of<T, Space>(bodies, blow, points);
      if (!(approach > passed.approach)) continue;
      passed.approach = approach;
      next = &blow;
    }
    if (!next || passed.approach <= resting_speed || passed.struck == most) return passed;
    strike<T, Space>(bodies[next->a], bodies[next->b], *next, points.subspan(next->first_point, next->point_count),
                     impulses.subspan(next->first_point, next->point_count));
    ++passed.struck;
  }
}

}  // namespace

template <class T>
PassedOn<T> pass_on(std::span<StruckBody<T>> bodies, std::span<const Blow<T>> blows, std::span<const Vec3<T>> points,
                    std::span<T> impulses, T resting_speed, std::size_t most) {
  return strike_until_none<T, Space<T>>(bodies, blows, points, impulses, resting_speed, most);
}
template <class T>
PassedOn<T> plane::pass_on(std::span<plane::StruckBody<T>> bodies, std::span<const plane::Blow<T>> blows,
                           std::span<const Vec2<T>> points, std::span<T> impulses, T resting_speed, std::size_t most) {
  return strike_until_none<T, plane::Space<T>>(bodies, blows, points, impulses, resting_speed, most);
}

#define GRAZE_PASS_ON(T)                                                                                               \
  template PassedOn<T> pass_on(std::span<StruckBody<T>>, std::span<const Blow<T>>, std::span<const Vec3<T>>,           \
                               std::span<T>, T, std::size_t);                                                          \
  template PassedOn<T> plane::pass_on(std::span<plane::StruckBody<T>>, std::span<const plane::Blow<T>>,                \
                                      std::span<const plane::Vec2<T>>, std::span<T>, T, std::size_t);
GRAZE_PASS_ON(float)
GRAZE_PASS_ON(double)
#undef GRAZE_PASS_ON

}  // namespace graze
