// How far a long piece of work is.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace graze::cli {

/// A line that counts up on a terminal, and nothing elsewhere.
class Progress {
 public:
  void operator()(std::size_t done, std::size_t all) {
    if (!isatty(STDERR_FILENO)) return;
    const auto now = std::chrono::steady_clock::now();
    if (done < all && now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    if (done < all) fmt::print(stderr, "\rcolliding: {} %", 100 * done / all);
    if (done < all) shown_ = true;
    if (done == all && shown_) fmt::print(stderr, "\r{:40}\r", "");
    std::fflush(stderr);
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  bool shown_ = false;
};

}  // namespace graze::cli
