// The parts of a batch: its pairs cut into chunks for threads.
#pragma once

#include "graze/plane/batch.hpp"

namespace graze::plane {

/// Pairs that a thread takes at a time. The cuts do not depend on the executor, and so neither do the arrays.
inline constexpr std::size_t chunk_pairs = 4096;

/// Calls `f(begin, end, chunk)` for the chunks of a batch.
template <class F>
void for_chunks(Executor* executor, std::size_t count, const F& f) {
  SerialExecutor serial;
  for_each_chunk(executor ? *executor : serial, count, chunk_pairs, f);
}

}  // namespace graze::plane
