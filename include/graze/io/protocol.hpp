// The query protocol: one JSON question a line, one JSON answer a line.
//
// Guarantee: every line that is not blank gets exactly one answer, in order; whatever its bytes, it can neither crash
// nor hang the process, nor make it hold more than a small multiple of the line itself. What cannot be answered is
// answered by an error that names the path of the value at fault, what was expected there and what was found.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

#include "graze/standard.hpp"

namespace graze::io {

/// The scalar that answers.
enum class Precision { single_precision, double_precision };

/// What is answered to one line.
struct AnswerLine {
  std::string text;    ///< one JSON object, without a line end
  bool error = false;  ///< whether the line could not be answered
};

/// Answers one question. With the number of its line, counted from 1, as `answer_stream` does: an error that has no
/// `id` to be known by begins with it.
GRAZE_API AnswerLine answer_line(std::string_view line, Precision precision, std::size_t number = 0);

/// The answer to a line with its trace, whether the question asks for it (`explain`) or not.
GRAZE_API AnswerLine explained_line(std::string_view line, Precision precision);

/// Answers all lines of `in`, one at a time; flushes before it would wait for more input. An error that has no `id` to
/// be known by begins with its line, counted from 1: "line 3: ...". Stops when `out` takes no more, which its state
/// tells. Returns how many answers were errors.
GRAZE_API std::size_t answer_stream(std::istream& in, std::ostream& out, Precision precision);

}  // namespace graze::io
