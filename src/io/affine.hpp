// Affine maps, as the nodes of a scene carry them: a linear part, which may scale and shear, and a translation.
#pragma once

#include <optional>

#include "graze/geometry.hpp"
#include "graze/pose.hpp"

namespace graze::io {

struct Affine {
  Mat3d linear = Mat3d::identity();
  Vec3d translation{};
  /// The signs of the scales that the map was made of, 1 or -1 an axis. A matrix alone cannot tell two negative scales
  /// from half a turn. A turn R behind the signs D is a turn before them, D R = (D R D) D, so that signs multiply.
  Vec3d signs{1, 1, 1};

  Vec3d operator()(const Vec3d& p) const { return linear * p + translation; }
  friend Affine operator*(const Affine& a, const Affine& b) {
    return {a.linear * b.linear, a(b.translation), scaled(a.signs, b.signs)};
  }
};

/// A map without shear: scale along its own axes, then a rigid motion. A mirror is taken out of the X axis.
struct ScaledPose {
  Pose<double> pose;
  Vec3d scale;
  bool mirrored = false;
};

/// Axes that turn with a map and have nothing of its scale: the first is the map's, the second next to it.
inline Mat3d turned_axes(const Mat3d& linear) {
  const Vec3d x = normalized(linear.column(0)), z = normalized(cross(x, normalized(linear.column(1))));
  return Mat3d::from_columns(x, cross(z, x), z);
}

/// The pose of a regular map: where it takes the origin, and how its axes are turned. A mirror is taken out of the Z
/// axis.
inline Posed rigid_part(const Affine& map) { return {map.translation, rotation_quaternion(turned_axes(map.linear))}; }

/// The pose of a body at a node with a regular map: turned as the node and those above it are, whatever the signs of
/// their scales.
inline Posed body_pose(const Affine& map) {
  return {map.translation, rotation_quaternion(turned_axes(map.linear * Mat3d::diagonal(map.signs)))};
}

/// The precision of right angles in files, which hold numbers in single precision.
inline constexpr double file_precision = 1e-5;

/// The map as a scale and a rigid motion; nothing when its axes are not perpendicular up to `file_precision`.
inline std::optional<ScaledPose> without_shear(const Affine& map) {
  Vec3d axis[3] = {map.linear.column(0), map.linear.column(1), map.linear.column(2)};
  const Vec3d scale{length(axis[0]), length(axis[1]), length(axis[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (std::abs(dot(axis[i], axis[j])) > file_precision * scale[i] * scale[j]) return std::nullopt;
  }
  const bool mirrored = determinant(map.linear) < 0;
  if (mirrored) axis[0] = -axis[0];
  const Mat3d rotation = Mat3d::from_columns(axis[0] / scale.x, axis[1] / scale.y, axis[2] / scale.z);
  return ScaledPose{{map.translation, rotation_quaternion(rotation)}, scale, mirrored};
}

/// The rounding of a volume that is zero, relative to the lengths of a map's three axes: in a chain of some hundred
/// nodes each product loses a few times 1e-16.
inline constexpr double volume_rounding = 1e-12;

/// False for zero volume up to rounding, relative to the map's own size: then no shape keeps its dimension.
inline bool is_regular(const Affine& map) {
  double product = 1;
  for (std::size_t i = 0; i < 3; ++i) product *= length(map.linear.column(i));
  return std::abs(determinant(map.linear)) > volume_rounding * product && std::isfinite(product) && product > 0;
}

inline bool equal_scales(double a, double b) { return std::abs(a - b) <= file_precision * greatest(a, b); }

}  // namespace graze::io
