// The query `response` of the protocol: the effect of a blow.
#pragma once

#include <string>
#include <vector>

#include "graze/io/explain.hpp"
#include "io/json_value.hpp"
#include "io/json_writer.hpp"

namespace graze::io {

template <class T>
struct ResponseQuestion {
  int dimension = 3;
  StruckContact<T> contact;
  StruckBody<T> a, b;
  bool explain = false;
};

/// Whether a question is a `response`.
bool asks_for_response(const JsonValue& json);

/// Reads the question; throws `InvalidValue` with the path of the first value at fault.
template <class T>
ResponseQuestion<T> read_response(const JsonValue& json);

/// The shape of a struck body, placed so that its centre of mass is the body's; nothing where the question has none.
std::optional<Placed<double>> read_struck_shape(const JsonValue& body);
std::optional<plane::Placed<double>> read_struck_plane_shape(const JsonValue& body);

/// The answer. Throws `InvalidValue` when there is none.
template <class T>
Response<T> answer_response(const ResponseQuestion<T>& question);

/// Writes the members of the answer into an open object. Throws `InvalidValue` when there is no answer.
template <class T>
void write_response(const ResponseQuestion<T>& question, JsonWriter& out);

/// Answers and explains the question, which is a `response`.
Explanation explain_response(const JsonValue& json, Precision precision);

/// A quantity of a blow: its name, and its numbers or a word.
struct Quantity {
  std::string name;
  std::vector<double> numbers;
  std::string word{};
};
/// The quantities that lead to the impulse, in the order in which they follow from each other.
std::vector<Quantity> quantities_of_blow(const Explanation& e);
/// The impulse and the motions after it.
std::vector<Quantity> effects_of_blow(const Explanation& e);

/// "the impulse along the normal is 12, friction holds".
std::string response_outcome(const Response<double>& r);
/// The effects and the quantities as a table for a terminal.
std::string response_text(const Explanation& e);

}  // namespace graze::io
