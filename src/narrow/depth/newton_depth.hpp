// The depth of two cores that are sums of boxes and ellipsoids, by Newton's descent on the sphere of directions and a
// proof.
//
// Guarantee: a depth is the overlap along its normal, and no separating translation is shorter than `lower`, the proven
// part; a separation is the gap along its normal. Where the descent finds no least value, nothing is returned and the
// general path answers. The same bits at every level of the instruction set.
#pragma once

#include <optional>

#include "narrow/core/core.hpp"
#include "narrow/depth/core_sum.hpp"
#include "simd/dispatch.hpp"

namespace graze {

struct NewtonDepth {
  Vec3d normal;  ///< unit, from A to B
  double depth;  ///< along the normal; negative when the cores are apart by at least as much
  Vec3d a, b;    ///< the deepest points, if the depth is not negative
  double lower;  ///< proven lower bound of the depth
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// `b_in_a` is B's pose in A's frame. Ends early where the cores are more than `limit` apart, which may be
    /// infinite.
    std::optional<NewtonDepth> newton_depth(const SummedCore& a, const SummedCore& b, const Posed& b_in_a,
                                            double limit);)
// clang-format on

}  // namespace graze
