// Frames of a simulation as JSON lines.
#pragma once

#include "graze/io/plane_simulate.hpp"
#include "graze/io/recording.hpp"

namespace graze::io {

/// Whether a file is one of lines: by the end of its name, or by its kind: a pipe or a device, which may have any name.
bool takes_lines(const std::filesystem::path& file);

/// One line with its end. Numbers are in the shortest form that reads back to the same value in `precision`.
std::string frame_line(const Scene& scene, const std::vector<std::uint32_t>& moving, const SimulationFrame& frame,
                       Precision precision);
std::string frame_line(const PlaneScene& scene, const std::vector<std::uint32_t>& moving,
                       const PlaneSimulationFrame& frame, Precision precision);

}  // namespace graze::io
