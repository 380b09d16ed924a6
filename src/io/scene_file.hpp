// The loaders behind `load_scene`.
#pragma once

#include "graze/io/scene.hpp"

namespace graze::io {

/// Loads as `load_gltf` does, with the folder that buffers of their own may be read from.
Scene load_gltf_from(const std::string& bytes, const std::string& name, const std::filesystem::path& folder,
                     const LoadOptions& options);

/// Loads as `load_scene` does, but tiles that the file references are not read.
Scene load_whole(const std::filesystem::path& file, const LoadOptions& options);

/// All bytes of a regular file.
std::string read_file(const std::filesystem::path& file);
/// "glb" of "a.GLB".
std::string ending_of(const std::filesystem::path& file);

}  // namespace graze::io
