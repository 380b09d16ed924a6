// What runs tasks in tests: threads, and a thread that says it is several.
#pragma once

#include <thread>
#include <vector>

#include "graze/executor.hpp"

namespace graze::testing {

/// Cuts the tasks among threads of its own, the last task first.
class ThreadExecutor final : public Executor {
 public:
  explicit ThreadExecutor(std::size_t threads) : threads_(threads) {}
  std::size_t concurrency() const override { return threads_; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < threads_; ++t)
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < count; i += threads_) task(count - 1 - i);
      });
    for (std::thread& thread : threads) thread.join();
  }

 private:
  std::size_t threads_;
};

/// One thread that says it is several: whoever comes first finds all of the work there.
class BusyExecutor final : public Executor {
 public:
  explicit BusyExecutor(bool last_first) : last_first_(last_first) {}
  std::size_t concurrency() const override { return 3; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    for (std::size_t i = 0; i < count; ++i) task(last_first_ ? count - 1 - i : i);
  }

 private:
  bool last_first_;
};

}  // namespace graze::testing
