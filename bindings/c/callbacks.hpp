// The caller's threads behind a C++ executor.
#pragma once

#include <atomic>

#include "c/arguments.hpp"
#include "graze/executor.hpp"

namespace graze::c {

/// An executor whose two functions are C's.
class CallersThreads final : public Executor {
 public:
  explicit CallersThreads(const GrazeExecutor& executor) : executor_(executor) {
    if (executor.concurrency == nullptr) null("executor.concurrency");
    if (executor.run == nullptr) null("executor.run");
  }
  std::size_t concurrency() const override {
    const std::size_t threads = executor_.concurrency(executor_.user);
    return threads == 0 ? 1 : threads;
  }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    executor_.run(executor_.user, count, &call, const_cast<std::function<void(std::size_t)>*>(&task));
  }

 private:
  static void call(void* task, std::size_t i) { (*static_cast<const std::function<void(std::size_t)>*>(task))(i); }

  GrazeExecutor executor_;
};

}  // namespace graze::c
