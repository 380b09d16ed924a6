// Traces in the form of C, the same for both scalars.
#include "c/trace.hpp"

#include "c/draw.hpp"

#include <cmath>
#include <type_traits>

namespace {

using graze::c::given;
using graze::c::guarded;
using graze::c::opened;

/// An array as one of the other language, whose values have the same members in the same order.
template <class To, class From>
const To* same_array(const std::vector<From>& from) {
  static_assert(sizeof(To) == sizeof(From) && alignof(To) == alignof(From));
  static_assert(std::is_trivially_copyable_v<From> && std::is_standard_layout_v<To>);
  return reinterpret_cast<const To*>(from.data());
}
const GrazeTraceSupport* supports(const std::vector<graze::TraceSupport>& from) {
  return same_array<GrazeTraceSupport>(from);
}

void write(const graze::Vec3d& v, double (&to)[3]) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

GrazeTraceSupport seen(const graze::TraceSupport& s) { return graze::c::same_bytes<GrazeTraceSupport>(s); }

GrazeTraceAxis seen(const graze::TraceAxis& axis) {
  GrazeTraceAxis out{axis.name.c_str(), {}, axis.a_lower, axis.a_upper, axis.b_lower, axis.b_upper};
  write(axis.direction, out.direction);
  return out;
}

GrazeTraceGjk seen(const graze::TraceGjk& step) {
  GrazeTraceGjk out{supports(step.simplex), step.simplex.size(), {}, seen(step.found), step.lower, step.upper,
                    supports(step.polygon), step.polygon.size()};
  write(step.direction, out.direction);
  return out;
}

GrazeTraceEpa seen(const graze::TraceEpa& step) {
  GrazeTraceEpa out{{},         step.face_depth,        step.found_depth,   seen(step.found),
                    step.faces, supports(step.polygon), step.polygon.size()};
  write(step.normal, out.normal);
  return out;
}

GrazeTraceSpan seen(const graze::TraceSpan& span) {
  GrazeTraceSpan out{span.name.c_str(), {}, span.enter, span.leave};
  write(span.normal, out.normal);
  return out;
}

GrazeTraceStep seen(const graze::TraceStep& step) {
  GrazeTraceStep out{step.t, step.distance, {}};
  write(step.normal, out.normal);
  return out;
}

/// Corners as three numbers each, one behind the other.
const double* corners(const std::vector<graze::Vec3d>& from) {
  static_assert(sizeof(graze::Vec3d) == 3 * sizeof(double) && std::is_standard_layout_v<graze::Vec3d>);
  return reinterpret_cast<const double*>(from.data());
}

GrazeTraceCut seen(const graze::TraceCut& cut) {
  GrazeTraceCut out{{}, {}, corners(cut.left), cut.left.size()};
  write(cut.from, out.from), write(cut.to, out.to);
  return out;
}

template <class From, class To>
void see(const std::vector<From>& from, std::vector<To>& to, const To*& first, size_t& count) {
  to.clear();
  for (const From& one : from) to.push_back(seen(one));
  first = to.data();
  count = to.size();
}

// What C tells as a trace's contents, checked.

/// A finite point or direction.
graze::Vec3d told_vector(const double (&v)[3], const char* path) {
  const graze::Vec3d out{v[0], v[1], v[2]};
  graze::validate::point(out, path);
  return out;
}
graze::TraceSupport told(const GrazeTraceSupport& s, const char* path) {
  return {told_vector(s.a, path), told_vector(s.b, path)};
}
std::string told(const char* words) { return words == nullptr ? "" : words; }

std::vector<graze::TraceSupport> told_supports(const GrazeTraceSupport* first, size_t count, const char* path) {
  std::vector<graze::TraceSupport> out;
  for (size_t i = 0; i < count; ++i) out.push_back(told(graze::c::array(first, count, path)[i], path));
  return out;
}
std::vector<graze::Vec3d> told_corners(const double* first, size_t count, const char* path) {
  std::vector<graze::Vec3d> out;
  for (size_t i = 0; i < count; ++i) {
    const double* p = graze::c::array(first, count, path) + 3 * i;
    out.push_back({p[0], p[1], p[2]});
    graze::validate::point(out.back(), path);
  }
  return out;
}

graze::TraceAxis told(const GrazeTraceAxis& axis, const char* path) {
  for (const double end : {axis.a_lower, axis.a_upper, axis.b_lower, axis.b_upper})
    if (std::isnan(end)) graze::validate::fail(path, "an interval", end);
  return {told(axis.name), told_vector(axis.direction, path), axis.a_lower, axis.a_upper, axis.b_lower, axis.b_upper};
}
graze::TraceSpan told(const GrazeTraceSpan& span, const char* path) {
  for (const double end : {span.enter, span.leave})
    if (std::isnan(end)) graze::validate::fail(path, "an interval", end);
  return {told(span.name), told_vector(span.normal, path), span.enter, span.leave};
}
graze::TraceGjk told(const GrazeTraceGjk& step, const char* path) {
  return {told_supports(step.simplex, step.simplex_count, path),
          told_vector(step.direction, path),
          told(step.found, path),
          step.lower,
          step.upper,
          told_supports(step.polygon, step.polygon_count, path)};
}
graze::TraceEpa told(const GrazeTraceEpa& step, const char* path) {
  if (!std::isfinite(step.face_depth)) graze::validate::fail(path, "a finite depth", step.face_depth);
  return {told_vector(step.normal, path), step.face_depth, step.found_depth,
          told(step.found, path),         step.faces,      told_supports(step.polygon, step.polygon_count, path)};
}
graze::TraceCut told(const GrazeTraceCut& cut, const char* path) {
  return {told_vector(cut.from, path), told_vector(cut.to, path), told_corners(cut.left, cut.left_count, path)};
}

template <class From, class To>
void tell(const From* first, size_t count, std::vector<To>& to, const char* path) {
  graze::c::array(first, count, path);
  for (size_t i = 0; i < count; ++i) to.push_back(told(first[i], graze::c::at(path, i).c_str()));
}

/// The parts of a trace that are drawn.
graze::Trace drawn_of(const GrazeTraceView* from) {
  const GrazeTraceView& view = *given(from, "view");
  graze::Trace out;
  out.winner = told(view.winner);
  tell(view.axes, view.axis_count, out.axes, "view.axes");
  tell(view.gjk, view.gjk_count, out.gjk, "view.gjk");
  tell(view.epa, view.epa_count, out.epa, "view.epa");
  tell(view.cuts, view.cut_count, out.cuts, "view.cuts");
  out.difference = told_supports(view.difference, view.difference_count, "view.difference");
  out.polytope = told_supports(view.polytope, view.polytope_count, "view.polytope");
  graze::c::array(view.triangles, view.triangle_count, "view.triangles");
  for (size_t i = 0; i < view.triangle_count; ++i) {
    auto& triangle = out.triangles.emplace_back();
    for (size_t k = 0; k < 3; ++k) {
      triangle[k] = view.triangles[i].corner[k];
      if (triangle[k] >= out.polytope.size())
        graze::validate::fail(graze::c::at("view.triangles", i), "numbers of vertices of the polytope",
                              std::to_string(triangle[k]));
    }
  }
  out.face_a = told_corners(view.face_a, view.face_a_count, "view.face_a");
  out.face_b = told_corners(view.face_b, view.face_b_count, "view.face_b");
  return out;
}

/// One step: an axis as the one that decides, an iteration or an expansion in the difference, or a cut of the faces.
void draw_step(graze::DebugDraw& on, const graze::Trace& trace, size_t step) {
  const auto& axes = trace.axes;
  const auto& gjk = trace.gjk;
  const auto& epa = trace.epa;
  const auto& cuts = trace.cuts;
  const size_t count = axes.size() + gjk.size() + epa.size() + cuts.size();
  if (step >= count) graze::validate::fail("step", "a number below " + std::to_string(count), std::to_string(step));
  if (step < axes.size()) return draw(on, axes[step]);
  step -= axes.size();
  graze::Trace around;
  const bool searched = step < gjk.size() + epa.size();
  if (searched) {
    around.difference = trace.difference;
  } else {
    around.face_a = trace.face_a, around.face_b = trace.face_b;
  }
  draw(on, around);
  if (step < gjk.size()) return draw(on, gjk[step]);
  if (searched) return draw(on, epa[step - gjk.size()]);
  draw(on, cuts[step - gjk.size() - epa.size()]);
}

}  // namespace

