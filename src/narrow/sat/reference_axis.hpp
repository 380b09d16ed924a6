// The axis of the reference face: the separating axis of a polyhedral pair along which contacts are found.
#pragma once

#include "narrow/pairs/box_box/reference_axis.hpp"
#include "narrow/sat/separating_axis.hpp"

namespace graze {

/// A face's axis, unless that of two edges is better by `face_preference`. `smaller`: size of the smaller shape.
inline const SeparatingAxis& reference_axis(const SeparatingAxes& axes, double smaller) {
  const SeparatingAxis& face = axes.best_face();
  return axes.edge.separation > face.separation + face_preference * smaller ? axes.edge : face;
}

}  // namespace graze
