// Do contacts of a body at rest hold still?
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace graze::bench {

/// How one library did on a box that rests on another: shares of successive frames.
struct Flicker {
  std::string library, scene;
  std::size_t frames = 0, kind_changes = 0, count_changes = 0, points = 0;
};

/// A box of 1 m on another, tilted up to 5 mrad and about 1 mm deep, its pose drawn anew in every frame. Asks all
/// libraries about the same frames, aligned, shifted and turned.
std::vector<Flicker> measure_flicker(std::size_t frames);

}  // namespace graze::bench
