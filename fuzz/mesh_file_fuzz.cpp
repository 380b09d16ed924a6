// Any bytes as an OBJ, PLY or STL file: refused as `InvalidValue`, or each collider made of its triangles has finite
// bounds with every point in them, and answers a ray. The first byte chooses format and collider, the rest is the file.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "graze/error.hpp"
#include "graze/raycast.hpp"
#include "graze/shape/mesh_findings.hpp"
#include "io/mesh_collider.hpp"
#include "io/mesh_file.hpp"

namespace {

void require(bool holds) {
  if (!holds) __builtin_trap();
}

constexpr std::array formats{"obj", "ply", "stl"};
constexpr std::array colliders{graze::io::MeshColliders::mesh, graze::io::MeshColliders::hull,
                               graze::io::MeshColliders::box, graze::io::MeshColliders::sphere};

/// Every point of the triangles lies in the bounds of the shape, to the rounding of a ball's radius and of a hull whose
/// nearly equal points are one.
void check_bounds(const graze::Shaped& shape, const graze::io::TriangleSoup& soup) {
  const graze::Aabbd box = bounds(shape, {});
  double size = 0;
  for (int k = 0; k < 3; ++k) {
    require(std::isfinite(box.lower[k]) && std::isfinite(box.upper[k]) && box.lower[k] <= box.upper[k]);
    size = std::max({size, std::abs(box.lower[k]), std::abs(box.upper[k])});
  }
  for (const auto& triangle : soup.triangles)
    for (const auto corner : triangle) {
      require(corner < soup.points.size());
      for (int k = 0; k < 3; ++k)
        require(soup.points[corner][k] >= box.lower[k] - 1e-12 * size &&
                soup.points[corner][k] <= box.upper[k] + 1e-12 * size);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string format = formats[bytes[0] % formats.size()];
  const graze::io::MeshColliders kind = colliders[bytes[0] / formats.size() % colliders.size()];
  try {
    const auto soup = graze::io::read_mesh_file({reinterpret_cast<const char*>(bytes + 1), size - 1}, format);
    const graze::Shaped shape = graze::io::mesh_collider(soup, kind);
    check_bounds(shape, soup);
    if (const auto* mesh = shape.as<graze::Mesh<double>>()) findings(*mesh);
    const graze::Rayd ray{soup.points[0] + graze::Vec3d{1, 2, 3}, {-1, -2, -3}};
    if (const auto hit = raycast(shape, {}, ray)) require(std::isfinite(hit->t));
  } catch (const graze::InvalidValue&) {
  }
  return 0;
}
