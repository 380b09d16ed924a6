// What the commands print, and how: JSON, and numbers in tables.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

#include "graze/vec3.hpp"

namespace graze::cli {

/// Keys stay in the order in which they are written.
using Json = nlohmann::ordered_json;

/// [x, y, z], a zero without a sign.
Json json_of(const Vec3d& v);

/// Prints a whole answer to standard output. Names that are not UTF-8 lose what is not.
void print(const Json& whole);

/// Three numbers of four decimals, `width` characters each; what these show as zero has no sign.
std::string shown(const Vec3d& v, int width);

}  // namespace graze::cli
