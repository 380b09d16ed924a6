// What oneTBB promises of the order of tasks, said to the thread sanitizer.
//
// Guarantee: without that sanitizer nothing of this is compiled. With it a task is ordered after the call of `run` and
// before its return, as it is by oneTBB, and by nothing else: races between tasks are still found.
//
// The sanitizer derives the order of threads from the atomics that it sees, and oneTBB's library is not built for it.
// It would take all data that is handed to a task for a race (1600 of them in one run of the tests). For the same
// reason the source that uses this is built without it: it holds oneTBB's templates, whose nodes pass from thread to
// thread through that library.
#pragma once

#ifdef GRAZE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace graze {

#ifdef GRAZE_THREAD_SANITIZER
class Order {
 public:
  void run_begins() { __tsan_release(&begin_); }
  void task_begins() { __tsan_acquire(&begin_); }
  void task_ends() { __tsan_release(&end_); }
  void run_ends() { __tsan_acquire(&end_); }

 private:
  char begin_ = 0, end_ = 0;  // their addresses are what counts
};
#else
class Order {
 public:
  void run_begins() {}
  void task_begins() {}
  void task_ends() {}
  void run_ends() {}
};
#endif

}  // namespace graze
