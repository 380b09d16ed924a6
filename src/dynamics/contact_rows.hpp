// The rows of contacts: a row along the normal for each point, and for each manifold friction at its pressure centre
// (`friction_rows.hpp`). Written once over S, a scalar or lanes, of which each has a manifold of its own.
//
// Guarantee: normal impulses push, friction stays in Coulomb's cone of the normal impulses of the same pass, in the
// passes with and without bias alike. Only + - * / and sqrt; the rows of a manifold are solved in their own order. The
// result of a lane does not depend on the others: where it has fewer rows or rounds than they, rows push nothing, and
// velocities without negative zeros (`RowVelocity`) stay bit for bit when nothing is added to them.
#pragma once

#include <span>

#include "dynamics/common_point.hpp"
#include "dynamics/contact_spring.hpp"
#include "dynamics/friction_rows.hpp"

namespace graze {

/// The material of two bodies that touch, and the motion of their surfaces.
template <class S, class Space>
struct Touching {
  ContactMaterial<S> material{};
  typename Space::Vec belt{};  ///< velocity of B's surface over A's while both bodies rest, in world space
  S size{};                    ///< the smaller of the two bodies
  typename Space::Vec rolled_a{}, rolled_b{};  ///< of arms, to the middle of the step
  S round_a{}, round_b{};                      ///< radii of the balls that the surfaces are at the contact
};

/// A point of contact as it was found.
template <class S, class Space>
struct FoundPoint {
  typename Space::Vec position{}, impulse{};  ///< the impulse is that of the last step
  S distance{};
};

/// The part of a body from which the rows of a manifold are made.
template <class S, class Space>
struct RowBody {
  typename Space::Vec first_center{};
  InverseMassIn<Space> mass{};
  RowVelocity<S, Space> velocity{};
};

/// Points that share a normal.
template <class S, class Space>
struct ManifoldRows {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;
  using Row = PointRow<S, Space>;
  using Mask = decltype(S() < S());
  using T = typename LaneOf<S>::type;
  using Bodies = RowBodies<S, Space>;

  Vec normal{};                             ///< from A to B
  InverseMassIn<Space> mass_a{}, mass_b{};  ///< when contacts were found
  CommonPoint<S, Space> common_point{};
  Touching<S, Space> touching{};
  FrictionRows<S, Space> friction{};

  /// Sets up the rows of the first `count` points for a step of duration `step`; others push nothing. `points[i]` is a
  /// `FoundPoint` for each row.
  template <class Points>
  void prepare(const RowBody<S, Space>& a, const RowBody<S, Space>& b, const Points& points, const S& count, T step,
               const WarmStart<T>& warm, std::span<Row> rows);
  void warm_start(std::span<const Row> rows, Bodies& bodies) const;
  /// One pass. With `bias` depth is recovered, without velocities alone count. Returns whether
  /// friction is at its limit.
  Mask solve(std::span<Row> rows, const ContactStep<T>& step, bool bias, Bodies& bodies);
  /// Whether any point pushes.
  Mask presses(std::span<const Row> rows) const;
  /// The fastest approach of a point that pushes.
  S approach(std::span<const Row> rows, const Bodies& bodies) const;
  /// The greatest speed at which a point that pushes parts: its impulse is too large by that.
  S parting(std::span<const Row> rows, const Bodies& bodies) const;
  /// Calls `write(i, impulse)` with the impulse of each point, `times` as large: friction is spread so that it is the
  /// same force and the same torque about the pressure centre.
  template <class F>
  void store(std::span<const Row> rows, T times, const F& write) const;

 private:
  /// The part of the smaller body's size by which a point that bears nothing yet has to come closer in a sub-step to be
  /// stopped by a rigid row: a spring would leave a part of the speed, at which fast bodies go through others.
  static constexpr T blow = T(0.005);
  /// The rounds of a pass for a manifold that slides: friction at its limit changes the loads of the points, and their
  /// impulses set its limit; a few rounds agree.
  static constexpr int sliding_rounds = 2;

