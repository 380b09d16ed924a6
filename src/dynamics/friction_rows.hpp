// Friction of a manifold at its pressure centre: in space two rows on a round cone, a twist about the normal, and
// rolling; in the plane one row along the contact, and rolling.
//
// Guarantee: friction stays in Coulomb's cone of the normal impulses that it is solved with. Only + - * / and sqrt.
#pragma once

#include <span>

#include "dynamics/solver_body.hpp"
#include "graze/material.hpp"

namespace graze {

/// A point of contact.
template <class T, class Space>
struct PointRow {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;

  Vec arm_a{}, arm_b{};        ///< from the centres of mass, where contacts were found
  Turning turn_a{}, turn_b{};  ///< arm × normal
  Turning spin_a{}, spin_b{};  ///< what an impulse of 1 does to the angular velocities
  T separation{};              ///< where contacts were found
  T effective_mass{};
  T impulse{};   ///< λ of a sub-step, >= 0
  T distance{};  ///< from the pressure centre
};

template <class T>
T inverse_or_zero(T value) {
  return value > T(0) ? T(1) / value : T(0);
}

template <class T, class Space>
class FrictionRows;

template <class T>
class FrictionRows<T, Space<T>> {
  using Body = SolverBody<T, Space<T>>;
  using Rows = std::span<const PointRow<T, Space<T>>>;

 public:
  /// About the pressure centre, seen from the centres of mass.
  void prepare(const Vec3<T>& normal, const Vec3<T>& arm_a, const Vec3<T>& arm_b, const Body& a, const Body& b) {
    u_ = any_perpendicular(normal);
    v_ = cross(normal, u_);
    arm_a_ = arm_a;
    arm_b_ = arm_b;
    // The inverse of the tangential 2×2 block of K (see `impulse.hpp`).
    const auto k = [&](const Vec3<T>& x, const Vec3<T>& y) {
      return dot(cross(arm_a, x), a.mass.inertia * cross(arm_a, y)) +
             dot(cross(arm_b, x), b.mass.inertia * cross(arm_b, y));
    };
    const T mass = a.mass.mass + b.mass.mass;
    const T uu = mass + k(u_, u_), vv = mass + k(v_, v_), uv = k(u_, v_);
    const T inverse = inverse_or_zero(uu * vv - uv * uv);
    mass_[0] = vv * inverse;
    mass_[1] = -uv * inverse;
    mass_[2] = uu * inverse;
    twist_mass_ = inverse_or_zero(dot(normal, (a.mass.inertia + b.mass.inertia) * normal));
  }

  /// Takes over what the points pushed in the last step, `share` of it: `friction` across the normal, and the twist.
  /// A point that was lost took its share of the pressure along, and others' shares may not hold without it.
  template <class Points>
  void take_over(const Vec3<T>& normal, const Vec3<T>& friction, const Points& points, T share, Rows rows,
                 const ContactMaterial<T>& material) {
    push_u_ = dot(friction, u_);
    push_v_ = dot(friction, v_);
    T loaded(0), lever(0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      twist_ += dot(cross(rows[i].arm_a - arm_a_, points[i].impulse * share), normal);
      loaded += rows[i].impulse;
      lever += rows[i].impulse * rows[i].distance;
    }
    const T held = std::sqrt(push_u_ * push_u_ + push_v_ * push_v_);
    const T most = material.static_friction * loaded;
    if (held > most) {
      push_u_ *= most / held;
      push_v_ *= most / held;
    }
    const T twist_limit = material.dynamic_friction * lever;
    twist_ = clamp(twist_, -twist_limit, twist_limit);
  }

  /// How the surface of B runs over that of A by itself.
  void set_belt(const Vec3<T>& belt) {
    belt_u_ = dot(belt, u_);
    belt_v_ = dot(belt, v_);
  }

  void scale(T part) {
    push_u_ *= part;
    push_v_ *= part;
    twist_ *= part;
  }

  /// Friction with the total impulse of the points at hand; tells whether it reached its limit.
  bool solve(const Vec3<T>& normal, Rows rows, const ContactMaterial<T>& material, Body& a, Body& b) {
    T pressed(0), lever(0);
    for (const auto& r : rows) {
      pressed += r.impulse;
      lever += r.impulse * r.distance;
    }
    const Vec3<T> turning = b.angular - a.angular;
    const T twist_limit = material.dynamic_friction * lever;
    const T twist = clamp(twist_ - twist_mass_ * dot(turning, normal), -twist_limit, twist_limit);
    const Vec3<T> twisted = normal * (twist - twist_);
    twist_ = twist;
    a.angular -= a.mass.inertia * twisted;
    b.angular += b.mass.inertia * twisted;

    if (material.rolling_friction > T(0)) {
      const Vec3<T> rolls = b.angular - a.angular;
      const Vec3<T> axis = normalized(rolls);
      const T mass = inverse_or_zero(dot(axis, (a.mass.inertia + b.mass.inertia) * axis));
      Vec3<T> rolling = rolling_ - rolls * mass;
      const T limit = material.rolling_friction * pressed, l = length(rolling);
      if (l > limit) rolling *= limit / l;
      a.angular -= a.mass.inertia * (rolling - rolling_);
      b.angular += b.mass.inertia * (rolling - rolling_);
      rolling_ = rolling;
    }

    const Vec3<T> slip = b.velocity(arm_b_) - a.velocity(arm_a_);
    const T su = dot(slip, u_) + belt_u_, sv = dot(slip, v_) + belt_v_;
    T fu = push_u_ - (mass_[0] * su + mass_[1] * sv);
    T fv = push_v_ - (mass_[1] * su + mass_[2] * sv);
    const T needed = std::sqrt(fu * fu + fv * fv);
    const bool slides = needed > material.static_friction * pressed;
    if (slides) {
      const T shorter = least(T(1), material.dynamic_friction * pressed / needed);
      fu *= shorter;
      fv *= shorter;
    }
    const Vec3<T> push = u_ * (fu - push_u_) + v_ * (fv - push_v_);
    push_u_ = fu;
    push_v_ = fv;
    a.push(-push, arm_a_);
    b.push(push, arm_b_);
    return slides;
  }

