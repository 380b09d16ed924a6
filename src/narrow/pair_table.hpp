// The table of pairs: the routines that answer for two convex shapes.
//
// Guarantee: total. Every pair of the list of shapes has an entry; a shape that fits none does not compile.
#pragma once

#include <optional>

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"

namespace graze {

/// Whether two shapes are given against the order of the list of shapes. They are then swapped and the answer mirrored,
/// so that swapping shapes of two kinds changes not one bit.
template <class T>
bool against_order(const Shape<T>& a, const Shape<T>& b) {
  return a.index() > b.index();
}

/// The distance of two convex shapes in order by the pair's own routine. Nothing where it has none, or none for these
/// values.
template <class T>
std::optional<Distance<T>> special_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b,
                                            const Pose<T>& pose_b);

/// The overlap of two convex shapes in order by the pair's own routine; nothing without one.
template <class T>
std::optional<bool> special_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// Whether overlap of two convex shapes in order is derived from their distance where no special routine answers: pairs
/// with a closed form.
template <class T>
bool overlaps_by_distance_alone(const Shape<T>& a, const Shape<T>& b);

/// `distance` of two convex shapes in order: the special routine's answer if there is one, else the general path's.
/// Beyond `limit` the answer may be any proven bound between the limit and the distance, along its normal and without
/// the points.
template <class T>
Distance<T> ordered_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                             T limit);

/// `distance` of two convex shapes.
template <class T>
Distance<T> convex_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// `overlap` of two convex shapes.
template <class T>
bool convex_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// `may_overlap` of two convex shapes.
template <class T>
bool convex_may_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// `contacts` of two convex shapes: fills the manifold. Returns their signed distance, for boxes that are apart a lower
/// bound with its sign, or where it exceeds `margin`, a number between the two; the normal is then a direction that
/// separates them by as much, or for two boxes unchanged.
template <class T>
T convex_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                  Manifold<T>& manifold);

/// The contacts of two bounded convex shapes along a given normal (unit, from A to B): their faces that meet along it,
/// clipped by each other. Appends the points up to `margin` apart; there may be none.
template <class T>
void contacts_along(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                    const Vec3<T>& normal, T margin, Manifold<T>& manifold);

}  // namespace graze
