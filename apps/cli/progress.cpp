#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "output.hpp"

namespace graze::cli {

namespace {

constexpr std::chrono::milliseconds patience{1000}, interval{200};

/// The characters that go back to the beginning of the line and leave nothing on it.
constexpr const char* wiped = "\r\x1b[K";

}  // namespace

Progress::Progress(std::string doing) : doing_(std::move(doing)) {
  if (isatty(STDERR_FILENO) == 0 || quiet()) return;
  shower_ = std::thread([this] { show_until_stopped(); });
}

Progress::~Progress() {
  if (!shower_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  shower_.join();
}

void Progress::now(std::string doing) {
  const std::scoped_lock lock(mutex_);
  doing_ = std::move(doing);
  all_ = 0;
}

void Progress::operator()(std::size_t done, std::size_t all) {
  done_ = done;
  all_ = all;
}

void Progress::without(const std::function<void()>& print) {
  const std::scoped_lock lock(mutex_);
  wipe();
  print();
}

void Progress::wipe() {
  if (!shown_) return;
  std::fputs(wiped, stderr);
  std::fflush(stderr);
  shown_ = false;
}

void Progress::show_until_stopped() {
  const auto begin = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  const auto stopped = [this] { return stopped_; };
  if (changed_.wait_for(lock, patience, stopped)) return;
  do {
    const std::size_t all = all_, done = all_ != 0 ? done_.load() : 0;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - begin);
    const std::string part = all > 1 && done <= all ? fmt::format("{} %, ", 100 * done / all) : "";
    std::fputs(fmt::format("{}{}: {}{} s", wiped, doing_, part, seconds.count()).c_str(), stderr);
    std::fflush(stderr);
    shown_ = true;
  } while (!changed_.wait_for(lock, interval, stopped));
  wipe();
}

}  // namespace graze::cli
