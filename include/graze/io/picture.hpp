// Pictures of a scene and its contacts, as SVG.
//
// Guarantee: any scene gives a picture; touching colliders are tinted, every contact point is a dot and every normal an
// arrow, drawn over the shapes so that none is hidden.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graze/io/collide.hpp"

namespace graze::io {

/// A picture as seen against `direction` (towards the viewer; not zero), orthographic, Y up.
GRAZE_API std::string draw_picture(const Scene& scene, const std::vector<TouchingPair>& pairs, const Vec3d& direction);

/// Writes a picture to a file. Throws `InvalidValue` when the file cannot be written or the direction is zero.
GRAZE_API void write_picture(const std::filesystem::path& file, const Scene& scene,
                             const std::vector<TouchingPair>& pairs, const Vec3d& direction);

}  // namespace graze::io
