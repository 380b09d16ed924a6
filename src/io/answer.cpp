#include "io/answer.hpp"

#include <algorithm>
#include <cstdio>

#include "graze/cast.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "io/bounded_answer.hpp"
#include "io/finite_depth.hpp"
#include "io/trace_writer.hpp"

namespace graze::io {

namespace {

template <class T>
void write_distance(const Question<T>& q, Trace* trace, JsonWriter& out) {
  if (q.limit && !within(q.a->shape, q.a->pose, q.b->shape, q.b->pose, *q.limit)) {
    if (trace) trace->method = "pieces within the limit";
    out.key("beyond").value(true);
    return;
  }
  const Distance<T> d = distance(q.a->shape, q.a->pose, q.b->shape, q.b->pose, trace);
  require_finite_depth(d.status);
  out.key("distance").number(d.distance).key("normal").vector(d.normal);
  out.key("a").vector(d.a).key("b").vector(d.b);
  write_bounded(d.status == Status::converged, d.error, out);
}

template <class T>
void write_contacts(const Question<T>& q, Trace* trace, JsonWriter& out) {
  Manifolds<T> manifolds;
  const bool touch = contacts(q.a->shape, q.a->pose, q.b->shape, q.b->pose, q.margin, manifolds, trace);
  out.key("overlap").value(touch).key("manifolds").open('[');
  for (const Manifold<T>& manifold : manifolds) {
    out.open('{').key("normal").vector(manifold.normal).key("points").open('[');
    for (const ContactPoint<T>& p : manifold.points) {
      char feature[16];
      std::snprintf(feature, sizeof feature, "\"%08x\"", p.feature);
      out.open('{').key("a").vector(p.a).key("b").vector(p.b);
      out.key("distance").number(p.distance).key("feature").raw(feature).close('}');
    }
    out.close(']').close('}');
  }
  out.close(']');
  write_bounded_of(manifolds, out);
}

template <class T>
void write_closest(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const Closest<T> c = closest(q.a->shape, q.a->pose, *q.point, trace);
  out.key("distance").number(c.distance).key("point").vector(c.point);
  out.key("normal").vector(c.normal);
  write_bounded(c.status == Status::converged, c.error, out);
}

template <class T>
void write_raycast(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const std::optional<RayHit<T>> hit = raycast(q.a->shape, q.a->pose, *q.ray, q.ray_length, BackFaces::hit, trace);
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t).key("point").vector(hit->point);
  out.key("normal").vector(hit->normal);
}

template <class T>
void write_cast(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const auto &a = *q.a, &b = *q.b;
  const std::optional<CastHit<T>> hit =
      cast<T>(a.shape, a.pose, {a.linear, a.angular}, b.shape, b.pose, {b.linear, b.angular}, q.duration, {}, trace);
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t).key("normal").vector(hit->normal);
  out.key("point").vector(hit->point);
  // Before that time they do not touch. A contact then or later is proven where they touch at the start; where the
  // first contact of other bodies could not be found, it is anywhere up to the end.
  const bool proven = hit->status == Status::converged || (hit->t == T(0) && overlap(a.shape, a.pose, b.shape, b.pose));
  write_bounded(proven, q.duration - hit->t, out);
}

}  // namespace

template <class T>
void write_answer(const Question<T>& q, JsonWriter& out) {
  Trace trace;
  Trace* asked = q.explain ? &trace : nullptr;
  switch (q.query) {
  case QueryKind::overlap:
    out.key("overlap").value(overlap(q.a->shape, q.a->pose, q.b->shape, q.b->pose, asked));
    break;
  case QueryKind::distance: write_distance(q, asked, out); break;
  case QueryKind::contacts: write_contacts(q, asked, out); break;
  case QueryKind::closest: write_closest(q, asked, out); break;
  case QueryKind::raycast: write_raycast(q, asked, out); break;
  case QueryKind::cast: write_cast(q, asked, out); break;
  }
  if (asked) write_trace(trace, out);
}

template void write_answer(const Question<float>&, JsonWriter&);
template void write_answer(const Question<double>&, JsonWriter&);

}  // namespace graze::io
