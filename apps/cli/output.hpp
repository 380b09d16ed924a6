// The output of commands: JSON, numbers in tables, notes.
//
// Guarantee: output that standard output does not take is an error of the program (see
// `flush_output`), never passed over.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "graze/vec3.hpp"

namespace graze::cli {

/// JSON whose keys stay in the order in which they are written.
using Json = nlohmann::ordered_json;

/// The array [x, y, z], a zero without a sign.
Json json_of(const Vec3d& v);

/// Prints a whole answer to standard output. Bytes of names that are not UTF-8 are replaced.
void print(const Json& whole);

/// Three numbers of four decimals, `width` characters each; a number that these show as zero has no sign.
std::string shown(const Vec3d& v, int width);

/// A number with its noun: "1 collider", "2 colliders".
std::string counted(std::size_t count, const std::string& noun);

/// Whether only answers and errors are wanted (--quiet): neither notes nor progress.
bool& quiet();

/// Prints notes to standard error, a line each, unless all is to be quiet.
void print_notes(const std::vector<std::string>& notes);

/// What is said of an output that did not take every byte, before the reason.
inline constexpr const char* unwritten_output = "standard output cannot be written";

/// Writes out all that was printed. Throws `std::system_error` unless standard output took every byte of it.
void flush_output();

}  // namespace graze::cli
