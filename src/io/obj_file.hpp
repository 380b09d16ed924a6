// OBJ files, as far as they describe a shape: points and the faces over them.
//
// Guarantee: any bytes are either read or refused by line, value and expectation; no more is allocated than in
// proportion to the bytes of the file.
#pragma once

#include <string_view>

#include "io/triangle_soup.hpp"

namespace graze::io {

/// The triangles of a file. Faces of more than three corners are cut into triangles; points that no face uses are left
/// out. Throws `InvalidValue`.
TriangleSoup read_obj(std::string_view text);

}  // namespace graze::io
