// Threads that run a simulation's tasks.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "graze/executor.hpp"

namespace graze::cli {

/// A fixed number of threads, the calling one among them, that take tasks as they come.
class ThreadExecutor final : public Executor {
 public:
  explicit ThreadExecutor(std::size_t threads);
  ~ThreadExecutor() override;
  ThreadExecutor(const ThreadExecutor&) = delete;
  ThreadExecutor& operator=(const ThreadExecutor&) = delete;

  std::size_t concurrency() const override { return threads_.size() + 1; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override;

 private:
  void work();
  void take_tasks(std::size_t count, const std::function<void(std::size_t)>& task);

  std::mutex mutex_;  ///< of what follows, but for the next task
  std::condition_variable begun_, ended_;
  const std::function<void(std::size_t)>* task_ = nullptr;
  std::size_t count_ = 0, round_ = 0, busy_ = 0;
  bool stopped_ = false;
  std::atomic<std::size_t> next_{0};
  std::vector<std::thread> threads_;
};

}  // namespace graze::cli
