// The progress of a long piece of work.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace graze::cli {

/// A line on standard error that counts seconds while something takes longer than one, with the part that is done where
/// that is known. It appears only on a terminal, and not with --quiet; it is wiped off at the end.
class Progress {
 public:
  /// Begins a line. `doing` names the work: "colliding".
  explicit Progress(std::string doing);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Names the work that follows.
  void now(std::string doing);
  /// Sets the part of the work that is done.
  void operator()(std::size_t done, std::size_t all);
  /// Prints whole lines on the same terminal, with the line of progress wiped off before them.
  void without(const std::function<void()>& print);

 private:
  void show_until_stopped();
  void wipe();

  std::mutex mutex_;  ///< of what follows, but for the two counts
  std::condition_variable changed_;
  std::string doing_;
  bool stopped_ = false, shown_ = false;
  std::atomic<std::size_t> done_{0}, all_{0};
  std::thread shower_;
};

}  // namespace graze::cli
