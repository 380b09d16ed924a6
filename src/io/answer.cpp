#include "io/answer.hpp"

#include <algorithm>
#include <cstdio>

#include "graze/cast.hpp"
#include "graze/query.hpp"
#include "graze/raycast.hpp"

namespace graze::io {

namespace {

/// An answer in the plane has no z, and its normal none either: what rounding left of it is taken off.
template <class T>
Vec3<T> in_plane(const Vec3<T>& normal, int dimension) {
  return dimension == 3 ? normal : normalized(Vec3<T>{normal.x, normal.y, T(0)});
}

void write_points(const std::vector<TraceSupport>& points, JsonWriter& out) {
  out.open('[');
  for (const TraceSupport& p : points) out.open('{').key("a").vector(p.a).key("b").vector(p.b).close('}');
  out.close(']');
}

/// [lower, upper]. A half-space reaches down without end, which no number of JSON says: "-infinity" does.
void write_interval(double lower, double upper, JsonWriter& out) {
  out.open('[');
  for (const double end : {lower, upper})
    std::isfinite(end) ? out.number(end) : out.raw(end < 0 ? R"("-infinity")" : R"("infinity")");
  out.close(']');
}

void write_trace(const Trace& trace, JsonWriter& out) {
  out.key("trace").open('{').key("method").raw(Json(trace.method).dump());
  if (!trace.winner.empty()) out.key("winner").raw(Json(trace.winner).dump());
  if (!trace.reason.empty()) out.key("reason").raw(Json(trace.reason).dump());
  out.key("axes").open('[');
  for (const TraceAxis& axis : trace.axes) {
    out.open('{').key("name").raw(Json(axis.name).dump()).key("direction").vector(axis.direction);
    write_interval(axis.a_lower, axis.a_upper, out.key("a"));
    write_interval(axis.b_lower, axis.b_upper, out.key("b"));
    out.key("overlap").number(axis.overlap()).close('}');
  }
  out.close(']').key("gjk").open('[');
  for (const TraceGjk& step : trace.gjk) {
    out.open('{').key("simplex");
    write_points(step.simplex, out);
    out.key("direction").vector(step.direction).key("found").open('{');
    out.key("a").vector(step.found.a).key("b").vector(step.found.b).close('}');
    out.key("lower").number(step.lower).key("upper").number(step.upper).close('}');
  }
  out.close(']').key("epa").open('[');
  for (const TraceEpa& step : trace.epa) {
    out.open('{').key("normal").vector(step.normal).key("faceDepth").number(step.face_depth);
    out.key("foundDepth").number(step.found_depth).key("faces").number(static_cast<double>(step.faces)).close('}');
  }
  out.close(']');
  if (!trace.polytope.empty()) {
    out.key("polytope").open('{').key("points");
    write_points(trace.polytope, out);
    out.key("triangles").open('[');
    for (const auto& t : trace.triangles) {
      out.open('[');
      for (const std::size_t i : t) out.number(static_cast<double>(i));
      out.close(']');
    }
    out.close(']').close('}');
  }
  out.close('}');
}

template <class T>
void write_distance(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const Distance<T> d = distance(q.a->shape, q.a->pose, q.b->shape, q.b->pose, trace);
  if (d.status == Status::unbounded)
    throw InvalidValue("a, b", "shapes of finite depth", "two half-spaces that are not opposite");
  out.key("distance").number(d.distance).key("normal").vector(in_plane(d.normal, q.dimension), q.dimension);
  out.key("a").vector(d.a, q.dimension).key("b").vector(d.b, q.dimension);
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
}

template <class T>
void write_closest(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const Closest<T> c = closest(q.a->shape, q.a->pose, *q.point, trace);
  out.key("distance").number(c.distance).key("point").vector(c.point, q.dimension);
  out.key("normal").vector(in_plane(c.normal, q.dimension), q.dimension);
}

template <class T>
void write_raycast(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const std::optional<RayHit<T>> hit = raycast(q.a->shape, q.a->pose, *q.ray, q.ray_length);
  if (trace) trace->method = "ray cast";
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t).key("point").vector(hit->point, q.dimension);
  out.key("normal").vector(in_plane(hit->normal, q.dimension), q.dimension);
}

template <class T>
void write_cast(const Question<T>& q, Trace* trace, JsonWriter& out) {
  const auto &a = *q.a, &b = *q.b;
  const std::optional<CastHit<T>> hit =
      cast<T>(a.shape, a.pose, {a.linear, a.angular}, b.shape, b.pose, {b.linear, b.angular}, q.duration);
  if (trace) trace->method = "conservative advancement";
  if (hit && hit->status != Status::converged)
    throw InvalidValue("a, b", "bodies that turn less often before they touch",
                       "so many turns so near each other that their first contact cannot be told");
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t).key("normal").vector(in_plane(hit->normal, q.dimension), q.dimension);
  out.key("point").vector(hit->point, q.dimension);
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
  if (q.dimension == 2) leave_plane_axes(trace);
  if (asked) write_trace(trace, out);
}

template void leave_plane_points(Manifold<float>&);
template void leave_plane_points(Manifold<double>&);
template void write_answer(const Question<float>&, JsonWriter&);
template void write_answer(const Question<double>&, JsonWriter&);

}  // namespace graze::io
