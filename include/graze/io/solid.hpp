// Closed meshes of a scene as solids, and what lies unseen in those that are surfaces.
//
// Guarantee: only meshes that are `closed` become solid, children of compounds too; all else stays as it is.
#pragma once

#include <string>
#include <vector>

#include "graze/io/scene.hpp"

namespace graze::io {

/// Makes every closed mesh solid. Adds a notice for each collider of which a mesh is not closed and stays a surface.
GRAZE_API void make_solid(Scene& scene);

/// A sentence for each pair of colliders that `collide` compares of which one lies wholly inside a closed mesh of the
/// other that is no solid, without touching it: by `collide` they are apart. Asks what lies within the bounds of such
/// meshes, and nothing where the scene has none.
GRAZE_API std::vector<std::string> unseen_inside(const Scene& scene);

}  // namespace graze::io
