#include "plane/ray_sides.hpp"

#include "simd/lanes.hpp"

namespace graze::GRAZE_ISA {

namespace {

using namespace plane;

constexpr std::uint32_t width = lanes_of<float> < static_cast<int>(most_sided) ? lanes_of<float> : most_sided;
using Beside = Wide<float, static_cast<int>(width)>;

template <std::size_t first, std::size_t... I>
[[gnu::always_inline]] inline Beside every_second(const Beside& low, const Beside& high, std::index_sequence<I...>) {
  return Beside::of(__builtin_shufflevector(low.v, high.v, (2 * I + first)...));
}

[[gnu::flatten]] RaySides ray_sides(const Vec2f* vertices, std::uint32_t count, float along_x, float along_y,
                                    float offset, float slack) {
  static_assert(sizeof(Vec2f) == 2 * sizeof(float));
  const float* const from = &vertices[0].x;
  const Beside toward_x(along_x), toward_y(along_y), at(offset), near(slack);
  const auto lanes = std::make_index_sequence<width>();
  RaySides sides{0, 0};
  for (std::uint32_t first = 0; first < most_sided; first += width) {
    const Beside low = Beside::load(from + 2 * first), high = Beside::load(from + 2 * first + width);
    const Beside x = every_second<0>(low, high, lanes), y = every_second<1>(low, high, lanes);
    const Beside beside = toward_x * y - toward_y * x - at;
    sides.left |= bits_of(beside > near) << first;
    sides.right |= bits_of(beside < -near) << first;
  }
  const std::uint32_t all = (std::uint32_t{1} << count) - 1;
  return {sides.left & all, sides.right & all};
}

}  // namespace

RaySidesKernel plane_ray_sides() { return ray_sides; }

}  // namespace graze::GRAZE_ISA
