// Options checked as any other input: finite, in range for the precision, and named when they are not.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "graze/error.hpp"
#include "graze/io/protocol.hpp"
#include "graze/vec3.hpp"

namespace graze::cli {

/// The precision named "float" or "double".
io::Precision precision_of(const std::string& name);

/// A whole number of at least one, as it was given, named by its option. Throws `InvalidValue`.
std::size_t checked_count(const char* option, const std::string& text);

/// A length or a time as it was given, named by its option. Throws `InvalidValue`.
double checked_length(const char* option, double value, io::Precision precision);

/// Three numbers that are a direction. Throws `InvalidValue`.
Vec3d checked_direction(const std::vector<double>& numbers);

/// Checks the name of a file to write. Throws `InvalidValue` when it does not end in `ending`, which has its dot, so
/// that no picture is taken for one of another kind. A pipe or a device may have any name.
void check_ending(const char* option, const std::string& file, const std::string& ending);

/// Checks that an output is none of the files that are read, which would be lost. Throws `InvalidValue`. No output is
/// an empty name.
void check_output(const char* option, const std::string& file, std::span<const std::string> inputs);

/// Names of values as the library has them, each with the option that holds it.
using OptionNames = std::span<const std::pair<const char*, const char*>>;
/// Throws the error that is being handled anew, under the name of the option that was given.
[[noreturn]] void throw_renamed(const InvalidValue& e, OptionNames names);

}  // namespace graze::cli
