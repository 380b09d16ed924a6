#include "thread_executor.hpp"

namespace graze::cli {

ThreadExecutor::ThreadExecutor(std::size_t threads) {
  for (std::size_t i = 1; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

ThreadExecutor::~ThreadExecutor() {
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (threads_.empty() || count < 2) {
    for (std::size_t i = 0; i < count; ++i) task(i);
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    task_ = &task;
    count_ = count;
    next_ = 0;
    ++round_;
    busy_ = threads_.size();
  }
  begun_.notify_all();
  take_tasks(count, task);
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [this] { return busy_ == 0; });
}

void ThreadExecutor::take_tasks(std::size_t count, const std::function<void(std::size_t)>& task) {
  for (std::size_t i = next_++; i < count; i = next_++) task(i);
}

void ThreadExecutor::work() {
  std::size_t seen = 0;
  std::unique_lock lock(mutex_);
  while (true) {
    begun_.wait(lock, [&] { return stopped_ || round_ != seen; });
    if (stopped_) return;
    seen = round_;
    const auto* task = task_;
    const std::size_t count = count_;
    lock.unlock();
    take_tasks(count, *task);
    lock.lock();
    if (--busy_ == 0) ended_.notify_one();
  }
}

}  // namespace graze::cli
