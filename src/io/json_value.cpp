#include "io/json_value.hpp"

#include <algorithm>
#include <cstdlib>

namespace graze::io {

namespace {

constexpr std::string_view overflow_mark = "\x01number:";
constexpr std::size_t longest_shown = 80;

bool in_number(char c) { return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E'; }

/// The place behind the string that begins at `i`.
std::size_t string_end(std::string_view text, std::size_t i) {
  for (++i; i < text.size() && text[i] != '"'; ++i)
    if (text[i] == '\\') ++i;
  return i + 1;
}

/// The place behind the value that begins at `i`, in text that is JSON.
std::size_t value_end(std::string_view text, std::size_t i) {
  for (int depth = 0; i < text.size();) {
    const char c = text[i];
    if (depth == 0 && (c == ',' || c == '}' || c == ']')) return i;
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    i = c == '"' ? string_end(text, i) : i + 1;
  }
  return text.size();
}

/// A first pass over the text, outside of strings: bounds the nesting and marks the numbers that overflow.
class Scan {
 public:
  explicit Scan(std::string_view text) : text_(text) {
    for (std::size_t i = 0; i < text.size();) i = step(i);
    if (!marked_.empty()) marked_.append(text.substr(copied_));
  }
  std::string_view result() const { return marked_.empty() ? text_ : std::string_view(marked_); }

 private:
  std::size_t step(std::size_t i) {
    const char c = text_[i];
    if (c == '"') return string_end(text_, i);
    if (in_number(c)) return number_end(i);
    if ((c == '{' || c == '[') && ++depth_ > max_json_depth)
      throw InvalidValue("", "JSON nested at most " + std::to_string(max_json_depth) + " deep", "deeper nesting");
    if (c == '}' || c == ']') --depth_;
    return i + 1;
  }
  std::size_t number_end(std::size_t begin) {
    std::size_t end = begin;
    while (end < text_.size() && in_number(text_[end])) ++end;
    const std::string number(text_.substr(begin, end - begin));
    char* parsed = nullptr;
    // Short numbers without an exponent cannot overflow, and are by far the most.
    const bool may_overflow = number.size() > 300 || number.find_first_of("eE") != std::string::npos;
    if (!may_overflow || std::isfinite(std::strtod(number.c_str(), &parsed)) || *parsed != '\0') return end;
    marked_.append(text_.substr(copied_, begin - copied_));
    marked_.append("\"\\u0001number:").append(number).append("\"");
    copied_ = end;
    return end;
  }

  std::string_view text_;
  std::string marked_;
  std::size_t copied_ = 0;
  int depth_ = 0;
};

}  // namespace

Json parse_json(std::string_view text) {
  // The parser would take a zero byte for the end of the text, whatever follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    throw InvalidValue("", "one JSON object", "a zero byte behind " + std::to_string(zero) + " others");
  const Scan scan(text);
  const std::string_view checked = scan.result();
  try {
    return Json::parse(checked.begin(), checked.end());
  } catch (const Json::exception& e) {
    // The parser's own words, without its error number in front.
    std::string why = e.what();
    if (const auto close = why.find("] "); close != std::string::npos) why.erase(0, close + 2);
    for (char& c : why)
      if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
    if (why.size() > 300) why = why.substr(0, 300) + "...";
    throw InvalidValue("", "one JSON object", "text that is none: " + why);
  }
}

std::string member_text(std::string_view text, std::string_view key) {
  std::string found;
  for (std::size_t i = text.find('"'); i < text.size(); i = text.find('"', i)) {
    const std::size_t colon = string_end(text, i), value = text.find_first_not_of(" \t\r\n:", colon);
    // A key may be written with escapes.
    const bool same = Json::parse(text.substr(i, colon - i)) == key;
    i = value_end(text, value);
    if (!same) continue;
    found = text.substr(value, i - value);
    found.erase(found.find_last_not_of(" \t\r\n") + 1);
  }
  for (char& c : found)
    if (c == '\n' || c == '\r') c = ' ';  // between values only, and an answer is one line
  return found;
}

std::string json_quoted(const std::string& words) {
  return Json(words).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string shown(const Json& value) {
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text.starts_with(overflow_mark)) return text.substr(overflow_mark.size(), longest_shown);
  }
  // The size is counted before the text is made: a large value is named by its kind, not printed to be cut.
  if (value.is_structured() && value.size() > longest_shown / 2)
    return std::string(value.is_array() ? "an array of " : "an object of ") + std::to_string(value.size());
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > longest_shown) text = text.substr(0, longest_shown) + "...";
  return text;
}

const JsonValue& JsonValue::keys(std::initializer_list<std::string_view> known) const {
  if (!json_->is_object()) fail("an object");
  for (const auto& [key, value] : json_->items()) {
    if (key == "comment" || std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string names;
    for (const std::string_view k : known) names += (names.empty() ? "" : ", ") + std::string(k);
    const std::string outer = path_.empty() ? "" : path_ + ".";
    const std::string name = key.size() > longest_shown ? key.substr(0, longest_shown) + "..." : key;
    throw InvalidValue(outer + name, names.empty() ? "no keys" : "one of the keys " + names, "an unknown key");
  }
  return *this;
}

JsonValue JsonValue::at(const char* key) const {
  const auto value = find(key);
  if (!value) throw InvalidValue(path_.empty() ? key : path_ + "." + key, "a value", "nothing");
  return *value;
}

std::optional<JsonValue> JsonValue::find(const char* key) const {
  if (!json_->is_object()) fail("an object");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return JsonValue(*found, path_.empty() ? key : path_ + "." + key);
}

std::vector<JsonValue> JsonValue::elements(std::optional<std::size_t> count) const {
  const std::string expected = count ? "an array of " + std::to_string(*count) : "an array";
  if (!json_->is_array() || (count && json_->size() != *count)) fail(expected);
  std::vector<JsonValue> parts;
  parts.reserve(json_->size());
  for (std::size_t i = 0; i < json_->size(); ++i)
    parts.emplace_back((*json_)[i], path_ + "[" + std::to_string(i) + "]");
  return parts;
}

std::string JsonValue::string() const {
  if (!json_->is_string()) fail("a string");
  return json_->get<std::string>();
}

bool JsonValue::boolean() const {
  if (!json_->is_boolean()) fail("true or false");
  return json_->get<bool>();
}

std::size_t JsonValue::whole_number(std::size_t least) const {
  const double value = json_->is_number() ? json_->get<double>() : -1;
  // Beyond 2^53 doubles do not hold every whole number, and nothing here counts that far.
  if (!(value >= static_cast<double>(least)) || value != std::floor(value) || value > 9007199254740992.0)
    fail("a whole number >= " + std::to_string(least));
  return static_cast<std::size_t>(value);
}

std::size_t JsonValue::index_below(std::size_t count) const {
  const std::size_t index = whole_number();
  if (index >= count) fail("an index below " + std::to_string(count));
  return index;
}

}  // namespace graze::io
