// The shapes of triangles that collide: themselves, their hull, a box or a ball.
#pragma once

#include "graze/io/scene.hpp"
#include "io/triangle_soup.hpp"

namespace graze::io {

/// The collider of a mesh, whose equal points are made one first. The box is tight along the mesh's own axes; the ball
/// is Ritter's (1990, "An efficient bounding sphere"), 5 to 20 % larger than the smallest.
Shaped mesh_collider(const TriangleSoup& soup, MeshColliders kind);

}  // namespace graze::io
