// The loaders behind `load_scene`.
#pragma once

#include "graze/io/scene.hpp"

namespace graze::io {

/// As `load_gltf`, with the folder that buffers of their own may be read from.
Scene load_gltf_from(const std::string& bytes, const std::string& name, const std::filesystem::path& folder,
                     const LoadOptions& options);

}  // namespace graze::io
