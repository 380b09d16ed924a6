// Frames of a simulation as JSON lines.
#pragma once

#include "graze/io/recording.hpp"

namespace graze::io {

/// One line with its end. Numbers are in the shortest form that reads back to the same value in `precision`.
std::string frame_line(const Scene& scene, const std::vector<std::uint32_t>& moving, const SimulationFrame& frame,
                       Precision precision);

}  // namespace graze::io
