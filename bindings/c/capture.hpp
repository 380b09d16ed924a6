// Captures for C: their sink, and the report of a replay.
#pragma once

#include <algorithm>

#include "c/arguments.hpp"
#include "capture/play.hpp"

namespace graze::c {

/// The caller's function as the sink of a capture.
inline CaptureSink sink_of(GrazeWriteFunction write, void* user) {
  given(write, "write");
  return [write, user](std::string_view bytes) { return write(user, bytes.data(), bytes.size()); };
}

/// Bytes of the caller's, from the first to the last.
struct BytesInMemory {
  const char* next;
  std::size_t left;

  std::size_t operator()(char* to, std::size_t count) {
    const std::size_t taken = std::min(count, left);
    std::copy_n(next, taken, to);
    next += taken;
    left -= taken;
    return taken;
  }
};

/// The frames of a capture that the caller has in memory.
inline capture::FrameReader frames_of(const void* bytes, std::size_t size) {
  return {BytesInMemory{static_cast<const char*>(given(bytes, "bytes")), size}, "bytes"};
}

inline GrazeReplayReport report_of(const ReplayReport& played) {
  GrazeReplayReport out{};
  out.simulation = played.simulation;
  out.plane = played.plane;
  out.cut = played.cut;
  out.frames = played.frames;
  out.calls = played.calls;
  if (!played.difference) return out;
  out.differs = true;
  out.frame = played.difference->frame;
  out.call = played.difference->call;
  // A text that does not fit is cut; the last byte stays zero.
  played.difference->what.copy(out.what, sizeof(out.what) - 1);
  return out;
}

}  // namespace graze::c
