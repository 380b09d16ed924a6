// PLY files (Turk 1994, "The PLY polygon file format"), ASCII and binary of either byte order, as triangles.
//
// Guarantee: memory stays within a small multiple of the file, whatever it claims: a count is compared with the bytes
// that are left before anything is made of it.
#pragma once

#include <string_view>

#include "io/triangle_soup.hpp"

namespace graze::io {

/// The polygons of the element `face` and the strips of `tristrips` over the points of `vertex`; all other elements are
/// left out. Throws `InvalidValue`.
TriangleSoup read_ply(std::string_view bytes);

}  // namespace graze::io
