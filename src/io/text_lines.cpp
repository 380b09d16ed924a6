#include "io/text_lines.hpp"

#include <charconv>
#include <cmath>

#include "graze/error.hpp"
#include "io/parsed_number.hpp"

namespace graze::io {

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string out = "\"";
  for (const char c : text.substr(0, longest)) out += c < ' ' || c > '~' ? '?' : c;
  out += text.size() > longest ? "...\"" : "\"";
  return out;
}

std::optional<double> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [value, length, error] = parse_number(word);
  // Beyond a double's range the word is still a number: a huge one, or one that is zero but for its rounding.
  if (error == std::errc::result_out_of_range && length == word.size())
    return word.find("e-") == std::string_view::npos && word.find("E-") == std::string_view::npos ? HUGE_VAL : 0.0;
  if (error != std::errc() || length != word.size()) return std::nullopt;
  return value;
}

bool TextLines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  text_ = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  line_ = ++lines_;
  return true;
}

bool TextLines::next_joined() {
  const auto continues = [](std::string_view text) { return text.ends_with('\\') || text.ends_with("\\\r"); };
  if (!next()) return false;
  if (!continues(text_)) return true;
  const std::size_t first = line_;
  joined_.clear();
  do {
    joined_.append(text_.substr(0, text_.rfind('\\'))).append(" ");
  } while (next() && continues(text_));
  if (!continues(text_)) joined_.append(text_);
  text_ = joined_;
  line_ = first;
  return true;
}

Words TextLines::words() const {
  Words words;
  for (std::size_t i = 0; i < text_.size();) {
    while (i < text_.size() && is_space(text_[i])) ++i;
    const std::size_t begin = i;
    while (i < text_.size() && !is_space(text_[i])) ++i;
    if (i > begin) words.push_back(text_.substr(begin, i - begin));
  }
  return words;
}

std::size_t TextLines::whole(std::string_view word) const {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    throw InvalidValue(place(), "a whole number >= 0", quoted(word));
  return value;
}

void TextLines::fail(const std::string& expectation) const { throw InvalidValue(place(), expectation, quoted(text_)); }

}  // namespace graze::io
