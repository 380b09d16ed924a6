// The explanation of a blow, and its quantities as a table.
#include <fmt/format.h>

#include <cmath>

#include "io/response.hpp"

namespace graze::io {

namespace {

template <class T>
Motion<double> widened(const Motion<T>& m) {
  return {converted<double>(m.linear), converted<double>(m.angular), converted<double>(m.center)};
}

template <class T>
StruckBody<double> widened(const StruckBody<T>& body) {
  return {widened(body.motion), {static_cast<double>(body.mass.mass), converted<double>(body.mass.inertia)}};
}

template <class T>
Response<double> widened(const Response<T>& r) {
  return {{converted<double>(r.approach.whole), static_cast<double>(r.approach.normal),
           converted<double>(r.approach.tangential)},
          r.at_fault,
          static_cast<double>(r.effective_mass),
          static_cast<double>(r.normal_impulse),
          converted<double>(r.sliding),
          converted<double>(r.stopping_impulse),
          static_cast<double>(r.friction_limit),
          converted<double>(r.friction_impulse),
          converted<double>(r.impulse),
          widened(r.a),
          widened(r.b)};
}

template <class T>
void ask(const ResponseQuestion<T>& q, Explanation& e) {
  e.dimension = q.dimension;
  e.response = {{converted<double>(q.contact.point), converted<double>(q.contact.normal),
                 static_cast<double>(q.contact.restitution), static_cast<double>(q.contact.friction)},
                widened(q.a),
                widened(q.b),
                widened(answer_response(q))};
}

struct FaultWords {
  const char *word, *sentence;
};

FaultWords words_of(AtFault fault) {
  switch (fault) {
  case AtFault::a: return {"A", "A runs into B"};
  case AtFault::b: return {"B", "B runs into A"};
  case AtFault::both: return {"both", "each runs into the other"};
  case AtFault::neither: break;
  }
  return {"neither", "neither runs into the other"};
}

std::string number_text(double number) { return std::isinf(number) ? "infinity" : fmt::format("{:.5g}", number + 0.0); }

/// The numbers of a vector or of a rotation: in the plane two, and the one about its normal.
class Numbers {
 public:
  explicit Numbers(const Explanation& e) : flat_(e.dimension == 2) {}
  std::vector<double> operator()(const Vec3d& v) const {
    return flat_ ? std::vector{v.x, v.y} : std::vector{v.x, v.y, v.z};
  }
  std::vector<double> turning(const Vec3d& v) const { return flat_ ? std::vector{v.z} : std::vector{v.x, v.y, v.z}; }

 private:
  bool flat_;
};

std::string row_text(const Quantity& row) {
  std::string out = fmt::format("  {:<20}", row.name);
  for (const double number : row.numbers) out += fmt::format(" {:>9}", number_text(number));
  if (!row.word.empty()) out += fmt::format(" {:>9}", row.word);
  return out + "\n";
}

}  // namespace

Explanation explain_response(const JsonValue& json, Precision precision) {
  Explanation e;
  // Read in double for the picture in any case, and so checked in double too.
  const auto q = read_response<double>(json);
  precision == Precision::double_precision ? ask(q, e) : ask(read_response<float>(json), e);
  e.query = "response";
  e.trace.method = "impulse";
  e.trace.reason = words_of(e.response->result.at_fault).sentence;
  if (e.dimension == 2) {
    e.plane_a = read_struck_plane_shape(json.at("a"));
    e.plane_b = read_struck_plane_shape(json.at("b"));
  } else {
    e.a = read_struck_shape(json.at("a"));
    e.b = read_struck_shape(json.at("b"));
  }
  return e;
}

std::vector<Quantity> quantities_of_blow(const Explanation& e) {
  const Response<double>& r = e.response->result;
  const Numbers of(e);
  return {{"point", of(e.response->contact.point)},
          {"normal", of(e.response->contact.normal)},
          {"B seen from A", of(r.approach.whole)},
          {"  along the normal", {r.approach.normal}},
          {"  across it", of(r.approach.tangential)},
          {"effective mass", {r.effective_mass}},
          {"normal impulse", {r.normal_impulse}},
          {"sliding after it", of(r.sliding)},
          {"impulse to end that", of(r.stopping_impulse)},
          {"friction up to", {r.friction_limit}},
          {"friction", of(r.friction_impulse)},
          {"at fault", {}, words_of(r.at_fault).word}};
}

std::vector<Quantity> effects_of_blow(const Explanation& e) {
  const Response<double>& r = e.response->result;
  const Numbers of(e);
  return {{"impulse on B", of(r.impulse)},
          {"A moves on by", of(r.a.linear)},
          {"A turns on by", of.turning(r.a.angular)},
          {"B moves on by", of(r.b.linear)},
          {"B turns on by", of.turning(r.b.angular)}};
}

std::string response_outcome(const Response<double>& r) {
  return fmt::format("the impulse along the normal is {:.6g}, friction {}", r.normal_impulse,
                     r.holds() ? "holds" : "slides");
}

std::string response_text(const Explanation& e) {
  std::string out;
  for (const Quantity& effect : effects_of_blow(e)) out += row_text(effect);
  out += fmt::format("\n  method    {}\n  because   {}\n\n", e.trace.method, e.trace.reason);
  for (const Quantity& quantity : quantities_of_blow(e)) out += row_text(quantity);
  return out;
}

}  // namespace graze::io
