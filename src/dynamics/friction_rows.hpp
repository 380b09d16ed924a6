// Friction of a manifold at its pressure centre: in space two rows on a round cone, a twist about the normal, and
// rolling; in the plane one row along the contact, and rolling. Over S, a scalar or lanes (`contact_rows.hpp`).
//
// Guarantee: friction stays in Coulomb's cone of the normal impulses that it is solved with. Only + - * / and sqrt.
#pragma once

#include <limits>
#include <span>

#include "dynamics/common_point.hpp"
#include "dynamics/row_bodies.hpp"
#include "graze/material.hpp"

namespace graze {

/// A point of contact.
template <class S, class Space>
struct PointRow {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;

  Vec arm_a{}, arm_b{};        ///< from the centres of mass, where contacts were found
  Turning spin_a{}, spin_b{};  ///< change of the angular velocities by an impulse of 1
  S separation{};              ///< where contacts were found
  S effective_mass{};
  S impulse{};   ///< λ of a sub-step, >= 0
  S distance{};  ///< from the pressure centre
};

template <class S>
S inverse_or_zero(const S& value) {
  const auto positive = value > S(0);
  return select(positive, S(1) / select(positive, value, S(1)), S(0));
}

/// The sum of the impulses that press two bodies together.
template <class S, class Rows>
S load_of(const Rows& rows) {
  S loaded(0);
  for (const auto& r : rows) loaded += r.impulse;
  return loaded;
}

/// The square of a point's distance from the pressure centre, zero where it is but the centre's rounding: a twist would
/// be laid on the one point that bears anything as a push across the normal, up to all that friction holds.
template <class S, class Vec>
S square_from_center(const Vec& arm, const Vec& center) {
  using T = typename LaneOf<S>::type;
  constexpr T rounding = T(16) * std::numeric_limits<T>::epsilon();
  const S square = length_squared(arm - center);
  return select(square > length_squared(arm) * S(rounding * rounding), square, S(0));
}

/// Whether friction of size `held` was at a limit of Coulomb's cone, where it is exactly, but for rounding, as long as
/// surfaces slide: at that of rest, which sliding begins with, or at that of motion. Between the two they stick.
template <class S>
auto at_limit(const S& held, const S& pressed, const ContactMaterial<S>& material) {
  using T = typename LaneOf<S>::type;
  const S rest = material.static_friction * pressed, motion = material.dynamic_friction * pressed;
  const S rounding(T(0.001));
  return (pressed > S(T(0))) & ((held >= rest - rest * rounding) |
                                ((held >= motion - motion * rounding) & (held <= motion + motion * rounding)));
}

/// The part of what friction can hold that is left for one of two motions of a surface, sliding and twisting, of which
/// each has a speed beyond that of surfaces at rest. Friction acts against the velocity of each place, so that what
/// slides fast hardly resists a slow twist, and the other way round: the limit surface as an ellipsoid (Howe, Cutkosky
/// 1996, "Practical force-motion models for sliding manipulation", section 3).
template <class S>
S left_for(const S& speed, const S& other, const S& at_rest) {
  using std::sqrt;
  using T = typename LaneOf<S>::type;
  const S beyond = greatest(S(T(0)), other - at_rest), both = sqrt(speed * speed + beyond * beyond);
  return select(beyond > S(T(0)), speed / select(both > S(T(0)), both, S(T(1))), S(T(1)));
}

/// The part of the speed that gravity gives in a step up to which surfaces stick whatever their friction was. Measured:
/// a resting cube that is pushed by 0.99 of what static friction holds rocks, and creeps by more than 0.02 of it
/// meanwhile.
template <class T>
constexpr T creeping = T(0.1);

template <class S, class Space>
class FrictionRows;

template <class S>
class FrictionRows<S, Space<S>> {
  using Vec = Vec3<S>;
  using Bodies = RowBodies<S, Space<S>>;
  using Shifts = ArmShifts<S, Space<S>>;
  using Rows = std::span<const PointRow<S, Space<S>>>;
  using Mask = decltype(S() < S());
  using T = typename LaneOf<S>::type;

