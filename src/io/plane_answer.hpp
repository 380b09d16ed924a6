// The answer to a question in two dimensions.
#pragma once

#include "graze/io/explain.hpp"
#include "io/json_writer.hpp"
#include "io/plane_question.hpp"

namespace graze::io {

/// Writes the members of the answer into an open object. Throws `InvalidValue` when there is no answer.
template <class T>
void write_plane_answer(const PlaneQuestion<T>& question, JsonWriter& out);

/// Fills in the answer to the question, at z = 0, but for the shapes to be drawn.
template <class T>
void explain_in_plane(const PlaneQuestion<T>& question, Explanation& explanation);

}  // namespace graze::io
