#include "io/question.hpp"

#include "io/question_parts.hpp"

namespace graze::io {

QueryKind read_query_kind(const JsonValue& json) {
  static constexpr std::pair<const char*, QueryKind> names[] = {
      {"overlap", QueryKind::overlap}, {"distance", QueryKind::distance}, {"contacts", QueryKind::contacts},
      {"raycast", QueryKind::raycast}, {"cast", QueryKind::cast},         {"closest", QueryKind::closest}};
  if (json.json().is_string())
    for (const auto& [name, kind] : names)
      if (json.json() == name) return kind;
  json.fail("one of overlap, distance, contacts, raycast, cast, closest, response");
}

namespace {

template <class T>
MovingBody<T> read_body(const JsonValue& json) {
  json.keys({"shape", "translation", "rotation", "linear", "angular"});
  MovingBody<T> body{read_shape<T>(json.at("shape"))};
  if (const auto v = json.find("translation")) body.pose.translation = v->vector<T>();
  if (const auto v = json.find("rotation")) body.pose.rotation = read_rotation<T>(*v);
  if (const auto v = json.find("linear")) body.linear = v->vector<T>();
  if (const auto v = json.find("angular")) body.angular = v->vector<T>();
  return body;
}

/// Checks a body's way: its end is a coordinate like any other.
template <class T>
void check_journey(const JsonValue& json, const MovingBody<T>& body, T duration) {
  const Vec3<T> way = body.linear * duration;
  if (!(max_abs(way) <= largest_magnitude<T>))
    json.at("linear").fail("a velocity that leads no further than " +
                           validate::number(static_cast<double>(largest_magnitude<T>)) + " within the duration");
}

template <class T>
bool is_half_space(const MovingBody<T>& body) {
  return body.shape.template as<HalfSpace<T>>() != nullptr;
}

}  // namespace

template <class T>
Quat<T> read_rotation(const JsonValue& json) {
  const auto parts = json.elements(4);
  const Quat<T> q{parts[0].number<T>(), parts[1].number<T>(), parts[2].number<T>(), parts[3].number<T>()};
  if (q == Quat<T>{T(0), T(0), T(0), T(0)}) json.fail("a quaternion that is not zero");
  return normalized(q);
}

template <class T>
Question<T> read_question(const JsonValue& json) {
  Question<T> q;
  read_parts(
      json, 3, read_body<T>, [](const JsonValue& vector) { return vector.vector<T>(); }, q);
  if (q.query == QueryKind::cast) {
    check_journey(json.at("a"), *q.a, q.duration);
    check_journey(json.at("b"), *q.b, q.duration);
    for (const auto* body : {&q.a, &q.b})
      if (*body && is_half_space(**body) && (**body).angular != Vec3<T>{})
        json.at(body == &q.a ? "a" : "b").at("angular").fail("no angular velocity of a half-space");
  }
  return q;
}

template Question<float> read_question(const JsonValue&);
template Question<double> read_question(const JsonValue&);
template Quat<float> read_rotation(const JsonValue&);
template Quat<double> read_rotation(const JsonValue&);

}  // namespace graze::io
