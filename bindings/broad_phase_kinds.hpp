// The broad phases by their numbers in C, and by their names in Python.
#pragma once

#include <memory>

#include "graze/broad_phase.hpp"

namespace graze {

/// One kind of broad phase.
template <class T>
struct BroadPhaseKind {
  const char* name;
  std::unique_ptr<BroadPhase<T>> (*make)();
};

/// All kinds, in the order of `GrazeBroadPhaseKind`.
template <class T>
inline constexpr BroadPhaseKind<T> broad_phase_kinds[] = {
    {"dynamic_tree", make_dynamic_tree<T>},       {"sort_and_sweep", make_sort_and_sweep<T>},
    {"sweep_and_prune", make_sweep_and_prune<T>}, {"hashed_grid", make_hashed_grid<T>},
    {"loose_octree", make_loose_octree<T>},       {"bsp", make_bsp<T>},
};

}  // namespace graze
