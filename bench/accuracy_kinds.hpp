// How far Graze's own answers about all of its kinds are from the truth, those among them that no other library has.
#pragma once

#include <cstddef>
#include <regex>

namespace graze::bench {

/// Prints a table of the largest errors about points and rays over `questions` shapes of each kind whose name matches,
/// and one of `pairs` pairs of each two kinds.
void print_accuracy_of_kinds(std::size_t questions, std::size_t pairs, const std::regex& only);

}  // namespace graze::bench
