// The parts of a triangle that a point of contact may lie on, as numbers for lanes, and their names.
//
// Guarantee: a name is the one that the triangle's faces give.
#pragma once

#include "narrow/manifold/features.hpp"

namespace graze {

/// What of a triangle a part names: a vertex, the edge between the two others and 3 before it, its front and its back.
inline constexpr int edge_part = 3, front_part = 6, back_part = 7;
static constexpr std::uint32_t triangle_features[most_parts] = {
    vertex_feature(0),  vertex_feature(1),  vertex_feature(2), edge_feature(1, 2),
    edge_feature(0, 2), edge_feature(0, 1), face_feature(0),   face_feature(1)};

}  // namespace graze
