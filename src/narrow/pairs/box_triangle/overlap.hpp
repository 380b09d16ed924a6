// Box against triangle: the overlap test.
//
// Guarantee: in every lane the answer that the pair gives alone. `contacts` tests the same axes, and agrees wherever
// the faces that these lead to determine its points.
#pragma once

#include "narrow/pairs/box_triangle/sat.hpp"

namespace graze {

/// Whether a box and a triangle touch, both without rounding, and whether that is known: not for slivers that the box's
/// own axes do not separate from it, nor where lengths are outside the bounds of `regular_box`.
template <class S>
struct BoxTouchesTriangle {
  decltype(S() < S()) touch, known;

  BoxTouchesTriangle(const BoxCore<S>& box, const Pose<S>& pose_box, const TriangleCore<S>& triangle,
                     const Pose<S>& pose_triangle) {
    TriangleDirections<S> directions;
    const S distance =
        triangle_reference_axis(BoxAndTriangle<S>(box, pose_box, triangle, pose_triangle), S(0), directions).distance;
    touch = !(distance > S(0));
    known = (distance > S(-std::numeric_limits<typename LaneOf<S>::type>::infinity())) & regular_box(box.half);
  }
};

}  // namespace graze
