// The query protocol: one query in JSON a line, one answer in JSON a line.
//
// Guarantee: every line that is not blank gets exactly one answer, in order; whatever its bytes, it can neither crash
// nor hang the process, nor make it hold more than a small multiple of the line itself. An invalid line is answered by
// an error that names the path of the value at fault, the expectation there and the value found.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

#include "graze/detail/standard.hpp"

namespace graze::io {

/// The scalar that answers.
enum class Precision { single_precision, double_precision };

/// The answer to one line.
struct AnswerLine {
  std::string text;    ///< one JSON object, without a line end
  bool error = false;  ///< whether the line could not be answered
};

/// Answers one query. `number` is that of its line, counted from 1: an error without an `id` to identify it begins with
/// the number, as in `answer_stream`.
GRAZE_API AnswerLine answer_line(std::string_view line, Precision precision, std::size_t number = 0);

/// The answer to a line with its trace, whether the query requests that (`explain`) or not.
GRAZE_API AnswerLine explained_line(std::string_view line, Precision precision);

/// Answers all lines of `in`, one at a time; flushes before it waits for more input. An error without an `id` to
/// identify it begins with its line, counted from 1: "line 3: ...". Stops when `out` takes no more, which the state of
/// `out` shows. Returns the number of answers that were errors.
GRAZE_API std::size_t answer_stream(std::istream& in, std::ostream& out, Precision precision);

}  // namespace graze::io
