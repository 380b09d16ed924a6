// Tasks on the threads of oneTBB: `graze::tbb`, a library of its own, since the core needs none.
//
// Guarantee: each task runs exactly once, and `run` returns after all of them; it may be called from any number of
// threads at a time and from within tasks, also of other executors. A thread that waits in it takes up only tasks below
// that very call, so that no caller finds other work of its own begun in the middle of an update.
#pragma once

#include <memory>
#include <optional>

#include "graze/executor.hpp"

namespace graze {

/// Runs tasks on the threads of oneTBB.
class GRAZE_API TbbExecutor final : public Executor {
 public:
  /// Runs tasks in the arena of the caller of `run`, within the limits set there. With `threads`: on at most so many at
  /// a time, callers among them, in an arena of its own; a larger number than oneTBB may use at construction is lowered
  /// to that. Throws `InvalidValue` for 0.
  explicit TbbExecutor(std::optional<std::size_t> threads = {});
  ~TbbExecutor() override;
  TbbExecutor(const TbbExecutor&) = delete;
  TbbExecutor& operator=(const TbbExecutor&) = delete;

  std::size_t concurrency() const override;
  /// A single task runs on the calling thread and wakes no other.
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override;

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;  // null: the caller's
};

}  // namespace graze
