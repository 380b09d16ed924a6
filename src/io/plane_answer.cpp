#include "io/plane_answer.hpp"

#include <cstdio>

#include "io/bounded_answer.hpp"
#include "io/finite_depth.hpp"
#include "io/trace_writer.hpp"

namespace graze::io {

namespace {

template <class T>
Vec3<T> flat(const plane::Vec2<T>& v) {
  return {v.x, v.y, T(0)};
}

/// A vector of two numbers.
template <class T>
JsonWriter& write_flat(JsonWriter& out, const char* key, const plane::Vec2<T>& v) {
  return out.key(key).vector(flat(v), 2);
}

template <class T>
void write_plane_distance(const PlaneQuestion<T>& q, Trace* trace, JsonWriter& out) {
  const plane::Distance<T> d = plane::distance(q.a->shape, q.a->pose, q.b->shape, q.b->pose, trace);
  require_finite_depth(d.status, "half-planes");
  if (q.limit && d.distance > *q.limit) {
    out.key("beyond").value(true);
    return;
  }
  out.key("distance").number(d.distance);
  write_flat(out, "normal", d.normal);
  write_flat(out, "a", d.a);
  write_flat(out, "b", d.b);
  write_bounded(d.status == Status::converged, d.error, out);
}

template <class T>
void write_plane_contacts(const PlaneQuestion<T>& q, Trace* trace, JsonWriter& out) {
  plane::Manifolds<T> manifolds;
  const bool touch = plane::contacts(q.a->shape, q.a->pose, q.b->shape, q.b->pose, q.margin, manifolds, trace);
  out.key("overlap").value(touch).key("manifolds").open('[');
  for (const plane::Manifold<T>& manifold : manifolds) {
    write_flat(out.open('{'), "normal", manifold.normal).key("points").open('[');
    for (const plane::ContactPoint<T>& p : manifold.points) {
      char feature[16];
      std::snprintf(feature, sizeof feature, "\"%08x\"", p.feature);
      write_flat(out.open('{'), "a", p.a);
      write_flat(out, "b", p.b).key("distance").number(p.distance).key("feature").raw(feature).close('}');
    }
    out.close(']').close('}');
  }
  out.close(']');
  write_bounded_of(manifolds, out);
}

template <class T>
void write_plane_closest(const PlaneQuestion<T>& q, Trace* trace, JsonWriter& out) {
  const plane::Closest<T> c = plane::closest(q.a->shape, q.a->pose, *q.point, trace);
  out.key("distance").number(c.distance);
  write_flat(out, "point", c.point);
  write_flat(out, "normal", c.normal);
  write_bounded(c.status == Status::converged, c.error, out);
}

template <class T>
void write_plane_raycast(const PlaneQuestion<T>& q, Trace* trace, JsonWriter& out) {
  const std::optional<plane::RayHit<T>> hit = plane::raycast(q.a->shape, q.a->pose, *q.ray, q.ray_length, trace);
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t);
  write_flat(out, "point", hit->point);
  write_flat(out, "normal", hit->normal);
}

template <class T>
std::optional<plane::CastHit<T>> cast_of(const PlaneQuestion<T>& q, Trace* trace) {
  const auto &a = *q.a, &b = *q.b;
  return plane::cast(a.shape, a.pose, a.velocity, b.shape, b.pose, b.velocity, q.duration, {}, trace);
}

template <class T>
void write_plane_cast(const PlaneQuestion<T>& q, Trace* trace, JsonWriter& out) {
  const auto hit = cast_of(q, trace);
  out.key("hit").value(hit.has_value());
  if (!hit) return;
  out.key("t").number(hit->t);
  write_flat(out, "normal", hit->normal);
  write_flat(out, "point", hit->point);
  // The contact is not before that time; whether it is then or later is not known.
  write_bounded(hit->status == Status::converged, q.duration - hit->t, out);
}

template <class T>
Distance<double> widened_flat(T distance, const plane::Vec2<T>& normal, const plane::Vec2<T>& a,
                              const plane::Vec2<T>& b, Status status, T error) {
  return {
      double(distance), converted<double>(flat(normal)), converted<double>(flat(a)), converted<double>(flat(b)), status,
      double(error)};
}

template <class T>
Vec3d widened_flat(const plane::Vec2<T>& v) {
  return converted<double>(flat(v));
}

template <class T>
void explain_raycast(const PlaneQuestion<T>& q, Explanation& e) {
  const auto hit = plane::raycast(q.a->shape, q.a->pose, *q.ray, q.ray_length, &e.trace);
  e.ray = {{widened_flat(q.ray->origin), widened_flat(q.ray->direction)}, double(q.ray_length), {}};
  if (hit) e.ray->hit = {double(hit->t), widened_flat(hit->point), widened_flat(hit->normal), hit->piece};
  e.overlap = hit.has_value();
}

template <class T>
void explain_cast(const PlaneQuestion<T>& q, Explanation& e) {
  const auto hit = cast_of(q, &e.trace);
  const auto velocity = [](const plane::Velocity<T>& v) {
    return Velocity<double>{widened_flat(v.linear), {0, 0, double(v.angular)}};
  };
  e.cast = {velocity(q.a->velocity), velocity(q.b->velocity), double(q.duration), {}};
  if (hit)
    e.cast->hit = {double(hit->t),
                   widened_flat(hit->point),
                   widened_flat(hit->normal),
                   double(hit->depth),
                   hit->status,
                   hit->piece_a,
                   hit->piece_b};
  e.overlap = hit.has_value();
}

}  // namespace

