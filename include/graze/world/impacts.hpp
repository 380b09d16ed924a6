// Impacts: bodies that fast ones would pass through before the next update.
//
// Guarantee: that of `cast`: no impact is missed, and none comes late. Covers the bodies that are marked fast, against
// all bodies, moving or not, while all keep their velocities; sorted by time and then by the bodies.
#pragma once

#include <vector>

#include "graze/dynamic_tree.hpp"
#include "graze/executor.hpp"
#include "graze/world/bodies.hpp"

namespace graze {

/// Two bodies and the time of their first contact: a.index < b.index, the normal of the hit from a to b.
template <class T, class Space = graze::Space<T>>
struct Impact {
  BodyId a, b;                  ///< the two bodies
  bool trigger;                 ///< one of them is a trigger
  typename Space::CastHit hit;  ///< their first contact
};

/// Finds the impacts of a time of `duration`. `allowed(i, j)` decides whether two indices may collide; it is called
/// from any thread. Bodies that touch and part, or slide, have no impact. Cost: a cast with each body whose bounds the
/// sweep of a fast one touches.
template <class T, class Space = graze::Space<T>>
GRAZE_API void find_impacts(const BodyArrays<T, Space>& bodies, const DynamicTree<T>& tree, T duration,
                            const std::function<bool(std::uint32_t, std::uint32_t)>& allowed, Executor& executor,
                            std::vector<Impact<T, Space>>& out);

}  // namespace graze
