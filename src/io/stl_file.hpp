// STL files, text and binary.
//
// Guarantee: any bytes are either read or refused by place, value and expectation; nothing is allocated that the file
// does not pay for.
#pragma once

#include <string_view>

#include "io/gltf_document.hpp"

namespace graze::io {

/// Three points of its own for each triangle; normals are left. Throws `InvalidValue`.
TriangleSoup read_stl(std::string_view bytes);

}  // namespace graze::io
