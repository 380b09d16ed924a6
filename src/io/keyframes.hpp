// Keyframes: a value that changes over time, as a sampler of glTF 2.0 gives it.
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

/// Whoever makes one sees to it that the times rise, from 0 or later, that there is at least one (of a spline: two),
/// and as many values as they ask for; all finite, and no rotation of zero length.
struct Keyframes {
  Interpolation interpolation = Interpolation::linear;
  std::shared_ptr<const std::vector<float>> times;  ///< seconds; shared, since one list often serves many
  /// Three or four numbers a value, and one value a time; of a spline three: the tangent towards the key, the key, the
  /// tangent away from it.
  std::shared_ptr<const std::vector<float>> values;

  double duration() const { return static_cast<double>(times->back()); }
  /// Of three numbers a value.
  Vec3d vector(double t) const;
  /// Of four. Between two keys a turn takes the shorter way; a spline is turned to unit length, and where it passes
  /// through zero it is the nearer key.
  Quatd rotation(double t) const;
};

}  // namespace graze::io
