// Any bytes as a question: one answer, which is one JSON object on one line.
#include <cstdint>
#include <string_view>

#include <nlohmann/json.hpp>

#include "graze/io/protocol.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using graze::io::Precision;
  const std::string_view line(reinterpret_cast<const char*>(bytes), size);
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    const graze::io::AnswerLine answer = graze::io::answer_line(line, precision);
    if (answer.text.find('\n') != std::string::npos) __builtin_trap();
    const auto json = nlohmann::json::parse(answer.text, nullptr, false);
    if (!json.is_object() || json.contains("error") != answer.error) __builtin_trap();
  }
  return 0;
}
