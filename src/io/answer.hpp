// The answer to a question, as the members of a JSON object.
#pragma once

#include "io/json_writer.hpp"
#include "io/question.hpp"

namespace graze::io {

/// Writes the members of the answer into an open object. Throws `InvalidValue` when there is no answer.
template <class T>
void write_answer(const Question<T>& question, JsonWriter& out);

}  // namespace graze::io
