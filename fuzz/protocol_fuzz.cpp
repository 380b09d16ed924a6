// Any bytes as a question: one answer, which is one JSON object on one line.
#include <cstdint>
#include <string_view>

#include <nlohmann/json.hpp>

#include "graze/error.hpp"
#include "graze/io/protocol.hpp"
#include "io/json_value.hpp"

namespace {

/// The answer, read by a parser that had no part in it. That one refuses numbers that no double holds; the question's
/// id may have some and is echoed as it stands.
nlohmann::json read(const std::string& text) {
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_discarded()) return json;
  try {
    return graze::io::parse_json(text);
  } catch (const graze::InvalidValue&) {
    return json;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using graze::io::Precision;
  const std::string_view line(reinterpret_cast<const char*>(bytes), size);
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const graze::io::AnswerLine answer = graze::io::answer_line(line, precision);
    if (answer.text.find('\n') != std::string::npos) __builtin_trap();
    const auto json = read(answer.text);
    if (!json.is_object() || json.contains("error") != answer.error) __builtin_trap();
  }
  return 0;
}
