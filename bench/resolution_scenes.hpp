// The rows of the table of engines: a scene, what is measured of it, and what was quoted of engines that are not run.
#pragma once

#include <string>
#include <vector>

#include "resolution_engine.hpp"

namespace graze::bench {

struct ResolutionRow {
  std::string what;
  std::string target;       ///< of Graze
  std::string box3d, jolt;  ///< quoted: measured once, elsewhere, on scenes of the same description
  std::function<std::string(const EngineKind&)> measure;
};

/// In the order of the table. `long_ones` is false where nobody waits for the tall towers and the pile.
std::vector<ResolutionRow> resolution_rows(bool long_ones);

}  // namespace graze::bench
