// A body as rows of the solver see it.
//
// Guarantee: a plain value, the only thing that contacts and joints read and write of a body within a sub-step. A body
// that is fixed, kinematic or of infinite mass has zero inverses and the velocity that it is given, so that no row
// needs a case of its own for it.
#pragma once

#include "dynamics/rigid_space.hpp"

namespace graze {

template <class T, class Space = graze::Space<T>>
struct SolverBody {
  using Vec = typename Space::Vec;
  using Turning = typename Space::Turning;

  Vec linear{};  ///< of the centre of mass, in world space
  Turning angular{};
  Vec linear_before{};  ///< the same at the beginning of the sub-step
  Turning angular_before{};
  InverseMassIn<Space> mass{};  ///< in world space, of this sub-step
  // Where the body is now and where it was when its contacts were found; of the centre of mass and the principal axes.
  Vec center{}, first_center{};
  RotationIn<Space> rotation{}, first_rotation{};
  Vec moved{};                 ///< center - first_center
  RotationIn<Space> turned{};  ///< from first_rotation to rotation

  /// Along what contacts press the body in this sub-step.
  enum class Pressed : std::uint8_t { freely, along_normal, tied };
  Pressed pressed = Pressed::freely;
  Vec normal{};

  void press(const Vec& along) {
    if (pressed == Pressed::freely) {
      pressed = Pressed::along_normal;
      normal = along;
    } else if (std::abs(dot(along, normal)) < T(0.999)) {
      pressed = Pressed::tied;
    }
  }
  void tie() { pressed = Pressed::tied; }
  /// The velocity that moves the body in this sub-step: the mean of that before and after, which is exact under gravity
  /// and sliding friction; but along what it is pressed, and in all directions where that is several or friction
  /// holds it, the one after, which the rows made what they wanted. The mean would make what swings on friction that
  /// holds, a wall that sways, gain energy: with forces of the old place it grows by 1 + (h w)² / 4 a sub-step.
  Vec moving_velocity() const {
    if (pressed == Pressed::tied) return linear;
    const Vec half = (linear_before - linear) / T(2);
    return linear + (pressed == Pressed::freely ? half : half - normal * dot(half, normal));
  }

  /// How the body's point moved since that was `arm` from the centre when contacts were found.
  Vec displacement(const Vec& arm) const { return moved + (rotate(turned, arm) - arm); }
  Vec velocity(const Vec& arm) const { return linear + cross(angular, arm); }
  /// Pushes by `impulse` at `arm` from the centre.
  void push(const Vec& impulse, const Vec& arm) {
    linear += impulse * mass.mass;
    angular += mass.inertia * cross(arm, impulse);
  }
};

/// A sub-step of duration h of an island. What rows press moves by h v₁ in it, v₁ being its velocity once the rows
/// were solved with bias, so that a row that wants to move by d asks for the velocity d / h; all else moves by
/// h (v₀ + v₁) / 2 (see `SolverBody::moving_velocity`). What joints hold moves by the mean too, unless contacts press
/// something in the island: what both hold has to be moved by one rule.
template <class T>
struct SubStep {
  T h{};
  T inverse_h{};
  T step{};               ///< the whole step
  bool joined_by_mean{};  ///< bodies of joints move by the mean of their velocities
};

/// The coefficients of a soft row (Catto 2011, "Soft constraints"), an implicit spring of angular frequency w and
/// damping ratio z: what the row pushes is -effective_mass (velocity + bias_rate error) mass_scale - impulse_scale λ.
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
