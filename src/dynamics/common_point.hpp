// The arms of contacts while bodies move.
//
// Rows have the arms from the centres of mass to where contacts were found. Once the bodies have moved against each
// other these lead to two points, and an impulse at one with its opposite at the other is a torque out of nothing. So
// both arms are shifted to one point again, which moves with the centres of mass, most with that of the lighter body.
//
// Guarantee: what rows with shifted arms push changes the angular momentum of two bodies together by rounding alone.
// Arms beside a body that nothing pushes stay bit for bit.
#pragma once

#include "dynamics/row_bodies.hpp"

namespace graze {

/// The ways by which the arms of two bodies have to be shifted.
template <class S, class Space>
struct ArmShifts {
  using Vec = typename Space::Vec;
  using Mass = InverseMassIn<Space>;

  Vec a{}, b{};

  /// Adds the turning of `push` at the shifted arms beyond that at the arms that rows began with, which the bodies
  /// have.
  void turn(const Mass& mass_a, const Mass& mass_b, const Vec& push, RowBodies<S, Space>& bodies) const {
    bodies.a.angular -= mass_a.inertia * cross(a, push);
    bodies.b.angular += mass_b.inertia * cross(b, push);
  }
};

/// The point of a manifold as its bodies move.
template <class S, class Space>
class CommonPoint {
 public:
  CommonPoint() = default;
  CommonPoint(const InverseMassIn<Space>& a, const InverseMassIn<Space>& b) {
    const S zero(0), one(1);
    const auto both = (a.mass > zero) & (b.mass > zero);
    const S sum = select(both, a.mass + b.mass, one);
    part_a_ = select(both, b.mass / sum, zero);
    part_b_ = select(both, a.mass / sum, zero);
  }

  /// The shifts of the arms when B's centre has moved by `gap` against A's.
  ArmShifts<S, Space> shifts(const typename Space::Vec& gap) const { return {gap * part_a_, gap * -part_b_}; }

 private:
  S part_a_{}, part_b_{};  ///< of the gap that an arm is shifted by; together 1, or 0 beside what nothing pushes
};

}  // namespace graze
