// Movement of characters in the plane: as far as there is room, and the rest along what is in the way.
//
// Guarantee: that of `graze/slide.hpp`, whose code it is: the shape never enters anything that it was not in before, by
// more than the tolerance of `cast`; it ends after a few casts whatever the scene. A function of the scene and the
// question alone.
#pragma once

#include <span>
#include <vector>

#include "graze/plane/world.hpp"
#include "graze/slide.hpp"

namespace graze::plane {

/// The end of a slide.
template <class T>
struct SlideResult {
  Pose2<T> pose{};                      ///< where the shape ends
  Vec2<T> left{};                       ///< what was still to be made when the casts were used up
  std::vector<BodyCastHit<T>> touched;  ///< what was in the way, in the order in which it was met
};

/// The rest of a motion in front of lines: the nearest motion that leads into none of them; two that meet in a
/// corner leave nothing of a motion into it. `normals` are unit and point away from what is in the way.
template <class T>
GRAZE_API Vec2<T> along_lines(const Vec2<T>& motion, std::span<const Vec2<T>> normals);

/// Moves a shape by `motion` through a world, without turning: until it touches, then along the outline, and so on.
/// Bodies that it touches and does not press against do not hold it. Cost: `iterations` casts.
template <class T>
GRAZE_API SlideResult<T> slide(const Shape<T>& shape, const Pose2<T>& pose, const Vec2<T>& motion,
                               const World<T>& world, const QueryFilter& filter = {}, const SlideOptions& options = {});

}  // namespace graze::plane
