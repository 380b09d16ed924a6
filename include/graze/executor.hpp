// Executors: threads that come from the caller.
//
// Guarantee: Graze starts no threads of its own and takes no locks around an executor; whatever runs the tasks, on
// however many threads and in whatever order, the answers are the same bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "graze/detail/standard.hpp"

namespace graze {

/// A job system behind two functions: runs tasks in parallel.
class GRAZE_API Executor {
 public:
  virtual ~Executor() = default;
  /// Number of tasks that run at a time: at least 1. Work is cut into some more pieces than that.
  virtual std::size_t concurrency() const = 0;
  /// Calls `task(i)` once for each i < count, in any order and from any threads, and returns when all have returned.
  /// Tasks do not throw.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& task) = 0;
};

/// Runs all tasks on the calling thread, in order.
class SerialExecutor final : public Executor {
 public:
  std::size_t concurrency() const override { return 1; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
};

/// Cuts `count` items into chunks of `size` and calls `f(begin, end, chunk)` for each. The cuts do not depend on the
/// executor.
template <class F>
void for_each_chunk(Executor& executor, std::size_t count, std::size_t size, const F& f) {
  const std::size_t chunks = (count + size - 1) / size;
  executor.run(chunks, [&](std::size_t chunk) { f(chunk * size, (std::min)(count, (chunk + 1) * size), chunk); });
}

}  // namespace graze
