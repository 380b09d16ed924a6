// Inverse mass and inertia in world space, the resistance of a body to impulses.
//
// Guarantee: `InverseMass` is a plain value. An immovable body has inverses of zero, so that no formula needs a case of
// its own for it. The functions that make one throw `InvalidValue` for a value that is no mass or inertia, naming it,
// and otherwise neither under- nor overflow where the result is a finite number.
#pragma once

#include "graze/shape.hpp"

namespace graze {

/// The inverse of a body's mass and of its inertia about the centre of mass, in world space. By default immovable.
template <class T>
struct InverseMass {
  T mass{};           ///< one over the mass
  Mat3<T> inertia{};  ///< inverse of the inertia tensor about the centre of mass

  /// Whether an impulse changes the body's motion.
  bool movable() const { return mass > T(0); }
};

/// The inverse mass of a body of `mass` (> 0; infinite for one that does not move or turn, whatever its inertia) whose
/// `inertia` is diagonal in the frame `rotation`: each component > 0, or infinite for an axis about which the body
/// does not turn; of three finite ones none larger than the sum of the others. Throws `InvalidValue` for anything else,
/// and for a mass too small to be inverted.
template <class T>
GRAZE_API InverseMass<T> inverse_mass(T mass, const Vec3<T>& inertia, const Quat<T>& rotation = {});

/// The inverse mass of a body with an inertia tensor in the frame `rotation`: symmetric and positive definite, none
/// of its principal moments larger than the sum of the others up to rounding by half of the digits.
template <class T>
GRAZE_API InverseMass<T> inverse_mass(T mass, const Mat3<T>& inertia, const Quat<T>& rotation = {});

/// The inertia tensor of `shape` about its own centre of mass, in its own frame, with `mass` spread evenly. Throws
/// `InvalidValue` for a shape without volume: a surface, a flat one, or a half-space.
template <class T>
GRAZE_API Mat3<T> inertia_of(const Shape<T>& shape, T mass);

}  // namespace graze
