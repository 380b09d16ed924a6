// Traces in the form of C, the same for both scalars.
#include "c/trace.hpp"

#include "c/draw.hpp"

#include <algorithm>
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

/// Moves the step with that number, of those of a trace one kind after the other, to a trace of its own.
template <class Step>
bool take(const std::vector<Step>& from, std::vector<Step>& to, size_t& step) {
  if (step < from.size()) {
    to.push_back(from[step]);
    return true;
  }
  step -= from.size();
  return false;
}

/// One step as a trace that has no other, its axis the one that decides.
graze::Trace step_of(const graze::Trace& told, size_t step) {
  const size_t count = told.axes.size() + told.gjk.size() + told.epa.size() + told.cuts.size();
  if (step >= count) graze::validate::fail("step", "a number below " + std::to_string(count), std::to_string(step));
  graze::Trace out;
  if (take(told.axes, out.axes, step)) {
    out.winner = out.axes[0].name;
  } else if (!take(told.gjk, out.gjk, step) && !take(told.epa, out.epa, step)) {
    take(told.cuts, out.cuts, step);
    out.face_a = told.face_a, out.face_b = told.face_b;
  } else {
    out.difference = told.difference;
  }
  return out;
}

}  // namespace

extern "C" {

GrazeStatus graze_trace_create(GrazeTrace** trace) {
  return guarded([&] { *given(trace, "trace") = new GrazeTrace; });
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
    draw(canvas, step_of(opened(trace, "trace").told, step));
  });
}

}  // extern "C"
