// What stands behind a trace of the C interface: the library's own, and the arrays in which C sees it.
#pragma once

#include "c/arguments.hpp"
#include "graze/trace.hpp"

struct GrazeTrace {
  static constexpr std::uint32_t own_tag = 0x67726101u;
  static constexpr const char* name = "a trace";
  std::uint32_t tag = own_tag;
  graze::Trace told;
  // What C sees of it, made by `graze_trace_view`.
  std::vector<GrazeTraceAxis> axes;
  std::vector<GrazeTraceGjk> gjk;
  std::vector<GrazeTraceEpa> epa;
  std::vector<GrazeTraceSpan> spans;
  std::vector<GrazeTraceStep> steps;
  std::vector<GrazeTraceCut> cuts;

  ~GrazeTrace() { tag = 0; }
};

namespace graze::c {

/// What a query tells what it did, emptied of what was told before; null where nobody asks.
inline Trace* emptied(GrazeTrace* trace) {
  if (trace == nullptr) return nullptr;
  Trace& told = opened(trace, "trace").told;
  told = {};
  return &told;
}

}  // namespace graze::c
