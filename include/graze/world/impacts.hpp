// What fast bodies would pass through before the next update.
//
// Guarantee: that of `cast`: no impact is missed, and none comes late. For the bodies that are marked fast, with
// whatever they meet, moving or not, while all keep their velocities; sorted by time and then by the bodies.
#pragma once

#include <vector>

#include "graze/dynamic_tree.hpp"
#include "graze/executor.hpp"
#include "graze/world/bodies.hpp"

namespace graze {

/// Two bodies and when they first meet: a.index < b.index, the normal of the hit from a to b.
template <class T, class Space = graze::Space<T>>
struct Impact {
  BodyId a, b;                  ///< the two bodies
  bool trigger;                 ///< one of them is a trigger
  typename Space::CastHit hit;  ///< when and where they first touch
};

/// `allowed(i, j)` tells whether two indices may meet; it is called from any thread. Bodies that touch and part, or
/// slide, do not meet. Cost: a cast with each body whose bounds the sweep of a fast one touches.
template <class T, class Space = graze::Space<T>>
GRAZE_API void find_impacts(const BodyArrays<T, Space>& bodies, const DynamicTree<T>& tree, T duration,
                            const std::function<bool(std::uint32_t, std::uint32_t)>& allowed, Executor& executor,
                            std::vector<Impact<T, Space>>& out);

}  // namespace graze