 public:
  /// Sets up the rows at the pressure centre, to which `arm_a` and `arm_b` lead from the centres of mass.
  void prepare(const Vec& normal, const Vec& arm_a, const Vec& arm_b, const InverseMass<S>& a,
               const InverseMass<S>& b) {
    u_ = any_perpendicular(normal);
    const Vec v = cross(normal, u_);
    arm_a_ = arm_a;
    arm_b_ = arm_b;
    const Vec turn_ua = cross(arm_a, u_), turn_ub = cross(arm_b, u_), turn_va = cross(arm_a, v),
              turn_vb = cross(arm_b, v);
    spin_ua_ = a.inertia * turn_ua;
    spin_ub_ = b.inertia * turn_ub;
    spin_va_ = a.inertia * turn_va;
    spin_vb_ = b.inertia * turn_vb;
    spin_na_ = a.inertia * normal;
    spin_nb_ = b.inertia * normal;
    // The inverse of the tangential 2×2 block of K (see `impulse.hpp`).
    const S mass = a.mass + b.mass;
    const S uu = mass + (dot(turn_ua, spin_ua_) + dot(turn_ub, spin_ub_));
    const S vv = mass + (dot(turn_va, spin_va_) + dot(turn_vb, spin_vb_));
    const S uv = dot(turn_ua, spin_va_) + dot(turn_ub, spin_vb_);
    const S inverse = inverse_or_zero(uu * vv - uv * uv);
    mass_[0] = vv * inverse;
    mass_[1] = -uv * inverse;
    mass_[2] = uu * inverse;
    twist_mass_ = inverse_or_zero(dot(normal, spin_na_ + spin_nb_));
  }

  /// Takes over the part `share` of the impulses of the last step: `friction` across the normal, and the twist. They
  /// are limited anew: a point that was lost took its part of the pressure along, and the rest may not hold as much.
  /// Surfaces slide on if their friction was at its limit, with the velocities `a` and `b` that the step begins with.
  template <class Points>
  void take_over(const Vec& normal, const Vec& friction, const Points& points, T share, Rows rows,
                 const ContactMaterial<S>& material, const RowVelocity<S, Space<S>>& a,
                 const RowVelocity<S, Space<S>>& b) {
    using std::sqrt;
    S loaded(0), lever(0), twist(0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      twist += dot(cross(rows[i].arm_a - arm_a_, points[i].impulse * share), normal);
      loaded += rows[i].impulse;
      lever += rows[i].impulse * rows[i].distance;
    }
    const S u = dot(friction, u_), v = dot(friction, cross(normal, u_));
    const S held = sqrt(u * u + v * v), most = material.static_friction * loaded;
    const auto beyond = held > most;
    const S su = slip_along(u_, belt_u_, {}, a, b), sv = slip_along(cross(normal, u_), belt_v_, {}, a, b);
    slid_ = select(at_limit(held, loaded, material), sqrt(su * su + sv * sv), S(0));
    const S shorter = select(beyond, most / select(beyond, held, S(1)), S(1));
    push_u_ = u * shorter;
    push_v_ = v * shorter;
    const S twist_limit = material.dynamic_friction * lever;
    twist_ = clamp(twist, -twist_limit, twist_limit);
  }

  /// Takes over an angular impulse that resisted rolling, no more of it than the points that are left hold.
  void take_over_rolling(const Vec& rolling, Rows rows, const ContactMaterial<S>& material) {
    rolling_ = no_longer_than(material.rolling_friction * load_of<S>(rows), rolling);
  }

  /// Sets the velocity of B's surface over A's while both bodies rest.
  void set_belt(const Vec& normal, const Vec& belt) {
    belt_u_ = dot(belt, u_);
    belt_v_ = dot(belt, cross(normal, u_));
  }

  /// Turns the bodies by the impulses of the last step.
  void turn_by_last(const InverseMass<S>& a, const InverseMass<S>& b, Bodies& bodies) const {
    bodies.a.angular -= spin_ua_ * push_u_ + spin_va_ * push_v_ + spin_na_ * twist_;
    bodies.b.angular += spin_ub_ * push_u_ + spin_vb_ * push_v_ + spin_nb_ * twist_;
    if (bodies.roll) roll(rolling_, a, b, bodies);
  }

