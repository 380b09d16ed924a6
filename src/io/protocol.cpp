#include "graze/io/protocol.hpp"

#include <istream>
#include <ostream>

#include "io/answer.hpp"
#include "io/plane_answer.hpp"
#include "io/response.hpp"

namespace graze::io {

namespace {

bool blank(std::string_view line) { return line.find_first_not_of(" \t\r\n\v\f") == std::string_view::npos; }

/// The manner in which a line is answered.
struct Manner {
  Precision precision;
  bool explained = false;  ///< with its trace, whatever the question says
  std::size_t line = 0;    ///< counted from 1, for errors without an id; 0 for a line by itself
};

/// The whole answer.
template <class T>
std::string answered(const Json& json, const std::string& id, const Manner& manner) {
  JsonWriter out;
  out.open('{');
  if (!id.empty()) out.key("id").raw(id);
  const JsonValue value(json, "");
  const auto asked = [&](auto question) {
    question.explain = question.explain || manner.explained;
    return question;
  };
  if (asks_for_response(value))
    write_response(asked(read_response<T>(value)), out);
  else if (in_the_plane(json))
    write_plane_answer(asked(read_plane_question<T>(value)), out);
  else
    write_answer(asked(read_question<T>(value)), out);
  return out.close('}').take();
}

AnswerLine failed(const std::string& id, const std::string& why, const Manner& manner) {
  JsonWriter out;
  out.open('{');
  if (!id.empty()) out.key("id").raw(id);
  const bool placed = id.empty() && manner.line != 0;
  const std::string message = (placed ? "line " + std::to_string(manner.line) + ": " : "") + why;
  out.key("error").raw(Json(message).dump(-1, ' ', true, Json::error_handler_t::replace)).close('}');
  return {out.take(), true};
}

AnswerLine answer(std::string_view line, const Manner& manner) {
  std::string id;
  try {
    const Json json = parse_json(line);
    if (!json.is_object()) throw InvalidValue("", "one JSON object", shown(json));
    // The id is copied as it stands: parsed and written again, a long number would lose its digits.
    if (json.contains("id")) id = member_text(line, "id");
    const bool wide = manner.precision == Precision::double_precision;
    return {wide ? answered<double>(json, id, manner) : answered<float>(json, id, manner), false};
  } catch (const InvalidValue& e) {
    return failed(id, e.what(), manner);
  } catch (const std::bad_alloc&) {
    return failed(id, "expected a question that fits into memory, got a larger one", manner);
  }
}

}  // namespace

AnswerLine answer_line(std::string_view line, Precision precision, std::size_t number) {
  return answer(line, {precision, false, number});
}

AnswerLine explained_line(std::string_view line, Precision precision) { return answer(line, {precision, true}); }

std::size_t answer_stream(std::istream& in, std::ostream& out, Precision precision) {
  std::size_t errors = 0, number = 0;
  std::string line;
  while (out && std::getline(in, line)) {
    ++number;
    if (!blank(line)) {
      const AnswerLine answered = answer(line, {precision, false, number});
      errors += answered.error;
      out << answered.text << '\n';
    }
    // The output is flushed when no further question waits: then a client may wait for the answer. Many questions sent
    // at once are not slowed down.
    if (in.rdbuf()->in_avail() <= 0) out.flush();
  }
  out.flush();
  return errors;
}

}  // namespace graze::io
