// A glTF scene together with the files that it refers to.
//
// Guarantee: no file outside the scene's own folder is opened, whatever the scene refers to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "graze/detail/standard.hpp"

namespace graze::io {

/// The files of a .gltf file's buffers. Empty for files of other kinds and for a file that is no JSON; names that lead
/// out of its folder are left out. Reads that file alone.
GRAZE_API std::vector<std::filesystem::path> buffer_files(const std::filesystem::path& scene);

/// The text of a .gltf file with everything that it refers to embedded. Throws `InvalidValue` for a file that is no
/// glTF scene, or lacks a buffer's bytes.
GRAZE_API std::string whole_gltf(const std::filesystem::path& scene);

}  // namespace graze::io