  /// What is pushed across the normal, and turned besides.
  Vec3<T> push() const { return u_ * push_u_ + v_ * push_v_; }
  Vec3<T> turn(const Vec3<T>& normal) const { return normal * twist_ + rolling_; }
  const Vec3<T>& arm_a() const { return arm_a_; }
  const Vec3<T>& arm_b() const { return arm_b_; }

  /// The twist as pushes on the points, which each push `cross` of this and its way from the pressure centre, times its
  /// part of the pressure: no point holds more of it than its own friction would. `inverse` is that of the pressure.
  Vec3<T> spread_twist(const Vec3<T>& normal, Rows rows, const Vec3<T>& center, T pressed, T inverse,
                       const ContactMaterial<T>& material) const {
    T lever(0), furthest(0);
    for (const auto& r : rows) {
      const T square = length_squared(r.arm_a - center);
      lever += r.impulse * inverse * square;
      if (r.impulse > T(0)) furthest = greatest(furthest, square);
    }
    const T most = material.dynamic_friction * pressed * inverse_or_zero(std::sqrt(furthest));
    return normal * clamp(twist_ * inverse_or_zero(lever), -most, most);
  }

 private:
  Vec3<T> u_{}, v_{};          ///< across the normal
  Vec3<T> arm_a_{}, arm_b_{};  ///< of the pressure centre
  T mass_[3]{};                ///< the inverse of the 2×2 block of u and v: uu, uv, vv
  T push_u_{}, push_v_{};
  T twist_mass_{}, twist_{};
  Vec3<T> rolling_{};
  T belt_u_{}, belt_v_{};
};

template <class T>
class FrictionRows<T, plane::Space<T>> {
  using Vec = plane::Vec2<T>;
  using Body = SolverBody<T, plane::Space<T>>;
  using Rows = std::span<const PointRow<T, plane::Space<T>>>;

 public:
  void prepare(const Vec& normal, const Vec& arm_a, const Vec& arm_b, const Body& a, const Body& b) {
    u_ = left(normal);
    arm_a_ = arm_a;
    arm_b_ = arm_b;
    turn_a_ = cross(arm_a, u_);
    turn_b_ = cross(arm_b, u_);
    mass_ = inverse_or_zero(a.mass.mass + b.mass.mass + turn_a_ * (a.mass.inertia * turn_a_) +
                            turn_b_ * (b.mass.inertia * turn_b_));
    rolling_mass_ = inverse_or_zero(a.mass.inertia + b.mass.inertia);
  }

  template <class Points>
  void take_over(const Vec&, const Vec& friction, const Points&, T, Rows rows, const ContactMaterial<T>& material) {
    T loaded(0);
    for (const auto& r : rows) loaded += r.impulse;
    const T most = material.static_friction * loaded;
    push_ = clamp(dot(friction, u_), -most, most);
  }

  void set_belt(const Vec& belt) { belt_ = dot(belt, u_); }
  void scale(T part) { push_ *= part; }

  bool solve(const Vec&, Rows rows, const ContactMaterial<T>& material, Body& a, Body& b) {
    T pressed(0);
    for (const auto& r : rows) pressed += r.impulse;
    if (material.rolling_friction > T(0)) {
      const T limit = material.rolling_friction * pressed;
      const T rolling = clamp(rolling_ - (b.angular - a.angular) * rolling_mass_, -limit, limit);
      a.angular -= a.mass.inertia * (rolling - rolling_);
      b.angular += b.mass.inertia * (rolling - rolling_);
      rolling_ = rolling;
    }
    const T slip = dot(b.linear - a.linear, u_) + turn_b_ * b.angular - turn_a_ * a.angular + belt_;
    T push = push_ - mass_ * slip;
    const bool slides = std::abs(push) > material.static_friction * pressed;
    if (slides) {
      const T limit = material.dynamic_friction * pressed;
      push = clamp(push, -limit, limit);
    }
    const T more = push - push_;
    push_ = push;
    a.linear -= u_ * (more * a.mass.mass);
    b.linear += u_ * (more * b.mass.mass);
    a.angular -= a.mass.inertia * (turn_a_ * more);
    b.angular += b.mass.inertia * (turn_b_ * more);
    return slides;
  }

  Vec push() const { return u_ * push_; }
  T turn(const Vec&) const { return rolling_; }
  const Vec& arm_a() const { return arm_a_; }
  const Vec& arm_b() const { return arm_b_; }
  /// Nothing twists about a normal of the plane.
  T spread_twist(const Vec&, Rows, const Vec&, T, T, const ContactMaterial<T>&) const { return T(0); }

 private:
  Vec u_{};                ///< across the normal
  Vec arm_a_{}, arm_b_{};  ///< of the pressure centre
  T turn_a_{}, turn_b_{};  ///< arm × u
  T mass_{}, push_{};
  T rolling_mass_{}, rolling_{};
  T belt_{};
};

}  // namespace graze
