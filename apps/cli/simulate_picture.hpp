// The picture of a scene before and after it was played.
#pragma once

#include <string>

#include "graze/io/plane_simulate.hpp"
#include "graze/io/simulate.hpp"

namespace graze::cli {

/// Writes two pictures in one, the scene as it begins and below it as the frame has it.
void write_pictures(const std::string& file, const io::Scene& scene, const io::SimulationFrame& last);
void write_pictures(const std::string& file, const io::PlaneScene& scene, const io::PlaneSimulationFrame& last);

}  // namespace graze::cli
