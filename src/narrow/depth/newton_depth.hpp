// The depth of two cores that are sums of boxes and ellipsoids, by descent on the sphere of directions and a proof.
//
// Guarantee: a depth is the overlap along its normal, and no translation is shorter than `lower`, what of it is proven;
// a separation is the gap along its normal. Where the descent ends in no least value, nothing is returned and the
// general path answers. The same bits at every level of the instruction set.
#pragma once

#include <optional>

#include "narrow/core/core.hpp"
#include "narrow/depth/core_sum.hpp"
#include "simd/dispatch.hpp"

namespace graze {

struct DirectDepth {
  Vec3d normal;  ///< unit, from A to B
  double depth;  ///< along the normal; negative when the cores are apart by as much or more
  Vec3d a, b;    ///< the deepest points, only where the depth is not negative
  double lower;  ///< what the depth is proven not to fall below
};

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// The way from A's origin to B's and B's rotation are seen from A. Ends early where the cores are more than
    /// `limit` apart, which may be infinite.
    std::optional<DirectDepth> newton_depth(const SummedCore& a, const SummedCore& b, const Posed& b_in_a,
                                            double limit);)
// clang-format on

}  // namespace graze
