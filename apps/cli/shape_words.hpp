// Shapes in the tables of commands.
#pragma once

#include <string>

#include "graze/plane/shape.hpp"
#include "graze/shape.hpp"

namespace graze::cli {

/// A shape in a table: its name and its numbers.
std::string told(const Shaped& shape);
std::string told(const plane::Shaped& shape);

}  // namespace graze::cli
