#include "dynamics/contact_rows.hpp"

#include <cmath>

namespace graze {

namespace {

template <class T>
constexpr T pi = T(3.14159265358979323846);

/// Sub-steps in the period of a contact's spring.
template <class T>
constexpr T period = T(6);

template <class T>
constexpr T damping_ratio = T(5);

/// How often a manifold that slides is solved in a pass.
constexpr int sliding_rounds = 2;

template <class T>
T inverse_effective_mass(const SolverBody<T>& body, const Vec3<T>& arm, const Vec3<T>& direction) {
  const Vec3<T> turn = cross(arm, direction);
  return body.mass.mass + dot(turn, body.mass.inertia * turn);
}

template <class T>
T inverse_or_zero(T value) {
  return value > T(0) ? T(1) / value : T(0);
}

/// The inverse of the tangential 2×2 block of K (see `impulse.hpp`) at the pressure centre.
template <class T>
void prepare_friction(ManifoldRows<T>& m, const SolverBody<T>& a, const SolverBody<T>& b) {
  const auto k = [&](const Vec3<T>& x, const Vec3<T>& y) {
    return dot(cross(m.arm_a, x), a.mass.inertia * cross(m.arm_a, y)) +
           dot(cross(m.arm_b, x), b.mass.inertia * cross(m.arm_b, y));
  };
  const T mass = a.mass.mass + b.mass.mass;
  const T uu = mass + k(m.u, m.u), vv = mass + k(m.v, m.v), uv = k(m.u, m.v);
  const T inverse = inverse_or_zero(uu * vv - uv * uv);
  m.friction_mass[0] = vv * inverse;
  m.friction_mass[1] = -uv * inverse;
  m.friction_mass[2] = uu * inverse;
  m.twist_mass = inverse_or_zero(dot(m.normal, (a.mass.inertia + b.mass.inertia) * m.normal));
}

/// Where the pressure of the points acts, by the impulses of the last step; of a contact that is new by how much
/// nearer each point is than the furthest, and a thousandth of the size more, so that a face has it in its middle.
template <class T>
void find_pressure_center(ManifoldRows<T>& m, std::span<PointRow<T>> rows, T loaded) {
  T furthest = rows.front().separation;
  for (const PointRow<T>& r : rows) furthest = greatest(furthest, r.separation);
  const auto weight = [&](const PointRow<T>& r) {
    return loaded > T(0) ? r.impulse : furthest - r.separation + m.size * T(0.001);
  };
  T sum(0);
  Vec3<T> center_a{}, center_b{};
  for (const PointRow<T>& r : rows) {
    sum += weight(r);
    center_a += r.arm_a * weight(r);
    center_b += r.arm_b * weight(r);
  }
  m.arm_a = center_a / sum;
  m.arm_b = center_b / sum;
  for (PointRow<T>& r : rows) r.distance = length(r.arm_a - m.arm_a);
}

/// Friction with the total impulse of the points at hand; tells whether it reached its limit.
template <class T>
bool solve_friction(ManifoldRows<T>& m, std::span<const PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b) {
  T pressed(0), lever(0);
  for (const PointRow<T>& r : rows) {
    pressed += r.impulse;
    lever += r.impulse * r.distance;
  }
  const Vec3<T> turning = b.angular - a.angular;
  const T twist_limit = m.material.dynamic_friction * lever;
  const T twist = clamp(m.twist - m.twist_mass * dot(turning, m.normal), -twist_limit, twist_limit);
  const Vec3<T> twisted = m.normal * (twist - m.twist);
  m.twist = twist;
  a.angular -= a.mass.inertia * twisted;
  b.angular += b.mass.inertia * twisted;

  if (m.material.rolling_friction > T(0)) {
    const Vec3<T> rolls = b.angular - a.angular;
    const Vec3<T> axis = normalized(rolls);
    const T mass = inverse_or_zero(dot(axis, (a.mass.inertia + b.mass.inertia) * axis));
    Vec3<T> rolling = m.rolling - rolls * mass;
    const T limit = m.material.rolling_friction * pressed, l = length(rolling);
    if (l > limit) rolling *= limit / l;
    a.angular -= a.mass.inertia * (rolling - m.rolling);
    b.angular += b.mass.inertia * (rolling - m.rolling);
    m.rolling = rolling;
  }

  const Vec3<T> slip = b.velocity(m.arm_b) - a.velocity(m.arm_a);
  const T su = dot(slip, m.u) + m.belt_u, sv = dot(slip, m.v) + m.belt_v;
  T fu = m.friction_u - (m.friction_mass[0] * su + m.friction_mass[1] * sv);
  T fv = m.friction_v - (m.friction_mass[1] * su + m.friction_mass[2] * sv);
  const T needed = std::sqrt(fu * fu + fv * fv);
  const bool slides = needed > m.material.static_friction * pressed;
  if (slides) {
    const T shorter = least(T(1), m.material.dynamic_friction * pressed / needed);
    fu *= shorter;
    fv *= shorter;
  }
  const Vec3<T> push = m.u * (fu - m.friction_u) + m.v * (fv - m.friction_v);
  m.friction_u = fu;
  m.friction_v = fv;
  a.push(-push, m.arm_a);
  b.push(push, m.arm_b);
  return slides;
}

template <class T>
void solve_normals(const ManifoldRows<T>& m, std::span<PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b,
                   const ContactStep<T>& step, bool bias) {
  const Softness<T>& soft = step.soft;
  const T fastest_push = std::sqrt(step.gravity * m.size);
  for (PointRow<T>& r : rows) {
    const T s = r.separation + dot(b.displacement(r.arm_b) - a.displacement(r.arm_a), m.normal);
    T wanted(0), mass_scale(1), impulse_scale(0);
    if (s > T(0)) {
      wanted = -s * step.time.inverse_h;
    } else if (bias) {
      wanted = least(-s * soft.bias_rate, step.gravity > T(0) ? fastest_push : m.size / (T(20) * step.time.step));
      mass_scale = soft.mass_scale;
      impulse_scale = soft.impulse_scale;
    }
    const T speed = dot(b.linear - a.linear, m.normal) + dot(r.turn_b, b.angular) - dot(r.turn_a, a.angular);
    const T change = r.effective_mass * (wanted - speed) * mass_scale - impulse_scale * r.impulse;
    const T impulse = greatest(T(0), r.impulse + change);
    const T more = impulse - r.impulse;
    r.impulse = impulse;
    a.linear -= m.normal * (more * a.mass.mass);
    b.linear += m.normal * (more * b.mass.mass);
    a.angular -= r.spin_a * more;
    b.angular += r.spin_b * more;
  }
}

}  // namespace

template <class T>
ContactStep<T> contact_step(const SubStep<T>& time, T gravity) {
  const T w = T(2) * pi<T> / (period<T> * time.h);
  return {time, softness(w, damping_ratio<T>, time.h), gravity};
}

template <class T>
T predicted_sink(T force, T inverse_mass, T h) {
  const T w = T(2) * pi<T> / (period<T> * h);
  return force * inverse_mass / (w * w);
}

template <class T>
ManifoldRows<T> prepare(const TouchingBodies<T>& touching, std::span<const SolverBody<T>> bodies,
                        const ContactManifold<T>& manifold, std::span<const SolverPoint<T>> points, T share,
                        std::uint32_t first_row, std::span<PointRow<T>> own) {
  const SolverBody<T>&a = bodies[touching.a], &b = bodies[touching.b];
  ManifoldRows<T> m;
  m.a = touching.a;
  m.b = touching.b;
  m.first_row = first_row;
  m.row_count = static_cast<std::uint32_t>(points.size());
  m.first_point = manifold.first_point;
  m.normal = manifold.normal;
  m.u = any_perpendicular(m.normal);
  m.v = cross(m.normal, m.u);
  m.material = touching.material;
  m.size = touching.size;
  m.inverse_mass = a.mass.mass + b.mass.mass;
  T loaded(0);
  Vec3<T> friction{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SolverPoint<T>& p = points[i];
    PointRow<T> r;
    const Vec3<T> at = p.position();
    r.arm_a = at - a.first_center;
    r.arm_b = at - b.first_center;
    r.turn_a = cross(r.arm_a, m.normal);
    r.turn_b = cross(r.arm_b, m.normal);
    r.spin_a = a.mass.inertia * r.turn_a;
    r.spin_b = b.mass.inertia * r.turn_b;
    r.separation = p.distance;
    r.effective_mass = inverse_or_zero(m.inverse_mass + dot(r.turn_a, r.spin_a) + dot(r.turn_b, r.spin_b));
    const T along = dot(p.impulse, m.normal);
    r.impulse = greatest(T(0), along) * share;
    friction += (p.impulse - m.normal * along) * share;
    loaded += r.impulse;
    own[i] = r;
  }
  find_pressure_center(m, own, loaded);
  prepare_friction(m, a, b);
  m.friction_u = dot(friction, m.u);
  m.friction_v = dot(friction, m.v);
  for (std::size_t i = 0; i < own.size(); ++i)
    m.twist += dot(cross(own[i].arm_a - m.arm_a, points[i].impulse * share), m.normal);
  // A point that was lost took its share of the pressure along, and others' shares may not hold without it.
  const T held = std::sqrt(m.friction_u * m.friction_u + m.friction_v * m.friction_v);
  const T most = m.material.static_friction * loaded;
  if (held > most) {
    m.friction_u *= most / held;
    m.friction_v *= most / held;
  }
  T lever(0);
  for (const PointRow<T>& r : own) lever += r.impulse * r.distance;
  const T twist_limit = m.material.dynamic_friction * lever;
  m.twist = clamp(m.twist, -twist_limit, twist_limit);
  const Vec3<T> belt = touching.surface_b - touching.surface_a;
  m.belt_u = dot(belt, m.u);
  m.belt_v = dot(belt, m.v);
  return m;
}

template <class T>
void warm_start(const ManifoldRows<T>& m, std::span<const PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b) {
  T pressed(0);
  Vec3<T> angular_a = m.normal * m.twist + m.rolling, angular_b = angular_a;
  Vec3<T> spun_a{}, spun_b{};
  for (const PointRow<T>& r : rows) {
    pressed += r.impulse;
    spun_a += r.spin_a * r.impulse;
    spun_b += r.spin_b * r.impulse;
  }
  const Vec3<T> friction = m.u * m.friction_u + m.v * m.friction_v;
  const Vec3<T> push = m.normal * pressed + friction;
  angular_a += cross(m.arm_a, friction);
  angular_b += cross(m.arm_b, friction);
  a.linear -= push * a.mass.mass;
  b.linear += push * b.mass.mass;
  a.angular -= spun_a + a.mass.inertia * angular_a;
  b.angular += spun_b + b.mass.inertia * angular_b;
}

template <class T>
void solve(ManifoldRows<T>& m, std::span<PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b,
           const ContactStep<T>& step, bool bias) {
  // Friction at its limit loads the points otherwise, and their impulses are its limit: a few rounds agree.
  const int most = sliding_rounds;
  bool slides = true;
  for (int round = 0; round < most && slides; ++round) {
    solve_normals(m, rows, a, b, step, bias);
    slides = solve_friction<T>(m, rows, a, b);
  }
}

template <class T>
void note_pressed(const ManifoldRows<T>& m, std::span<const PointRow<T>> rows, SolverBody<T>& a, SolverBody<T>& b) {
  T pressed(0);
  for (const PointRow<T>& r : rows) pressed += r.impulse;
  if (!(pressed > T(0))) return;
  a.press(m.normal);
  b.press(m.normal);
}

template <class T>
void store(const ManifoldRows<T>& m, std::span<const PointRow<T>> rows, std::span<SolverPoint<T>> points, T times) {
  T pressed(0);
  Vec3<T> center{};
  for (const PointRow<T>& r : rows) {
    pressed += r.impulse;
    center += r.arm_a * r.impulse;
  }
  const T inverse = inverse_or_zero(pressed);
  center = center * inverse;
  T lever(0), furthest(0);
  for (const PointRow<T>& r : rows) {
    const T square = length_squared(r.arm_a - center);
    lever += r.impulse * inverse * square;
    if (r.impulse > T(0)) furthest = greatest(furthest, square);
  }
  const Vec3<T> friction = m.u * m.friction_u + m.v * m.friction_v;
  // No point holds more of the twist than its own friction would.
  const T most = m.material.dynamic_friction * pressed * inverse_or_zero(std::sqrt(furthest));
  const Vec3<T> twist = m.normal * clamp(m.twist * inverse_or_zero(lever), -most, most);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec3<T> across = (friction + cross(twist, rows[i].arm_a - center)) * (rows[i].impulse * inverse);
    points[i].impulse = (m.normal * rows[i].impulse + across) * times;
  }
}

