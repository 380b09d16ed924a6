// OBJ, STL and PLY files, as triangles.
#pragma once

#include <string>

#include "io/gltf_document.hpp"

namespace graze::io {

/// All triangles of a mesh file, one mesh. `format` is the file's ending. Throws `InvalidValue`.
TriangleSoup read_mesh_file(const std::string& bytes, const std::string& format);

}  // namespace graze::io