  void set_pressure_center(std::span<Row> rows, const S& count, const S& loaded, Vec& arm_a, Vec& arm_b) const;
  static Vec gained_by_turning(const RowBody<S, Space>& body, const Vec& arm, T step);
  /// Returns by how much the points together push more than before.
  S solve_normals(std::span<Row> rows, const ContactStep<T>& step, bool bias, const Mask& active,
                  const ArmShifts<S, Space>& shifts, Bodies& bodies);
  ArmShifts<S, Space> shifts(const Bodies& bodies) const {
    return common_point.shifts(bodies.place_b.moved - bodies.place_a.moved);
  }
  /// The speed at which the centres of mass part along the normal.
  S parting_of_centers(const Bodies& bodies) const { return dot(bodies.b.linear - bodies.a.linear, normal); }
  /// The part of a point's speed along the normal that its bodies have by turning.
  S parting_by_turning(const Row& r, const ArmShifts<S, Space>& shifts, const Bodies& bodies) const {
    return dot(cross(r.arm_b + shifts.b, normal), bodies.b.angular) -
           dot(cross(r.arm_a + shifts.a, normal), bodies.a.angular);
  }
  S speed_along_normal(const Row& r, const ArmShifts<S, Space>& shifts, const Bodies& bodies) const {
    return parting_of_centers(bodies) + parting_by_turning(r, shifts, bodies);
  }
};

/// Sets the centre of pressure of the points, weighted by the impulses of the last step; in a new contact by how much
/// nearer each point is than the furthest, and a thousandth of the size more, so that a face has it in its middle.
template <class S, class Space>
void ManifoldRows<S, Space>::set_pressure_center(std::span<Row> rows, const S& count, const S& loaded, Vec& arm_a,
                                                 Vec& arm_b) const {
  S furthest = rows.front().separation, sum(T(0)), number(T(0));
  for (const Row& r : rows) furthest = greatest(furthest, r.separation);
  Vec center_a{}, center_b{};
  for (const Row& r : rows) {
    const S by_depth = select(number < count, furthest - r.separation + touching.size * T(0.001), S(T(0)));
    const S weight = select(loaded > S(T(0)), r.impulse, by_depth);
    sum += weight;
    center_a += r.arm_a * weight;
    center_b += r.arm_b * weight;
    number += T(1);
  }
  const S divisor = select(sum > S(T(0)), sum, S(T(1)));
  arm_a = center_a / divisor;
  arm_b = center_b / divisor;
  using std::sqrt;
  for (Row& r : rows) r.distance = sqrt(square_from_center<S>(r.arm_a, arm_a));
}

/// The velocity that the surface of a body which nothing pushes has gained at `arm` by the middle of the step, as it
/// turns. What it carries moves straight in a step: along the chord then of the arc, where along the tangent it would
/// leave a turntable.
template <class S, class Space>
auto ManifoldRows<S, Space>::gained_by_turning(const RowBody<S, Space>& body, const Vec& arm, T step) -> Vec {
  const Vec gained = cross(body.velocity.angular, cross(body.velocity.angular, arm)) * S(step * T(0.5));
  return select(body.mass.mass == S(T(0)), gained, Vec{});
}

template <class S, class Space>
template <class Points>
void ManifoldRows<S, Space>::prepare(const RowBody<S, Space>& a, const RowBody<S, Space>& b, const Points& points,
                                     const S& count, T step, const WarmStart<T>& warm, std::span<Row> rows) {
  mass_a = a.mass;
  mass_b = b.mass;
  common_point = CommonPoint<S, Space>(mass_a, mass_b);
  S loaded(T(0)), number(T(0));
  Vec across{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const FoundPoint<S, Space> p = points[i];
    Row r;
    r.arm_a = p.position - a.first_center + touching.rolled_a;
    r.arm_b = p.position - b.first_center + touching.rolled_b;
    const Turning turn_a = cross(r.arm_a, normal), turn_b = cross(r.arm_b, normal);
    r.spin_a = a.mass.inertia * turn_a;
    r.spin_b = b.mass.inertia * turn_b;
    r.separation = p.distance;
    const S effective_mass = inverse_or_zero(mass_a.mass + mass_b.mass + dot(turn_a, r.spin_a) + dot(turn_b, r.spin_b));
    r.effective_mass = select(number < count, effective_mass, S(T(0)));
    const S along = dot(p.impulse, normal);
    const S pressed = greatest(S(T(0)), along), whole = pressed * warm.share;
    r.impulse = warm.of(pressed);
    const S share = select(r.impulse < whole, r.impulse / select(pressed > S(T(0)), pressed, S(T(1))), S(warm.share));
    across += (p.impulse - normal * along) * share;
    loaded += r.impulse;
    rows[i] = r;
    number += T(1);
  }
  Vec arm_a{}, arm_b{};
  set_pressure_center(rows, count, loaded, arm_a, arm_b);
  friction.prepare(normal, arm_a, arm_b, a.mass, b.mass);
  friction.set_belt(normal, touching.belt + gained_by_turning(b, arm_b, step) - gained_by_turning(a, arm_a, step));
  friction.take_over(normal, across, points, warm.share, rows, touching.material, a.velocity, b.velocity);
}

template <class S, class Space>
void ManifoldRows<S, Space>::warm_start(std::span<const Row> rows, Bodies& bodies) const {
  S pressed(T(0));
  Turning spun_a{}, spun_b{};
  for (const Row& r : rows) {
    pressed += r.impulse;
    spun_a += r.spin_a * r.impulse;
    spun_b += r.spin_b * r.impulse;
  }
  const Vec push = friction.push(normal) + normal * pressed;
  bodies.a.linear -= push * mass_a.mass;
  bodies.b.linear += push * mass_b.mass;
  bodies.a.angular -= spun_a;
  bodies.b.angular += spun_b;
  friction.turn_by_last(mass_a, mass_b, bodies);
  shifts(bodies).turn(mass_a, mass_b, push, bodies);
}

template <class S, class Space>
S ManifoldRows<S, Space>::solve_normals(std::span<Row> rows, const ContactStep<T>& step, bool bias, const Mask& active,
                                        const ArmShifts<S, Space>& shifts, Bodies& bodies) {
  const S zero(T(0)), one(T(1)), h(step.time.h);
  const S& size = touching.size;
  const S most = fastest_push(step, size);
  // The motion of a point's two material points against each other along the normal since it was found: in place of
  // both arms the normal is turned, which all points share.
  const Vec turned_a = turned_back_by(bodies.place_a.turned, normal);
  const Vec turned_b = turned_back_by(bodies.place_b.turned, normal);
  // A ball's surface stays where it is as the ball turns about its middle, while the point of it that was found rises.
  const S moved = dot(bodies.place_b.moved - bodies.place_a.moved, normal) +
                  (touching.round_a * dot(normal, turned_a) + touching.round_b * dot(normal, turned_b));
  const Mask bounces = touching.material.restitution > zero;
  // Rows push the centres along the normal alone: their parting is one number until all have pushed.
  const S yields_to_push = mass_a.mass + mass_b.mass;
  S parting_centers = parting_of_centers(bodies), pushed = zero;
  for (Row& r : rows) {
    const S s = r.separation + (moved + dot(r.arm_b, turned_b) - dot(r.arm_a, turned_a));
    const S speed = parting_centers + parting_by_turning(r, shifts, bodies);
    const Mask apart = s > zero;
    S wanted = select(apart, -s * step.time.inverse_h, zero), mass_scale = one, impulse_scale = zero;
    if (bias) {
      wanted = select(apart, wanted, least(-s * step.soft.bias_rate, most));
      impulse_scale = select(apart, zero, S(step.soft.impulse_scale));
      const Mask yields = (r.impulse > zero) | (-speed * h < size * blow);
      mass_scale = select(apart, one, select(yields, S(step.soft.mass_scale), one));
    }
    const S change = r.effective_mass * (wanted - speed) * mass_scale - impulse_scale * r.impulse;
    // Points that bounce are not braked before they meet: the next step may be the one that strikes them.
    const Mask at_hand = bias ? active : active & ((s <= zero) | (r.impulse > zero) | !bounces);
    const S impulse = select(at_hand, greatest(zero, r.impulse + change), r.impulse);
    const S more = impulse - r.impulse;
    r.impulse = impulse;
    parting_centers += more * yields_to_push;
    pushed += more;
    bodies.a.angular -= r.spin_a * more;
    bodies.b.angular += r.spin_b * more;
  }
  bodies.a.linear -= normal * (pushed * mass_a.mass);
  bodies.b.linear += normal * (pushed * mass_b.mass);
  return pushed;
}

template <class S, class Space>
auto ManifoldRows<S, Space>::solve(std::span<Row> rows, const ContactStep<T>& step, bool bias, Bodies& bodies) -> Mask {
  Mask slides = S(T(0)) <= S(T(0));
  // A body that is put down slips in the sub-steps until its weight rests on the contact. Such slipping is not sliding:
  // up to the speed that gravity gives in a step static friction stops what stuck or was apart before, or it would
  // never be stopped where the dynamic one is too weak.
  const S slow(step.gravity * step.time.step);
  const ArmShifts<S, Space> moved = shifts(bodies);
  for (int round = 0; round < sliding_rounds && any(slides); ++round) {
    const Vec held = friction.push(normal);
    const S pushed = solve_normals(rows, step, bias, slides, moved, bodies);
    slides = friction.solve(normal, mass_a, mass_b, rows, touching.material, slow, slides, moved, bodies);
    // Once for all rows: while they push, each knows nothing of the others' shifts.
    moved.turn(mass_a, mass_b, normal * pushed + (friction.push(normal) - held), bodies);
  }
  return slides;
}

template <class S, class Space>
auto ManifoldRows<S, Space>::presses(std::span<const Row> rows) const -> Mask {
  S pressed(T(0));
  for (const Row& r : rows) pressed += r.impulse;
  return pressed > S(T(0));
}

template <class S, class Space>
S ManifoldRows<S, Space>::approach(std::span<const Row> rows, const Bodies& bodies) const {
  S fastest(T(0));
  const ArmShifts<S, Space> moved = shifts(bodies);
  for (const Row& r : rows)
    fastest = select(r.impulse > S(T(0)), greatest(fastest, -speed_along_normal(r, moved, bodies)), fastest);
  return fastest;
}

template <class S, class Space>
S ManifoldRows<S, Space>::parting(std::span<const Row> rows, const Bodies& bodies) const {
  S fastest(T(0));
  const ArmShifts<S, Space> moved = shifts(bodies);
  for (const Row& r : rows)
    fastest = select(r.impulse > S(T(0)), greatest(fastest, speed_along_normal(r, moved, bodies)), fastest);
  return fastest;
}

template <class S, class Space>
template <class F>
void ManifoldRows<S, Space>::store(std::span<const Row> rows, T times, const F& write) const {
  S pressed(T(0));
  Vec center{};
  for (const Row& r : rows) {
    pressed += r.impulse;
    center += r.arm_a * r.impulse;
  }
  const S inverse = inverse_or_zero(pressed);
  center = center * inverse;
  const Vec push = friction.push(normal);
  const Turning twist = friction.spread_twist(normal, rows, center, pressed, inverse, touching.material);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec across = (push + cross(twist, rows[i].arm_a - center)) * (rows[i].impulse * inverse);
    write(i, (normal * rows[i].impulse + across) * times);
  }
}

}  // namespace graze
