// The member "trace" of an answer: the steps of the query, as JSON.
#pragma once

#include "graze/trace.hpp"
#include "io/json_writer.hpp"

namespace graze::io {

/// Writes the member into an open object.
void write_trace(const Trace& trace, JsonWriter& out);

}  // namespace graze::io
