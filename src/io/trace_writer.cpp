#include "io/trace_writer.hpp"

#include "io/json_value.hpp"

namespace graze::io {

namespace {

void write_points(const std::vector<TraceSupport>& points, JsonWriter& out) {
  out.open('[');
  for (const TraceSupport& p : points) out.open('{').key("a").vector(p.a).key("b").vector(p.b).close('}');
  out.close(']');
}

/// Writes a length that may have no end, as the reach of a half-space: JSON has no such number, so it is "infinity".
void write_length(double length, JsonWriter& out) {
  std::isfinite(length) ? out.number(length) : out.raw(length < 0 ? R"("-infinity")" : R"("infinity")");
}

void write_interval(double lower, double upper, JsonWriter& out) {
  out.open('[');
  write_length(lower, out);
  write_length(upper, out);
  out.close(']');
}

void write_spans(const std::vector<TraceSpan>& spans, JsonWriter& out) {
  out.key("spans").open('[');
  for (const TraceSpan& span : spans) {
    out.open('{').key("name").raw(Json(span.name).dump()).key("normal").vector(span.normal);
    // A condition that the ray never meets has no span.
    if (span.enter <= span.leave) write_interval(span.enter, span.leave, out.key("span"));
    out.close('}');
  }
  out.close(']');
}

void write_steps(const std::vector<TraceStep>& steps, JsonWriter& out) {
  out.key("steps").open('[');
  for (const TraceStep& step : steps)
    out.open('{')
        .key("t")
        .number(step.t)
        .key("distance")
        .number(step.distance)
        .key("normal")
        .vector(step.normal)
        .close('}');
  out.close(']');
}

void write_outline(const std::vector<Vec3d>& outline, JsonWriter& out) {
  out.open('[');
  for (const Vec3d& corner : outline) out.vector(corner);
  out.close(']');
}

/// Writes the faces that contacts stand on, and the clipping of one by the other.
void write_faces(const Trace& trace, JsonWriter& out) {
  out.key("faces").open('{');
  write_outline(trace.face_a, out.key("a"));
  write_outline(trace.face_b, out.key("b"));
  out.close('}').key("cuts").open('[');
  for (const TraceCut& cut : trace.cuts) {
    out.open('{').key("from").vector(cut.from).key("to").vector(cut.to);
    write_outline(cut.left, out.key("left"));
    out.close('}');
  }
  out.close(']');
}

/// Writes the numbers of boxes and pieces of a composite that a ray came upon.
void write_visits(const Trace& trace, JsonWriter& out) {
  if (trace.nodes == 0 && trace.pieces == 0) return;
  out.key("nodes").number(static_cast<double>(trace.nodes)).key("pieces").number(static_cast<double>(trace.pieces));
}

}  // namespace

void write_trace(const Trace& trace, JsonWriter& out) {
  out.key("trace").open('{').key("method").raw(Json(trace.method).dump());
  if (!trace.winner.empty()) out.key("winner").raw(Json(trace.winner).dump());
  if (!trace.reason.empty()) out.key("reason").raw(Json(trace.reason).dump());
  out.key("axes").open('[');
  for (const TraceAxis& axis : trace.axes) {
    out.open('{').key("name").raw(Json(axis.name).dump()).key("direction").vector(axis.direction);
    write_interval(axis.a_lower, axis.a_upper, out.key("a"));
    write_interval(axis.b_lower, axis.b_upper, out.key("b"));
    write_length(axis.overlap(), out.key("overlap"));
    out.close('}');
  }
  out.close(']');
  if (!trace.face_a.empty()) write_faces(trace, out);
  if (!trace.spans.empty()) write_spans(trace.spans, out);
  if (!trace.steps.empty()) write_steps(trace.steps, out);
  write_visits(trace, out);
  out.key("gjk").open('[');
  for (const TraceGjk& step : trace.gjk) {
    out.open('{').key("simplex");
    write_points(step.simplex, out);
    out.key("direction").vector(step.direction).key("found").open('{');
    out.key("a").vector(step.found.a).key("b").vector(step.found.b).close('}');
    out.key("lower").number(step.lower).key("upper").number(step.upper);
    if (!step.polygon.empty()) write_points(step.polygon, out.key("polygon"));
    out.close('}');
  }
  out.close(']').key("epa").open('[');
  for (const TraceEpa& step : trace.epa) {
    out.open('{').key("normal").vector(step.normal).key("faceDepth").number(step.face_depth);
    out.key("foundDepth").number(step.found_depth).key("faces").number(static_cast<double>(step.faces));
    if (!step.polygon.empty()) write_points(step.polygon, out.key("polygon"));
    out.close('}');
  }
  out.close(']');
  if (!trace.difference.empty()) {
    write_points(trace.difference, out.key("difference"));
    out.key("rounding").number(trace.rounding);
  }
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

}  // namespace graze::io
