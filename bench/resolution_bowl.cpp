#include "resolution_bowl.hpp"

#include <cmath>

namespace graze::bench {

Bowl bowl_of(double radius) {
  constexpr std::uint32_t rings = 8, around = 32;
  constexpr double quarter = 1.5707963267948966;
  Bowl bowl{{{0, -radius, 0}}, {}};
  for (std::uint32_t ring = 1; ring <= rings; ++ring)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double polar = quarter * ring / rings, turned = 4 * quarter * i / around;
      bowl.points.push_back(
          Vec3d{std::sin(polar) * std::cos(turned), -std::cos(polar), std::sin(polar) * std::sin(turned)} * radius);
    }
  const auto point = [](std::uint32_t ring, std::uint32_t i) {
    return ring == 0 ? 0 : 1 + (ring - 1) * around + i % around;
  };
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t low = point(ring, i), low_next = point(ring, i + 1), high = point(ring + 1, i),
                          high_next = point(ring + 1, i + 1);
      bowl.indices.insert(bowl.indices.end(), {low, high_next, high});
      if (ring > 0) bowl.indices.insert(bowl.indices.end(), {low, low_next, high_next});
    }
  return bowl;
}

}  // namespace graze::bench
