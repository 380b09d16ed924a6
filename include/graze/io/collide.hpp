// The main job: which colliders of a scene touch, where, how deep and in which direction.
//
// Guarantee: every allowed pair whose shapes come within the margin, in the order of the colliders; the answer is a
// function of the scene and the options alone. Pairs of one body, pairs that the filters forbid and, in a scene where
// anything can move, pairs of which neither can, are left out.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "graze/contact.hpp"
#include "graze/io/protocol.hpp"
#include "graze/io/scene.hpp"

namespace graze::io {

/// What may be told.
struct CollideOptions {
  double margin = 0;                                  ///< >= 0, up to `largest_magnitude` of the precision
  Precision precision = Precision::double_precision;  ///< in which scalar it is computed
  /// Points that a pair has at most, as `WorldSettings::points_per_pair`; all by default.
  std::optional<std::size_t> points_per_pair;
  /// Called from time to time with how much of a part of the work is done, of how much.
  std::function<void(std::size_t, std::size_t)> progress;
};

/// Two colliders within the margin.
struct TouchingPair {
  std::uint32_t a, b;           ///< indices of colliders, a < b
  bool overlap = false;         ///< whether they overlap, and are not only near
  bool trigger = false;         ///< one of them is a trigger
  Manifolds<double> manifolds;  ///< normals from a to b

  /// The deepest point's signed distance, and the normal of its manifold.
  double distance() const;
  Vec3d normal() const;             ///< of the deepest point
  std::size_t point_count() const;  ///< of all manifolds
};

/// Throws `InvalidValue` for a margin, shape or pose that is too large for the precision.
GRAZE_API std::vector<TouchingPair> collide(const Scene& scene, const CollideOptions& options = {});

}  // namespace graze::io
