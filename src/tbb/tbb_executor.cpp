#include "graze/tbb_executor.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "graze/error.hpp"
#include "tbb/order.hpp"

namespace graze {

struct TbbExecutor::Arena {
  explicit Arena(int threads) : arena(threads) {}

  tbb::task_arena arena;
};

namespace {

int checked(std::size_t threads) {
  if (threads == 0) throw InvalidValue("threads", "at least 1", "0");
  const std::size_t most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(std::min(threads, most));
}

/// In the calling thread's arena. Each task by itself: those of a world are cut so that one is worth a thread's time.
void run_here(std::size_t count, const std::function<void(std::size_t)>& task, Order& order) {
  const auto one = [&](std::size_t i) {
    order.task_begins();
    task(i);
    order.task_ends();
  };
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, count, one, tbb::simple_partitioner{}); });
}

}  // namespace

TbbExecutor::TbbExecutor(std::optional<std::size_t> threads)
    : arena_(threads ? std::make_unique<Arena>(checked(*threads)) : nullptr) {}

TbbExecutor::~TbbExecutor() = default;

std::size_t TbbExecutor::concurrency() const {
  const int threads = arena_ ? arena_->arena.max_concurrency() : tbb::this_task_arena::max_concurrency();
  return static_cast<std::size_t>(std::max(threads, 1));
}

void TbbExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (count == 0) return;
  if (count == 1) return task(0);
  Order order;
  order.run_begins();
  if (arena_)
    arena_->arena.execute([&] { run_here(count, task, order); });
  else
    run_here(count, task, order);
  order.run_ends();
}

}  // namespace graze
