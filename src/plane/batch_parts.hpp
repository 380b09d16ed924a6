// The parts of a batch: its pairs one by one, and cut into chunks for threads.
#pragma once

#include "graze/plane/batch.hpp"

namespace graze::plane {

/// Pairs that a thread takes at a time. The cuts do not depend on the executor, and so neither do the arrays.
inline constexpr std::size_t chunk_pairs = 4096;

/// Calls `question(a, pose_a, b, pose_b)` for one pair.
template <class T, class Question>
auto ask(const Batch<T>& batch, std::size_t i, const Question& question) {
  const IdPair p = batch[i];
  return batch.a().visit(p.a, [&](const Shape<T>& a) {
    return batch.b().visit(p.b,
                           [&](const Shape<T>& b) { return question(a, batch.a().pose(p.a), b, batch.b().pose(p.b)); });
  });
}

/// Calls `f(begin, end, chunk)` for the chunks of a batch.
template <class F>
void for_chunks(Executor* executor, std::size_t count, const F& f) {
  SerialExecutor serial;
  for_each_chunk(executor ? *executor : serial, count, chunk_pairs, f);
}

}  // namespace graze::plane
