// The threads that a benchmark of a world may have: those of oneTBB, where it is installed.
#pragma once

#include <memory>

#include "graze/executor.hpp"
#ifdef GRAZE_BENCH_TBB
#include "graze/tbb_executor.hpp"
#endif

namespace graze::bench {

/// For so many threads; null where there is no library for more than one.
inline std::unique_ptr<Executor> make_executor(std::size_t threads) {
#ifdef GRAZE_BENCH_TBB
  if (threads > 1) return std::make_unique<TbbExecutor>(threads);
#endif
  return threads > 1 ? nullptr : std::make_unique<SerialExecutor>();
}

}  // namespace graze::bench
