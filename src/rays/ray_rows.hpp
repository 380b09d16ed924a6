// Consecutive rays read into a block. Only for `*.kernel.cpp`.
//
// Guarantee: numbers are copied, and floats converted to double, only.
#pragma once

#include "rays/lane_vec3.hpp"
#include "rays/ray_block.hpp"
#include "simd/rows.hpp"

namespace graze::GRAZE_ISA {

/// Reads the numbers of a register of rays in double, to index `i` and the following.
[[gnu::always_inline]] inline void read_some(const float* rays, rays::RayBlock& block, std::size_t i) {
  using Row = Lanes<float>;
  Row from[4], to[4];  // a row of four is loaded at once
  load_rows<6, 0, float>(rays, from);
  load_rows<6, 2, float>(rays, to);
  const auto store = [i](const Row& numbers, rays::RayBlock::Numbers& column) __attribute__((always_inline)) {
    typedef double Doubles __attribute__((vector_size(Row::lanes * sizeof(double))));
    const Doubles wide = __builtin_convertvector(numbers.v, Doubles);
    std::memcpy(column + i, &wide, sizeof wide);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    store(from[k], block.origin[k]);
    store(to[k + 1], block.along[k]);
  }
}
/// The number of lanes filled for `count` rays, the same at every level.
[[gnu::always_inline]] inline std::size_t filled(std::size_t count) { return (count + 7) / 8 * 8; }

/// Reads origins and directions unchanged; remaining lanes repeat the last ray.
[[gnu::always_inline]] inline void read_rays(const float* rays, std::size_t count, rays::RayBlock& block) {
  constexpr std::size_t lanes = lanes_of<float>;
  static_assert(rays::RayBlock::size % lanes == 0);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) read_some(rays + 6 * i, block, i);
  for (; i < filled(count); i += lanes) {
    float rest[6 * lanes];
    for (std::size_t k = 0; k < lanes; ++k)
      std::memcpy(rest + 6 * k, rays + 6 * (i + k < count ? i + k : count - 1), 6 * sizeof(float));
    read_some(rest, block, i);
  }
}
[[gnu::always_inline]] inline void read_rays(const double* rays, std::size_t count, rays::RayBlock& block) {
  constexpr auto step = static_cast<std::size_t>(lanes_of<double>);
  for (std::size_t i = 0; i < filled(count); i += step)
    for (std::size_t k = 0; k < 3; ++k) {
      column<6>(rays, i, count - 1, k).store(block.origin[k] + i);
      column<6>(rays, i, count - 1, 3 + k).store(block.along[k] + i);
    }
}

}  // namespace graze::GRAZE_ISA
