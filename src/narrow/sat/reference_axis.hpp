// The axis of the reference face: the separating axis of a polyhedral pair along which contacts are found.
#pragma once

#include "narrow/sat/choose_axis.hpp"
#include "narrow/sat/separating_axis.hpp"

namespace graze {

/// A face's axis, unless that of two edges is better by `face_preference`. `noise`: rounding of a separation;
/// `smaller`: size of the smaller shape.
inline const SeparatingAxis& reference_axis(const SeparatingAxes& axes, double noise, double smaller) {
  const SeparatingAxis& face = axes.best_face();
  return choose_axis(face.separation, axes.edge.separation, noise, smaller).edge_chosen ? axes.edge : face;
}

}  // namespace graze
