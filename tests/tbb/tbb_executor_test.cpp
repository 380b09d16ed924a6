// Tasks on the threads of oneTBB, against the same tasks one after the other.
#include "graze/tbb_executor.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "world/scenario.hpp"

namespace graze {
namespace {

using testing::Scenario;
using testing::Snapshot;

/// Lets oneTBB have eight threads on machines with fewer processors too.
class Tbb : public ::testing::Test {
 protected:
  tbb::global_control eight_{tbb::global_control::max_allowed_parallelism, 8};
};

TEST_F(Tbb, EveryTaskRunsExactlyOnce) {
  for (const std::optional<std::size_t> threads :
       {std::optional<std::size_t>{}, std::optional<std::size_t>{1}, std::optional<std::size_t>{8}}) {
    TbbExecutor executor(threads);
    for (const std::size_t count : {0, 1, 2, 3, 1000}) {
      std::vector<std::atomic<int>> runs(count);
      executor.run(count, [&](std::size_t i) { ++runs.at(i); });
      for (const auto& n : runs) ASSERT_EQ(n, 1);
    }
  }
}

TEST_F(Tbb, RunReturnsAfterAllTasks) {
  TbbExecutor executor(8);
  std::vector<std::size_t> plain(200);  // no atomics: the thread sanitizer sees whether the ends are ordered
  for (std::size_t round = 1; round <= 20; ++round) {
    executor.run(plain.size(), [&](std::size_t i) { plain[i] += i; });
    for (std::size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(plain[i], i * round);
  }
}

TEST_F(Tbb, TasksMayRunTasks) {
  TbbExecutor outer(3), inner(2), anywhere;
  std::atomic<int> runs{0};
  outer.run(10, [&](std::size_t) {
    outer.run(10, [&](std::size_t) { ++runs; });
    inner.run(10, [&](std::size_t) { anywhere.run(10, [&](std::size_t) { ++runs; }); });
  });
  EXPECT_EQ(runs, 10 * 10 + 10 * 10 * 10);
}

TEST_F(Tbb, WaitingTakesUpNoOtherTaskOfTheCaller) {
  TbbExecutor executor;
  std::atomic<int> surprises{0};
  executor.run(64, [&](std::size_t) {
    thread_local int depth = 0;
    surprises += depth != 0;
    ++depth;
    executor.run(16, [](std::size_t) { std::this_thread::yield(); });
    --depth;
  });
  EXPECT_EQ(surprises, 0);
}

TEST_F(Tbb, SeveralThreadsMayShareOne) {
  TbbExecutor executor(2);
  std::atomic<int> runs{0};
  std::vector<std::thread> callers;
  for (int t = 0; t < 4; ++t) callers.emplace_back([&] { executor.run(100, [&](std::size_t) { ++runs; }); });
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(runs, 400);
}

TEST_F(Tbb, NoMoreTasksAtATimeThanAsked) {
  for (const std::size_t threads : {1, 2, 3, 8}) {
    TbbExecutor executor(threads);
    EXPECT_EQ(executor.concurrency(), threads);
    std::atomic<std::size_t> now{0}, most{0};
    executor.run(200, [&](std::size_t) {
      const std::size_t n = ++now;
      for (std::size_t m = most; m < n && !most.compare_exchange_weak(m, n);) continue;
      std::this_thread::yield();
      --now;
    });
    EXPECT_GE(most, 1u);
    EXPECT_LE(most, threads);
  }
}

TEST_F(Tbb, SeveralThreadsTakePart) {
  TbbExecutor executor(3);
  std::atomic<int> begun{0};
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  executor.run(3, [&](std::size_t) {
    ++begun;  // a thread that waits here begins no other task
    while (begun < 2 && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
  });
  EXPECT_LT(std::chrono::steady_clock::now(), patience);
}

TEST_F(Tbb, LimitsThatMeanNothing) {
  EXPECT_THROW(TbbExecutor(0), InvalidValue);
  EXPECT_EQ(TbbExecutor(~std::size_t{0}).concurrency(), 8u);
  EXPECT_GE(TbbExecutor().concurrency(), 1u);
}

/// Whoever runs the tasks: a world's updates are the same bits.
TEST_F(Tbb, AWorldIsTheSameBitsOnAnyNumberOfThreads) {
  std::vector<Snapshot<float>> expected;
  const auto play = [](Executor& executor, const auto& each) {
    Scenario<float> scenario(2, 400, &executor);
    for (std::size_t frame = 0; frame < 6; ++frame) {
      scenario.step(frame % 2 == 0);
      for (SolverPoint<float>& p : scenario.world().contacts().points) p.impulse += p.a;
      each(frame, Snapshot<float>::of(scenario.world()));
    }
  };
  SerialExecutor serial;
  play(serial, [&](std::size_t, const Snapshot<float>& now) { expected.push_back(now); });
  EXPECT_GT(expected.back().points.size(), 100u);
  for (const std::size_t threads : {1, 2, 3, 8}) {
    TbbExecutor executor(threads);
    play(executor, [&](std::size_t frame, const Snapshot<float>& now) {
      EXPECT_EQ(now, expected[frame]) << threads << " threads, frame " << frame;
    });
  }
}

}  // namespace
}  // namespace graze
