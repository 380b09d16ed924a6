#include "io/question.hpp"

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

template <class T>
Ray<T> read_ray(const JsonValue& json, T& length) {
  json.keys({"origin", "direction", "length"});
  const Ray<T> ray{json.at("origin").vector<T>(), json.at("direction").vector<T>()};
  if (ray.direction == Vec3<T>{}) json.at("direction").fail("a direction that is not zero");
  if (const auto l = json.find("length")) length = l->length<T>();
  return ray;
}

/// Checks a body's way: its end is a coordinate like any other.
template <class T>
void check_journey(const JsonValue& json, const MovingBody<T>& body, T duration) {
  const Vec3<T> way = body.linear * duration;
  if (!(max_abs(way) <= largest_magnitude<T>))
    json.at("linear").fail("a velocity that leads no further than " +
                           validate::number(static_cast<double>(largest_magnitude<T>)) + " within the duration");
}

bool asks_for_two(QueryKind query) { return query != QueryKind::raycast && query != QueryKind::closest; }

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
  json.keys({"id", "query", "a", "b", "dimension", "margin", "ray", "point", "duration", "limit", "explain"});
  Question<T> q;
  q.query = read_query_kind(json.at("query"));
  if (const auto d = json.find("dimension"))
    if (d->json() != 3) d->fail("2 or 3");
  json.at("a");
  if (asks_for_two(q.query)) json.at("b");
  q.a = read_body<T>(json.at("a"));
  if (const auto b = json.find("b")) q.b = read_body<T>(*b);
  if (const auto m = json.find("margin")) q.margin = m->length<T>();
  if (const auto r = json.find("ray")) q.ray = read_ray<T>(*r, q.ray_length);
  if (const auto p = json.find("point")) q.point = p->vector<T>();
  if (const auto d = json.find("duration")) q.duration = d->length<T>();
  if (const auto l = json.find("limit")) {
    if (q.query != QueryKind::distance) l->fail("no limit for this query");
    q.limit = l->length<T>();
  }
  if (const auto e = json.find("explain")) q.explain = e->boolean();

  if (q.query == QueryKind::raycast && !q.ray) json.at("ray");
  if (q.query == QueryKind::closest && !q.point) json.at("point");
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