#define GRAZE_CONTACT_ROWS(T)                                                                                          \
  template ContactStep<T> contact_step(const SubStep<T>&, T);                                                          \
  template T predicted_sink(T, T, T);                                                                                  \
  template ManifoldRows<T> prepare(const TouchingBodies<T>&, std::span<const SolverBody<T>>,                           \
                                   const ContactManifold<T>&, std::span<const SolverPoint<T>>, T, std::uint32_t,       \
                                   std::span<PointRow<T>>);                                                            \
  template void warm_start(const ManifoldRows<T>&, std::span<const PointRow<T>>, SolverBody<T>&, SolverBody<T>&);      \
  template void solve(ManifoldRows<T>&, std::span<PointRow<T>>, SolverBody<T>&, SolverBody<T>&, const ContactStep<T>&, \
                      bool);                                                                                           \
  template void note_pressed(const ManifoldRows<T>&, std::span<const PointRow<T>>, SolverBody<T>&, SolverBody<T>&);    \
  template void store(const ManifoldRows<T>&, std::span<const PointRow<T>>, std::span<SolverPoint<T>>, T);
GRAZE_CONTACT_ROWS(float)
GRAZE_CONTACT_ROWS(double)
#undef GRAZE_CONTACT_ROWS

}  // namespace graze
