// The answer to a question, as the members of a JSON object.
#pragma once

#include "graze/contact.hpp"
#include "graze/trace.hpp"
#include "io/json_writer.hpp"
#include "io/question.hpp"

namespace graze::io {

/// Writes the members of the answer into an open object. Throws `InvalidValue` when there is no answer.
template <class T>
void write_answer(const Question<T>& question, JsonWriter& out);

/// Of a question in the plane, leaves of the points, which stand twice at both depths of the prisms, one each, at z = 0.
template <class T>
void leave_plane_points(Manifold<T>& manifold);

/// And leaves of the axes those that lie in the plane, each direction once: the rest belong to the prisms
/// that stand for the figures.
void leave_plane_axes(Trace& trace);

/// And of the spans those across the plane.
void leave_plane_spans(Trace& trace);

}  // namespace graze::io