template <class T>
void write_plane_answer(const PlaneQuestion<T>& q, JsonWriter& out) {
  Trace trace;
  Trace* asked = q.explain ? &trace : nullptr;
  switch (q.query) {
  case QueryKind::overlap:
    out.key("overlap").value(plane::overlap(q.a->shape, q.a->pose, q.b->shape, q.b->pose, asked));
    break;
  case QueryKind::distance: write_plane_distance(q, asked, out); break;
  case QueryKind::contacts: write_plane_contacts(q, asked, out); break;
  case QueryKind::closest: write_plane_closest(q, asked, out); break;
  case QueryKind::raycast: write_plane_raycast(q, asked, out); break;
  case QueryKind::cast: write_plane_cast(q, asked, out); break;
  }
  if (asked) write_trace(trace, out);
}

template <class T>
void explain_in_plane(const PlaneQuestion<T>& q, Explanation& e) {
  if (q.query == QueryKind::closest) {
    const plane::Closest<T> c = plane::closest(q.a->shape, q.a->pose, *q.point, &e.trace);
    e.distance = widened_flat(c.distance, c.normal, c.point, *q.point, c.status, c.error);
    e.overlap = c.distance <= T(0);
    return;
  }
  if (q.query == QueryKind::raycast) return explain_raycast(q, e);
  if (q.query == QueryKind::cast) return explain_cast(q, e);
  const auto &a = *q.a, &b = *q.b;
  if (q.query == QueryKind::overlap) {
    e.overlap = plane::overlap(a.shape, a.pose, b.shape, b.pose, &e.trace);
  } else if (q.query == QueryKind::distance) {
    const plane::Distance<T> d = plane::distance(a.shape, a.pose, b.shape, b.pose, &e.trace);
    require_finite_depth(d.status, "half-planes");
    e.distance = widened_flat(d.distance, d.normal, d.a, d.b, d.status, d.error);
    e.overlap = d.distance <= T(0);
  } else {
    plane::Manifolds<T> manifolds;
    e.overlap = plane::contacts(a.shape, a.pose, b.shape, b.pose, q.margin, manifolds, &e.trace);
    for (const plane::Manifold<T>& m : manifolds) {
      Manifold<double>& to = e.manifolds.emplace_back();
      to.normal = converted<double>(flat(m.normal));
      to.piece_a = m.piece_a;
      to.piece_b = m.piece_b;
      for (const plane::ContactPoint<T>& p : m.points)
        to.points.push_back({converted<double>(flat(p.a)), converted<double>(flat(p.b)), double(p.distance), p.feature,
                             double(p.weight)});
    }
  }
}

template void write_plane_answer(const PlaneQuestion<float>&, JsonWriter&);
template void write_plane_answer(const PlaneQuestion<double>&, JsonWriter&);
template void explain_in_plane(const PlaneQuestion<float>&, Explanation&);
template void explain_in_plane(const PlaneQuestion<double>&, Explanation&);

}  // namespace graze::io
