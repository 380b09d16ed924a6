#include "io/mesh_file.hpp"

#include "io/obj_file.hpp"
#include "io/ply_file.hpp"
#include "io/stl_file.hpp"

namespace graze::io {

TriangleSoup read_mesh_file(const std::string& bytes, const std::string& format) {
  TriangleSoup soup = format == "ply" ? read_ply(bytes) : format == "obj" ? read_obj(bytes) : read_stl(bytes);
  if (soup.triangles.empty()) throw InvalidValue("", "a mesh with triangles", "none");
  return soup;
}

}  // namespace graze::io
