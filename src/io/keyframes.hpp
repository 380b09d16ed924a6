// Keyframes: a value that changes over time, as defined for a sampler of glTF 2.0.
//
// Guarantee: a value for every time, never NaN: before the first keyframe that of the first, behind the last that of
// the last. Rotations come out of unit length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "graze/quat.hpp"

namespace graze::io {

enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// Keyframes are made with times that rise, from 0 or later, at least one (for a spline two), and with as many values
/// as these require; all finite, and no rotation of zero length.
struct Keyframes {
  Interpolation interpolation = Interpolation::linear;
  std::shared_ptr<const std::vector<float>> times;  ///< seconds; shared, since one list often serves many
  /// Three or four numbers a value, and one value a time; of a spline three: the tangent towards the key, the key, the
  /// tangent away from it.
  std::shared_ptr<const std::vector<float>> values;

  double duration() const { return static_cast<double>(times->back()); }
  /// The value at a time, of three numbers.
  Vec3d vector(double t) const;
  /// The value at a time, of four numbers. Between two keys a turn takes the shorter way; a spline is brought to unit
  /// length, and where it passes through zero it is the nearer key.
  Quatd rotation(double t) const;
};

}  // namespace graze::io
