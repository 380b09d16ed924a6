// The work of one rank in a sweep: it takes chunks, answers their lines, and keeps or hands on the answers.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "graze/mpi/sweep.hpp"
#include "mpi/journal.hpp"
#include "mpi/line_chunks.hpp"

namespace graze::mpi {

/// A chunk with its answers.
struct Answered {
  Record record;
  std::string text;  ///< empty where it is in the journal
  double seconds = 0;
};

class Worker {
 public:
  /// `record_bytes`: as for the chunks.
  Worker(const File& questions, std::uint64_t record_bytes, JournalPart* journal, const LineAnswer& answer)
      : questions_(questions), record_bytes_(record_bytes), journal_(journal), answer_(answer) {}

  Answered work(const Chunk& chunk);

 private:
  void answer_lines(std::string_view lines, std::uint64_t first, Answered& answered) const;
  void answer_records(std::string_view records, std::uint64_t first, Answered& answered) const;

  const File& questions_;
  std::uint64_t record_bytes_;
  JournalPart* journal_;
  const LineAnswer& answer_;
};

/// A worker in a thread of its own, beside the one that hands out the work.
class LocalWorker {
 public:
  explicit LocalWorker(Worker worker);
  ~LocalWorker();
  LocalWorker(const LocalWorker&) = delete;
  LocalWorker& operator=(const LocalWorker&) = delete;

  void give(const Chunk& chunk);
  /// The chunk that is done first, if any. Throws what the worker threw.
  std::optional<Answered> take();

 private:
  void run();

  Worker worker_;
  std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  std::deque<Chunk> given_;
  std::deque<Answered> done_;
  std::exception_ptr failed_;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace graze::mpi
