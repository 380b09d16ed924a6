// Tasks shared among threads, so that each thread has tasks that follow each other.
//
// Guarantee: every task is given out once, whatever threads take them in whatever order. There is no lock, and no
// thread waits for another.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace graze {

/// Each share is a range of the tasks. Its owner takes them from the front; a thread without tasks left takes the last
/// of another's (Blumofe and Leiserson 1999, "Scheduling Multithreaded Computations by Work Stealing").
class Shares {
 public:
  Shares(std::size_t tasks, std::size_t shares) : left_(shares) {
    for (std::size_t i = 0; i < shares; ++i)
      left_[i].range.store(packed(tasks * i / shares, tasks * (i + 1) / shares), std::memory_order_relaxed);
  }

  /// Takes the first task that is left of a share. False if none is.
  bool take_own(std::size_t share, std::size_t& task) {
    return take(share, [&](std::uint64_t first, std::uint64_t end) {
      task = static_cast<std::size_t>(first);
      return packed(first + 1, end);
    });
  }
  /// Takes the last task that is left of any other share. False if none is.
  bool take_other(std::size_t share, std::size_t& task) {
    for (std::size_t i = 1; i < left_.size(); ++i)
      if (take((share + i) % left_.size(), [&](std::uint64_t first, std::uint64_t end) {
            task = static_cast<std::size_t>(end - 1);
            return packed(first, end - 1);
          }))
        return true;
    return false;
  }

 private:
  /// A share on a line of its own, since its owner writes it again and again.
  struct alignas(64) Left {
    std::atomic<std::uint64_t> range{};
  };

  static std::uint64_t packed(std::uint64_t first, std::uint64_t end) { return first << 32 | end; }

  /// Changes a share to the rest `rest(first, end)` of it. The order is relaxed, since no data of the tasks depends on
  /// it: the executor that runs the threads begins and ends them in order.
  template <class Rest>
  bool take(std::size_t share, const Rest& rest) {
    std::atomic<std::uint64_t>& range = left_[share].range;
    std::uint64_t seen = range.load(std::memory_order_relaxed);
    while (true) {
      const std::uint64_t first = seen >> 32, end = seen & 0xffffffff;
      if (first == end) return false;
      if (range.compare_exchange_weak(seen, rest(first, end), std::memory_order_relaxed)) return true;
    }
  }

  std::vector<Left> left_;
};

}  // namespace graze
