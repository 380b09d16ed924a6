// Parts of a batch: its pairs cut for threads.
#pragma once

#include <vector>

#include "graze/batch.hpp"

namespace graze {

/// Pairs that a thread takes at a time: enough that queues for the kernels fill up and are allocated for many. The cuts
/// do not depend on the executor, and so neither does the order of what is found.
inline constexpr std::size_t pairs_per_part = 8192;

/// Calls `f(part, first)` for the parts of a batch, of which the pairs are those from the `first`-th on; without an
/// executor for the whole.
template <class T, class F>
void for_parts(Executor* executor, const Batch<T>& batch, const F& f) {
  if (executor == nullptr) return f(batch, 0);
  for_each_chunk(*executor, batch.size(), pairs_per_part,
                 [&](std::size_t begin, std::size_t end, std::size_t) { f(batch.part(begin, end), begin); });
}

/// Calls `take(found, first)`, in their order, with what `find(part, found)` found for the parts of a batch.
template <class Found, class T, class Find, class Take>
void find_in_parts(Executor& executor, const Batch<T>& batch, const Find& find, const Take& take) {
  std::vector<Found> parts((batch.size() + pairs_per_part - 1) / pairs_per_part);
  for_each_chunk(executor, batch.size(), pairs_per_part, [&](std::size_t begin, std::size_t end, std::size_t part) {
    find(batch.part(begin, end), parts[part]);
  });
  for (std::size_t part = 0; part < parts.size(); ++part) take(parts[part], part * pairs_per_part);
}

}  // namespace graze
