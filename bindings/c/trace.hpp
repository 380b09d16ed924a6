// The object behind a trace of the C interface: the library's own trace, and its arrays in the form of C.
#pragma once

#include "c/arguments.hpp"
#include "graze/draw.hpp"
#include "graze/trace.hpp"

struct GrazeTrace {
  static constexpr std::uint32_t own_tag = 0x67726101u;
  static constexpr const char* name = "a trace";
  std::uint32_t tag = own_tag;
  graze::Trace told;
  // Arrays for C, made by `graze_trace_view`.
  std::vector<GrazeTraceAxis> axes;
  std::vector<GrazeTraceGjk> gjk;
  std::vector<GrazeTraceEpa> epa;
  std::vector<GrazeTraceSpan> spans;
  std::vector<GrazeTraceStep> steps;
  std::vector<GrazeTraceCut> cuts;

  ~GrazeTrace() { tag = 0; }
};

namespace graze::c {

/// The trace that a query fills, emptied first; null where the caller wants none.
inline Trace* emptied(GrazeTrace* trace) {
  if (trace == nullptr) return nullptr;
  Trace& told = opened(trace, "trace").told;
  told = {};
  return &told;
}

/// The spans of a view and its winner, checked.
Trace spans_of(const GrazeTraceView* view);

/// Draws one span of a ray, which decides where it is the trace's winner. Throws for a number that is not below that of
/// the spans.
void draw_span(DebugDraw& on, const Trace& trace, std::size_t span, const Ray<double>& ray);

}  // namespace graze::c
