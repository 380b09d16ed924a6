// STL files, text and binary.
//
// Guarantee: any bytes are either read or refused by place, value and expectation; no more is allocated than in
// proportion to the bytes of the file.
#pragma once

#include <string_view>

#include "io/triangle_soup.hpp"

namespace graze::io {

/// The triangles of a file, each with three points of its own; normals are left. Throws `InvalidValue`.
TriangleSoup read_stl(std::string_view bytes);

}  // namespace graze::io
