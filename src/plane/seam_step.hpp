// The step between two bodies that still makes them one ground.
#pragma once

namespace graze::plane {

/// Height of a step between two bodies up to which they are one ground, relative to the smaller of the body that moves
/// and the piece that it meets; as between solids (`composite/internal_edges`).
inline constexpr double seam_step = 4e-4;

}  // namespace graze::plane
