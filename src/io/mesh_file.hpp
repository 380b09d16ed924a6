// OBJ, STL and PLY files, as triangles.
//
// Each is read here and not by assimp 5.2, which trusts counts (a PLY file of 120 bytes took 11 GB), names no line,
// holds numbers in single precision and loses 1.3 kB with every OBJ or STL file that it refuses.
#pragma once

#include <string>

#include "io/triangle_soup.hpp"

namespace graze::io {

/// All triangles of a mesh file, one mesh. `format` is the file's ending. Throws `InvalidValue`.
TriangleSoup read_mesh_file(const std::string& bytes, const std::string& format);

}  // namespace graze::io
