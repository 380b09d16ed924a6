// Options checked as any other input: finite, in range for the precision, and named when they are not.
#pragma once

#include <vector>

#include "graze/io/protocol.hpp"
#include "graze/vec3.hpp"

namespace graze::cli {

/// "float" or "double".
io::Precision precision_of(const std::string& name);

/// The margin as it came. Throws `InvalidValue`.
double checked_margin(double margin, io::Precision precision);

/// Three numbers that are a direction. Throws `InvalidValue`.
Vec3d checked_direction(const std::vector<double>& numbers);

}  // namespace graze::cli