  /// Solves friction with the total impulse of the points at hand, in the active lanes; returns whether it reached its
  /// limit there. Surfaces that begin to slide count as at rest up to the speed `slow`.
  Mask solve(const Vec& normal, const InverseMass<S>& a, const InverseMass<S>& b, Rows rows,
             const ContactMaterial<S>& material, const S& slow, const Mask& active, const Shifts& shifts,
             Bodies& bodies) {
    S pressed(0), lever(0);
    for (const auto& r : rows) {
      pressed += r.impulse;
      lever += r.impulse * r.distance;
    }
    using std::sqrt, std::abs;
    const S su = slip_along(u_, belt_u_, shifts, bodies.a, bodies.b);
    const S sv = slip_along(cross(normal, u_), belt_v_, shifts, bodies.a, bodies.b);
    const S slip = sqrt(su * su + sv * sv), mean_lever = lever * inverse_or_zero(pressed);
    const S turning = abs(dot(bodies.b.angular - bodies.a.angular, normal)) * mean_lever;
    solve_twist(normal, material.dynamic_friction * lever * left_for(turning, slip, slow), active, bodies);
    if (bodies.roll) solve_rolling(material.rolling_friction * pressed, active, a, b, bodies);
    return solve_sliding(normal, a, b, pressed * left_for(slip, turning, slow), material, slow, active, shifts, bodies);
  }

  /// The impulse across the normal.
  Vec push(const Vec& normal) const { return u_ * push_u_ + cross(normal, u_) * push_v_; }
  /// The angular impulse that resists rolling, on B.
  const Vec& rolling() const { return rolling_; }

  /// The twist as pushes on the points: each gets the cross product of this vector and its way from the
  /// pressure centre, times its part of the pressure, and no point more than its own friction could hold.
  /// `inverse`: of the pressure.
  Vec spread_twist(const Vec& normal, Rows rows, const Vec& center, const S& pressed, const S& inverse,
                   const ContactMaterial<S>& material) const {
    using std::sqrt;
    S lever(0), furthest(0);
    for (const auto& r : rows) {
      const S square = square_from_center<S>(r.arm_a, center);
      lever += r.impulse * inverse * square;
      furthest = select(r.impulse > S(0), greatest(furthest, square), furthest);
    }
    const S most = material.dynamic_friction * pressed * inverse_or_zero(sqrt(furthest));
    return normal * clamp(twist_ * inverse_or_zero(lever), -most, most);
  }

 private:
  /// The speed along `axis` at which B's surface slides over A's at the pressure centre.
  S slip_along(const Vec& axis, const S& belt, const Shifts& shifts, const RowVelocity<S, Space<S>>& a,
               const RowVelocity<S, Space<S>>& b) const {
    const Vec slip =
        (b.linear + cross(b.angular, arm_b_ + shifts.b)) - (a.linear + cross(a.angular, arm_a_ + shifts.a));
    return dot(slip, axis) + belt;
  }
  void solve_twist(const Vec& normal, const S& limit, const Mask& active, Bodies& bodies) {
    const S turning = dot(bodies.b.angular - bodies.a.angular, normal);
    const S twist = select(active, clamp(twist_ - twist_mass_ * turning, -limit, limit), twist_);
    const S more = twist - twist_;
    twist_ = twist;
    bodies.a.angular -= spin_na_ * more;
    bodies.b.angular += spin_nb_ * more;
  }

  void solve_rolling(const S& limit, const Mask& active, const InverseMass<S>& a, const InverseMass<S>& b,
                     Bodies& bodies) {
    const Vec rolls = bodies.b.angular - bodies.a.angular, axis = normalized(rolls);
    const S mass = inverse_or_zero(dot(axis, (a.inertia + b.inertia) * axis));
    const Vec rolling = select(active, no_longer_than(limit, rolling_ - rolls * mass), rolling_);
    roll(rolling - rolling_, a, b, bodies);
    rolling_ = rolling;
  }
  static Vec no_longer_than(const S& limit, const Vec& v) {
    const S l = length(v);
    const auto beyond = l > limit;
    return v * select(beyond, limit / select(beyond, l, S(1)), S(1));
  }
  static void roll(const Vec& torque, const InverseMass<S>& a, const InverseMass<S>& b, Bodies& bodies) {
    bodies.a.angular -= a.inertia * torque;
    bodies.b.angular += b.inertia * torque;
  }

