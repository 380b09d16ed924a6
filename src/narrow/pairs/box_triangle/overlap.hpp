// Box against triangle: whether they touch.
//
// Guarantee: in every lane what the pair gives alone. `contacts` asks the same axes, and says the same wherever the
// faces that these lead to tell its points.
#pragma once

#include "narrow/pairs/box_triangle/sat.hpp"

namespace graze {

/// Whether a box and a triangle touch, both without a margin, and whether that is known: not of slivers that the box's
/// own axes do not part from it, nor where lengths are not those of `regular_box`.
template <class S>
struct BoxTouchesTriangle {
  decltype(S() < S()) touch, known;

  BoxTouchesTriangle(const BoxCore<S>& box, const Pose<S>& pose_box, const TriangleCore<S>& triangle,
                     const Pose<S>& pose_triangle) {
    TriangleDirections<S> directions;
    const S distance =
        triangle_choice(BoxAndTriangle<S>(box, pose_box, triangle, pose_triangle), S(0), directions).distance;
    touch = !(distance > S(0));
    known = (distance > S(-std::numeric_limits<typename LaneOf<S>::type>::infinity())) & regular_box(box.half);
  }
};

}  // namespace graze
