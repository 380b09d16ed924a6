// The lines of a text and the words in them, for formats that are written line by line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graze::io {

using Words = std::vector<std::string_view>;

inline bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Text for an error: in quotes, shortened when long, without characters that no terminal shows.
std::string quoted(std::string_view text);

/// The number that a whole word is, infinities and NaN included; or nothing.
std::optional<double> number_in(std::string_view word);

/// A text without the byte-order mark of UTF-8 that editors of some systems put before it.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(without_byte_order_mark(text)) {}

  /// Goes on to the next line, which ends with \n or \r\n; false at the end.
  bool next();
  /// Goes on to the next line, joined with those after it where a line ends with a backslash.
  bool next_joined();

  Words words() const;
  std::size_t line() const { return line_; }       ///< counted from 1
  std::string_view rest() const { return rest_; }  ///< behind this line
  std::string place() const { return "line " + std::to_string(line_); }

  /// The whole number >= 0 that a word of this line must be.
  std::size_t whole(std::string_view word) const;
  [[noreturn]] void fail(const std::string& expectation) const;

 private:
  std::string_view rest_, text_;
  std::string joined_;
  std::size_t line_ = 0, lines_ = 0;
};

}  // namespace graze::io
