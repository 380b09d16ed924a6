// The axis of the reference face: which of a polyhedral pair's separating axes its contacts stand on.
#pragma once

#include "narrow/pairs/box_box/reference_axis.hpp"
#include "narrow/sat/separating_axis.hpp"

namespace graze {

/// A face's axis, unless that of two edges is clearly better. `smaller`: size of the smaller shape.
inline const SeparatingAxis& reference_axis(const SeparatingAxes& axes, double smaller) {
  const SeparatingAxis& face = axes.best_face();
  return axes.edge.separation > face.separation + face_preference * smaller ? axes.edge : face;
}

}  // namespace graze
