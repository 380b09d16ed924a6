// Part numbers of a triangle for lanes, and the features that they name.
//
// Guarantee: features equal those of the triangle's faces.
#pragma once

#include "narrow/manifold/features.hpp"

namespace graze {

/// Part numbers: below 3 a vertex, from 3 on the edge opposite to it, then the front and the back.
inline constexpr int edge_part = 3, front_part = 6, back_part = 7;
static constexpr std::uint32_t triangle_features[most_parts] = {
    vertex_feature(0),  vertex_feature(1),  vertex_feature(2), edge_feature(1, 2),
    edge_feature(0, 2), edge_feature(0, 1), face_feature(0),   face_feature(1)};

}  // namespace graze
