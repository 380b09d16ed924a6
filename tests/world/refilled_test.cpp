// A list that is filled anew in every update: what is in it, and that its room stays.
#include "graze/detail/refilled.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace graze {
namespace {

TEST(Refilled, HoldsWhatWasAppended) {
  Refilled<int> list;
  EXPECT_TRUE(list.filled().empty());
  std::vector<int> expected;
  for (int i = 0; i < 1000; ++i) {
    if (i % 3 == 0) {
      list.push_back(i);
      expected.push_back(i);
    } else {
      int* const some = list.extend(static_cast<std::size_t>(i % 7));
      std::iota(some, some + i % 7, i);
      for (int k = 0; k < i % 7; ++k) expected.push_back(i + k);
    }
  }
  EXPECT_EQ(std::vector<int>(list.filled().begin(), list.filled().end()), expected);
  list.shorten(5);
  expected.resize(5);
  EXPECT_EQ(std::vector<int>(list.filled().begin(), list.filled().end()), expected);
}

TEST(Refilled, ItsRoomStays) {
  Refilled<int> list;
  list.extend(1000);
  const int* const room = list.data();
  const std::size_t capacity = list.capacity();
  for (int update = 0; update < 5; ++update) {
    list.clear();
    EXPECT_EQ(list.size(), 0u);
    EXPECT_EQ(list.extend(1000), room);
  }
  EXPECT_EQ(list.capacity(), capacity);
}

/// As the world does: the vector shrinks to what was found, and its room is filled again in the next update.
TEST(Refilled, ChangesItsRoomForAVector) {
  Refilled<int> list;
  std::vector<int> found{1, 2, 3};
  found.swap(list.room());
  list.clear();
  for (int i = 0; i < 5; ++i) list.push_back(10 + i);
  found.swap(list.room());
  found.resize(list.size());
  EXPECT_EQ(found, (std::vector<int>{10, 11, 12, 13, 14}));
}

}  // namespace
}  // namespace graze
