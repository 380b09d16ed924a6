// Two colliders that touch, as JSON.
#pragma once

#include <fmt/format.h>

#include "graze/io/collide.hpp"
#include "output.hpp"

namespace graze::cli {

/// The JSON of a pair but for its two colliders: their overlap and contacts. `vector_of` gives a vector's coordinates.
template <class VectorOf>
Json json_of_touch(const io::TouchingPair& pair, VectorOf&& vector_of) {
  Json manifolds = Json::array();
  for (const auto& m : pair.manifolds) {
    Json points = Json::array();
    for (const auto& p : m.points)
      points.push_back({{"a", vector_of(p.a)},
                        {"b", vector_of(p.b)},
                        {"distance", p.distance},
                        {"feature", fmt::format("{:08x}", p.feature)}});
    manifolds.push_back({{"normal", vector_of(m.normal)}, {"points", points}});
  }
  return {{"overlap", pair.overlap}, {"trigger", pair.trigger}, {"manifolds", manifolds}};
}

}  // namespace graze::cli
