// A glTF scene with the motion of its bodies as an animation.
#pragma once

#include "graze/io/recording.hpp"

namespace graze::io {

/// Records a simulation as `record` does, for glTF files.
std::unique_ptr<Recording> record_animation(const std::filesystem::path& file, const Scene& scene,
                                            const std::filesystem::path& source);

}  // namespace graze::io
