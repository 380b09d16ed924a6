// A special pair is one struct, which the list of pairs (`narrow/pair_list.hpp`) names, and from which everything else
// follows: the table for single pairs, the kernels for batches, for the world's bins and for runs of a mesh's
// triangles.
//
// The struct names the kinds of its two shapes, in the order of `ShapeList`, as the templates `A` and `B` (from its
// base `PairOfKinds`). All other members are optional; missing ones, and shapes without an answer, are left to the
// general path:
//
//     distance(a, b) -> std::optional<Distance<T>>
//     overlap(a, b) -> std::optional<bool>             cheaper than the distance
//     overlaps_by_distance = true                      no cheaper test, and the distance costs as little
//     may_overlap(a, b) -> bool                        a first test, which may be true for disjoint shapes
//     contacts(a, b, margin, manifold) -> std::optional<T>   the distance; fills the manifold
//     more_contacts(a, b, margin, manifold)            where `contacts` found the closest points only, and left these
//
// Pairs of `graze/typed_query.hpp` fill any type with a normal and points: a `Manifold`, or one of fixed size.
//
// Members across lanes, for shapes that `taken_by_lanes` (`narrow/batch/lane_shapes.hpp`) names, without rounding:
//
//     overlap_rows<T>(), distance_rows<T>(), contact_rows<T>()   kernels for pairs in rows (`pair_kernels.hpp`)
//     visit_contacts(pairs, count, turned, sink)                 passes the kernels' results to a `contact_sink.hpp`
//     overlaps_by_mpr = true                                     batches ask for what is left by MPR, which is
//                                                                faster than the routine of a single pair
//     takes_all_shapes = true                                    no shape is filtered out: the kernels check themselves
//
// Members by which a pair is compiled with the kernels of a family, which it then names in the members above:
//
//     closed_form_rows = true      `row_overlaps`, `row_distances`: a `distance_of` is there (`pairs/row_distance.hpp`)
//     one_contact_kernels = true   `sphere_capsule_contacts`, `sphere_capsule_row_contacts`
//     half_space_kernels = true    `half_space_slots`
#pragma once

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "shape/rounding.hpp"

namespace graze {

/// The kinds of a pair's two shapes, as its struct names them.
template <template <class> class KindA, template <class> class KindB>
struct PairOfKinds {
  template <class T>
  using A = KindA<T>;
  template <class T>
  using B = KindB<T>;
};

/// A convex shape in place, as the routine of a pair takes it.
template <class C, class T>
struct InPlace {
  const C& shape;
  T rounded_by;  ///< `rounding()`
  const Pose<T>& pose;

  /// The rounding radius of the shape.
  T rounding() const { return rounded_by; }
  /// The rounding radius plus the core's own.
  T radius() const { return rounding_radius(shape, rounded_by); }
};

}  // namespace graze
