// Mesh files as shapes, for JavaScript, in the manner of the C interface.
#include <array>
#include <atomic>
#include <string>
#include <string_view>

#include "c/arguments.hpp"
#include "io/mesh_collider.hpp"
#include "io/mesh_file.hpp"
#include "scalar.hpp"

#include "c/shape_handle.inc"

namespace {

constexpr std::array<std::string_view, 3> formats{"obj", "ply", "stl"};

}  // namespace

extern "C" {

/// Makes a mesh of the triangles of a file of `length` bytes; `format`: 0 to 2, of `formats`.
EXPORTED("mesh_of_file")
GrazeStatus graze_js_mesh_of_file(const char* bytes, std::size_t length, std::size_t format, TYPE(Shape) * *shape) {
  return graze::c::guarded([&] {
    const graze::io::TriangleSoup soup = graze::io::read_mesh_file({bytes, length}, std::string(formats[format]));
    *shape = new TYPE(Shape)(graze::io::mesh_collider(soup, graze::io::MeshColliders::mesh));
  });
}

}  // extern "C"
