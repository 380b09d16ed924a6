// The parts of a glTF file that tinygltf reads, checked before it does.
//
// Guarantee: the file requires no version and no extension that is not read; lists are lists of objects, and buffers,
// views, accessors and primitives have the keys that they need, of the right kind and in range. tinygltf refuses some
// faults without naming the place, and takes other values for absent.
#pragma once

#include "io/json_value.hpp"

namespace graze::io {

/// Checks a file. `chunk`: it is a .glb with bytes of its own. Throws `InvalidValue`.
void check_gltf(const Json& json, bool chunk);

/// Finds the buffer that could not be read, which tinygltf does not name: `missing` is the file that was not found, or
/// empty. Throws `InvalidValue` for the buffer at fault; returns when none is.
void check_gltf_buffers(const Json& json, const std::string& missing);

}  // namespace graze::io
