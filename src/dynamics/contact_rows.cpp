#include "dynamics/contact_rows.hpp"

#include <cmath>
#include <utility>

namespace graze {

namespace {

/// Sub-steps in the period of a contact's spring, and its damping ratio. Measured: with ratios of 5 and more the rows
/// forget so little from pass to pass that a pyramid of base 20 sways for good (14 J of energy after 20 s; with 2 it is
/// 6e-4 J), with 1 a box of a thousand times the mass falls off a light one; with periods of 5 and less walls sway too,
/// and with 8 a tower of forty leans.
template <class T>
constexpr T period = T(5.5);

template <class T>
constexpr T damping_ratio = T(2);

/// A point that bears nothing yet, and comes closer by this part of the smaller body's size in a sub-step, is stopped
/// by a rigid row: a spring would leave a part of the speed, with which what is fast goes through.
template <class T>
constexpr T blow = T(0.005);

/// How often a manifold that slides is solved in a pass.
constexpr int sliding_rounds = 2;

/// Where the pressure of the points acts, by the impulses of the last step; of a contact that is new by how much
/// nearer each point is than the furthest, and a thousandth of the size more, so that a face has it in its middle.
template <class T, class Space>
std::pair<typename Space::Vec, typename Space::Vec> pressure_center(T size, std::span<PointRow<T, Space>> rows,
                                                                    T loaded) {
  T furthest = rows.front().separation;
  for (const PointRow<T, Space>& r : rows) furthest = greatest(furthest, r.separation);
  const auto weight = [&](const PointRow<T, Space>& r) {
    return loaded > T(0) ? r.impulse : furthest - r.separation + size * T(0.001);
  };
  T sum(0);
  typename Space::Vec center_a{}, center_b{};
  for (const PointRow<T, Space>& r : rows) {
    sum += weight(r);
    center_a += r.arm_a * weight(r);
    center_b += r.arm_b * weight(r);
  }
  center_a = center_a / sum;
  center_b = center_b / sum;
  for (PointRow<T, Space>& r : rows) r.distance = length(r.arm_a - center_a);
  return {center_a, center_b};
}

template <class T, class Space>
void solve_normals(const ManifoldRows<T, Space>& m, std::span<PointRow<T, Space>> rows, SolverBody<T, Space>& a,
                   SolverBody<T, Space>& b, const ContactStep<T>& step, bool bias) {
  const Softness<T>& soft = step.soft;
  const T fastest_push = std::sqrt(step.gravity * m.size);
  for (PointRow<T, Space>& r : rows) {
    const T s = r.separation + dot(b.displacement(r.arm_b) - a.displacement(r.arm_a), m.normal);
    const T speed = dot(b.linear - a.linear, m.normal) + dot(r.turn_b, b.angular) - dot(r.turn_a, a.angular);
    T wanted(0), mass_scale(1), impulse_scale(0);
    if (s > T(0)) {
      wanted = -s * step.time.inverse_h;
    } else if (bias) {
      wanted = least(-s * soft.bias_rate, step.gravity > T(0) ? fastest_push : m.size / (T(20) * step.time.step));
      impulse_scale = soft.impulse_scale;
      if (r.impulse > T(0) || -speed * step.time.h < blow<T> * m.size) mass_scale = soft.mass_scale;
    }
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

template <class T, class Space>
ManifoldRows<T, Space> prepare(const TouchingBodies<T, Space>& touching, std::span<const SolverBody<T, Space>> bodies,
                               const ContactManifold<T, Space>& manifold, std::span<const SolverPoint<T, Space>> points,
                               T share, std::uint32_t first_row, std::span<PointRow<T, Space>> own) {
  using Vec = typename Space::Vec;
  const SolverBody<T, Space>&a = bodies[touching.a], &b = bodies[touching.b];
  ManifoldRows<T, Space> m;
  m.a = touching.a;
  m.b = touching.b;
  m.first_row = first_row;
  m.row_count = static_cast<std::uint32_t>(points.size());
  m.first_point = manifold.first_point;
  m.normal = manifold.normal;
  m.material = touching.material;
  m.size = touching.size;
  m.inverse_mass = a.mass.mass + b.mass.mass;
  T loaded(0);
  Vec friction{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SolverPoint<T, Space>& p = points[i];
    PointRow<T, Space> r;
    const Vec at = p.position();
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
  const auto [arm_a, arm_b] = pressure_center<T, Space>(m.size, own, loaded);
  m.friction.prepare(m.normal, arm_a, arm_b, a, b);
  m.friction.take_over(m.normal, friction, points, share, own, m.material);
  m.friction.set_belt(touching.surface_b - touching.surface_a);
  return m;
}

template <class T, class Space>
void warm_start(const ManifoldRows<T, Space>& m, std::span<const PointRow<T, Space>> rows, SolverBody<T, Space>& a,
                SolverBody<T, Space>& b) {
  T pressed(0);
  typename Space::Turning angular_a = m.friction.turn(m.normal), angular_b = angular_a;
  typename Space::Turning spun_a{}, spun_b{};
  for (const PointRow<T, Space>& r : rows) {
    pressed += r.impulse;
    spun_a += r.spin_a * r.impulse;
    spun_b += r.spin_b * r.impulse;
  }
  const typename Space::Vec friction = m.friction.push();
  const typename Space::Vec push = m.normal * pressed + friction;
  angular_a += cross(m.friction.arm_a(), friction);
  angular_b += cross(m.friction.arm_b(), friction);
  a.linear -= push * a.mass.mass;
  b.linear += push * b.mass.mass;
  a.angular -= spun_a + a.mass.inertia * angular_a;
  b.angular += spun_b + b.mass.inertia * angular_b;
}

template <class T, class Space>
bool solve(ManifoldRows<T, Space>& m, std::span<PointRow<T, Space>> rows, SolverBody<T, Space>& a,
           SolverBody<T, Space>& b, const ContactStep<T>& step, bool bias) {
  // Friction at its limit loads the points otherwise, and their impulses are its limit: a few rounds agree.
  const int most = sliding_rounds;
  bool slides = true;
  for (int round = 0; round < most && slides; ++round) {
    solve_normals(m, rows, a, b, step, bias);
    slides = m.friction.solve(m.normal, rows, m.material, a, b);
  }
  return slides;
}

template <class T, class Space>
void note_pressed(const ManifoldRows<T, Space>& m, std::span<const PointRow<T, Space>> rows, bool slides,
                  SolverBody<T, Space>& a, SolverBody<T, Space>& b) {
  T pressed(0);
  for (const PointRow<T, Space>& r : rows) pressed += r.impulse;
  if (!(pressed > T(0))) return;
  for (SolverBody<T, Space>* body : {&a, &b}) {
    if (slides)
      body->press(m.normal);
    else
      body->tie();
  }
}

template <class T, class Space>
void store(const ManifoldRows<T, Space>& m, std::span<const PointRow<T, Space>> rows,
           std::span<SolverPoint<T, Space>> points, T times) {
  using Vec = typename Space::Vec;
  T pressed(0);
  Vec center{};
  for (const PointRow<T, Space>& r : rows) {
    pressed += r.impulse;
    center += r.arm_a * r.impulse;
  }
  const T inverse = inverse_or_zero(pressed);
  center = center * inverse;
  const Vec friction = m.friction.push();
  const auto twist = m.friction.spread_twist(m.normal, rows, center, pressed, inverse, m.material);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec across = (friction + cross(twist, rows[i].arm_a - center)) * (rows[i].impulse * inverse);
    points[i].impulse = (m.normal * rows[i].impulse + across) * times;
  }
}

template ContactStep<float> contact_step(const SubStep<float>&, float);
template ContactStep<double> contact_step(const SubStep<double>&, double);
template float predicted_sink(float, float, float);
template double predicted_sink(double, double, double);

#define GRAZE_CONTACT_ROWS(T, Space)                                                                                   \
  template ManifoldRows<T, Space> prepare(const TouchingBodies<T, Space>&, std::span<const SolverBody<T, Space>>,      \
                                          const ContactManifold<T, Space>&, std::span<const SolverPoint<T, Space>>, T, \
                                          std::uint32_t, std::span<PointRow<T, Space>>);                               \
  template void warm_start(const ManifoldRows<T, Space>&, std::span<const PointRow<T, Space>>, SolverBody<T, Space>&,  \
                           SolverBody<T, Space>&);                                                                     \
  template bool solve(ManifoldRows<T, Space>&, std::span<PointRow<T, Space>>, SolverBody<T, Space>&,                   \
                      SolverBody<T, Space>&, const ContactStep<T>&, bool);                                             \
  template void note_pressed(const ManifoldRows<T, Space>&, std::span<const PointRow<T, Space>>, bool,                 \
                             SolverBody<T, Space>&, SolverBody<T, Space>&);                                            \
  template void store(const ManifoldRows<T, Space>&, std::span<const PointRow<T, Space>>,                              \
                      std::span<SolverPoint<T, Space>>, T);
GRAZE_CONTACT_ROWS(float, Space<float>)
GRAZE_CONTACT_ROWS(double, Space<double>)
GRAZE_CONTACT_ROWS(float, plane::Space<float>)
GRAZE_CONTACT_ROWS(double, plane::Space<double>)
#undef GRAZE_CONTACT_ROWS

}  // namespace graze
