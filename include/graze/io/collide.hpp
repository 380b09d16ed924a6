// Collision detection of a whole scene: the colliders that touch, with their contacts.
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

/// Options of `collide`.
struct CollideOptions {
  double margin = 0;                                  ///< >= 0, up to `largest_magnitude` of the precision
  Precision precision = Precision::double_precision;  ///< scalar of the computation
  /// Largest number of points of a pair, as `WorldSettings::points_per_pair`; by default all.
  std::optional<std::size_t> points_per_pair;
  /// Called from time to time with the amount of work done so far in the present stage, and the stage's whole amount.
  std::function<void(std::size_t, std::size_t)> progress;
};

/// Two colliders within the margin.
struct TouchingPair {
  std::uint32_t a, b;           ///< indices of colliders, a < b
  bool overlap = false;         ///< true for overlap, false for a gap within the margin
  bool trigger = false;         ///< one of them is a trigger
  Manifolds<double> manifolds;  ///< normals from a to b

  /// The deepest point's signed distance.
  double distance() const;
  Vec3d normal() const;             ///< normal of the deepest point's manifold
  std::size_t point_count() const;  ///< number of points in all manifolds
  /// Whether they are in contact, or one is in the other's trigger. What stands on the back of a one-sided chain, and
  /// two half-spaces without a finite depth, overlap and touch nothing.
  bool in_contact() const { return trigger || !manifolds.empty(); }
};

/// The number of pairs that are in contact.
GRAZE_API std::size_t count_in_contact(const std::vector<TouchingPair>& pairs);

/// The touching pairs. Throws `InvalidValue` for a margin, shape or pose that is too large for the precision.
GRAZE_API std::vector<TouchingPair> collide(const Scene& scene, const CollideOptions& options = {});

}  // namespace graze::io
