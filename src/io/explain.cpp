#include "graze/io/explain.hpp"

#include "io/answer.hpp"
#include "io/convert.hpp"
#include "io/finite_depth.hpp"
#include "io/plane_answer.hpp"
#include "io/response.hpp"

namespace graze::io {

namespace {

template <class T>
Distance<double> widened(const Distance<T>& d) {
  return {static_cast<double>(d.distance),
          converted<double>(d.normal),
          converted<double>(d.a),
          converted<double>(d.b),
          d.status,
          static_cast<double>(d.error)};
}

template <class T>
Manifolds<double> widened(const Manifolds<T>& manifolds) {
  Manifolds<double> wide;
  for (const Manifold<T>& m : manifolds) {
    Manifold<double>& to = wide.emplace_back();
    to.normal = converted<double>(m.normal);
    to.piece_a = m.piece_a;
    to.piece_b = m.piece_b;
    for (const ContactPoint<T>& p : m.points)
      to.points.push_back({converted<double>(p.a), converted<double>(p.b), static_cast<double>(p.distance), p.feature,
                           static_cast<double>(p.weight)});
  }
  return wide;
}

template <class T>
void ask_closest(const Question<T>& q, Explanation& e) {
  const Closest<T> c = closest(q.a->shape, q.a->pose, *q.point, &e.trace);
  e.distance = Distance<double>{static_cast<double>(c.distance), converted<double>(c.normal),
                                converted<double>(c.point), converted<double>(*q.point), c.status};
  e.overlap = c.distance <= T(0);
}

template <class T>
void ask_raycast(const Question<T>& q, Explanation& e) {
  const auto hit = raycast(q.a->shape, q.a->pose, *q.ray, q.ray_length, BackFaces::hit, &e.trace);
  e.ray = {
      {converted<double>(q.ray->origin), converted<double>(q.ray->direction)}, static_cast<double>(q.ray_length), {}};
  if (hit)
    e.ray->hit = {static_cast<double>(hit->t), converted<double>(hit->point), converted<double>(hit->normal),
                  hit->piece};
  e.overlap = hit.has_value();
}

template <class T>
void ask_cast(const Question<T>& q, Explanation& e) {
  const auto &a = *q.a, &b = *q.b;
  const auto hit =
      cast<T>(a.shape, a.pose, {a.linear, a.angular}, b.shape, b.pose, {b.linear, b.angular}, q.duration, {}, &e.trace);
  e.cast = {{converted<double>(a.linear), converted<double>(a.angular)},
            {converted<double>(b.linear), converted<double>(b.angular)},
            static_cast<double>(q.duration),
            {}};
  if (hit)
    e.cast->hit = {static_cast<double>(hit->t),
                   converted<double>(hit->point),
                   converted<double>(hit->normal),
                   static_cast<double>(hit->depth),
                   hit->status,
                   hit->piece_a,
                   hit->piece_b};
  e.overlap = hit.has_value();
}

template <class T>
void ask_contacts(const Question<T>& q, Explanation& e) {
  Manifolds<T> manifolds;
  e.overlap = contacts(q.a->shape, q.a->pose, q.b->shape, q.b->pose, q.margin, manifolds, &e.trace);
  e.manifolds = widened(manifolds);
}

template <class T>
void ask_distance(const Question<T>& q, Explanation& e) {
  const Distance<T> d = distance(q.a->shape, q.a->pose, q.b->shape, q.b->pose, &e.trace);
  require_finite_depth(d.status);
  e.distance = widened(d);
  e.overlap = e.distance->distance <= 0;
}

/// Fills in the answer to the question.
template <class T>
void ask(const Question<T>& q, Explanation& e) {
  switch (q.query) {
  case QueryKind::overlap: e.overlap = overlap(q.a->shape, q.a->pose, q.b->shape, q.b->pose, &e.trace); break;
  case QueryKind::distance: ask_distance(q, e); break;
  case QueryKind::contacts: ask_contacts(q, e); break;
  case QueryKind::closest: ask_closest(q, e); break;
  case QueryKind::raycast: ask_raycast(q, e); break;
  case QueryKind::cast: ask_cast(q, e); break;
  }
}

}  // namespace

Explanation explain(std::string_view question, Precision precision) {
  const Json json = parse_json(question);
  if (!json.is_object()) throw InvalidValue("", "one JSON object", shown(json));
  const JsonValue value(json, "");
  if (asks_for_response(value)) return explain_response(value, precision);
  const bool wide = precision == Precision::double_precision;
  Explanation e;
  if (json.contains("query") && json["query"].is_string()) e.query = json["query"].get<std::string>();
  if (in_the_plane(json)) {
    e.dimension = 2;
    // Read in double for the picture in any case, and so checked in double too.
    const PlaneQuestion<double> q = read_plane_question<double>(value);
    e.plane_a = plane::Placed<double>{q.a->shape, q.a->pose};
    if (q.query == QueryKind::closest)
      e.plane_b = plane::Placed<double>{plane::Circle<double>(0), {*q.point, {}}};
    else if (q.query != QueryKind::raycast)
      e.plane_b = plane::Placed<double>{q.b->shape, q.b->pose};
    wide ? explain_in_plane(q, e) : explain_in_plane(read_plane_question<float>(value), e);
    return e;
  }
  const Question<double> q = read_question<double>(value);
  e.a = Placed<double>{q.a->shape, q.a->pose};
  if (q.query == QueryKind::closest)
    e.b = Placed<double>{Sphere<double>(0), {*q.point, {}}};
  else if (q.query != QueryKind::raycast)
    e.b = Placed<double>{q.b->shape, q.b->pose};
  wide ? ask(q, e) : ask(read_question<float>(value), e);
  return e;
}

}  // namespace graze::io
