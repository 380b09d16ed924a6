// Solids made of the closed meshes of a scene, and bodies hidden inside meshes that are surfaces.
//
// Guarantee: only meshes that are `closed` become solid, children of compounds too; everything else stays unchanged.
#pragma once

#include <string>
#include <vector>

#include "graze/io/scene.hpp"

namespace graze::io {

/// Makes every closed mesh solid. Adds a notice for each collider with a mesh that is not closed and stays a surface.
GRAZE_API void make_solid(Scene& scene);

/// A sentence for each pair of colliders tested by `collide` of which one lies wholly inside a closed mesh of the other
/// that is no solid, without touching it: by `collide` they are apart. Tests only colliders within the bounds of such
/// meshes.
GRAZE_API std::vector<std::string> unseen_inside(const Scene& scene);

}  // namespace graze::io
