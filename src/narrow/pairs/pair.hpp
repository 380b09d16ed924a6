// What a special pair is: one struct, which the list of pairs (`narrow/pair_list.hpp`) names, and from which all else
// follows: the table for single pairs, the kernels for batches, for the world's bins and for runs of a mesh's
// triangles.
//
// The struct names the kinds of its two shapes, in the order of `ShapeList`, as the templates `A` and `B`. Everything
// else is optional; what a pair does not have, or does not know for the shapes at hand, is left to the general path:
//
//     distance(a, b) -> std::optional<Distance<T>>
//     overlap(a, b) -> std::optional<bool>             sooner known than the distance
//     overlaps_by_distance = true                      no sooner, and the distance costs as little
//     may_overlap(a, b) -> bool                        a first look that may say yes wrongly
//     contacts(a, b, margin, manifold) -> std::optional<T>   the distance; fills the manifold
//     more_contacts(a, b, margin, manifold)            where `contacts` knew the closest points only, and left these
//
// Pairs of `graze/typed_query.hpp` fill whatever has a normal and points: a `Manifold`, or one of fixed size.
//
// and across lanes, for shapes that `taken_by_lanes` (`narrow/batch/lane_pairs.hpp`) names, without rounding:
//
//     overlap_rows<T>(), distance_rows<T>(), contact_rows<T>()   kernels for pairs in rows (`pair_kernels.hpp`)
//     visit_contacts(pairs, count, turned, sink)                 hands what kernels find to a `contact_sink.hpp`
//     takes_all_shapes = true                                    and says itself which shapes it does not take
#pragma once

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// A convex shape in place, as the routine of a pair takes it.
template <class C, class T>
struct InPlace {
  const C& shape;
  T margin;  ///< `rounding()`
  const Pose<T>& pose;

  /// The radius of the ball that is added to the concrete shape.
  T rounding() const { return margin; }
  /// That and the shape's own.
  T radius() const { return rounding_radius(shape, margin); }
};

}  // namespace graze
