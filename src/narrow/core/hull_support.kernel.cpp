#include "narrow/core/hull_scan.hpp"

namespace graze::GRAZE_ISA {

namespace {

constexpr int double_lanes = lanes_of<double>;
using Doubles = Lanes<double>;

/// A register of a hull's vertices in double, from a number on.
template <class T>
[[gnu::always_inline]] inline Vec3<Doubles> vertices_from(const ScannedHull<T>& hull, std::size_t first) {
  Vec3<Doubles> v;
  for (int k = 0; k < double_lanes; ++k) {
    const std::size_t i = first + static_cast<std::size_t>(k);
    const Vec3<T>& p = hull.vertices[i < hull.count ? i : 0];
    v.x.set(k, p.x), v.y.set(k, p.y), v.z.set(k, p.z);
  }
  return v;
}
template <>
[[gnu::always_inline]] inline Vec3<Doubles> vertices_from(const ScannedHull<float>& hull, std::size_t first) {
  typedef float Half __attribute__((vector_size(double_lanes * sizeof(float))));
  const VertexBlock& block = hull.blocks[first / VertexBlock::size];
  const auto widened = [&](const float* from) {
    Half half;
    std::memcpy(&half, from + first % VertexBlock::size, sizeof half);
    return Doubles::of(__builtin_convertvector(half, Doubles::Vector));
  };
  return {widened(block.x), widened(block.y), widened(block.z)};
}

[[gnu::always_inline]] inline void store_rounded(const Doubles& v, float* to) {
  typedef float Half __attribute__((vector_size(double_lanes * sizeof(float))));
  const Half half = __builtin_convertvector(v.v, Half);
  std::memcpy(to, &half, sizeof half);
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

template <class T>
[[gnu::flatten]] void place_vertices(const HullPair<T>& hulls, PlacedVertices& placed) {
  const Mat3<Doubles> rotation = converted<Doubles>(hulls.rotation);
  const Vec3<Doubles> translation = converted<Doubles>(hulls.translation);
  const std::size_t room = scan_blocks(hulls.b.count) * VertexBlock::size;
  for (std::size_t i = 0; i < room; i += double_lanes) {
    const Vec3<Doubles> turned = rotation * vertices_from(hulls.b, i), at = turned + translation;
    VertexBlock& block = placed.turned[i / VertexBlock::size];
    const std::size_t k = i % VertexBlock::size;
    store_rounded(turned.x, block.x + k);
    store_rounded(turned.y, block.y + k);
    store_rounded(turned.z, block.z + k);
    at.x.store(placed.x + i);
    at.y.store(placed.y + i);
    at.z.store(placed.z + i);
  }
}

template <class T>
void placed_support(const HullPair<T>& hulls, const PlacedVertices& placed, const Vec3d& direction,
                    SupportPoint& point) {
  point = support_of(hulls, placed, direction);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template void hull_support(const HullPair<T>&, const Vec3d&, SupportPoint&);                                         \
  template void place_vertices(const HullPair<T>&, PlacedVertices&);                                                   \
  template void placed_support(const HullPair<T>&, const PlacedVertices&, const Vec3d&, SupportPoint&);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
