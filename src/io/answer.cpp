#include "io/answer.hpp"

#include <algorithm>
#include <cstdio>

#include "graze/cast.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"
#include "io/trace_writer.hpp"

namespace graze::io {

namespace {

/// An answer in the plane has no z, and its normal none either: what rounding left of it is taken off.
template <class T>
Vec3<T> in_plane(const Vec3<T>& normal, int dimension) {
  return dimension == 3 ? normal : normalized(Vec3<T>{normal.x, normal.y, T(0)});
}

/// An answer that is not proven within the tolerance says how far off it may be.
template <class T>
void write_bounded(bool proven, T error, JsonWriter& out) {
  if (!proven) out.key("bounded").number(error);
}

template <class T>
void write_distance(const Question<T>& q, Trace* trace, JsonWriter& out) {
  if (q.limit && !within(q.a->shape, q.a->pose, q.b->shape, q.b->pose, *q.limit)) {
    if (trace) trace->method = "pieces within the limit";
    out.key("beyond").value(true);
    return;
  }
  const Distance<T> d = distance(q.a->shape, q.a->pose, q.b->shape, q.b->pose, trace);
  if (d.status == Status::unbounded)
    throw InvalidValue("a, b", "shapes of finite depth", "two half-spaces that are not opposite");
  out.key("distance").number(d.distance).key("normal").vector(in_plane(d.normal, q.dimension), q.dimension);
  out.key("a").vector(d.a, q.dimension).key("b").vector(d.b, q.dimension);
  write_bounded(d.status == Status::converged, d.error, out);
}

template <class T>
void write_contacts(const Question<T>& q, Trace* trace, JsonWriter& out) {
  Manifolds<T> manifolds;
  const bool touch = contacts(q.a->shape, q.a->pose, q.b->shape, q.b->pose, q.margin, manifolds, trace);
  out.key("overlap").value(touch).key("manifolds").open('[');
  for (Manifold<T>& manifold : manifolds) {
    if (q.dimension == 2) leave_plane_points(manifold);
    out.open('{').key("normal").vector(in_plane(manifold.normal, q.dimension), q.dimension).key("points").open('[');
    for (const ContactPoint<T>& p : manifold.points) {
      char feature[16];
      std::snprintf(feature, sizeof feature, "\"%08x\"", p.feature);
      out.open('{').key("a").vector(p.a, q.dimension).key("b").vector(p.b, q.dimension);
      out.key("distance").number(p.distance).key("feature").raw(feature).close('}');
    }
    out.close(']').close('}');
  }
  out.close(']');
  // The points of two convex shapes lie along the normal of their distance, and are as deep as that is known.
  if (manifolds.empty() || !q.a->shape.convex() || !q.b->shape.convex()) return;
  const Distance<T> d = distance(q.a->shape, q.a->pose, q.b->shape, q.b->pose);
  write_bounded(d.status != Status::bounded, d.error, out);
}

template <class T>
void write_closest(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const Closest<T> c = closest(q.a->shape, q.a->pose, *q.point, trace);
  out.key("distance").number(c.distance).key("point").vector(c.point, q.dimension);
  out.key("normal").vector(in_plane(c.normal, q.dimension), q.dimension);
  write_bounded(c.status == Status::converged, c.error, out);
}

template <class T>
void write_raycast(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const std::optional<RayHit<T>> hit = raycast(q.a->shape, q.a->pose, *q.ray, q.ray_length, BackFaces::hit, trace);
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t).key("point").vector(hit->point, q.dimension);
  out.key("normal").vector(in_plane(hit->normal, q.dimension), q.dimension);
}

template <class T>
void write_cast(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const auto &a = *q.a, &b = *q.b;
  const std::optional<CastHit<T>> hit =
      cast<T>(a.shape, a.pose, {a.linear, a.angular}, b.shape, b.pose, {b.linear, b.angular}, q.duration, {}, trace);
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t).key("normal").vector(in_plane(hit->normal, q.dimension), q.dimension);
  out.key("point").vector(hit->point, q.dimension);
  // Before that time they do not touch. Whether they do then or later is proven of what touches at the start; of other
  // bodies whose first contact could not be told it is anywhere up to the end.
  const bool proven = hit->status == Status::converged || (hit->t == T(0) && overlap(a.shape, a.pose, b.shape, b.pose));
  write_bounded(proven, q.duration - hit->t, out);
}

}  // namespace

template <class T>
void leave_plane_points(Manifold<T>& manifold) {
  T size(0);
  for (const auto& p : manifold.points) size = greatest(size, greatest(max_abs(p.a), max_abs(p.b)));
  const T same = T(64) * std::numeric_limits<T>::epsilon() * size;
  std::size_t kept = 0;
  for (ContactPoint<T> p : manifold.points) {
    p.a.z = p.b.z = T(0);
    const bool known = std::any_of(manifold.points.begin(), manifold.points.begin() + kept, [&](const auto& other) {
      return max_abs(other.a - p.a) <= same && max_abs(other.b - p.b) <= same;
    });
    if (!known) manifold.points[kept++] = p;
  }
  manifold.points.truncate(kept);
}

void leave_plane_axes(Trace& trace) {
  // Between unit vectors: far above the few roundings of 1e-16 that an axis comes about with, far below any angle of a
  // figure.
  constexpr double same = 1e-9;
  std::vector<TraceAxis> kept;
  for (TraceAxis& axis : trace.axes) {
    if (std::abs(axis.direction.z) > same) continue;
    const auto twin = std::find_if(kept.begin(), kept.end(), [&](const TraceAxis& k) {
      return length(cross(k.direction, axis.direction)) <= same;
    });
    const bool product = axis.name.find("×") != std::string::npos;
    if (twin == kept.end() || !product) {
      kept.push_back(std::move(axis));
    } else if (axis.name == trace.winner) {
      trace.winner = twin->name;
    }
  }
  trace.axes = std::move(kept);
}

void leave_plane_spans(Trace& trace) {
  constexpr double same = 1e-9;  // as of axes
  // A disc is the side of a prism whose balls lie off the plane.
  std::erase_if(trace.spans, [&](const TraceSpan& span) {
    return std::abs(span.normal.z) > same || span.name.starts_with("ball at") || span.name == "slab z";
  });
  for (TraceSpan& span : trace.spans) {
    if (span.name != "balls and side") continue;
    span.name = "circle";
    trace.method = "quadratic";
    if (!trace.winner.empty()) trace.winner = span.name, trace.reason = "the ray comes in through the circle";
  }
}

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
  if (q.dimension == 2) {
    leave_plane_axes(trace);
    leave_plane_spans(trace);
  }
  if (asked) write_trace(trace, out);
}

template void leave_plane_points(Manifold<float>&);
template void leave_plane_points(Manifold<double>&);
template void write_answer(const Question<float>&, JsonWriter&);
template void write_answer(const Question<double>&, JsonWriter&);

}  // namespace graze::io
