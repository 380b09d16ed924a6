// The query protocol for JavaScript: one line in, one line out.
#include "graze/io/protocol.hpp"

#include <cstdint>

namespace {

std::string answer;  ///< the last one

}  // namespace

extern "C" {

/// Answers the line of `length` bytes; returns where the answer's bytes are, and writes their number to `count`.
__attribute__((export_name("graze_js_answer"))) const char* graze_js_answer(const char* line, std::size_t length,
                                                                            bool explained, std::size_t* count) {
  const std::string_view text(line, length);
  const auto precision = graze::io::Precision::double_precision;
  answer = (explained ? graze::io::explained_line(text, precision) : graze::io::answer_line(text, precision)).text;
  *count = answer.size();
  return answer.data();
}

}  // extern "C"
