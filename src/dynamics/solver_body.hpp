// A body as rows of the solver see it.
//
// Guarantee: a plain value, the only thing that contacts and joints read and write of a body within a sub-step. A body
// that is fixed, kinematic or of infinite mass has zero inverses and the velocity that it is given, so that no row
// needs a case of its own for it.
#pragma once

#include "dynamics/row_bodies.hpp"

namespace graze {

/// The direction in which contacts press a body in a sub-step; over S, a scalar or lanes.
template <class S, class Space>
struct Pressure {
  using T = typename LaneOf<S>::type;

  static constexpr T none = T(0), along_normal = T(1), everywhere = T(2);

  typename Space::Vec normal{};
  S kind = S(none);

  /// Records that a contact presses along its normal, and, where it does not slide, holds in all directions.
  template <class Mask>
  void add(const typename Space::Vec& along, const Mask& presses, const Mask& slides) {
    using std::abs;
    const Mask before = kind > S(none);
    const Mask across = before & (abs(dot(along, normal)) < S(T(0.999)));
    const Mask first = presses & slides & !before;
    normal = select(first, along, normal);
    kind = select(presses & (across | !slides), S(everywhere), select(first, S(along_normal), kind));
  }
};

template <class T, class Space = graze::Space<T>>
struct SolverBody {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;

  // Members that lanes load at once stand together: `RowVelocity`, `RowPlace`, `Pressure`.
  Vec linear{};  ///< of the centre of mass, in world space
  Turning angular{};
  Vec moved{};                 ///< center - first_center
  RotationIn<Space> turned{};  ///< from first_rotation to rotation
  Pressure<T, Space> pressure{};
  InverseMassIn<Space> mass{};  ///< in world space, of this step
  Vec linear_before{};          ///< at the beginning of the sub-step
  Turning angular_before{};
  // Places of the body now, and when its contacts were found: those of the centre of mass and the principal axes.
  Vec center{}, first_center{};
  RotationIn<Space> rotation{}, first_rotation{};

  void tie() { pressure.kind = pressure.everywhere; }
  Vec velocity(const Vec& arm) const { return linear + cross(angular, arm); }
  /// Pushes by `impulse` at `arm` from the centre.
  void push(const Vec& impulse, const Vec& arm) {
    linear += impulse * mass.mass;
    angular += mass.inertia * cross(arm, impulse);
  }
};

/// A sub-step of duration h of an island. A body that rows press moves by h v₁ in it, v₁ being its velocity once the
/// rows were solved with bias, so that a row that is to move it by d has the target velocity d / h; all other bodies
/// move by h (v₀ + v₁) / 2 (`moving_velocity` in `body_motion.kernel.cpp`). Bodies on joints move by the mean too,
/// unless contacts press something in the island: bodies that both hold have to be moved by one rule.
template <class T>
struct SubStep {
  T h{};
  T inverse_h{};
  T step{};               ///< the whole step
  bool joined_by_mean{};  ///< bodies of joints move by the mean of their velocities
};

/// The coefficients of a soft row (Catto 2011, "Soft constraints"), an implicit spring of angular frequency w and
/// damping ratio z: the row's impulse is -effective_mass (velocity + bias_rate error) mass_scale - impulse_scale λ.
template <class T>
struct Softness {
  T bias_rate{}, mass_scale = T(1), impulse_scale{};
};

/// The softness of frequency `w` (in radians per unit of time) and damping ratio `z` in sub-steps of h.
template <class T>
constexpr Softness<T> softness(T w, T z, T h) {
  const T a1 = T(2) * z + h * w, a2 = h * w * a1, a3 = T(1) / (T(1) + a2);
  return {w / a1, a2 * a3, a3};
}

}  // namespace graze
