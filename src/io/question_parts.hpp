// The reading of a question's parts, in the order in which the first value at fault is reported.
#pragma once

#include "io/question.hpp"

namespace graze::io {

inline bool asks_for_two(QueryKind query) { return query != QueryKind::raycast && query != QueryKind::closest; }

/// A ray, and its length where it has one. `read_vector(json)` reads its vectors.
template <class RayOfSpace, class T, class ReadVector>
RayOfSpace read_ray(const JsonValue& json, T& length, const ReadVector& read_vector) {
  json.keys({"origin", "direction", "length"});
  const RayOfSpace ray{read_vector(json.at("origin")), read_vector(json.at("direction"))};
  if (ray.direction == decltype(ray.direction){}) json.at("direction").fail("a direction that is not zero");
  if (const auto l = json.find("length")) length = l->template length<T>();
  return ray;
}

/// A question of `dimensions` dimensions with all parts that it needs, of which only a body's motion is left to check.
/// `read_body(json)` and `read_vector(json)` read the parts that depend on the space.
template <class T, class Body, class RayOfSpace, class Point, class ReadBody, class ReadVector>
void read_parts(const JsonValue& json, int dimensions, const ReadBody& read_body, const ReadVector& read_vector,
                QuestionOf<T, Body, RayOfSpace, Point>& q) {
  json.keys({"id", "query", "a", "b", "dimension", "margin", "ray", "point", "duration", "limit", "explain"});
  q.query = read_query_kind(json.at("query"));
  if (const auto d = json.find("dimension"))
    if (d->json() != dimensions) d->fail("2 or 3");
  json.at("a");
  if (asks_for_two(q.query)) json.at("b");
  q.a = read_body(json.at("a"));
  if (const auto b = json.find("b")) q.b = read_body(*b);
  if (const auto m = json.find("margin")) q.margin = m->template length<T>();
  if (const auto r = json.find("ray")) q.ray = read_ray<RayOfSpace>(*r, q.ray_length, read_vector);
  if (const auto p = json.find("point")) q.point = read_vector(*p);
  if (const auto d = json.find("duration")) q.duration = d->template length<T>();
  if (const auto l = json.find("limit")) {
    if (q.query != QueryKind::distance) l->fail("no limit for this query");
    q.limit = l->template length<T>();
  }
  if (const auto e = json.find("explain")) q.explain = e->boolean();

  if (q.query == QueryKind::raycast && !q.ray) json.at("ray");
  if (q.query == QueryKind::closest && !q.point) json.at("point");
}

}  // namespace graze::io
