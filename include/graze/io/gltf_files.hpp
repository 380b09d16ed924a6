// A glTF scene together with the files that it refers to.
//
// Guarantee: no file outside the scene's own folder is looked at, whatever the scene says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graze/standard.hpp"

namespace graze::io {

/// The files that the buffers of a .gltf file lie in. None of another file, of one that is no JSON, and of names that
/// lead out of its folder. Reads that file alone.
GRAZE_API std::vector<std::filesystem::path> buffer_files(const std::filesystem::path& scene);

/// A .gltf file with everything that it refers to, as the text of one that refers to nothing. Throws `InvalidValue` for
/// what is no glTF scene, or lacks a buffer's bytes.
GRAZE_API std::string whole_gltf(const std::filesystem::path& scene);

}  // namespace graze::io
