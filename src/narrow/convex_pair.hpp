// The one table of pairs: which routine answers for two convex shapes.
//
// Guarantee: total. Every pair of the list of shapes has an entry; a shape that fits none does not compile.
#pragma once

#include "graze/query.hpp"

namespace graze {

/// `distance` of two convex shapes.
template <class T>
Distance<T> convex_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            Trace* trace);

/// `overlap` of two convex shapes.
template <class T>
bool convex_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace* trace);

/// `contacts` of two convex shapes: fills the manifold; returns its smallest signed distance, or infinity when there is
/// nothing within `margin`.
template <class T>
Distance<T> convex_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                            T margin, Manifold<T>& manifold, Trace* trace);

}  // namespace graze
