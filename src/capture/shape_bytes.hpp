// Shapes as bytes of a capture.
//
// Guarantee: a shape that was read has the numbers of the one that was written; a convex hull those of its vertices,
// and an outline of the plane those of its corners, from which it is built anew. Throws `Damaged` for bytes that are no
// shape, and the errors of the shapes' constructors.
#pragma once

#include "capture/bytes.hpp"
#include "graze/error.hpp"

namespace graze::capture {

/// The most levels of compounds within compounds.
inline constexpr int deepest_compound = 32;

/// Writes a shape of space or of the plane (`AnyShape`). Throws `InvalidValue` for a user's shape, whose support
/// function no file can hold.
template <class AnyShape>
void write_shape(Writing& io, const AnyShape& shape);

template <class AnyShape>
AnyShape read_shape(Reading& io, int depth = 0);

}  // namespace graze::capture
