// Shapes as bytes of a capture.
//
// Guarantee: a shape that was read has the numbers of the one that was written; of a convex hull those of its vertices,
// from which it is built anew. Throws `Damaged` for bytes that are no shape, and what the shapes' constructors throw.
#pragma once

#include "capture/bytes.hpp"
#include "graze/error.hpp"

namespace graze::capture {

/// Compounds within compounds, at most.
inline constexpr int deepest_compound = 32;

/// Throws `InvalidValue` for a user's shape, whose support function no file can hold.
template <class T>
void write_shape(Writing& io, const Shape<T>& shape);

template <class T>
Shape<T> read_shape(Reading& io, int depth = 0);

}  // namespace graze::capture
