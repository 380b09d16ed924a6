// Shapes as the query protocol reads them.
//
// Guarantee: the text read in double gives a shape of the same measures; those of `float` are widened, exactly.
#pragma once

#include "graze/plane/shape.hpp"
#include "graze/shape.hpp"
#include "io/json_writer.hpp"

namespace graze::io {

/// Writes a shape of space. Throws `InvalidValue` for one that the protocol cannot express: a user's own, and a mesh or
/// a height field that is seen from its front alone. A ball beside its origin becomes a compound of one child, a
/// segment the hull of its two ends.
template <class T>
void write_shape(JsonWriter& out, const Shape<T>& shape);

/// Writes a place in the plane: the keys `translation` and, where it is turned, `rotation` in radians.
template <class T>
void write_pose(JsonWriter& out, const plane::Pose2<T>& pose);

/// Writes a shape of the plane. Throws `InvalidValue` for a user's own.
template <class T>
void write_shape(JsonWriter& out, const plane::Shape<T>& shape);

}  // namespace graze::io
