#include "shape/vertex_scan.hpp"

namespace graze::GRAZE_ISA {

template <class T, class S>
std::uint32_t furthest_vertex(const ScannedHull<T>& hull, const Vec3<S>& direction) {
  return scan(hull, direction);
}

namespace {

template <std::size_t Blocks>
[[gnu::always_inline]] inline HighestVertices highest_in(const ScannedHull<float>& hull, const Vec3<float>& direction,
                                                         float below) {
  const Places<Blocks> places(hull.blocks, direction);
  const float most = places.most();
  const VertexBits all = all_vertices(hull);
  return {first_of(places.not_less(most) & all), places.not_less(most - below) & all};
}

}  // namespace

HighestVertices highest_vertices(const ScannedHull<float>& hull, const Vec3<float>& direction, float below) {
  if (hull.count > 2 * VertexBlock::size) return highest_in<most_scan_blocks>(hull, direction, below);
  return hull.count > VertexBlock::size ? highest_in<2>(hull, direction, below) : highest_in<1>(hull, direction, below);
}

template std::uint32_t furthest_vertex(const ScannedHull<float>&, const Vec3<float>&);
template std::uint32_t furthest_vertex(const ScannedHull<float>&, const Vec3<double>&);
template std::uint32_t furthest_vertex(const ScannedHull<double>&, const Vec3<double>&);

}  // namespace graze::GRAZE_ISA
