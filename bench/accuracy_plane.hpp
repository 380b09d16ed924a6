// How far the answers of the plane are from the truth.
#pragma once

#include <cstddef>
#include <regex>

namespace graze::plane {

/// Prints a table of the largest errors over `pairs` pairs of each two kinds of the plane whose names match.
void print_accuracy(std::size_t pairs, const std::regex& only);

}  // namespace graze::plane