  Mask solve_sliding(const Vec& normal, const InverseMass<S>& a, const InverseMass<S>& b, const S& pressed,
                     const ContactMaterial<S>& material, const S& slow, const Mask& active, const Shifts& shifts,
                     Bodies& bodies) {
    using std::sqrt;
    const Vec v = cross(normal, u_);
    const S su = slip_along(u_, belt_u_, shifts, bodies.a, bodies.b);
    const S sv = slip_along(v, belt_v_, shifts, bodies.a, bodies.b);
    const S fu = push_u_ - (mass_[0] * su + mass_[1] * sv), fv = push_v_ - (mass_[1] * su + mass_[2] * sv);
    const S needed = sqrt(fu * fu + fv * fv);
    const S held = select(slid_ > slow * creeping<T>, material.dynamic_friction, material.static_friction) * pressed;
    const Mask slides = active & (needed > held);
    const S limit = select(slow * slow < su * su + sv * sv, material.dynamic_friction * pressed, held);
    const S shorter = select(slides, least(S(1), limit / select(slides, needed, S(1))), S(1));
    const S push_u = select(active, fu * shorter, push_u_), push_v = select(active, fv * shorter, push_v_);
    const S more_u = push_u - push_u_, more_v = push_v - push_v_;
    push_u_ = push_u;
    push_v_ = push_v;
    const Vec push = u_ * more_u + v * more_v;
    bodies.a.linear -= push * a.mass;
    bodies.b.linear += push * b.mass;
    bodies.a.angular -= spin_ua_ * more_u + spin_va_ * more_v;
    bodies.b.angular += spin_ub_ * more_u + spin_vb_ * more_v;
    return slides;
  }

  Vec u_{};                ///< across the normal; v is across both
  Vec arm_a_{}, arm_b_{};  ///< of the pressure centre
  Vec spin_ua_{}, spin_ub_{}, spin_va_{},
      spin_vb_{};              ///< changes of the angular velocities by an impulse of 1 along u or v
  Vec spin_na_{}, spin_nb_{};  ///< changes by an angular impulse of 1 about the normal
  S mass_[3]{};                ///< the inverse of the 2×2 block of u and v: uu, uv, vv
  S push_u_{}, push_v_{};
  S twist_mass_{}, twist_{};
  Vec rolling_{};
  S belt_u_{}, belt_v_{};
  S slid_{};  ///< the speed of sliding when the step began; 0 where the surfaces stuck
};

template <class S>
class FrictionRows<S, plane::Space<S>> {
  using Vec = plane::Vec2<S>;
  using Bodies = RowBodies<S, plane::Space<S>>;
  using Shifts = ArmShifts<S, plane::Space<S>>;
  using Rows = std::span<const PointRow<S, plane::Space<S>>>;
  using Mask = decltype(S() < S());
  using T = typename LaneOf<S>::type;
  using Mass = plane::InverseMass<S>;

 public:
  void prepare(const Vec& normal, const Vec& arm_a, const Vec& arm_b, const Mass& a, const Mass& b) {
    const Vec u = left(normal);
    turn_a_ = cross(arm_a, u);
    turn_b_ = cross(arm_b, u);
    spin_a_ = a.inertia * turn_a_;
    spin_b_ = b.inertia * turn_b_;
    mass_ = inverse_or_zero(a.mass + b.mass + turn_a_ * spin_a_ + turn_b_ * spin_b_);
    rolling_mass_ = inverse_or_zero(a.inertia + b.inertia);
  }

