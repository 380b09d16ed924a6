// Any bytes as points: the hull must be built, closed, and hold them all.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "graze/shape.hpp"

namespace {

void require(bool holds) {
  if (!holds) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size < 4) return 0;
  // Small integers make coplanar and equal points likely; the first byte chooses between them and raw floats.
  std::vector<graze::Vec3d> points;
  const bool raw = bytes[0] & 1;
  const std::size_t step = raw ? 12 : 3;
  for (std::size_t i = 1; i + step <= size && points.size() < 500; i += step) {
    graze::Vec3d p;
    for (std::size_t k = 0; k < 3; ++k) {
      float f = static_cast<float>(static_cast<std::int8_t>(bytes[i + k]));
      if (raw) std::memcpy(&f, bytes + i + 4 * k, 4);
      p[k] = std::isfinite(f) ? static_cast<double>(f) : 0;
    }
    points.push_back(p);
  }
  if (points.empty()) return 0;
  const graze::ConvexHull<double> hull(points);
  const auto& data = hull.data();
  for (const auto& plane : data.planes)
    for (const auto& p : points) require(dot(plane.normal, p) - plane.offset <= 4 * data.tolerance);
  if (data.dimension == 3) require(data.vertices.size() + data.planes.size() == data.edges.size() + 2);
  for (const auto& p : points) {
    const auto& top = data.vertices[hull.support_vertex(p)];
    require(dot(top, p) >= dot(p, p) - 8 * data.tolerance * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)));
  }
  return 0;
}
