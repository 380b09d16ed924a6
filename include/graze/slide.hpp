// Movement of characters: as far as there is room, and the rest along what is in the way.
//
// Guarantee: the shape never enters anything that it was not in before, by more than the tolerance of `cast`; it ends
// after a few casts whatever the scene. A function of the scene and the question alone.
//
// Source: Fauerby 2003, "Improved collision detection and response", on sliding planes; two planes leave the line along
// which they cross, three leave nothing.
#pragma once

#include "graze/world.hpp"

namespace graze {

/// What a slide may be told.
struct SlideOptions {
  int iterations = 6;  ///< casts, at most
};

/// Where a slide ended.
template <class T>
struct SlideResult {
  Pose<T> pose{};                       ///< where the shape ends
  Vec3<T> left{};                       ///< what was still to be made when the casts were used up
  std::vector<BodyCastHit<T>> touched;  ///< what was in the way, in the order in which it was met
};

/// What is left of a motion in front of planes: the nearest motion that leads into none of them. `normals` are unit and
/// point away from what is in the way.
template <class T>
GRAZE_API Vec3<T> along_planes(const Vec3<T>& motion, std::span<const Vec3<T>> normals);

/// Moves a shape by `motion` through a world, without turning: until it touches, then along the surface, and so on.
/// What it touches and does not press against does not hold it. Cost: `iterations` casts.
template <class T>
GRAZE_API SlideResult<T> slide(const Shape<T>& shape, const Pose<T>& pose, const Vec3<T>& motion, const World<T>& world,
                               const QueryFilter& filter = {}, const SlideOptions& options = {});

}  // namespace graze
