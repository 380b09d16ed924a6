// The one table of pairs: which routine answers for two convex shapes.
//
// Guarantee: total. Every pair of the list of shapes has an entry; a shape that fits none does not compile.
#pragma once

#include "graze/query.hpp"

namespace graze {

/// Whether two shapes stand in the question against the order of the list of shapes. They are then asked about the
/// other way round and the answer mirrored, so that swapping shapes of two kinds changes not one bit.
template <class T>
bool against_order(const Shape<T>& a, const Shape<T>& b) {
  return a.index() > b.index();
}

/// `distance` of two convex shapes that stand in order, without the axes of an explanation. Where it is more than
/// `limit` the answer may be anything between the two that is proven, along its normal and without the points.
template <class T>
Distance<T> ordered_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                             T limit, Trace* trace);

/// `distance` of two convex shapes.
template <class T>
Distance<T> convex_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            Trace* trace);

/// `overlap` of two convex shapes.
template <class T>
bool convex_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace* trace);

/// `may_overlap` of two convex shapes.
template <class T>
bool convex_may_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b);

/// `contacts` of two convex shapes: fills the manifold. Returns their signed distance, of boxes that are apart a lower
/// bound with its sign, or where it is more than `margin`, something between the two; the normal is then a direction
/// that separates them by as much, or of two boxes as it was.
template <class T>
T convex_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                  Manifold<T>& manifold, Trace* trace);

/// The contacts of two bounded convex shapes along a normal that is given (unit, from A to B): their faces that meet
/// along it, laid over each other. Appends the points up to `margin` apart; there may be none.
template <class T>
void contacts_along(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                    const Vec3<T>& normal, T margin, Manifold<T>& manifold);

}  // namespace graze
