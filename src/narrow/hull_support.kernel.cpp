#include "narrow/hull_support.hpp"
#include "shape/vertex_scan.hpp"

namespace graze::GRAZE_ISA {

namespace {

/// A float's block, which the scan has just read, holds the vertex itself.
template <class T>
[[gnu::always_inline]] inline Vec3d vertex(const ScannedHull<T>& hull, std::uint32_t i) {
  if constexpr (sizeof(T) == sizeof(float)) {
    const VertexBlock& block = hull.blocks[i / VertexBlock::size];
    const std::size_t k = i % VertexBlock::size;
    return {static_cast<double>(block.x[k]), static_cast<double>(block.y[k]), static_cast<double>(block.z[k])};
  } else {
    return hull.vertices[i];
  }
}

}  // namespace

template <class T>
void hull_support(const HullPair<T>& hulls, const Vec3d& direction, SupportPoint& point) {
  const Vec3d against = transposed_times(hulls.rotation, -direction);
  const std::uint32_t i = scan(hulls.a, direction), j = scan(hulls.b, against);
  point.a = vertex(hulls.a, i);
  point.b = hulls.rotation * vertex(hulls.b, j) + hulls.translation;
  point.w = point.b - point.a;
}

template void hull_support(const HullPair<float>&, const Vec3d&, SupportPoint&);
template void hull_support(const HullPair<double>&, const Vec3d&, SupportPoint&);

}  // namespace graze::GRAZE_ISA
