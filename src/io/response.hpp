// The query `response` of the protocol: the effect of a blow.
#pragma once

#include "graze/impulse.hpp"
#include "io/json_value.hpp"
#include "io/json_writer.hpp"

namespace graze::io {

template <class T>
struct ResponseQuestion {
  int dimension = 3;
  StruckContact<T> contact;
  StruckBody<T> a, b;
  bool explain = false;
};

/// Whether a question is a `response`.
bool asks_for_response(const JsonValue& json);

/// Reads the question; throws `InvalidValue` with the path of the first value at fault.
template <class T>
ResponseQuestion<T> read_response(const JsonValue& json);

/// Writes the members of the answer into an open object. Throws `InvalidValue` when there is no answer.
template <class T>
void write_response(const ResponseQuestion<T>& question, JsonWriter& out);

}  // namespace graze::io
