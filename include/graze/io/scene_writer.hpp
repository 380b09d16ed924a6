// A scene's colliders and contacts as a glTF file, for any viewer.
//
// Guarantee: a valid binary glTF 2.0: every collider as a mesh of its own name, touching ones tinted and triggers
// translucent; every contact point a small octahedron, every normal an arrow.
#pragma once

#include <filesystem>
#include <vector>

#include "graze/io/collide.hpp"

namespace graze::io {

/// Throws `InvalidValue` when the file cannot be written.
void write_contacts(const std::filesystem::path& file, const Scene& scene, const std::vector<TouchingPair>& pairs);

}  // namespace graze::io