  template <class Points>
  void take_over(const Vec& normal, const Vec& friction, const Points&, T, Rows rows,
                 const ContactMaterial<S>& material, const RowVelocity<S, plane::Space<S>>& a,
                 const RowVelocity<S, plane::Space<S>>& b) {
    const S loaded = load_of<S>(rows), most = material.static_friction * loaded, held = dot(friction, left(normal));
    slid_ = select(at_limit(abs_of(held), loaded, material), abs_of(slip(normal, {}, a, b)), S(0));
    push_ = clamp(held, -most, most);
  }

  void take_over_rolling(const S& rolling, Rows rows, const ContactMaterial<S>& material) {
    const S most = material.rolling_friction * load_of<S>(rows);
    rolling_ = clamp(rolling, -most, most);
  }

  void set_belt(const Vec& normal, const Vec& belt) { belt_ = dot(belt, left(normal)); }

  void turn_by_last(const Mass& a, const Mass& b, Bodies& bodies) const {
    spin(push_, bodies);
    if (bodies.roll) roll(rolling_, a, b, bodies);
  }

  Mask solve(const Vec& normal, const Mass& a, const Mass& b, Rows rows, const ContactMaterial<S>& material,
             const S& slow, const Mask& active, const Shifts& shifts, Bodies& bodies) {
    S pressed(0);
    for (const auto& r : rows) pressed += r.impulse;
    if (bodies.roll) solve_rolling(material.rolling_friction * pressed, active, a, b, bodies);
    const S speed = slip(normal, shifts, bodies.a, bodies.b);
    const S needed = push_ - mass_ * speed;
    const S held = select(slid_ > slow * creeping<T>, material.dynamic_friction, material.static_friction) * pressed;
    const Mask slides = active & (abs_of(needed) > held);
    const S limit = select(slow < abs_of(speed), material.dynamic_friction * pressed, held);
    const S push = select(active, select(slides, clamp(needed, -limit, limit), needed), push_);
    const S more = push - push_;
    push_ = push;
    const Vec along = left(normal) * more;
    bodies.a.linear -= along * a.mass;
    bodies.b.linear += along * b.mass;
    spin(more, bodies);
    return slides;
  }

  Vec push(const Vec& normal) const { return left(normal) * push_; }
  const S& rolling() const { return rolling_; }
  /// Zero: in the plane nothing twists about a normal.
  S spread_twist(const Vec&, Rows, const Vec&, const S&, const S&, const ContactMaterial<S>&) const { return S(0); }

 private:
  static S abs_of(const S& x) {
    using std::abs;
    return abs(x);
  }
  /// The speed at which B's surface slides over A's.
  S slip(const Vec& normal, const Shifts& shifts, const RowVelocity<S, plane::Space<S>>& a,
         const RowVelocity<S, plane::Space<S>>& b) const {
    const Vec u = left(normal);
    return dot(b.linear - a.linear, u) + (turn_b_ + cross(shifts.b, u)) * b.angular -
           (turn_a_ + cross(shifts.a, u)) * a.angular + belt_;
  }
  void spin(const S& push, Bodies& bodies) const {
    bodies.a.angular -= spin_a_ * push;
    bodies.b.angular += spin_b_ * push;
  }
  void solve_rolling(const S& limit, const Mask& active, const Mass& a, const Mass& b, Bodies& bodies) {
    const S wanted = clamp(rolling_ - (bodies.b.angular - bodies.a.angular) * rolling_mass_, -limit, limit);
    const S rolling = select(active, wanted, rolling_);
    roll(rolling - rolling_, a, b, bodies);
    rolling_ = rolling;
  }
  static void roll(const S& torque, const Mass& a, const Mass& b, Bodies& bodies) {
    bodies.a.angular -= a.inertia * torque;
    bodies.b.angular += b.inertia * torque;
  }

  S turn_a_{}, turn_b_{};  ///< arm of the pressure centre × the direction across the normal
  S spin_a_{}, spin_b_{};  ///< changes of the angular velocities by an impulse of 1 across the normal
  S mass_{}, push_{};
  S rolling_mass_{}, rolling_{};
  S belt_{};
  S slid_{};  ///< as in space
};

}  // namespace graze
