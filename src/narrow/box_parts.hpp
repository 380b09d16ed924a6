// The vertices, edges and faces of a box by the numbers of `Box`, which are independent of its size.
#pragma once

#include <array>
#include <cstdint>

#include "graze/shape/convex_hull.hpp"

namespace graze {

/// A box's parts by their numbers, as `Box` gives them.
struct BoxParts {
  std::array<HullEdge, 12> edges{};
  std::array<std::uint32_t, 7> begins{};
  std::array<std::uint32_t, 24> loops{};
};

constexpr BoxParts make_box_parts() {
  BoxParts parts;
  const auto corner = [](std::uint32_t u, bool at_u, std::uint32_t v, bool at_v, std::uint32_t w, bool at_w) {
    return (std::uint32_t(at_u) << u) | (std::uint32_t(at_v) << v) | (std::uint32_t(at_w) << w);
  };
  std::size_t edge = 0;
  for (std::uint32_t u = 0; u < 3; ++u) {
    const std::uint32_t v = (u + 1) % 3, w = (u + 2) % 3;
    for (int side = 0; side < 4; ++side) {
      const bool at_v = side & 1, at_w = side & 2;
      const std::uint32_t face_v = 2 * v + at_v, face_w = 2 * w + at_w;
      const bool same = at_v == at_w;  // e_v x e_w = e_u: with both signs alike the face across v is on the left
      parts.edges[edge++] = {{corner(u, false, v, at_v, w, at_w), corner(u, true, v, at_v, w, at_w)},
                             {same ? face_v : face_w, same ? face_w : face_v}};
    }
    for (const bool positive : {false, true}) {
      const std::size_t at = 4 * (2 * u + positive);
      const bool around[4][2] = {{false, false}, {positive, !positive}, {true, true}, {!positive, positive}};
      for (std::size_t k = 0; k < 4; ++k) parts.loops[at + k] = corner(u, positive, v, around[k][0], w, around[k][1]);
    }
  }
  for (std::uint32_t f = 0; f <= 6; ++f) parts.begins[f] = 4 * f;
  return parts;
}
inline constexpr BoxParts box_parts = make_box_parts();

}  // namespace graze
