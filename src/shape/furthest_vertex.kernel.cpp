#include "shape/vertex_scan.hpp"

namespace graze::GRAZE_ISA {

template <class T, class S>
std::uint32_t furthest_vertex(const ScannedHull<T>& hull, const Vec3<S>& direction) {
  return scan(hull, direction);
}

std::uint32_t vertices_at_least(const ScannedHull<float>& hull, const Vec3<float>& direction, float level) {
  const std::uint32_t bits = hull.count > VertexBlock::size ? Places<2>(hull.blocks, direction).not_less(level)
                                                            : Places<1>(hull.blocks, direction).not_less(level);
  return bits & all_vertices(hull);
}

template std::uint32_t furthest_vertex(const ScannedHull<float>&, const Vec3<float>&);
template std::uint32_t furthest_vertex(const ScannedHull<float>&, const Vec3<double>&);
template std::uint32_t furthest_vertex(const ScannedHull<double>&, const Vec3<double>&);

}  // namespace graze::GRAZE_ISA
