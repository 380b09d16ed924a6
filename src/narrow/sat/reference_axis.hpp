// The axis of the reference face: the separating axis of a polyhedral pair along which contacts are found.
#pragma once

#include "narrow/sat/choose_axis.hpp"
#include "narrow/sat/separating_axis.hpp"

namespace graze {

/// A face's axis, unless that of two edges is better by `face_preference` of the smaller shape's size.
inline const SeparatingAxis& reference_axis(const SeparatingAxes& axes, double smaller) {
  const SeparatingAxis& face = axes.best_face();
  return edge_chosen(face.separation, axes.edge.separation, smaller) ? axes.edge : face;
}

}  // namespace graze
