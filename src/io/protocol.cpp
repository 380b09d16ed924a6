#include "graze/io/protocol.hpp"

#include <istream>
#include <ostream>

#include "io/answer.hpp"

namespace graze::io {

namespace {

bool blank(std::string_view line) { return line.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos; }

/// The members of the answer, as text that begins after the id.
template <class T>
std::string answered(const Json& json, const std::string& id) {
  JsonWriter out;
  out.open('{');
  if (!id.empty()) out.key("id").raw(id);
  write_answer(read_question<T>(JsonValue(json, "")), out);
  return out.close('}').take();
}

AnswerLine failed(const std::string& id, const std::string& why) {
  JsonWriter out;
  out.open('{');
  if (!id.empty()) out.key("id").raw(id);
  out.key("error").raw(Json(why).dump(-1, ' ', true, Json::error_handler_t::replace)).close('}');
  return {out.take(), true};
}

}  // namespace

AnswerLine answer_line(std::string_view line, Precision precision) {
  std::string id;
  try {
    const Json json = parse_json(line);
    if (!json.is_object()) throw InvalidValue("", "one JSON object", shown(json));
    // As it stands: parsed and written again, a long number would lose its digits.
    if (json.contains("id")) id = member_text(line, "id");
    return {precision == Precision::double_precision ? answered<double>(json, id) : answered<float>(json, id), false};
  } catch (const InvalidValue& e) {
    return failed(id, e.what());
  } catch (const std::bad_alloc&) {
    return failed(id, "expected a question that fits into memory, got a larger one");
  }
}

std::size_t answer_stream(std::istream& in, std::ostream& out, Precision precision) {
  std::size_t errors = 0;
  std::string line;
  while (std::getline(in, line)) {
    if (!blank(line)) {
      const AnswerLine answer = answer_line(line, precision);
      errors += answer.error;
      out << answer.text << '\n';
    }
    // Whoever asks one question at a time waits for its answer; whoever sends many at once is not slowed down.
    if (in.rdbuf()->in_avail() <= 0) out.flush();
  }
  out.flush();
  return errors;
}

}  // namespace graze::io
