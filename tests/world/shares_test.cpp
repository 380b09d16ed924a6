// Tasks that threads share: each is given out once.
#include "world/shares.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace graze {
namespace {

TEST(Shares, OwnersTakeTheirsInOrderAndOthersTheLast) {
  Shares shares(10, 3);  // 0 to 2, 3 to 5, 6 to 9
  std::size_t task = 0;
  ASSERT_TRUE(shares.take_own(1, task));
  EXPECT_EQ(task, 3u);
  ASSERT_TRUE(shares.take_own(1, task));
  EXPECT_EQ(task, 4u);
  ASSERT_TRUE(shares.take_other(0, task));
  EXPECT_EQ(task, 5u);
  EXPECT_FALSE(shares.take_own(1, task));
  ASSERT_TRUE(shares.take_other(1, task));
  EXPECT_EQ(task, 9u);
  ASSERT_TRUE(shares.take_own(2, task));
  EXPECT_EQ(task, 6u);
}

TEST(Shares, NoneOfNoTasksAndOneThreadHasAll) {
  std::size_t task = 7;
  Shares none(0, 2);
  EXPECT_FALSE(none.take_own(0, task));
  EXPECT_FALSE(none.take_other(0, task));
  EXPECT_EQ(task, 7u);
  Shares alone(3, 1);
  EXPECT_FALSE(alone.take_other(0, task));
  for (std::size_t expected = 0; expected < 3; ++expected) {
    ASSERT_TRUE(alone.take_own(0, task));
    EXPECT_EQ(task, expected);
  }
  EXPECT_FALSE(alone.take_own(0, task));
}

TEST(Shares, EveryTaskIsGivenOutOnceToThreadsThatTakeThemAllAtATime) {
  constexpr std::size_t tasks = 20000, threads = 4;
  Shares shares(tasks, threads);
  std::vector<std::vector<std::size_t>> taken(threads);
  std::vector<std::thread> running;
  for (std::size_t t = 0; t < threads; ++t)
    running.emplace_back([&, t] {
      std::size_t task = 0;
      while (shares.take_own(t, task)) taken[t].push_back(task);
      while (shares.take_other(t, task)) taken[t].push_back(task);
    });
  for (std::thread& thread : running) thread.join();
  std::vector<int> times(tasks);
  for (const auto& some : taken)
    for (const std::size_t task : some) ++times[task];
  EXPECT_EQ(times, std::vector<int>(tasks, 1));
}

}  // namespace
}  // namespace graze
