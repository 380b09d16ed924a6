// Limits that casts of one ray and of several in lanes share.
#pragma once

namespace graze::rays {

/// Magnitude below which a component of a direction counts as zero: its inverse might overflow, and along no admissible
/// length does it move a point by a representable amount.
inline constexpr double no_component = 1e-300;

}  // namespace graze::rays
