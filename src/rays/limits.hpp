// Numbers of rays that one alone and several in lanes have in common.
#pragma once

namespace graze::rays {

/// A component of a direction below this is none: its inverse might overflow, and along no ray of a length that there
/// is does it come to a number.
inline constexpr double no_component = 1e-300;

}  // namespace graze::rays
