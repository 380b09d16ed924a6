// A scene with its contacts drawn into it, as a glTF file for any viewer.
//
// Guarantee: a valid binary glTF 2.0 that stands alone. A scene that was a glTF file stays unchanged, down to the bytes
// of its pictures and to unknown extensions; added are the touching colliders as a translucent tint over it, the
// colliders and triggers without visible meshes, every contact point as a small octahedron and every normal as an
// arrow. In any other scene every collider becomes a mesh of its own name.
//
// Tinted are touching colliders that can move; in a scene where nothing can move, all touching ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graze/io/collide.hpp"

namespace graze::io {

/// Writes the file. `source` is the file that the scene was read from; without one, or if it is a mesh file, the
/// colliders are drawn alone. Returns a sentence for each thing of the scene that could not be kept. Throws
/// `InvalidValue` when `source` cannot be read or `file` cannot be written.
GRAZE_API std::vector<std::string> write_contacts(const std::filesystem::path& file, const Scene& scene,
                                                  const std::vector<TouchingPair>& pairs,
                                                  const std::filesystem::path& source = {});

}  // namespace graze::io
