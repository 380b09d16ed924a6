// The results of the separating-axis test of two polyhedra.
#pragma once

#include <cstddef>
#include <limits>

#include "graze/vec3.hpp"

namespace graze {

enum class AxisKind { face_a, face_b, edges };

/// An axis and the separation of the polyhedra along it; negative when their intervals overlap.
struct SeparatingAxis {
  AxisKind kind;
  double separation = -std::numeric_limits<double>::infinity();
  Vec3d normal{};            ///< unit, from A to B
  std::size_t a = 0, b = 0;  ///< numbers of A's and B's face or edge
};

/// The best axis of each kind; its separation is minus infinity where none was tested, since it is no better than the
/// best face's, and for edges where no arcs cross.
struct SeparatingAxes {
  SeparatingAxis face_a{AxisKind::face_a}, face_b{AxisKind::face_b}, edge{AxisKind::edges};

  const SeparatingAxis& best_face() const { return face_b.separation > face_a.separation ? face_b : face_a; }
  /// The best of all; a face rather than an edge that is better by no more than `noise`, as the product of parallel
  /// edges is.
  const SeparatingAxis& best(double noise) const {
    return edge.separation > best_face().separation + noise ? edge : best_face();
  }
};

}  // namespace graze