graze::Trace graze::c::spans_of(const GrazeTraceView* view) {
  Trace out;
  out.winner = told(given(view, "view")->winner);
  tell(view->spans, view->span_count, out.spans, "view.spans");
  return out;
}

void graze::c::draw_span(DebugDraw& on, const Trace& trace, std::size_t span, const Ray<double>& ray) {
  const std::size_t count = trace.spans.size();
  if (span >= count) validate::fail("span", "a number below " + std::to_string(count), std::to_string(span));
  draw(on, trace.spans[span], ray, trace.spans[span].name == trace.winner);
}

extern "C" {

GrazeStatus graze_trace_create(GrazeTrace** trace) {
  return guarded([&] {
    given(trace, "trace");
    *trace = new GrazeTrace;
  });
}

void graze_trace_destroy(GrazeTrace* trace) {
  if (trace != nullptr && trace->tag == GrazeTrace::own_tag) delete trace;
}

GrazeStatus graze_trace_view(GrazeTrace* trace, GrazeTraceView* view) {
  return guarded([&] {
    GrazeTrace& t = opened(trace, "trace");
    given(view, "view");
    const graze::Trace& told = t.told;
    GrazeTraceView out{};
    out.method = told.method.c_str(), out.winner = told.winner.c_str(), out.reason = told.reason.c_str();
    see(told.axes, t.axes, out.axes, out.axis_count);
    see(told.gjk, t.gjk, out.gjk, out.gjk_count);
    see(told.epa, t.epa, out.epa, out.epa_count);
    see(told.spans, t.spans, out.spans, out.span_count);
    see(told.steps, t.steps, out.steps, out.step_count);
    out.difference = supports(told.difference), out.difference_count = told.difference.size();
    out.rounding = told.rounding;
    out.polytope = supports(told.polytope), out.polytope_count = told.polytope.size();
    out.triangles = same_array<GrazeTraceTriangle>(told.triangles), out.triangle_count = told.triangles.size();
    out.nodes = told.nodes, out.pieces = told.pieces;
    out.face_a = corners(told.face_a), out.face_a_count = told.face_a.size();
    out.face_b = corners(told.face_b), out.face_b_count = told.face_b.size();
    see(told.cuts, t.cuts, out.cuts, out.cut_count);
    *view = out;
  });
}

GrazeDebugDraw graze_debug_draw_default(void) {
  return {~std::uint32_t{0}, {0, 0, 0}, 1, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr};
}

GrazeStatus graze_draw_color(GrazeDrawMeaning meaning, uint8_t rgb[3]) {
  return guarded([&] {
    given(rgb, "rgb");
    const graze::DrawColor color = graze::suggested_color(graze::c::meaning_of(meaning));
    rgb[0] = color.red, rgb[1] = color.green, rgb[2] = color.blue;
  });
}

GrazeStatus graze_trace_draw(const GrazeTrace* trace, const GrazeDebugDraw* on) {
  return guarded([&] {
    graze::c::CallersDraw canvas(on);
    draw(canvas, opened(trace, "trace").told);
  });
}

GrazeStatus graze_trace_step_draw(const GrazeTrace* trace, size_t step, const GrazeDebugDraw* on) {
  return guarded([&] {
    graze::c::CallersDraw canvas(on);
    draw_step(canvas, opened(trace, "trace").told, step);
  });
}

GrazeStatus graze_trace_view_draw(const GrazeTraceView* view, const GrazeDebugDraw* on) {
  return guarded([&] {
    graze::c::CallersDraw canvas(on);
    draw(canvas, drawn_of(view));
  });
}

GrazeStatus graze_trace_view_step_draw(const GrazeTraceView* view, size_t step, const GrazeDebugDraw* on) {
  return guarded([&] {
    graze::c::CallersDraw canvas(on);
    draw_step(canvas, drawn_of(view), step);
  });
}

}  // extern "C"
