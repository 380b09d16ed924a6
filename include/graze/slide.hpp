// Character movement: as far as there is room, and the rest along the obstacles.
//
// Guarantee: the shape never enters an obstacle that it was not in before, by more than the tolerance of `cast`; it
// ends after a few casts whatever the scene. A function of the scene and the arguments alone.
//
// Source: Fauerby 2003, "Improved collision detection and response", on sliding planes; two planes leave the line along
// which they cross, three leave nothing.
#pragma once

#include "graze/world.hpp"

namespace graze {

/// Options of a slide.
struct SlideOptions {
  int iterations = 6;  ///< casts, at most
};

/// The end of a slide.
template <class T>
struct SlideResult {
  Pose<T> pose{};                       ///< pose at the end
  Vec3<T> left{};                       ///< the rest of the motion when the casts were used up
  std::vector<BodyCastHit<T>> touched;  ///< obstacles, in the order in which they were met
};

/// The part of a motion that planes leave: the nearest motion that leads into none of them. `normals` are unit and
/// point away from the obstacles.
template <class T>
GRAZE_API Vec3<T> along_planes(const Vec3<T>& motion, std::span<const Vec3<T>> normals);

/// Moves a shape by `motion` through a world, without turning: until it touches, then along the surface, and so on.
/// Bodies that it touches without pressing against them do not hold it. Cost: `iterations` casts.
template <class T>
GRAZE_API SlideResult<T> slide(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& motion, const World<T>& world,
                               const QueryFilter& filter = {}, const SlideOptions& options = {});

}  // namespace graze
